// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/response_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/csv.hpp"
#include "io/result_head.hpp"
#include "io/tables.hpp"

namespace ehd {

namespace {

/// Errors are relative.
void put_SI(Json& json, const std::optional<DynamicStiffness>& si) {
  if (!si) return;
  put(json, "stiffness_N_per_m2", si->stiffness_N_per_m2);
  put(json, "stiffness_error", si->stiffness_error / std::abs(si->stiffness_N_per_m2));
  if (!std::isfinite(si->damping_error)) return;
  put(json, "damping_N_s_per_m2", si->damping_N_s_per_m2);
  put(json, "damping_error", si->damping_error / std::abs(si->damping_N_s_per_m2));
}

Json stiffness_json(const ResponseRun& run, const Stiffness& at) {
  Json json = Json::object();
  json["omega"] = at.Omega;
  put(json, "frequency_Hz", run.frequency_Hz(at.Omega));
  json["status"] = to_string(at.status);
  if (at.status == StopReason::diverged || !std::isfinite(at.error)) return json;
  put(json["kappa"], "real", at.kappa.real());
  put(json["kappa"], "imag", at.kappa.imag() + 0.0);  // of -0.0 too it is 0.0
  put(json["kappa"], "error", at.error);
  if (at.Omega > 0) {
    const Kappa kappa = in_series(at, 0);
    put(json["damping"], "value", kappa.damping);
    put(json["damping"], "error", kappa.damping_error / std::abs(kappa.damping));
  }
  put_SI(json, run.dynamic_stiffness(at));
  return json;
}

Json waviness_json(const WavinessResponse& at) {
  Json json = Json::object();
  json["wavelength"] = at.waviness.wavelength;
  json["slip"] = at.waviness.slip;
  json["status"] = to_string(at.status);
  if (at.status == StopReason::diverged || !std::isfinite(at.error)) return json;
  put(json, "amplitude_ratio", at.amplitude_ratio());
  put(json, "phase_deg", at.phase_deg());
  put(json, "error", at.error);
  return json;
}

Json slow_json(const ResponseRun& run) {
  const SlowStiffness& slow = *run.response.slow;
  Json json = Json::object();
  put(json["kappa_0"], "value", slow.kappa_0);
  put(json["kappa_0"], "error", slow.error_0);
  put(json["kappa_1"], "value", slow.kappa_1);
  put(json["kappa_1"], "error", slow.error_1);
  put_SI(json, run.at_rest());
  return json;
}

Json cost_json(const Cost& cost) {
  Json json = Json::object();
  put(json, "wall_s", cost.wall_s);
  put(json, "planning_s", cost.planning_s);
  put(json, "total_s", cost.wall_s + cost.planning_s);
  json["convolutions"] = cost.convolutions;
  json["newton_iterations"] = cost.newton_iterations;
  json["krylov_iterations"] = cost.krylov_iterations;
  json["nodes"] = cost.nodes;
  return json;
}

}  // namespace

Json to_json(const ResponseRun& run) {
  Json json = result_head("ehd-response-1");
  json["case"] = run.case_id;
  json["version"] = run.version;
  json["solver"] = run.solver;
  json["status"] = to_string(run.response.status);
  if (!run.response.reason.empty()) json["reason"] = run.response.reason;
  if (run.oil) json["lubricant"] = to_json(*run.oil);
  json["groups"] = groups_json(run.groups, run.hertz);
  put(json, "x0_m", run.datum_m);
  if (run.response.slow) json["slow"] = slow_json(run);
  put(json, "highest_certified_omega", run.response.highest_certified);
  json["response"] = Json::array();
  for (const Stiffness& at : run.response.frequencies) json["response"].push_back(stiffness_json(run, at));
  if (!run.response.waviness.empty()) json["waviness"] = Json::array();
  for (const WavinessResponse& at : run.response.waviness) json["waviness"].push_back(waviness_json(at));
  json["cost"] = cost_json(run.response.cost);
  json["notes"] = run.notes;
  return json;
}

namespace {

const std::vector<std::string> frequency_columns{"omega",
                                                 "frequency_Hz",
                                                 "kappa_real",
                                                 "kappa_imag",
                                                 "kappa_error",
                                                 "stiffness_N_per_m2",
                                                 "stiffness_error_N_per_m2",
                                                 "damping_N_s_per_m2",
                                                 "damping_error_N_s_per_m2"};
const std::vector<std::string> wave_columns{"wavelength", "slip", "amplitude_ratio", "phase_deg", "amplitude_error"};
constexpr int all_digits = 17;

std::vector<std::string> frequency_cells(const ResponseRun& run, const Stiffness& at) {
  const bool known = at.status != StopReason::diverged && std::isfinite(at.error);
  const auto si = run.dynamic_stiffness(at);
  std::vector<std::string> cells;
  const auto add = [&](const std::optional<double>& value) { cells.push_back(csv_number(value, all_digits)); };
  add(at.Omega);
  add(run.frequency_Hz(at.Omega));
  for (const double part : {at.kappa.real(), at.kappa.imag() + 0.0, at.error})
    add(known ? std::optional(part) : std::nullopt);
  add(si ? std::optional(si->stiffness_N_per_m2) : std::nullopt);
  add(si ? std::optional(si->stiffness_error) : std::nullopt);
  const bool damped = si && std::isfinite(si->damping_error);
  add(damped ? std::optional(si->damping_N_s_per_m2) : std::nullopt);
  add(damped ? std::optional(si->damping_error) : std::nullopt);
  return cells;
}

std::vector<std::string> wave_cells(const WavinessResponse& at) {
  const bool known = at.status != StopReason::diverged && std::isfinite(at.error);
  std::vector<std::string> cells{csv_number(at.waviness.wavelength, all_digits),
                                 csv_number(at.waviness.slip, all_digits)};
  for (const double number : {at.amplitude_ratio(), at.phase_deg(), at.error})
    cells.push_back(csv_number(known ? std::optional(number) : std::nullopt, all_digits));
  return cells;
}

}  // namespace

std::string response_csv(const ResponseRun& run) {
  const auto& frequencies = run.response.frequencies;
  const auto& waves = run.response.waviness;
  // Cells of the columns that the other kind of line has stay empty.
  const std::size_t of_frequency = waves.empty() || !frequencies.empty() ? frequency_columns.size() : 0;
  const std::size_t of_wave = waves.empty() ? 0 : wave_columns.size();
  const auto line = [&](std::vector<std::string> frequency, const std::vector<std::string>& wave,
                        const std::string& status) {
    frequency.resize(of_frequency);
    frequency.insert(frequency.end(), wave.begin(), wave.end());
    frequency.resize(of_frequency + of_wave);
    frequency.push_back(status);
    return csv_line(frequency);
  };
  std::string text = line(frequency_columns, of_wave > 0 ? wave_columns : std::vector<std::string>(), "status");
  for (const Stiffness& at : frequencies) text += line(frequency_cells(run, at), {}, std::string(to_string(at.status)));
  for (const WavinessResponse& at : waves) text += line({}, wave_cells(at), std::string(to_string(at.status)));
  return text;
}

namespace {

std::string at_rest_text(const ResponseRun& run) {
  const SlowStiffness& slow = *run.response.slow;
  std::string text = fmt::format("\nkappa_0  {}\nkappa_1  {}\n", with_error(slow.kappa_0, slow.error_0),
                                 with_error(slow.kappa_1, slow.error_1));
  if (const auto si = run.at_rest())
    text +=
        fmt::format("at rest  {} N/m^2, {} N s/m^2\n", with_absolute_error(si->stiffness_N_per_m2, si->stiffness_error),
                    with_absolute_error(si->damping_N_s_per_m2, si->damping_error));
  return text;
}

/// Leaves out each column without a number below its head: a case by its groups has no Hz, and nothing in SI.
void erase_empty_columns(std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return;
  for (std::size_t column = rows.front().size(); column-- > 0;) {
    if (!std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[column].empty(); })) continue;
    for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
}

std::vector<std::string> stiffness_row(const ResponseRun& run, const Stiffness& at) {
  const auto si = run.dynamic_stiffness(at);
  const auto hertz = run.frequency_Hz(at.Omega);
  std::vector<std::string> row{plain(at.Omega), hertz ? plain(*hertz) : ""};
  if (std::isfinite(at.error)) {
    const Kappa kappa = at.Omega > 0 ? in_series(at, 0) : Kappa{};
    const double size = at.error * std::abs(at.kappa);
    row.push_back(with_absolute_error(at.kappa.real(), size));
    row.push_back(with_absolute_error(at.kappa.imag() + 0.0, at.Omega > 0 ? at.Omega * kappa.damping_error : size));
    row.push_back(plain(at.error, 2));
  } else {
    row.insert(row.end(), 3, "-");
  }
  row.push_back(si ? with_absolute_error(si->stiffness_N_per_m2, si->stiffness_error) : "");
  row.push_back(si ? with_absolute_error(si->damping_N_s_per_m2, si->damping_error) : "");
  row.emplace_back(to_string(at.status));
  return row;
}

}  // namespace

std::string human_table(const ResponseRun& run, const std::string& title) {
  const Response& response = run.response;
  std::string text = fmt::format("{}\nstatus  {} ({})\n", title, to_string(response.status), run.solver);
  if (!response.reason.empty()) text += fmt::format("reason  {}\n", response.reason);
  if (response.slow) text += at_rest_text(run);
  std::vector<std::vector<std::string>> rows;
  if (!response.frequencies.empty())
    rows.push_back({"Omega", "Hz", "Re kappa", "Im kappa", "error", "N/m^2", "N s/m^2", "status"});
  for (const Stiffness& at : response.frequencies) rows.push_back(stiffness_row(run, at));
  erase_empty_columns(rows);
  if (!rows.empty()) text += "\n" + aligned(rows, 0);
  rows.clear();
  if (!response.waviness.empty())
    rows.push_back({"wavelength/b", "slip", "amplitude ratio", "phase [deg]", "error", "status"});
  // An error of the film in the complex plane is one of its length, and as many radians of its angle.
  constexpr double degrees = 180 / std::numbers::pi;
  for (const WavinessResponse& at : response.waviness) {
    const bool known = std::isfinite(at.error);
    rows.push_back({plain(at.waviness.wavelength), plain(at.waviness.slip),
                    known ? with_error(at.amplitude_ratio(), at.error) : "-",
                    known ? with_absolute_error(at.phase_deg(), degrees * at.error) : "-",
                    known ? plain(at.error, 2) : "-", std::string(to_string(at.status))});
  }
  if (!rows.empty()) text += "\n" + aligned(rows, 0);
  if (!run.notes.empty()) text += "\n";
  for (const std::string& note : run.notes) text += wrapped("note: " + note, "      ");
  return text;
}

}  // namespace ehd
