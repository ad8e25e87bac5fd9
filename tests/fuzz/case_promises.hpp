// SPDX-License-Identifier: GPL-3.0-or-later
// What the case reader promises of ANY bytes (case_broken).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "bearing/geometry.hpp"
#include "bearing/law_table.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "tests/fuzz/refusal.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_plan.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification::promises {

/// A case is called like its file: the value of the first `id = "…"`, where it may be a file's name, else "fuzz".
inline std::string file_name_for(std::string_view bytes) {
  constexpr std::size_t longest_name = 60;
  const auto key = bytes.find("id = \"");
  if (key == std::string_view::npos) return "fuzz.toml";
  const std::string_view rest = bytes.substr(key + 6);
  const std::string_view name = rest.substr(0, rest.find('"'));
  const auto plain_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
  };
  const bool usable = !name.empty() && name.size() <= longest_name && name.front() != '.' &&
                      std::all_of(name.begin(), name.end(), plain_letter);
  return (usable ? std::string(name) : "fuzz") + ".toml";
}

inline bool positive(double x) { return std::isfinite(x) && x > 0; }
inline bool not_negative(double x) { return std::isfinite(x) && x >= 0; }

inline std::string broken_by_scales(const Scales& scales) {
  if (!positive(scales.hertz_pressure_Pa)) return "p_H = " + plain(scales.hertz_pressure_Pa) + " Pa";
  if (scales.half_width_m && !positive(*scales.half_width_m)) return "b = " + plain(*scales.half_width_m) + " m";
  if (const auto unit = scales.film_m_per_hertz_film(); unit && !positive(*unit))
    return "the unit of film is " + plain(*unit) + " m";
  if (scales.dowson &&
      !(positive(scales.dowson->W) && positive(scales.dowson->U_mean) && not_negative(scales.dowson->G)))
    return fmt::format("W, U, G = {}, {}, {}", plain(scales.dowson->W), plain(scales.dowson->U_mean),
                       plain(scales.dowson->G));
  return "";
}

/// Groups and laws of a problem that the reader let through; laws at pressures of 0, p_H and 4 p_H.
inline std::string broken_by_problem(const Problem& problem) {
  const Groups& groups = problem.groups;
  if (!(positive(groups.M) && not_negative(groups.L) && positive(groups.lambda) && not_negative(groups.alpha_p_H)))
    return fmt::format("M, L, lambda, alpha p_H = {}, {}, {}, {}", plain(groups.M), plain(groups.L),
                       plain(groups.lambda), plain(groups.alpha_p_H));
  if (!(groups.M >= smallest_M && groups.M <= largest_M && groups.L <= largest_L))
    return fmt::format("M = {} or L = {} is out of range", plain(groups.M), plain(groups.L));
  Array pressure(3);
  pressure << 0, 1, 4;
  const auto log_viscosity = evaluate(problem.viscosity, pressure);
  const auto density = evaluate(problem.density, pressure);
  // ln eta may be as large as it likes (solvers refuse what they cannot do), but it is a number, and grows.
  for (Eigen::Index i = 0; i < pressure.size(); ++i) {
    if (std::isnan(log_viscosity.value(i)) || std::isnan(log_viscosity.slope(i)) || !(log_viscosity.slope(i) >= 0))
      return fmt::format("ln(eta/eta_0) = {}, slope {} at P = {}", plain(log_viscosity.value(i)),
                         plain(log_viscosity.slope(i)), plain(pressure(i)));
    constexpr double densest = 1.4;  // both printed laws end at 1.34 and 1.353
    if (!(density.value(i) >= 1 && density.value(i) <= densest && not_negative(density.slope(i))))
      return fmt::format("rho/rho_0 = {}, slope {} at P = {}", plain(density.value(i)), plain(density.slope(i)),
                         plain(pressure(i)));
  }
  return "";
}

/// Every stage is decided once, and what is skipped says why.
inline std::string broken_by_plan(const Plan& plan) {
  if (plan.run.empty()) return "the plan runs nothing";
  std::vector<std::string> stages = plan.run;
  for (const auto& skipped : plan.skipped) {
    if (skipped.why.empty()) return "the plan skips " + skipped.stage + " without a reason";
    stages.push_back(skipped.stage);
  }
  std::sort(stages.begin(), stages.end());
  const auto twice = std::adjacent_find(stages.begin(), stages.end());
  return twice == stages.end() ? "" : "the plan decides twice on " + *twice;
}

/// The way of a contact, up to the solve and after one that gave nothing.
inline std::string broken_by_body(const Case& read, const ContactCase& contact) {
  const RegisteredSolver solver{.name = "fast",
                                .description = {},
                                .solve = [](const Problem&, const Request&) { return Solution{}; },
                                .uses_fft = true,
                                .memory_bytes = {}};
  if (!contact.dry()) {
    const Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
    if (auto broken = broken_by_problem(reading.problem); !broken.empty()) return broken;
  }
  const ContactRun run = run_contact(read, solver, {});
  if (auto broken = broken_by_plan(run.plan); !broken.empty()) return broken;
  if (run.scales) {
    if (auto broken = broken_by_scales(*run.scales); !broken.empty()) return broken;
  }
  for (const auto& [quantity, reading] : run.solution.observables) {
    if (!std::isfinite(reading.value)) return std::string(to_string(quantity)) + " = " + plain(reading.value);
  }
  for (const auto& formula : run.formulas) {
    if (!not_negative(formula.moes_film)) return formula.name + " = " + plain(formula.moes_film);
  }
  for (const auto& note : run.notes) {
    if (one_line(note) != note || names_no_number(note)) return "a note: " + one_line(note);
  }
  return "";
}

/// Geometry, kinematics, and the balance by the dry laws: the part that needs no contact solve.
inline std::string broken_by_body(const Case& read, const BearingCase& body) {
  const bearing::Geometry& geometry = body.geometry;
  for (const auto raceway : bearing::both_raceways) {
    if (!positive(bearing::reduced_radius_m(geometry, raceway)))
      return "a reduced radius is " + plain(bearing::reduced_radius_m(geometry, raceway)) + " m";
  }
  const auto speeds = bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm);
  if (!not_negative(bearing::sum_speed_m_per_s(geometry, speeds)))
    return "the sum speed is " + plain(bearing::sum_speed_m_per_s(geometry, speeds)) + " m/s";
  if (!not_negative(bearing::centrifugal_force_N(geometry, speeds)))
    return "F_c = " + plain(bearing::centrifugal_force_N(geometry, speeds)) + " N";
  if (!positive(bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson)))
    return "E' = " + plain(bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson)) + " Pa";
  if (auto broken = broken_by_plan(plan_bearing(body, default_laws(body))); !broken.empty()) return broken;

  ContactMemory memory([](const Problem&, const Request&) { return Solution{}; });
  for (const bearing::Law law : bearing::laws_of(bearing::Laws::dry_without_ring_thickness)) {
    const auto results = run_bearing(read, {.laws = {law}, .explicitly = true, .films = false}, memory);
    if (results.size() != 1) return "one law gives " + std::to_string(results.size()) + " results";
    const BearingResult& result = results.front();
    if (memory.solves() > 0) return "a dry law solves contacts";
    if (result.status != StopReason::converged) {
      if (result.why.empty()) return "no balance, and no word why";
      continue;
    }
    // The literal bound of a reported balance.
    if (!(result.balance_error <= bearing::largest_balance_error) || !std::isfinite(result.displacement_m))
      return fmt::format("balance error {}, displacement {} m", plain(result.balance_error),
                         plain(result.displacement_m));
    for (const RollerRow& roller : result.rollers) {
      for (const ContactRow& row : {roller.inner, roller.outer}) {
        if (!not_negative(row.force_N) || !std::isfinite(row.displacement_m) ||
            (row.hertz_pressure_Pa && !positive(*row.hertz_pressure_Pa)))
          return fmt::format("a roller carries {} N at {} m", plain(row.force_N), plain(row.displacement_m));
      }
    }
  }
  return "";
}

/// "" where every promise is kept. What the reader throws beside CaseError passes through: it is a broken promise too.
inline std::string case_broken(std::string_view bytes) {
  const std::string file = file_name_for(bytes);
  Case read;
  try {
    read = read_case(std::string(bytes), file);
  } catch (const CaseError& refusal) {
    return broken_by_refusal(refusal.what(), file, bytes);
  }
  if (read.id + ".toml" != file) return "the id is not the file's name: " + read.id;
  for (const Expectation& expectation : read.expectations) {
    if (!std::isfinite(expectation.value) || !(expectation.uncertainty >= 0) || !std::isfinite(expectation.uncertainty))
      return fmt::format("{} = {} +- {}", expectation.quantity, plain(expectation.value),
                         plain(expectation.uncertainty));
  }
  return std::visit([&](const auto& body) { return broken_by_body(read, body); }, read.body);
}

}  // namespace ehd::verification::promises
