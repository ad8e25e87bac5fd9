// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tables.hpp"

#include <algorithm>
#include <cmath>

#include "contact/text.hpp"

namespace ehd {

namespace {

const Reading* find(const ContactRun& run, Quantity quantity) {
  const auto at = run.solution.observables.find(quantity);
  return at == run.solution.observables.end() ? nullptr : &at->second;
}

/// Characters, not bytes: columns are aligned by what is seen.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::string bold(const std::string& text, bool styled) { return styled ? "\033[1m" + text + "\033[0m" : text; }

std::string status_text(StopReason status, bool styled) {
  const std::string text(to_string(status));
  if (!styled) return text;
  return (status == StopReason::converged ? "\033[32m" : "\033[31m") + text + "\033[0m";
}

/// The error in a number scaled from a reading, its digits shown as far as known.
std::string digits(const Reading& reading, double unit, bool absolute) {
  if (!reading.error) return plain(reading.value * unit);
  if (absolute) return with_absolute_error(reading.value * unit, *reading.error * unit);
  return with_error(reading.value * unit, reading.error);
}

std::string seconds(double s) { return s < 1 ? plain(1e3 * s, 3) + " ms" : plain(s, 3) + " s"; }

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left, const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = indent;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(widths[c] - width(row[c]), ' ');
      line += (c > 0 ? "  " : "") + (c < left ? row[c] + padding : padding + row[c]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string human_plan(const Plan& plan) {
  std::string text = "runs\n";
  for (const auto& stage : plan.run) text += "  " + stage + "\n";
  text += "skipped, and why\n";
  std::vector<std::vector<std::string>> rows;
  for (const auto& stage : plan.skipped) rows.push_back({stage.stage, stage.why});
  return text + aligned(rows, 2, "  ");
}

std::string human_table(const ContactRun& run, const std::string& title, bool styled) {
  std::string text = bold(title, styled) + "\n";
  text += "status  " + status_text(run.status(), styled) +
          (run.solver.empty() ? " (dry, closed form)" : " (" + run.solver + ")") + "\n";
  if (!run.solution.record.reason.empty()) text += "reason  " + run.solution.record.reason + "\n";

  std::vector<std::vector<std::string>> groups;
  const auto group = [&](const std::string& name, std::optional<double> value) {
    if (value) groups.push_back({name, plain(*value)});
  };
  if (run.groups) {
    group("M", run.groups->M);
    group("L", run.groups->L);
    group("lambda", run.groups->lambda);
    group("alpha p_H", run.groups->alpha_p_H);
  }
  if (run.scales) {
    group("p_H [Pa]", run.scales->hertz_pressure_Pa);
    group("b [m]", run.scales->half_width_m);
    if (run.scales->dowson) {
      group("W", run.scales->dowson->W);
      group("U (mean speed)", run.scales->dowson->U_mean);
      group("G", run.known_G());
    }
  }
  text += "\n" + aligned(groups, 1, "  ");

  const auto moes = run.moes_per_hertz_film();
  const auto metres = run.m_per_hertz_film();
  std::vector<std::vector<std::string>> rows{{"", "Hertz", moes ? "Moes" : "", metres ? "m" : "", "at X"}};
  for (const auto& [quantity, reading] : run.solution.observables) {
    if (quantity == Quantity::load_error || quantity == Quantity::flux_variation) continue;
    const std::string name(to_string(quantity));
    const bool film =
        quantity == Quantity::film_minimum || quantity == Quantity::film_central || quantity == Quantity::film_couette;
    const bool absolute = quantity == Quantity::film_offset || quantity == Quantity::approach;
    rows.push_back({name, digits(reading, 1, absolute), film && moes ? digits(reading, *moes, false) : "",
                    metres && (film || quantity == Quantity::approach) ? digits(reading, *metres, absolute) : "",
                    reading.place ? plain(*reading.place) : ""});
  }
  if (rows.size() > 1) text += "\n" + aligned(rows, 1, "  ");
  const Reading* load = find(run, Quantity::load_error);
  const Reading* flux = find(run, Quantity::flux_variation);
  if (load) text += "  load error " + plain(load->value, 2) + (flux ? "" : "\n");
  if (flux) text += (load ? ", " : "  ") + std::string("flux variation ") + plain(flux->value, 2) + "\n";

  if (!run.formulas.empty() && moes) {
    std::vector<std::vector<std::string>> table;
    for (const auto& formula : run.formulas) {
      const auto quantity = quantity_from(formula.of);
      const Reading* reading = quantity ? find(run, *quantity) : nullptr;
      const double film = reading ? reading->value * *moes : 0;
      table.push_back({formula.name, formula.of, plain(formula.moes_film, 4),
                       film > 0 ? plain(100 * (formula.moes_film / film - 1), 2) + " %" : ""});
    }
    text += "\nfilm formulas, Moes units (regressions: plausibility, no verdict" +
            std::string(run.known_G() ? "" : "; G = 5000 assumed") + ")\n" + aligned(table, 2, "  ");
  }

  if (run.plan.runs(stage::solve)) {
    const Cost& cost = run.solution.record.cost;
    const bool accepted = cost.nodes > 0;
    text += "\ncost  " + seconds(cost.wall_s) + " (FFT planning " + seconds(cost.planning_s) + "), " +
            (accepted ? std::to_string(cost.nodes) + " intervals, " + std::to_string(cost.levels) + " levels, "
                      : std::string("no grid accepted, ")) +
            std::to_string(cost.newton_iterations) + " Newton and " + std::to_string(cost.krylov_iterations) +
            " Krylov iterations, " + std::to_string(cost.convolutions) + " products" +
            (accepted ? ", " + plain(cost.work_units, 3) + " work units" : "") + "\n";
  }
  for (const auto& note : run.notes) text += "note  " + note + "\n";
  return text;
}

}  // namespace ehd
