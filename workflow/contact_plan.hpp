// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of one contact: which stages run and which are skipped, each with its reason. The plan is made from the case
// and the request before anything runs, and run_contact follows it.
#pragma once

#include <string>

#include "contact/problem.hpp"
#include "contact/solver.hpp"
#include "workflow/case.hpp"
#include "workflow/plan.hpp"
#include "workflow/registry.hpp"

namespace ehd {

/// Names of the stages. Each wanted quantity is a stage of its own, "observe film.minimum".
namespace stage {
inline constexpr const char* groups = "similarity groups";
inline constexpr const char* hertz = "Hertz scales in SI";
inline constexpr const char* dry = "dry contact in closed form";
inline constexpr const char* fft_plan = "FFT plan";
inline constexpr const char* viscosity = "viscosity law at each node";
inline constexpr const char* density = "density law at each node";
inline constexpr const char* solve = "EHD solve";
inline constexpr const char* grids = "finer grids until the tolerance is met";
inline constexpr const char* finer = "grids finer than the first that meets the tolerance";
inline constexpr const char* formulas = "film formulas beside the result";
[[nodiscard]] std::string observe(Quantity quantity);
}  // namespace stage

/// The request with the tolerances alone that serve a wanted quantity: film.couette, film.offset and approach follow
/// the central film, each film itself, and all others both films. Where none serves one, the tolerances stay as they
/// are.
[[nodiscard]] Request request_for(const Request& request, const Wanted& wanted);

/// With request_for(request, wanted). Throws StatementError where the statement makes no problem (a case from read_case
/// always makes one).
[[nodiscard]] Plan plan_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                                const Wanted& wanted);

/// The quantities that a plan observes.
[[nodiscard]] Wanted wanted_by(const Plan& plan);

}  // namespace ehd
