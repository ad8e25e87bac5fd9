// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of one contact: which stages run and which are skipped, each with its reason. The plan is made from the case
// and the request before anything runs, and run_contact follows it.
#pragma once

#include <string>
#include <string_view>

#include "contact/problem.hpp"
#include "contact/solver.hpp"
#include "workflow/case.hpp"
#include "workflow/plan.hpp"
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

/// Throws StatementError where the statement makes no problem (a case from read_case always makes one).
[[nodiscard]] Plan plan_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                                const Wanted& wanted);

/// The quantities that a plan observes.
[[nodiscard]] Wanted wanted_by(const Plan& plan);

}  // namespace ehd
