// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "contact/text.hpp"
#include "io/duration.hpp"

namespace ehd {

namespace {

using Rows = std::vector<std::vector<std::string>>;

const Reading* find(const ContactRun& run, Quantity quantity) {
  const auto at = run.solution.observables.find(quantity);
  return at == run.solution.observables.end() ? nullptr : &at->second;
}

/// Counts characters, not bytes, so that columns with UTF-8 text are aligned.
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

constexpr int digits_without_error = 3;  // on 64 intervals, the fewest that converge, films are known to 1 %

/// A reading times `unit`, with as many digits as its error leaves. A closed form has no error.
std::string digits(const ContactRun& run, Quantity quantity, const Reading& reading, double unit) {
  if (!reading.error && run.solver.empty()) return plain(reading.value * unit);
  if (!reading.error) return plain(reading.value * unit, digits_without_error) + " (error unknown)";
  if (has_absolute_error(quantity)) return with_absolute_error(reading.value * unit, *reading.error * unit);
  return with_error(reading.value * unit, reading.error);
}

std::string heading(const ContactRun& run, const std::string& title, bool styled) {
  const std::string solver = run.solver.empty() ? "dry, closed form" : run.solver;
  std::string text =
      fmt::format("{}\nstatus  {} ({})\n", bold(title, styled), status_text(run.status(), styled), solver);
  if (!run.solution.record.reason.empty()) text += fmt::format("reason  {}\n", run.solution.record.reason);
  return text;
}

/// The unit in which a table shows a quantity that is known in SI: micrometres, megapascals, newtons per metre.
struct ShownUnit {
  const char* name;
  double per_SI;
};
ShownUnit shown_unit(SIScale scale) {
  switch (scale) {
    case SIScale::pressure: return {.name = "MPa", .per_SI = 1e-6};
    case SIScale::force: return {.name = "N/m", .per_SI = 1};
    case SIScale::none:
    case SIScale::film:
    case SIScale::length: break;
  }
  return {.name = "um", .per_SI = 1e6};
}

std::string groups_table(const ContactRun& run) {
  Rows rows;
  const auto add = [&](const char* name, std::optional<double> value) {
    if (value) rows.push_back({name, plain(*value)});
  };
  if (run.scales) {
    add("p_H [MPa]", shown_unit(SIScale::pressure).per_SI * run.scales->hertz_pressure_Pa);
    if (run.scales->half_width_m) add("b [um]", shown_unit(SIScale::length).per_SI * *run.scales->half_width_m);
  }
  if (run.groups) {
    add("M", run.groups->M);
    add("L", run.groups->L);
    add("lambda", run.groups->lambda);
    add("alpha p_H", run.groups->alpha_p_H);
  }
  if (run.scales && run.scales->dowson) {
    add("W", run.scales->dowson->W);
    add("U (mean speed)", run.scales->dowson->U_mean);
    add("G", run.known_G());
  }
  return "\n" + aligned(rows, 1, "  ");
}

/// "0.2182(1) um"; empty where the scale is not known.
std::string digits_in_SI(const ContactRun& run, Quantity quantity, const Reading& reading) {
  const SIScale scale = row_of(quantity).SI;
  const auto SI_per_hertz = run.SI_per_hertz(scale);
  const ShownUnit unit = shown_unit(scale);
  return SI_per_hertz ? digits(run, quantity, reading, *SI_per_hertz * unit.per_SI) + " " + unit.name : "";
}

/// Leaves out each column that is empty below its head.
void erase_empty_columns(Rows& rows) {
  for (std::size_t column = rows.front().size() - 1; column > 0; --column) {
    const auto empty = [&](const auto& row) { return row[column].empty(); };
    if (!std::all_of(rows.begin() + 1, rows.end(), empty)) continue;
    for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
}

/// A row a quantity, in SI first where that is known; the self checks stand in a line below.
std::string observables_table(const ContactRun& run) {
  const auto moes = run.moes_per_hertz_film();
  const auto b_m = run.SI_per_hertz(SIScale::length);
  const ShownUnit length = shown_unit(SIScale::length);
  const auto place = [](double at) { return plain(at, digits_without_error); };
  Rows rows{{"", "SI", "Hertz", "Moes", "at x", "at X"}};
  for (const auto& [quantity, reading] : run.solution.observables) {
    if (is_self_check(quantity)) continue;
    const QuantityRow& row = row_of(quantity);
    const bool shows_place = reading.place && row.SI != SIScale::length;  // a length is a place itself
    rows.push_back({std::string(row.name), digits_in_SI(run, quantity, reading), digits(run, quantity, reading, 1),
                    row.in_moes_units && moes ? digits(run, quantity, reading, *moes) : "",
                    shows_place && b_m ? place(*reading.place * *b_m * length.per_SI) + " " + length.name : "",
                    shows_place ? place(*reading.place) : ""});
  }
  if (rows.size() == 1) return "";
  erase_empty_columns(rows);
  return "\n" + aligned(rows, 1, "  ");
}

std::string self_checks(const ContactRun& run) {
  std::vector<std::string> checks;
  if (const Reading* load = find(run, Quantity::load_error)) checks.push_back("load error " + plain(load->value, 2));
  if (const Reading* flux = find(run, Quantity::flux_variation))
    checks.push_back("flux variation " + plain(flux->value, 2));
  return checks.empty() ? "" : fmt::format("  {}\n", fmt::join(checks, ", "));
}

/// The fits beside the result, in its own unit, with their difference from it.
std::string formulas_table(const ContactRun& run) {
  const auto moes = run.moes_per_hertz_film(), metres = run.m_per_hertz_film();
  if (run.formulas.empty() || !moes) return "";
  const ShownUnit unit = shown_unit(SIScale::film);
  const double shown_per_moes = metres ? unit.per_SI * *metres / *moes : 1;
  Rows rows;
  for (const auto& formula : run.formulas) {
    const Reading* reading = find(run, formula.of);
    const double film = reading ? reading->value * *moes : 0;
    rows.push_back({formula.name, std::string(to_string(formula.of)), plain(shown_per_moes * formula.moes_film, 4),
                    film > 0 ? percent(formula.moes_film / film - 1, 2) : ""});
  }
  return fmt::format("\nfilm formulas, {} (published fits for flooded inlets, for comparison only{})\n{}",
                     metres ? unit.name : "Moes units", run.known_G() ? "" : "; G = 5000 assumed",
                     aligned(rows, 2, "  "));
}

std::string cost_line(const ContactRun& run) {
  if (!run.plan.runs(stage::solve)) return "";
  const Cost& cost = run.solution.record.cost;
  const bool accepted = cost.nodes > 0;
  const std::string grid = accepted ? fmt::format("{} intervals", cost.nodes) : "no grid accepted";
  const std::string work = accepted ? fmt::format(", {} work units", plain(cost.work_units, 3)) : "";
  return fmt::format("\ncost  {}, FFT planning {}, {}, {} Newton steps{}\n", computing_time(cost.wall_s),
                     computing_time(cost.planning_s), grid, cost.newton_iterations, work);
}

std::vector<std::size_t> widths_of(const Rows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  return widths;
}

constexpr std::size_t between_columns = 2;

/// The columns of each part: the first `left` of the table in all of them, then as many others as fit.
std::vector<std::vector<std::size_t>> parts_of(const std::vector<std::size_t>& widths, std::size_t left,
                                               std::size_t indent) {
  std::vector<std::size_t> first;
  std::size_t begin = indent;
  for (std::size_t c = 0; c < std::min(left, widths.size()); ++c) {
    first.push_back(c);
    begin += widths[c] + between_columns;
  }
  std::vector<std::vector<std::size_t>> parts{first};
  std::size_t line = begin;
  for (std::size_t c = first.size(); c < widths.size(); ++c) {
    if (line + widths[c] > widest_table && parts.back().size() > first.size()) {
      parts.push_back(first);
      line = begin;
    }
    parts.back().push_back(c);
    line += widths[c] + between_columns;
  }
  return parts;
}

/// Some columns of the rows, aligned.
std::string printed_lines(const Rows& rows, const std::vector<std::size_t>& widths,
                          const std::vector<std::size_t>& columns, std::size_t left, const std::string& indent) {
  std::string text;
  for (const auto& row : rows) {
    std::string line = indent;
    for (const std::size_t c : columns) {
      if (c >= row.size()) continue;
      const std::string padding(widths[c] - width(row[c]), ' ');
      line += (c > 0 ? std::string(between_columns, ' ') : "") + (c < left ? row[c] + padding : padding + row[c]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace

std::size_t table_width(const Rows& rows, const std::string& indent) {
  std::size_t line = indent.size();
  for (const std::size_t one : widths_of(rows)) line += one + between_columns;
  return line - between_columns;
}

std::string aligned(const Rows& rows, std::size_t left, const std::string& indent) {
  const std::vector<std::size_t> widths = widths_of(rows);
  std::vector<std::size_t> all(widths.size());
  std::iota(all.begin(), all.end(), 0);
  return printed_lines(rows, widths, all, left, indent);
}

std::string aligned_in_parts(const Rows& rows, std::size_t left, const std::string& indent) {
  const std::vector<std::size_t> widths = widths_of(rows);
  std::string text;
  for (const auto& columns : parts_of(widths, left, indent.size()))
    text += (text.empty() ? "" : "\n") + printed_lines(rows, widths, columns, left, indent);
  return text;
}

std::string wrapped(const std::string& line, const std::string& indent) {
  std::string text, left = line;
  while (width(left) > widest_table) {
    const auto space = left.rfind(' ', widest_table);
    if (space == std::string::npos || left.find_first_not_of(' ') > space) break;  // one long word
    text += left.substr(0, space) + "\n";
    left = indent + left.substr(space + 1);
  }
  return text + left + "\n";
}

std::string wrapped_lines(const std::string& text) {
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    all += wrapped(line, std::string(std::min(line.find_first_not_of(' '), line.size()), ' '));
  return all;
}

std::string human_plan(const Plan& plan) {
  std::string text = "runs\n";
  for (const auto& stage : plan.run) text += "  " + stage + "\n";
  text += "skipped, and why\n";
  for (const auto& stage : plan.skipped) text += fmt::format("  {}\n      {}\n", stage.stage, stage.why);
  return text;
}

std::string human_table(const ContactRun& run, const std::string& title, bool styled) {
  std::string text = heading(run, title, styled) + groups_table(run) + observables_table(run) + self_checks(run) +
                     formulas_table(run) + cost_line(run);
  for (const auto& note : run.notes) text += wrapped("note  " + note, "      ");
  return text;
}

}  // namespace ehd
