// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/text.hpp"
#include "verification/bench/timing.hpp"
#include "verification/studies/bit_digest.hpp"

namespace ehd::verification {

namespace {

// Processor time of a point, measured: kappa_0 and kappa_1 0.05 s at (0.5, 5), 0.3 s at (20, 10), 2 s at (500, 15),
// Barus 5 s at (500, 10); with all frequencies 20 to 60 s at M = 2000 and 5000, L = 30; a wave of pure rolling 0.2 s at
// (20, 10), 1 s at (200, 10), of sliding up to 3 s there. All points: about twenty minutes.
constexpr double heaviest_motion_M = 5000;
constexpr double motion_L[] = {2.5, 5, 10, 15, 20, 30};
/// Where the film begins to be elastic, damping may be negative in slow motion. More loads and L of light contacts show
/// where.
constexpr double elastic_M[] = {0.6, 0.7, 0.8, 0.9};
constexpr double more_roelands_L[] = {25};
constexpr double heaviest_of_more_L_M = 2;
constexpr double lightest_with_frequencies_M = 0.6;  ///< lighter contacts damp at every Omega
constexpr double frequencies_of_a_point[] = {1, 2, 3, 4, 5, 6, 7, 8};
constexpr double lightest_wavy_M = 1, heaviest_wavy_M = 200;
constexpr double sliding_M[] = {5, 20};
constexpr double shortest_wave_b = 0.1, longest_wave_b = 20;

std::string reading_name(const std::string& value, const std::vector<double>& places) {
  std::string name = value;
  for (const double place : places) name += " " + plain(place);
  return name;
}

void note(AtlasRecord& record, const std::string& value, const std::vector<double>& places, double number,
          double error) {
  if (std::isfinite(number) && std::isfinite(error)) record.readings[reading_name(value, places)] = {number, error};
}

/// The places of a table's rows of a point.
std::vector<std::vector<double>> places_of(const MotionTable& table, const AtlasPoint& point) {
  const ResponseRequest request = motion_request(point);
  std::vector<std::vector<double>> places;
  if (&table == &kappa_table()) {
    places.push_back({0});
    for (const double Omega : request.frequencies) places.push_back({Omega});
  } else {
    for (const Waviness& wave : request.waviness) places.push_back({wave.wavelength, wave.slip});
  }
  return places;
}

Problem problem_of(const AtlasPoint& point) {
  return problem_at({point.M, point.L}, point.laws == AtlasLaws::roelands, point.inlet);
}

/// Changes where a record of an earlier run is not valid any more: the solver's name, a digest of the bits of two short
/// responses, and a digest of the requests of all points.
std::string motion_solver_version(const RegisteredSolver& solver) {
  BitDigest digest;
  for (const AtlasPoint& probe :
       {AtlasPoint{AtlasLaws::barus, 4, 3, Flooded{}}, AtlasPoint{AtlasLaws::roelands, 9, 7, Flooded{}}}) {
    const Response found =
        solver.respond(problem_of(probe), {.frequencies = {2}, .waviness = {{2, 1}}, .tolerance = 1e-5});
    for (const Stiffness& at : found.frequencies) digest.add(at.kappa.imag()), digest.add(at.error);
    for (const WavinessResponse& at : found.waviness) digest.add(at.film.imag()), digest.add(at.error);
    if (found.slow) digest.add(found.slow->kappa_1), digest.add(found.slow->error_1);
  }
  for (const AtlasPoint& point : motion_points()) {
    const ResponseRequest request = motion_request(point);
    for (const double Omega : request.frequencies) digest.add(Omega);
    for (const Waviness& wave : request.waviness) digest.add(wave.wavelength), digest.add(wave.slip);
  }
  return fmt::format("{} {}", solver.name, digest.text());
}

}  // namespace

double similar_wavelength(MoesGroups moes, double wavelength_b) {
  return wavelength_b * std::pow(moes.M, 0.75) / std::sqrt(moes.L);
}

std::vector<AtlasPoint> motion_points() {
  std::vector<AtlasPoint> points;
  const auto add = [&](AtlasLaws laws, std::vector<double> all_M, std::vector<double> all_L) {
    const Box box{
        .M = std::move(all_M), .L = std::move(all_L), .roelands = {laws == AtlasLaws::roelands}, .flooded = {true}};
    for (const BoxContact& contact : contacts_of(box))
      points.push_back({laws, contact.moes.M, contact.moes.L, contact.inlet});
  };
  const std::vector<double> all_M = round_loads(box_lightest_M, heaviest_motion_M);
  const std::vector<double> all_L{std::begin(motion_L), std::end(motion_L)};
  std::vector<double> light_M = round_loads(box_lightest_M, heaviest_of_more_L_M);
  light_M.insert(light_M.end(), std::begin(elastic_M), std::end(elastic_M));
  std::ranges::sort(light_M);
  add(AtlasLaws::isoviscous, all_M, {0});
  for (const AtlasLaws laws : {AtlasLaws::barus, AtlasLaws::roelands}) {
    add(laws, all_M, all_L);
    add(laws, {std::begin(elastic_M), std::end(elastic_M)}, all_L);
  }
  add(AtlasLaws::roelands, light_M, {std::begin(more_roelands_L), std::end(more_roelands_L)});
  return points;
}

ResponseRequest motion_request(const AtlasPoint& point) {
  ResponseRequest request{.tolerance = motion_tolerance};
  if (point.M < lightest_with_frequencies_M) return request;
  request.frequencies.assign(std::begin(frequencies_of_a_point), std::end(frequencies_of_a_point));
  if (point.laws != AtlasLaws::roelands || point.M < lightest_wavy_M || point.M > heaviest_wavy_M) return request;
  const bool sliding = std::ranges::find(sliding_M, point.M) != std::end(sliding_M);
  for (const double slip : sliding ? std::vector<double>{0, 1, 2} : std::vector<double>{1}) {
    for (const double similar : similar_wavelengths) {
      const double b = std::stod(plain(similar / similar_wavelength({point.M, point.L}, 1), 4));
      if (b >= shortest_wave_b && b <= longest_wave_b) request.waviness.push_back({.wavelength = b, .slip = slip});
    }
  }
  return request;
}

const MotionTable& kappa_table() {
  static const MotionTable table{
      .file = "kappa.csv",
      .comment =
          "# kappa = -W_1/H_01 of flooded line contacts at Omega = omega b/u_m, Hertz units: stiffness is Re kappa, "
          "damping Im kappa/Omega; at Omega = 0 kappa_0 and kappa_1. NAME_error: absolute uncertainty of the "
          "printed NAME; empty: not known. docs/atlas.md says more.",
      .places = {"Omega"},
      .values = {"stiffness", "damping"}};
  return table;
}

const MotionTable& waviness_table() {
  static const MotionTable table{
      .file = "waviness.csv",
      .comment =
          "# What a flooded line contact leaves of a waviness that moves at slip u_m: the amplitude in the film at "
          "X = 0 over that on the body, and its phase; wavelength in b. NAME_error: absolute uncertainty of the "
          "printed NAME; empty: not known. docs/atlas.md says more.",
      .places = {"wavelength", "slip"},
      .values = {"ratio", "phase_deg"}};
  return table;
}

AtlasRecord solve_motion(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                         double time_limit_s) {
  ResponseRequest request = motion_request(point);
  request.tolerance = tolerance;
  request.time_limit_s = time_limit_s;
  const Response found = solver.respond(problem_of(point), request);
  AtlasRecord record{.id = point.id(),
                     .solver = {},
                     .tolerance = tolerance,
                     .time_limit_s = time_limit_s,
                     .status = found.status,
                     .reason = found.reason,
                     .readings = {},
                     .nodes = found.cost.nodes,
                     .wall_s = found.cost.wall_s};
  if (const auto& slow = found.slow) {
    note(record, "stiffness", {0}, slow->kappa_0, slow->error_0 * std::abs(slow->kappa_0));
    note(record, "damping", {0}, slow->kappa_1, slow->error_1 * std::abs(slow->kappa_1));
  }
  for (const Stiffness& at : found.frequencies) {
    const double error = at.error * std::abs(at.kappa);  // of the complex number
    note(record, "stiffness", {at.Omega}, at.kappa.real(), error);
    note(record, "damping", {at.Omega}, at.kappa.imag() / at.Omega, error / at.Omega);
  }
  for (const WavinessResponse& at : found.waviness) {
    const std::vector<double> place{at.waviness.wavelength, at.waviness.slip};
    note(record, "ratio", place, at.amplitude_ratio(), at.error * at.amplitude_ratio());
    note(record, "phase_deg", place, at.phase_deg(), at.error * 180 / std::numbers::pi);
  }
  return record;
}

std::string motion_reading_name(const MotionTable& table, const std::string& value, const AtlasRow& row) {
  std::vector<double> places;
  for (const std::string& place : table.places) places.push_back(std::stod(row.at(place)));
  return reading_name(value, places);
}

std::vector<AtlasRow> motion_rows(const MotionTable& table, const AtlasPoint& point, const AtlasRecord& record) {
  std::vector<AtlasRow> rows;
  for (const auto& places : places_of(table, point)) {
    AtlasRow row{
        {"id", point.id()}, {"laws", std::string(to_string(point.laws))}, {"M", plain(point.M)}, {"L", plain(point.L)}};
    for (std::size_t k = 0; k < places.size(); ++k) row[table.places[k]] = plain(places[k]);
    for (const std::string& value : table.values) {
      const auto at = record.readings.find(motion_reading_name(table, value, row));
      const auto known = at == record.readings.end() ? std::nullopt : known_digits(at->second.value, at->second.error);
      row[value] = known ? known->text : "";
      row[value + "_error"] = known ? known->absolute : "";
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

AtlasResult run_motion_atlas(const AtlasRequest& request, const RegisteredSolver& solver) {
  const Stopwatch watch;
  const MotionTable* const tables[] = {&kappa_table(), &waviness_table()};
  std::map<const MotionTable*, std::vector<AtlasRow>> before;
  for (const MotionTable* table : tables)
    if (!request.only.empty() && atlas_text(request.folder / table->file))
      before[table] = read_motion_table(*table, request.folder);
  AtlasResult result;
  result.entries = recorded_entries(
      request, {.name = "motion",
                .solver = motion_solver_version(solver),
                .usual_tolerance = [](const AtlasPoint&) { return motion_tolerance; },
                .solve = [&](const AtlasPoint& point, double tolerance,
                             double time_limit_s) { return solve_motion(point, solver, tolerance, time_limit_s); },
                .has_digits = [](const AtlasRecord& record) { return !record.readings.empty(); }});
  for (const MotionTable* table : tables) {
    std::map<std::string, std::vector<AtlasRow>> by_point;
    for (AtlasRow& row : before[table]) by_point[row.at("id")].push_back(std::move(row));
    for (const auto& entry : result.entries)
      by_point[entry.point.id()] = motion_rows(*table, entry.point, entry.record);
    std::vector<AtlasRow> rows;
    for (const AtlasPoint& point : request.points)
      for (AtlasRow& row : by_point[point.id()]) rows.push_back(std::move(row));
    replace_file(request.folder / table->file, motion_csv_text(*table, rows));
  }
  result.wall_s = watch.seconds();
  return result;
}

std::string human_motion_summary(const AtlasResult& result) {
  std::size_t reused = 0, converged = 0;
  std::string without;
  for (const auto& [point, record, is_old] : result.entries) {
    reused += is_old ? 1 : 0;
    converged += record.status == StopReason::converged ? 1 : 0;
    if (record.readings.empty())
      without += fmt::format("without digits: {}: {}, {}\n", record.id, to_string(record.status), record.reason);
  }
  const std::size_t all = result.entries.size();
  return fmt::format(
             "{} points, {} solved now, {} from records of an earlier run, {} s; at {} every number is within "
             "the tolerance\n",
             all, all - reused, reused, plain(result.wall_s, 3), converged) +
         without;
}

}  // namespace ehd::verification
