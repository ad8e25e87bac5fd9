// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "contact/text.hpp"

namespace ehd {

// -- JSON -------------------------------------------------------------------------------------------------------

void put(Json& object, const std::string& key, double value) {
  if (std::isfinite(value)) object[key] = value;
}

void put(Json& object, const std::string& key, const std::optional<double>& value) {
  if (value) put(object, key, *value);
}

namespace {

std::optional<double> times(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return std::nullopt;
  return *a * *b;
}

const Reading* find(const ContactRun& run, Quantity quantity) {
  const auto at = run.solution.observables.find(quantity);
  return at == run.solution.observables.end() ? nullptr : &at->second;
}

void put_film(Json& film, const std::string& key, const ContactRun& run, Quantity quantity) {
  const Reading* reading = find(run, quantity);
  if (!reading || !std::isfinite(reading->value)) return;
  Json entry;
  put(entry, "hertz", reading->value);
  if (quantity != Quantity::film_offset) put(entry, "moes", times(reading->value, run.moes_per_hertz_film()));
  if (quantity != Quantity::film_offset) put(entry, "m", times(reading->value, run.m_per_hertz_film()));
  put(entry, "x", reading->place);
  put(entry, "error", reading->error);
  // Where the relative error of the films that a tolerance speaks of comes from.
  const SolveRecord& record = run.solution.record;
  const ErrorBudget* const budget = quantity == Quantity::film_minimum   ? &record.film_minimum
                                    : quantity == Quantity::film_central ? &record.film_central
                                                                         : nullptr;
  if (budget && reading->error) {
    put(entry["errors"], "discretisation", budget->discretisation);
    put(entry["errors"], "iteration", budget->iteration);
    put(entry["errors"], "truncation", budget->truncation);
  }
  film[key] = entry;
}

void put_pressure(Json& pressure, const std::string& key, const ContactRun& run, Quantity quantity) {
  const Reading* reading = find(run, quantity);
  if (!reading || !std::isfinite(reading->value)) return;
  Json entry;
  put(entry, "hertz", reading->value);
  if (run.scales) put(entry, "Pa", reading->value * run.scales->hertz_pressure_Pa);
  put(entry, "x", reading->place);
  put(entry, "error", reading->error);
  pressure[key] = entry;
}

Json groups_json(const ContactRun& run) {
  Json groups = Json::object();
  if (run.groups) {
    put(groups, "M", run.groups->M);
    put(groups, "L", run.groups->L);
    put(groups, "lambda", run.groups->lambda);
    put(groups, "alpha_p_H", run.groups->alpha_p_H);
  }
  if (run.scales) {
    put(groups, "hertz_pressure_Pa", run.scales->hertz_pressure_Pa);
    put(groups, "half_width_m", run.scales->half_width_m);
    if (run.scales->dowson) {
      put(groups, "W", run.scales->dowson->W);
      put(groups, "U_mean", run.scales->dowson->U_mean);
      put(groups, "G", run.known_G());
    }
  }
  return groups;
}

Json cost_json(const Cost& cost) {
  Json json;
  put(json, "wall_s", cost.wall_s);
  put(json, "planning_s", cost.planning_s);
  const bool accepted = cost.nodes > 0;  // a work unit is a product on the finest grid accepted
  if (accepted) put(json, "work_units", cost.work_units);
  json["convolutions"] = cost.convolutions;
  json["newton_iterations"] = cost.newton_iterations;
  json["krylov_iterations"] = cost.krylov_iterations;
  if (accepted) {
    json["nodes"] = cost.nodes;
    json["levels"] = cost.levels;
  }
  json["viscosity_points"] = cost.viscosity_points;
  json["density_points"] = cost.density_points;
  json["fft_plans"] = cost.fft_plans;
  for (const auto& [stage, seconds] : cost.stage_s) put(json["stage_s"], stage, seconds);
  return json;
}

}  // namespace

Json to_json(const Plan& plan) {
  Json json;
  json["run"] = plan.run;
  json["skipped"] = Json::array();
  for (const auto& stage : plan.skipped) json["skipped"].push_back({{"stage", stage.stage}, {"why", stage.why}});
  return json;
}

Json to_json(const ContactRun& run) {
  Json json;
  if (!run.case_id.empty()) json["case"] = run.case_id;
  if (run.version > 0) json["version"] = run.version;
  if (!run.solver.empty()) json["solver"] = run.solver;
  json["status"] = to_string(run.status());
  if (!run.solution.record.reason.empty()) json["reason"] = run.solution.record.reason;
  json["groups"] = groups_json(run);

  Json film = Json::object();
  put_film(film, "minimum", run, Quantity::film_minimum);
  put_film(film, "central", run, Quantity::film_central);
  put_film(film, "couette", run, Quantity::film_couette);
  put_film(film, "offset", run, Quantity::film_offset);
  if (!film.empty()) json["film"] = film;

  Json pressure = Json::object();
  put_pressure(pressure, "maximum", run, Quantity::pressure_maximum);
  put_pressure(pressure, "spike", run, Quantity::pressure_spike);
  if (const Reading* exit = find(run, Quantity::pressure_exit)) put(pressure, "exit_x", exit->value);
  if (!pressure.empty()) json["pressure"] = pressure;

  if (const Reading* approach = find(run, Quantity::approach)) {
    Json entry = Json::object();
    put(entry, "hertz", approach->value);
    put(entry, "m", times(approach->value, run.m_per_hertz_film()));
    if (!entry.empty()) json["approach"] = entry;
  }
  if (const Reading* force = find(run, Quantity::rolling_force)) {
    Json entry = Json::object();
    put(entry, "dimensionless", force->value);
    if (!entry.empty()) json["rolling_force"] = entry;
  }
  if (const Reading* load = find(run, Quantity::load_error)) put(json, "load_error", load->value);
  if (const Reading* flux = find(run, Quantity::flux_variation)) put(json, "flux_variation", flux->value);
  json["cost"] = cost_json(run.solution.record.cost);
  json["plan"] = to_json(run.plan);
  json["notes"] = run.notes;
  return json;
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

// -- CSV --------------------------------------------------------------------------------------------------------

std::string profile_csv(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  const auto nodes = fields.X.size();
  const bool lubricated = fields.density.size() == nodes && fields.log_viscosity.size() == nodes;
  const auto length = run.scales ? run.scales->half_width_m : std::nullopt;
  const auto film = run.m_per_hertz_film();
  const bool metres = length && film;

  std::string csv = "X [x/b],P [p/p_H],H [h R/b^2]";
  if (lubricated) csv += ",rho [rho/rho_0],eta [eta/eta_0]";
  if (metres) csv += ",x_m [m],p_Pa [Pa],h_m [m]";
  csv += "\n";
  const auto cell = [&](double value, bool first = false) {
    char text[32] = "";
    if (std::isfinite(value)) std::snprintf(text, sizeof text, "%.15g", value);
    if (!first) csv += ',';
    csv += text;
  };
  for (Eigen::Index i = 0; i < nodes; ++i) {
    cell(fields.X[i], true);
    cell(fields.P[i]);
    cell(fields.H[i]);
    if (lubricated) {
      cell(fields.density[i]);
      cell(std::exp(fields.log_viscosity[i]));
    }
    if (metres) {
      cell(fields.X[i] * *length);
      cell(fields.P[i] * run.scales->hertz_pressure_Pa);
      cell(fields.H[i] * *film);
    }
    csv += "\n";
  }
  return csv;
}

// -- tables -----------------------------------------------------------------------------------------------------

namespace {

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

// -- files ------------------------------------------------------------------------------------------------------

namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why) {
  throw OutputError(one_line(path.string() + ": cannot be written (" + why + "); allowed is a file in a folder that " +
                             "exists and may be written"));
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  const auto status = std::filesystem::status(path_, error);
  if (path_.empty()) cannot_write(path_, "the name is empty");
  if (std::filesystem::is_directory(status)) cannot_write(path_, "it is a directory");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    if (!std::ofstream(path_)) cannot_write(path_, std::strerror(errno));
    return;
  }
  if (std::filesystem::exists(status)) {
    if (::access(path_.c_str(), W_OK) != 0) cannot_write(path_, std::strerror(errno));
    path_ = std::filesystem::canonical(path_, error);  // through a link, so that the link stays one
  }
  const auto temporary = path_.string() + ".partial-" + std::to_string(::getpid());
  if (!std::ofstream(temporary)) cannot_write(path_, std::strerror(errno));
  temporary_ = temporary;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::move(other.temporary_)) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void OutputFile::commit(const std::string& text) {
  std::ofstream stream(temporary_.empty() ? path_ : temporary_, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) cannot_write(path_, "the device is full or failed");
  commit();
}

void OutputFile::append(const std::string& text) {
  std::ofstream stream(temporary_.empty() ? path_ : temporary_, std::ios::binary | std::ios::app);
  stream << text;
  stream.close();
  if (!stream) cannot_write(path_, "the device is full or failed");
}

void OutputFile::commit() {
  if (temporary_.empty()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) cannot_write(path_, error.message());
  temporary_.clear();
}

}  // namespace ehd
