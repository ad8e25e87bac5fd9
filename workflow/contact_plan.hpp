// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of one contact: decided before anything runs, from the case and the request alone, and obeyed by
// run_contact. What a case does not need does not run, and says why.
#pragma once

#include <string>
#include <string_view>

#include "contact/problem.hpp"
#include "contact/solver.hpp"
#include "contact/stages.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd {

/// Names of the stages. Each wanted quantity is a stage of its own, "observe film.minimum".
namespace stage {
inline constexpr std::string_view groups = "similarity groups";
inline constexpr std::string_view hertz = "Hertz scales in SI";
inline constexpr std::string_view dry = "dry contact in closed form";
inline constexpr std::string_view fft_plan = "FFT plan";
inline constexpr std::string_view viscosity = "viscosity law at each node";
inline constexpr std::string_view density = "density law at each node";
inline constexpr std::string_view solve = "EHD solve";
inline constexpr std::string_view grids = "finer grids until the tolerance is met";
inline constexpr std::string_view finer = "grids finer than the first that meets the tolerance";
inline constexpr std::string_view formulas = "film formulas beside the result";
[[nodiscard]] std::string observe(Quantity quantity);
}  // namespace stage

/// Throws StatementError where the statement makes no problem (a case from read_case always does).
[[nodiscard]] Plan plan_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                                const Wanted& wanted);

/// The quantities that a dry contact has: film.offset, pressure.maximum, pressure.exit, approach.
[[nodiscard]] bool exists_in_dry_contact(Quantity quantity);

/// The quantities that a plan observes.
[[nodiscard]] Wanted wanted_by(const Plan& plan);

}  // namespace ehd
