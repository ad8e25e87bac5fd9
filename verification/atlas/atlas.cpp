// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/atlas.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <system_error>
#include <tuple>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/tables.hpp"
#include "verification/tolerance.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification {

namespace {

constexpr int record_schema = 1;
constexpr double giga = 1e9;
constexpr std::string_view csv_name = "atlas.csv", digits_name = "digits.txt", records_name = ".progress";

/// A number of the table; the column NAME_error follows it.
struct Column {
  std::string_view name;
  std::optional<Quantity> quantity;  ///< none: where the spike stands, which no case expects
  /// Its error in the CSV.
  [[nodiscard]] bool absolute() const { return !quantity || has_absolute_error(*quantity); }
};
const std::array columns_of_values = {
    Column{"H_min", Quantity::film_minimum},     Column{"H_cen", Quantity::film_central},
    Column{"H_couette", Quantity::film_couette}, Column{"X_exit", Quantity::pressure_exit},
    Column{"H_0", Quantity::film_offset},        Column{"rolling_force", Quantity::rolling_force},
    Column{"P_spike", Quantity::pressure_spike}, Column{"X_spike", std::nullopt},
};
std::string error_column(const Column& column) { return std::string(column.name) + "_error"; }

constexpr std::string_view csv_comment =
    "# Line contacts in Hertz units: X = x/b, P = p/p_H, H = h R/b^2 (H_Moes = 8M/pi H); p_H_GPa with alpha = 2.2e-8 "
    "1/Pa; "
    "NAME_error is the uncertainty of the printed NAME, relative, of H_0 and X_spike absolute; wall_s in seconds; "
    "empty: "
    "not known. README.md says more.";

std::string of_inlet(const Inlet& inlet, std::string_view flooded, const std::string& before, bool negated) {
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  if (!cut) return std::string(flooded);
  return before + plain(negated ? -cut->x : cut->x);
}

}  // namespace

// -- points -----------------------------------------------------------------------------------------------------

std::string_view to_string(AtlasLaws laws) {
  switch (laws) {
    case AtlasLaws::isoviscous: return "isoviscous";
    case AtlasLaws::barus: return "barus";
    case AtlasLaws::roelands: return "roelands";
  }
  return "";
}

std::string AtlasPoint::id() const {
  return "atlas-" + std::string(to_string(laws)) + "-m" + plain(M) + "-l" + plain(L) + "-" +
         of_inlet(inlet, "flooded", "cut", true);
}

std::string AtlasPoint::title() const {
  const std::string law = laws == AtlasLaws::isoviscous ? "isoviscous, incompressible"
                          : laws == AtlasLaws::barus    ? "Barus, incompressible"
                                                        : "Roelands, compressible";
  return "Atlas: M = " + plain(M) + ", L = " + plain(L) + ", " + law + ", " +
         of_inlet(inlet, "flooded", "inlet cut at X = ", false) +
         (numerical_test() ? " (a numerical test: p_H = " + plain(hertz_pressure_Pa() / giga, 2) + " GPa)" : "");
}

double AtlasPoint::hertz_pressure_Pa() const {
  return groups_from(MoesGroups{.M = M, .L = L}).alpha_p_H / atlas_alpha_per_Pa;
}

bool AtlasPoint::numerical_test() const { return hertz_pressure_Pa() > atlas_highest_pressure_Pa; }

ContactCase AtlasPoint::contact() const {
  Lubricant lubricant{.viscosity = ViscosityLaw::isoviscous, .density = DensityLaw::incompressible};
  if (laws == AtlasLaws::barus)
    lubricant = {
        .viscosity = ViscosityLaw::barus, .density = DensityLaw::incompressible, .alpha_per_Pa = atlas_alpha_per_Pa};
  if (laws == AtlasLaws::roelands)
    lubricant = {.viscosity = ViscosityLaw::roelands,
                 .density = DensityLaw::dowson_higginson,
                 .alpha_per_Pa = atlas_alpha_per_Pa,
                 .z = 0.68,
                 .p0_Pa = 1.96e8};
  return {.statement = MoesGroups{.M = M, .L = L}, .lubricant = lubricant, .inlet = inlet};
}

double AtlasPoint::usual_tolerance() const {
  // Measured at (20, 10): 1e-8 costs Barus, whose spike has no bound, three times as much; at (1000, 15) it is not met.
  return laws == AtlasLaws::barus ? 1e-7 : 1e-10;
}

std::vector<AtlasPoint> atlas_points() {
  constexpr double Ms[] = {0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};
  constexpr double Ls[] = {0, 2.5, 5, 10, 15, 20, 30};
  constexpr double cut = -4, lightest_cut = 2;  // of a lighter contact, -4 lies inside the film's own length
  std::vector<AtlasPoint> points;
  for (const AtlasLaws laws : {AtlasLaws::isoviscous, AtlasLaws::barus, AtlasLaws::roelands}) {
    for (const bool flooded : {true, false}) {
      for (const double M : Ms) {
        for (const double L : Ls) {
          if ((L == 0) != (laws == AtlasLaws::isoviscous)) continue;  // L = 0 is the same for all laws
          if (!flooded && M < lightest_cut) continue;
          points.push_back({laws, M, L, flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{cut}}});
        }
      }
    }
  }
  return points;
}

// -- digits -----------------------------------------------------------------------------------------------------

namespace {

/// `value` to the decimal place 10^place, which is not above its first digit.
std::string rounded_text(double value, int leading, int place) {
  char buffer[64];
  constexpr int largest_plain = 5, smallest_plain = -3;  // 999999 and 0.001; the exponent form beyond
  if (place <= 0 && leading <= largest_plain && leading >= smallest_plain) {
    std::snprintf(buffer, sizeof buffer, "%.*f", -place, value);
    return buffer;
  }
  std::snprintf(buffer, sizeof buffer, "%.*e", leading - place, value);
  const std::string text = buffer;
  const auto e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  std::string mantissa = text.substr(0, e);
  if (exponent > leading) mantissa += leading > place ? "0" : ".0";  // 9.96e-5 to 1e-6 is 1.00e-4, not 1.0e-4
  return exponent == 0 ? mantissa : mantissa + "e" + std::to_string(exponent);
}

/// Two significant digits, rounded up: an uncertainty may grow, never shrink.
std::string rounded_up(double size) {
  const int leading = static_cast<int>(std::floor(std::log10(size)));
  constexpr double rounding = 1e-9;  // 1.2 is 1.2, not 1.3
  for (const int place : {leading - 1, leading}) {
    const double units = std::ceil(size / std::pow(10.0, place) * (1 - rounding));
    if (units > 99) continue;
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.0fe%d", units, place);
    return plain(std::strtod(buffer, nullptr), 2);
  }
  return plain(size, 2);
}

}  // namespace

std::optional<KnownDigits> known_digits(double value, double error) {
  constexpr int most_digits = 15;  // what a double holds
  if (!std::isfinite(value) || !std::isfinite(error) || !(error > 0) || value == 0) return std::nullopt;
  int place = static_cast<int>(std::floor(std::log10(2 * error)));
  while (!(error < 0.5 * std::pow(10.0, place))) ++place;
  const int leading = static_cast<int>(std::floor(std::log10(std::abs(value))));
  place = std::max(place, leading - most_digits + 1);
  if (place > leading) return std::nullopt;
  KnownDigits known{.text = rounded_text(value, leading, place), .relative = {}, .absolute = {}};
  const double printed = std::strtod(known.text.c_str(), nullptr);
  const double uncertainty = error + std::abs(printed - value);
  known.relative = rounded_up(uncertainty / std::abs(printed));
  known.absolute = rounded_up(uncertainty);
  return known;
}

int count_digits(std::string_view text) {
  int digits = 0;
  for (const char c : text.substr(0, text.find_first_of("eE"))) {
    if (c < '0' || c > '9') continue;
    if (digits > 0 || c != '0') ++digits;
  }
  return digits;
}

// -- one point solved -------------------------------------------------------------------------------------------

namespace {

double relative_error(const AtlasRecord& record, const std::string& name) {
  const auto at = record.readings.find(name);
  if (at == record.readings.end() || at->second.value == 0) return std::numeric_limits<double>::infinity();
  const double error = at->second.error / std::abs(at->second.value);
  return error >= 0 ? error : std::numeric_limits<double>::infinity();  // NaN too
}

double film_error(const AtlasRecord& record) {
  return std::max(relative_error(record, "H_min"), relative_error(record, "H_cen"));
}

/// Where the spike stands comes without an error. Three times what the two discretisations differ by, and what the
/// error of its height may move it by: the relative error times its distance from the exit, times 30.
std::optional<AtlasReading> place_of_spike(const Solution& solution) {
  constexpr double safety = 3, steepness = 30;
  const auto at = solution.observables.find(Quantity::pressure_spike);
  const auto exit = solution.observables.find(Quantity::pressure_exit);
  const auto& grids = solution.record.grids;
  if (at == solution.observables.end() || exit == solution.observables.end() || !at->second.place ||
      !at->second.error || grids.size() < 2)
    return std::nullopt;
  const double place = *at->second.place;
  double farthest = 0;
  for (const GridRecord& grid : grids) {
    const auto seen = grid.observed.find(Quantity::pressure_spike);
    if (seen == grid.observed.end() || !seen->second.place) return std::nullopt;
    farthest = std::max(farthest, std::abs(*seen->second.place - place));
  }
  return AtlasReading{place, safety * farthest + steepness * *at->second.error * std::abs(exit->second.value - place)};
}

std::map<std::string, AtlasReading> readings_of(const Solution& solution) {
  std::map<std::string, AtlasReading> readings;
  for (const Column& column : columns_of_values) {
    if (!column.quantity) continue;
    const auto at = solution.observables.find(*column.quantity);
    if (at == solution.observables.end() || !at->second.error) continue;
    const Reading& reading = at->second;
    const double error = *reading.error * (column.absolute() ? 1 : std::abs(reading.value));
    if (std::isfinite(reading.value) && std::isfinite(error))
      readings[std::string(column.name)] = {reading.value, error};
  }
  if (const auto place = place_of_spike(solution)) readings["X_spike"] = *place;
  return readings;
}

std::optional<StopReason> stop_reason_from(const std::string& text) {
  for (const StopReason reason : {StopReason::converged, StopReason::tolerance_not_met, StopReason::under_resolved,
                                  StopReason::limit_reached, StopReason::diverged}) {
    if (text == to_string(reason)) return reason;
  }
  return std::nullopt;
}

}  // namespace

bool AtlasRecord::has_digits() const { return film_error(*this) <= atlas_worst_error; }

std::string json_of(const AtlasRecord& record) {
  Json json;
  json["schema"] = record_schema;
  json["id"] = record.id;
  json["solver"] = record.solver;
  json["tolerance"] = record.tolerance;
  json["time_limit_s"] = record.time_limit_s;
  json["status"] = to_string(record.status);
  json["reason"] = record.reason;
  json["nodes"] = record.nodes;
  json["wall_s"] = record.wall_s;
  Json readings = Json::object();
  for (const auto& [name, reading] : record.readings)
    readings[name] = {{"value", reading.value}, {"absolute_error", reading.error}};
  json["readings"] = readings;
  return json_text(json);
}

std::optional<AtlasRecord> record_from(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (json.at("schema") != record_schema) return std::nullopt;
    AtlasRecord record;
    record.id = json.at("id").get<std::string>();
    record.solver = json.at("solver").get<std::string>();
    record.tolerance = json.at("tolerance").get<double>();
    record.time_limit_s = json.at("time_limit_s").get<double>();
    const auto status = stop_reason_from(json.at("status").get<std::string>());
    if (!status) return std::nullopt;
    record.status = *status;
    record.reason = json.at("reason").get<std::string>();
    record.nodes = json.at("nodes").get<long>();
    record.wall_s = json.at("wall_s").get<double>();
    for (const auto& [name, reading] : json.at("readings").items())
      record.readings[name] = {reading.at("value").get<double>(), reading.at("absolute_error").get<double>()};
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

AtlasRecord solve_point(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                        double time_limit_s) {
  AtlasRecord best{.id = point.id(),
                   .solver = {},
                   .tolerance = tolerance,
                   .time_limit_s = time_limit_s,
                   .reason = {},
                   .readings = {}};
  constexpr double looser = 1000;
  bool first = true;
  for (double asked = tolerance;;) {
    const Solution solution =
        run_contact(point.contact(), solver, {.tolerance = asked, .time_limit_s = time_limit_s}).solution;
    best.wall_s += solution.record.cost.wall_s;
    if (first) {
      best.status = solution.record.status;
      best.reason = solution.record.reason;
    }
    AtlasRecord tried = best;
    tried.readings = readings_of(solution);
    tried.nodes = solution.record.cost.nodes;
    if (first || film_error(tried) < film_error(best)) best = std::move(tried);
    if (best.has_digits() || asked >= atlas_worst_error) break;
    // What ended for lack of time would do so again a little looser.
    const bool out_of_time = solution.record.status == StopReason::limit_reached;
    asked = out_of_time ? atlas_worst_error : std::min(asked * looser, atlas_worst_error);
    first = false;
  }
  const bool failed = best.status == StopReason::diverged || best.status == StopReason::under_resolved;
  if (!first && failed && best.has_digits()) best.status = StopReason::tolerance_not_met;
  return best;
}

std::string atlas_solver_version(const RegisteredSolver& solver) {
  // FNV-1a over everything that a change of the method would move.
  std::uint64_t digest = 14695981039346656037ULL;
  const auto mix = [&](std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      digest = (digest ^ ((bits >> (8 * byte)) & 0xFF)) * 1099511628211ULL;
    }
  };
  const AtlasPoint probes[] = {{AtlasLaws::isoviscous, 0.7, 0, Flooded{}},
                               {AtlasLaws::barus, 7, 3, TruncatedAt{-4}},
                               {AtlasLaws::roelands, 15, 7, Flooded{}}};
  for (const AtlasPoint& probe : probes) {
    const Solution solution = run_contact(probe.contact(), solver, {.tolerance = 1e-6}).solution;
    mix(static_cast<std::uint64_t>(solution.record.status));
    mix(static_cast<std::uint64_t>(solution.record.cost.nodes));
    for (const auto& [quantity, reading] : solution.observables) {
      mix(static_cast<std::uint64_t>(quantity));
      mix(std::bit_cast<std::uint64_t>(reading.value));
      mix(std::bit_cast<std::uint64_t>(reading.error.value_or(0)));
    }
  }
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(digest));
  return solver.name + " " + text;
}

// -- files ------------------------------------------------------------------------------------------------------

namespace {

std::map<std::string, KnownDigits> known_of(const AtlasRecord& record) {
  std::map<std::string, KnownDigits> known;
  if (!record.has_digits()) return known;
  for (const auto& [name, reading] : record.readings) {
    if (const auto digits = known_digits(reading.value, reading.error)) known[name] = *digits;
  }
  return known;
}

}  // namespace

std::string case_text_of(const AtlasPoint& point, const AtlasRecord& record, int version) {
  const ContactCase contact = point.contact();
  const Lubricant& lubricant = *contact.lubricant;
  std::string text = "# Written by `ehd atlas`: README.md in this folder.\n";
  text += "id = \"" + point.id() + "\"\n";
  text += "version = " + std::to_string(version) + "\n";
  text += "title = \"" + point.title() + "\"\n";
  text += "source = \"own\"\n";
  text += "\n[moes]\nM = " + plain(point.M) + "\nL = " + plain(point.L) + "\n";
  text += "\n[lubricant]\nviscosity = \"" + std::string(to_string(lubricant.viscosity)) + "\"\n";
  text += "density = \"" + std::string(to_string(lubricant.density)) + "\"\n";
  if (lubricant.alpha_per_Pa) text += "alpha_per_Pa = " + plain(*lubricant.alpha_per_Pa) + "\n";
  if (lubricant.z) text += "z = " + plain(*lubricant.z) + "\np0_Pa = " + plain(lubricant.p0_Pa) + "\n";
  text += "\n[domain]\ninlet = " + of_inlet(point.inlet, "\"flooded\"", "", false) + "\n";
  const auto known = known_of(record);
  for (const Column& column : columns_of_values) {
    if (!column.quantity) continue;
    const auto at = known.find(std::string(column.name));
    const std::string heading = "\n[[expect]]\nquantity = \"" + std::string(to_string(*column.quantity)) + "\"\n";
    if (at != known.end()) {
      text += heading + "value = \"" + at->second.text +
              "\"\nscaling = \"hertz\"\nuncertainty = " + at->second.relative + "\nkind = \"computed\"\n";
    } else if (*column.quantity == Quantity::film_minimum || *column.quantity == Quantity::film_central) {
      text += heading + "status = \"waiting\"\n";
    }
  }
  return text;
}

const std::vector<std::string>& atlas_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"id", "laws", "M", "L", "inlet", "p_H_GPa", "numerical_test", "status"};
    for (const Column& column : columns_of_values) {
      all.emplace_back(column.name);
      all.push_back(error_column(column));
    }
    all.insert(all.end(), {"tolerance", "nodes", "wall_s"});
    return all;
  }();
  return names;
}

std::vector<std::string> atlas_row(const AtlasPoint& point, const AtlasRecord& record) {
  std::vector<std::string> cells{point.id(),
                                 std::string(to_string(point.laws)),
                                 plain(point.M),
                                 plain(point.L),
                                 of_inlet(point.inlet, "flooded", "", false),
                                 point.L > 0 ? plain(point.hertz_pressure_Pa() / giga, 4) : "",
                                 point.numerical_test() ? "yes" : "no",
                                 std::string(to_string(record.status))};
  const auto known = known_of(record);
  for (const Column& column : columns_of_values) {
    const auto at = known.find(std::string(column.name));
    cells.push_back(at == known.end() ? "" : at->second.text);
    cells.push_back(at == known.end() ? "" : column.absolute() ? at->second.absolute : at->second.relative);
  }
  cells.push_back(plain(record.tolerance));
  cells.push_back(record.nodes > 0 ? std::to_string(record.nodes) : "");
  cells.push_back(plain(record.wall_s, 3));
  return cells;
}

namespace {

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + cells[i];
  return line;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::optional<std::string> text_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  return stream.bad() ? std::nullopt : std::optional(text.str());
}

std::string table_text(const AtlasTable& table) {
  std::string text = std::string(csv_comment) + "\n" + joined(atlas_columns()) + "\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const auto& name : atlas_columns()) cells.push_back(row.at(name));
    text += joined(cells) + "\n";
  }
  return text;
}

std::map<std::string, std::string> row_of(const std::vector<std::string>& cells) {
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < cells.size(); ++i) row[atlas_columns()[i]] = cells[i];
  return row;
}

/// What a cell may hold.
struct Allowed {
  bool empty = false;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_itself = true;
  std::string_view what = "a number";
};

Allowed allowed_in(std::string_view column) {
  if (column == "M") return {.low = smallest_M, .high = largest_M, .what = "a number from 1e-3 to 1e6"};
  if (column == "L") return {.low = 0, .high = largest_L, .what = "a number from 0 to 100"};
  const Allowed positive{.empty = true, .low = 0, .low_itself = false, .what = "a positive number, or nothing"};
  if (column == "X_exit" || column == "H_0" || column == "X_spike")
    return {.empty = true, .what = "a number, or nothing"};
  if (column == "tolerance") return {.low = 0, .low_itself = false, .what = "a positive number"};
  if (column == "nodes" || column == "wall_s") return {.low = 0, .what = "a number that is not negative"};
  return positive;  // films, forces, pressures, and every uncertainty
}

/// What is wrong with a number's cell; empty where nothing is.
std::string wrong_with(const std::string& cell, const Allowed& allowed) {
  if (cell.empty()) return allowed.empty ? "" : "is missing";
  double value = 0;
  const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (read.ptr != cell.data() + cell.size() || read.ec == std::errc::invalid_argument) return "is not a number";
  if (read.ec != std::errc()) return "is out of range";
  if (!std::isfinite(value)) return "is not finite";
  const bool low_enough = allowed.low_itself ? value >= allowed.low : value > allowed.low;
  return low_enough && value <= allowed.high ? "" : "is out of range";
}

bool is_text(std::string_view column) {
  return column == "id" || column == "laws" || column == "inlet" || column == "numerical_test" || column == "status";
}

struct WrongCell {
  std::string column, what, allowed;
};

/// The first cell of a row that `ehd atlas` would not write.
std::optional<WrongCell> wrong_cell(const std::map<std::string, std::string>& row) {
  for (const std::string& column : atlas_columns()) {
    if (is_text(column)) continue;
    const Allowed allowed = allowed_in(column);
    if (const std::string what = wrong_with(row.at(column), allowed); !what.empty())
      return WrongCell{column, what, std::string(allowed.what)};
  }
  for (const Column& column : columns_of_values) {
    const std::string value(column.name), error = error_column(column);
    if (row.at(value).empty() != row.at(error).empty())
      return WrongCell{error, row.at(error).empty() ? "is missing" : "has no value before it",
                       "a number and its uncertainty, or neither"};
  }
  const std::string& laws = row.at("laws");
  const auto is_law = [&](AtlasLaws one) { return laws == to_string(one); };
  if (!is_law(AtlasLaws::isoviscous) && !is_law(AtlasLaws::barus) && !is_law(AtlasLaws::roelands))
    return WrongCell{"laws", "is unknown", "isoviscous, barus, roelands"};
  if (is_law(AtlasLaws::isoviscous) != (std::stod(row.at("L")) == 0))
    return WrongCell{"laws", "does not go with L = " + row.at("L"), "isoviscous at L = 0, barus or roelands above"};
  const Allowed cut{.high = -1, .what = "flooded, or a number up to -1"};
  const std::string& inlet = row.at("inlet");
  if (inlet != "flooded" && !wrong_with(inlet, cut).empty())
    return WrongCell{"inlet", "is unknown", std::string(cut.what)};
  if (const std::string& test = row.at("numerical_test"); test != "yes" && test != "no")
    return WrongCell{"numerical_test", "is unknown", "yes, no"};
  return std::nullopt;
}

}  // namespace

AtlasTable read_atlas_table(const std::filesystem::path& csv) {
  const auto text = text_of_file(csv);
  const auto refuse = [&](int line, const std::string& what) {
    return CaseError(one_line(csv.string() + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what));
  };
  if (!text) throw refuse(0, "cannot be read; required is the table that `ehd atlas` writes");
  AtlasTable table;
  std::istringstream lines(*text);
  int number = 0;
  bool header = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = split(line);
    if (!header) {
      if (cells != atlas_columns())
        throw refuse(number, shortened(line, 60) +
                                 ": other columns; allowed is what `ehd atlas` writes: " + joined(atlas_columns()));
      header = true;
      continue;
    }
    if (cells.size() != atlas_columns().size())
      throw refuse(number, shortened(line, 60) + ": has " + std::to_string(cells.size()) + " cells; allowed is " +
                               std::to_string(atlas_columns().size()));
    auto row = row_of(cells);
    if (const auto wrong = wrong_cell(row))
      throw refuse(number, wrong->column + " = " + shortened(row.at(wrong->column), 60) + ": " + wrong->what +
                               "; allowed is " + wrong->allowed);
    table.rows.push_back(std::move(row));
  }
  if (!header) throw refuse(std::max(number, 1), "has no header; required is the table that `ehd atlas` writes");
  return table;
}

std::string digits_text(const AtlasTable& table) {
  std::vector<std::pair<std::string, std::string>> blocks;  // laws, inlet
  for (const auto& row : table.rows) {
    const std::pair block{row.at("laws"), row.at("inlet")};
    if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) blocks.push_back(block);
  }
  const auto by_value = [](const std::string& a, const std::string& b) { return std::stod(a) < std::stod(b); };
  std::string text =
      "Significant digits known of H_min/H_cen; -: not known to 1e-4; *: a numerical test, p_H above 4 GPa\n";
  for (const auto& block : blocks) {
    std::set<std::string, decltype(by_value)> all_M(by_value), all_L(by_value);
    std::map<std::pair<std::string, std::string>, std::string> cells;
    for (const auto& row : table.rows) {
      if (row.at("laws") != block.first || row.at("inlet") != block.second) continue;
      all_M.insert(row.at("M"));
      all_L.insert(row.at("L"));
      const int minimum = count_digits(row.at("H_min")), central = count_digits(row.at("H_cen"));
      cells[{row.at("M"), row.at("L")}] =
          (minimum == 0 && central == 0 ? "-" : std::to_string(minimum) + "/" + std::to_string(central)) +
          (row.at("numerical_test") == "yes" ? "*" : "");
    }
    std::vector<std::vector<std::string>> lines{{"M"}};
    for (const auto& L : all_L) lines[0].push_back("L = " + L);
    for (const auto& M : all_M) {
      lines.push_back({M});
      for (const auto& L : all_L) {
        const auto at = cells.find({M, L});
        lines.back().push_back(at == cells.end() ? "" : at->second);
      }
    }
    text += "\n" + block.first + ", " + (block.second == "flooded" ? "flooded" : "inlet cut at X = " + block.second) +
            "\n" + aligned(lines, 0, "  ");
  }
  return text;
}

std::filesystem::path atlas_folder() { return cases_folder() / "atlas"; }

std::vector<std::filesystem::path> atlas_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const auto& path = entry->path();
    if (path.extension() == ".toml" && path.filename().string().starts_with("atlas-")) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

/// A row against its case: what differs, empty for nothing.
std::string difference(const std::map<std::string, std::string>& row, const Case& read) {
  const auto* contact = std::get_if<ContactCase>(&read.body);
  const auto* moes = contact ? std::get_if<MoesGroups>(&contact->statement) : nullptr;
  if (!moes || contact->dry()) return "states no lubricated contact by M and L";
  AtlasPoint point{.laws = {}, .M = moes->M, .L = moes->L, .inlet = *contact->inlet};
  bool known_laws = false;
  for (const AtlasLaws laws : {AtlasLaws::isoviscous, AtlasLaws::barus, AtlasLaws::roelands}) {
    if (row.at("laws") != to_string(laws)) continue;
    point.laws = laws;
    known_laws = true;
  }
  const Lubricant expected = point.contact().lubricant.value(), &stated = *contact->lubricant;
  const auto as_row = atlas_row(point, {});
  for (std::size_t i = 0; i < 7; ++i) {  // what the point alone decides: id … numerical_test
    if (as_row[i] != row.at(atlas_columns()[i]))
      return atlas_columns()[i] + " is " + as_row[i] + ", not " + row.at(atlas_columns()[i]);
  }
  if (!known_laws || stated.viscosity != expected.viscosity || stated.density != expected.density ||
      stated.alpha_per_Pa != expected.alpha_per_Pa || stated.z != expected.z ||
      (stated.z && stated.p0_Pa != expected.p0_Pa))
    return "has another lubricant than " + row.at("laws");
  if (read.title != point.title()) return "is called " + read.title;
  std::size_t compared = 0;
  for (const Column& column : columns_of_values) {
    if (!column.quantity) continue;
    const std::string name(column.name), digits = row.at(name), error = row.at(error_column(column));
    const auto at = std::find_if(read.expectations.begin(), read.expectations.end(),
                                 [&](const Expectation& one) { return one.quantity == to_string(*column.quantity); });
    const bool there = at != read.expectations.end();
    compared += there ? 1 : 0;
    const std::string in_case = there ? at->digits : "";
    if (in_case != digits)
      return name + " is " + (in_case.empty() ? "absent" : in_case) + ", not " + (digits.empty() ? "absent" : digits);
    if (digits.empty()) continue;
    if (at->scaling != Scaling::hertz || at->kind != ExpectationKind::computed)
      return name + " is not a computed one in Hertz units";
    // Both are rounded up to two digits; of H_0 one is relative, one absolute.
    const double uncertainty = column.absolute() ? at->uncertainty * std::abs(at->value) : at->uncertainty;
    constexpr double two_digits = 0.11;
    if (!(std::abs(uncertainty - std::stod(error)) <= two_digits * uncertainty))
      return "the uncertainty of " + name + " is " + plain(uncertainty) + ", not " + error;
  }
  if (compared != read.expectations.size()) return "expects what the table does not have";
  return "";
}

}  // namespace

std::vector<std::string> atlas_disagreements(const std::filesystem::path& folder) {
  const AtlasTable table = read_atlas_table(folder / csv_name);
  std::vector<std::string> found;
  std::set<std::string> ids;
  for (const auto& row : table.rows) {
    const std::string& id = row.at("id");
    if (!ids.insert(id).second) found.push_back(id + ": stands twice in " + std::string(csv_name));
    try {
      const std::string what = difference(row, read_case(folder / (id + ".toml")));
      if (!what.empty()) found.push_back(id + ": the case differs from the table: " + what);
    } catch (const CaseError& wrong) {
      found.push_back(wrong.what());
    } catch (const std::logic_error&) {  // std::stod
      found.push_back(id + ": a number of the table cannot be read");
    }
  }
  for (const auto& file : atlas_files(folder)) {
    if (!ids.contains(file.stem().string())) found.push_back(file.string() + ": is not in " + std::string(csv_name));
  }
  return found;
}

// -- the run ----------------------------------------------------------------------------------------------------

namespace {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw OutputError(one_line(folder.string() + ": cannot be made (" + (error ? error.message() : "it is no folder") +
                               "); allowed is a folder that exists or can be made"));
}

/// The record of an earlier run that answers the same question.
std::optional<AtlasRecord> earlier(const std::filesystem::path& file, const AtlasRecord& asked) {
  const auto text = text_of_file(file);
  auto record = text ? record_from(*text) : std::nullopt;
  if (!record || record->id != asked.id || record->solver != asked.solver || record->tolerance != asked.tolerance)
    return std::nullopt;
  const bool more_time = record->time_limit_s < asked.time_limit_s;
  if (more_time && (record->status == StopReason::limit_reached || !record->has_digits())) return std::nullopt;
  return record;
}

/// The case file of a point, with the next version where a number of the old one changes.
std::string versioned_text(const std::filesystem::path& file, const AtlasPoint& point, const AtlasRecord& record) {
  const auto old_text = text_of_file(file);
  if (!old_text) return case_text_of(point, record);
  try {
    const int old = read_case(file).version;
    return case_text_of(point, record, *old_text == case_text_of(point, record, old) ? old : old + 1);
  } catch (const CaseError&) {
    return case_text_of(point, record);  // no case of ours
  }
}

}  // namespace

std::vector<AtlasPoint> selected_points(const AtlasRequest& request) {
  std::vector<AtlasPoint> points;
  for (const auto& point : request.points) {
    if (point.id().find(request.only) != std::string::npos) points.push_back(point);
  }
  return points;
}

AtlasResult run_atlas(const AtlasRequest& request, const RegisteredSolver& solver) {
  const auto start = std::chrono::steady_clock::now();
  const auto records = request.folder / records_name;
  const auto csv = request.folder / csv_name;
  AtlasTable before;
  std::error_code error;
  if (!request.only.empty() && std::filesystem::exists(csv, error)) before = read_atlas_table(csv);
  make_folder(request.folder);
  make_folder(records);
  { const OutputFile writable(csv); }  // refused before anything is computed

  AtlasResult result;
  const std::string version = atlas_solver_version(solver);
  for (const AtlasPoint& point : selected_points(request)) {
    AtlasResult::Entry entry{.point = point, .record = {}};
    entry.record.id = point.id();
    entry.record.solver = version;
    entry.record.tolerance = request.tolerance.value_or(point.usual_tolerance());
    entry.record.time_limit_s = request.time_limit_s;
    if (!request.fresh) {
      if (const auto known = earlier(records / (point.id() + ".json"), entry.record)) {
        entry.record = *known;
        entry.reused = true;
      }
    }
    result.entries.push_back(std::move(entry));
  }

  // What is known, then the heaviest first, so that no thread is left with a long one at the end.
  std::vector<std::size_t> order(result.entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto &one = result.entries[a], &other = result.entries[b];
    if (one.reused != other.reused) return one.reused;
    return one.point.hertz_pressure_Pa() > other.point.hertz_pressure_Pa();
  });
  std::size_t done = 0;
  std::mutex reporting;
  in_threads(order.size(), request.threads, [&](std::size_t k) {
    AtlasResult::Entry& entry = result.entries[order[k]];
    if (!entry.reused) {
      AtlasRecord solved = solve_point(entry.point, solver, entry.record.tolerance, request.time_limit_s);
      solved.solver = version;
      OutputFile(records / (solved.id + ".json")).commit(json_of(solved));
      entry.record = std::move(solved);
    }
    const std::lock_guard lock(reporting);
    ++done;
    if (request.progress) request.progress(done, order.size(), entry.record, entry.reused);
  });

  // Rows in the order of the request; others that are to stay, behind. Each file is replaced whole; a run that ends
  // between two of them is made good by the next one.
  std::map<std::string, std::map<std::string, std::string>> rows;
  for (const auto& row : before.rows) rows[row.at("id")] = row;
  std::map<std::string, std::string> files;
  for (const auto& entry : result.entries) {
    const std::string name = entry.record.id + ".toml";
    rows[entry.record.id] = row_of(atlas_row(entry.point, entry.record));
    files[name] = versioned_text(request.folder / name, entry.point, entry.record);
  }
  AtlasTable table;
  for (const auto& point : request.points) {
    if (const auto at = rows.find(point.id()); at != rows.end()) {
      table.rows.push_back(at->second);
      rows.erase(at);
    }
  }
  for (const auto& row : before.rows) {
    if (rows.contains(row.at("id"))) table.rows.push_back(row);
  }
  files[std::string(digits_name)] = digits_text(table);
  files[std::string(csv_name)] = table_text(table);
  for (const auto& [name, text] : files) {
    if (text_of_file(request.folder / name) != text) OutputFile(request.folder / name).commit(text);
  }

  std::set<std::string> ids;
  for (const auto& row : table.rows) ids.insert(row.at("id"));
  for (const auto& file : atlas_files(request.folder)) {
    if (!ids.contains(file.stem().string())) result.left_over.push_back(file.filename().string());
  }
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string human_summary(const AtlasResult& result) {
  constexpr int many = 9, several = 6;
  constexpr std::size_t slowest_shown = 8, most_named = 40;
  std::size_t reused = 0, with_many = 0, with_several = 0, tests = 0;
  std::vector<const AtlasResult::Entry*> by_time;
  std::vector<std::string> without;
  AtlasTable table;
  for (const auto& entry : result.entries) {
    table.rows.push_back(row_of(atlas_row(entry.point, entry.record)));
    const auto& row = table.rows.back();
    const int digits = std::min(count_digits(row.at("H_min")), count_digits(row.at("H_cen")));
    reused += entry.reused ? 1 : 0;
    with_many += digits >= many ? 1 : 0;
    with_several += digits >= several ? 1 : 0;
    tests += entry.point.numerical_test() ? 1 : 0;
    by_time.push_back(&entry);
    if (!entry.record.has_digits())
      without.push_back(entry.record.id + ": " + std::string(to_string(entry.record.status)) +
                        (entry.record.reason.empty() ? "" : ", " + entry.record.reason));
  }
  std::stable_sort(by_time.begin(), by_time.end(),
                   [](const auto* a, const auto* b) { return a->record.wall_s > b->record.wall_s; });
  std::string text = digits_text(table) + "\n";
  text += std::to_string(result.entries.size()) + " points, " + std::to_string(result.entries.size() - reused) +
          " solved now, " + std::to_string(reused) + " from records of an earlier run, " + plain(result.wall_s, 3) +
          " s\n";
  text += std::to_string(with_many) + " with " + std::to_string(many) + " digits or more of H_min and H_cen, " +
          std::to_string(with_several) + " with " + std::to_string(several) + " or more, " +
          std::to_string(without.size()) + " without; " + std::to_string(tests) + " are numerical tests\n";
  text += "slowest\n";
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(slowest_shown, by_time.size()); ++i)
    rows.push_back({by_time[i]->record.id, std::string(to_string(by_time[i]->record.status)),
                    plain(by_time[i]->record.wall_s, 3) + " s"});
  text += aligned(rows, 2, "  ");
  if (!without.empty()) text += "without digits\n";
  for (std::size_t i = 0; i < std::min(most_named, without.size()); ++i) text += "  " + without[i] + "\n";
  if (without.size() > most_named) text += "  and " + std::to_string(without.size() - most_named) + " more\n";
  for (const auto& file : result.left_over) text += "left over: " + file + " belongs to no point of the list\n";
  return text;
}

}  // namespace ehd::verification
