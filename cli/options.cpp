// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

constexpr int fewest_nodes = 16;
constexpr allowed::Integer node_counts{.low = fewest_nodes, .high = std::numeric_limits<int>::max()};
constexpr allowed::Integer iteration_counts{.low = 1, .high = std::numeric_limits<int>::max()};
constexpr allowed::Integer thread_counts{.low = 1, .high = 1024};
constexpr Interval tolerances{.low = 0, .high = loosest_tolerance, .open_low = true};
constexpr Interval times_s{.low = 0, .high = 1e9, .open_low = true};  // longer times overflow the clock

}  // namespace

void RequestOptions::add_to(Command& command, bool with_accuracy) {
  if (with_accuracy) {
    command
        .text("--tolerance", tolerance,
              "relative error allowed in the minimum and central film (1e-3); with --quantity, in those that it needs")
        .called("T");
    command.text("--tolerance-minimum", tolerance_minimum, "instead, of the minimum film").called("T");
    command.text("--tolerance-central", tolerance_central, "instead, of the central film; one or both").called("T");
    command.text("--nodes", nodes, "intervals on the finest grid instead, inlet to exit, at least 16").called("N");
  }
  command.text("--max-iterations", max_iterations, "Newton iterations over all grids (2000)").called("I");
  command.text("--time-limit", time_limit, "seconds for each solve (300)").called("S");
}

Request RequestOptions::request() const {
  Request request;
  const bool of_a_film = tolerance_minimum || tolerance_central;
  if (tolerance && nodes) throw UsageError("--tolerance and --nodes exclude each other; allowed is one of them");
  if (of_a_film && (tolerance || nodes))
    throw UsageError(fmt::format("{} and {} exclude each other; allowed is one of them",
                                 tolerance_minimum ? "--tolerance-minimum" : "--tolerance-central",
                                 tolerance ? "--tolerance" : "--nodes"));
  if (of_a_film) {
    request.tolerance = {};
    if (tolerance_minimum)
      request.tolerance.minimum = parse_number("--tolerance-minimum", *tolerance_minimum, tolerances);
    if (tolerance_central)
      request.tolerance.central = parse_number("--tolerance-central", *tolerance_central, tolerances);
  }
  if (tolerance) request.tolerance = parse_number("--tolerance", *tolerance, tolerances);
  if (nodes) {
    request.nodes = parse_integer("--nodes", *nodes, node_counts);
    request.tolerance = {};
  }
  if (max_iterations) request.max_iterations = parse_integer("--max-iterations", *max_iterations, iteration_counts);
  if (time_limit) request.time_limit_s = parse_number("--time-limit", *time_limit, times_s);
  return request;
}

void RequestOptions::require_wanted(const Wanted& wanted) const {
  const auto require = [&](const char* option, const std::optional<std::string>& text, Quantity film) {
    if (!text || serves(film, wanted)) return;
    std::string names;
    for (const Quantity quantity : wanted) names.append(names.empty() ? "" : ", ").append(to_string(quantity));
    throw option_error(option, *text,
                       fmt::format("is of a film that the chosen {} {} not need; leave it out, or add --quantity {}",
                                   names, wanted.size() == 1 ? "does" : "do", to_string(film)));
  };
  require("--tolerance-minimum", tolerance_minimum, Quantity::film_minimum);
  require("--tolerance-central", tolerance_central, Quantity::film_central);
}

const RegisteredSolver& solver_named(const std::string& name) {
  const auto* solver = find_solver(name);
  if (!solver) throw unknown_word_error("--solver", name, solver_names());
  return *solver;
}

Wanted quantities_named(const std::vector<std::string>& names) {
  if (names.empty()) return want_everything();
  Wanted wanted;
  for (const auto& name : names) {
    const auto quantity = quantity_from(name);
    if (!quantity) throw unknown_word_error("--quantity", name, names_of_quantities([](Quantity) { return true; }));
    wanted.insert(*quantity);
  }
  return wanted;
}

std::vector<bearing::Law> laws_named(const std::vector<std::string>& names) {
  std::vector<bearing::Law> laws;
  for (const auto& name : names) {
    const auto law = bearing::law_from(name);
    if (!law) throw unknown_word_error("--law", name, bearing::names_of(bearing::Laws::all));
    if (std::find(laws.begin(), laws.end(), *law) == laws.end()) laws.push_back(*law);
  }
  return laws;
}

unsigned thread_count(const std::optional<std::string>& text) {
  if (!text) return 0;
  return static_cast<unsigned>(parse_integer("--threads", *text, thread_counts));
}

void add_time_limit_total(Command& command, std::optional<std::string>& text) {
  command
      .text("--time-limit-total", text, "seconds for the whole command; what is not finished by then is named (none)")
      .called("S");
}

Deadline deadline_in(const std::optional<std::string>& text) {
  return text ? Deadline(parse_number("--time-limit-total", *text, times_s)) : Deadline();
}

void require_memory(const RegisteredSolver& solver, const Request& request) {
  if (!request.nodes) return;
  constexpr double gigabyte = 1e9;
  const double needed = solver.memory_bytes(*request.nodes);
  const double available = available_memory_bytes();
  if (needed <= available) return;
  int fitting = *request.nodes;
  while (fitting > fewest_nodes && solver.memory_bytes(fitting) > available) fitting /= 2;
  throw option_error(
      "--nodes", std::to_string(*request.nodes),
      fmt::format("would not fit into memory ({} needs about {} GB, available are {} GB); allowed is up to about {}",
                  solver.name, plain(needed / gigabyte, 2), plain(available / gigabyte, 2), fitting));
}

}  // namespace ehd::cli
