// SPDX-License-Identifier: GPL-3.0-or-later
// How errors fall with the grid: films of cases against their certified digits, and every scheme against the
// manufactured solutions of rung 5. Orders are fitted here; solvers declare theirs, and rungs 5 and 8 judge them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "contact/observables.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "verification/studies/figures/parts.hpp"
#include "verification/studies/fits.hpp"
#include "verification/studies/manufactured_study.hpp"
#include "verification/studies/solver_lists.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

struct SeriesPoint {
  double n = 0, error = 0, uncertainty = 0;  ///< relative; for manufactured solutions absolute
  StopReason status = StopReason::converged;
};

struct Series {
  std::string id, title, solver, contact_case, quantity;
  std::string abscissa = "intervals";
  std::optional<double> declared_order = {};   ///< algebraic
  std::optional<double> declared_factor = {};  ///< geometric in the degree
  bool geometric = false;
  std::vector<SeriesPoint> points = {};
};

/// The last four converged points whose error is above ten times its uncertainty and above what the iteration leaves.
/// Of a geometric study every converged point, as in its claim.
std::vector<SeriesPoint> fitted_points(const Series& series) {
  constexpr std::size_t most = 4;
  constexpr double clear_of = 10, iterated_to = 1e-10;
  std::vector<SeriesPoint> fitted;
  for (const SeriesPoint& point : series.points)
    if (point.status == StopReason::converged &&
        (series.geometric || point.error > std::max(clear_of * point.uncertainty, iterated_to)))
      fitted.push_back(point);
  if (!series.geometric && fitted.size() > most)
    fitted.erase(fitted.begin(), fitted.end() - static_cast<std::ptrdiff_t>(most));
  return fitted;
}

Json to_json(const Series& series) {
  Json json = {{"id", series.id},
               {"title", series.title},
               {"solver", series.solver},
               {"case", series.contact_case},
               {"quantity", series.quantity},
               {"abscissa", series.abscissa},
               {"kind", series.geometric ? "geometric" : "algebraic"}};
  put(json, "declared_order", series.declared_order);
  put(json, "declared_factor", series.declared_factor);
  const auto fitted = fitted_points(series);
  constexpr std::size_t least = 4;  // an order is fitted to at least four grids
  if (fitted.size() >= least) {
    std::vector<double> x, y;
    for (const SeriesPoint& point : fitted) {
      x.push_back(series.geometric ? point.n : std::log(point.n));
      y.push_back(std::log(point.error));
    }
    const double fitted_slope = slope(x, y);
    if (!series.geometric) put(json, "fitted_order", -fitted_slope);
    if (series.declared_factor) put(json, "fitted_factor", std::exp(-fitted_slope));
    json["fitted_points"] = fitted.size();
  }
  json["points"] = Json::array();
  for (const SeriesPoint& point : series.points) {
    Json entry = Json::object();
    put(entry, "n", point.n);
    put(entry, "error", point.error);
    put(entry, "uncertainty", point.uncertainty);
    if (point.status != StopReason::converged) entry["status"] = to_string(point.status);
    if (entry.contains("error")) json["points"].push_back(std::move(entry));
  }
  return json;
}

// -- grids against certified digits ---------------------------------------------------------------------------------

/// The expectation with the most digits.
const Expectation* certified(const Case& one, const std::string& quantity) {
  const Expectation* best = nullptr;
  for (const Expectation& expectation : one.expectations) {
    if (expectation.quantity != quantity || expectation.waiting || expectation.kind == ExpectationKind::fit) continue;
    if (!best || expectation.uncertainty < best->uncertainty) best = &expectation;
  }
  return best;
}

void add_point(Series& series, const ContactRun& run, const Expectation& truth, double n) {
  const auto measured = measure(run, truth);
  if (!measured || run.status() == StopReason::diverged || run.status() == StopReason::limit_reached) return;
  series.points.push_back({.n = n,
                           .error = std::abs(measured->value / truth.value - 1),
                           .uncertainty = truth.uncertainty,
                           .status = run.status()});
}

std::vector<Series> film_series(const Case& one, const std::string& solver, const std::string& title) {
  std::vector<Series> list;
  for (const Quantity quantity : judged_films) {
    const std::string film(to_string(quantity));
    list.push_back({.id = fmt::format("grids/{}/{}/{}", one.id, solver, film),
                    .title = fmt::format("{}{} of {}", title, film, one.id),
                    .solver = solver,
                    .contact_case = one.id,
                    .quantity = film});
  }
  return list;
}

/// The film on the finest grid in Hertz units. The reported film may be an extrapolation.
std::optional<double> own_film(const ContactRun& run, const std::string& quantity) {
  const auto& grids = run.solution.record.grids;
  const auto name = quantity_from(quantity);
  if (grids.empty() || !name) return std::nullopt;
  const auto at = grids.back().observed.find(*name);
  return at == grids.back().observed.end() ? std::nullopt : std::optional(at->second.value);
}

/// Orders are declared for smooth solutions. Equal cells do not resolve a spike, so beside one H_min has no order.
bool has_spike(const Case& one, const ContactRun& run) {
  const auto* contact = std::get_if<ContactCase>(&one.body);
  return contact && contact->lubricant && contact->lubricant->viscosity != ViscosityLaw::isoviscous &&
         run.solution.fields.X.size() > 2 &&
         observe(run.solution.fields, {Quantity::pressure_spike}).contains(Quantity::pressure_spike);
}

/// The reported films. Where they are extrapolated, the films of the grids are added, to which the declared order
/// belongs.
std::vector<Series> grid_series(const Case& one, const RegisteredSolver& solver, const std::vector<int>& grids) {
  auto reported = film_series(one, solver.name, solver.name + ": ");
  auto own = film_series(one, solver.name, solver.name + ", each grid's own: ");
  bool extrapolated = false, spike = false;
  for (const int intervals : grids) {
    const ContactRun run = run_contact(one, solver, {.tolerance = {}, .nodes = intervals});
    if (run.status() == StopReason::converged) spike = has_spike(one, run);  // the finest grid decides
    for (std::size_t i = 0; i < reported.size(); ++i) {
      const Expectation* truth = certified(one, reported[i].quantity);
      if (!truth) continue;
      add_point(reported[i], run, *truth, intervals);
      const auto film = own_film(run, own[i].quantity);
      if (!film || truth->scaling != Scaling::hertz || reported[i].points.empty()) continue;
      SeriesPoint point = reported[i].points.back();
      point.error = std::abs(*film / truth->value - 1);
      extrapolated = extrapolated || point.error != reported[i].points.back().error;
      own[i].points.push_back(point);
    }
  }
  for (Series& series : extrapolated ? own : reported) {
    if (spike && series.quantity == "film.minimum") {
      series.title += " (with a spike: no order is declared)";
    } else {
      series.declared_order = solver.description.formal_order;
    }
  }
  if (!extrapolated) return reported;
  for (Series& series : reported)
    series.title = fmt::format("{}, extrapolated: {} of {}", solver.name, series.quantity, one.id);
  for (Series& series : own) {
    series.id += "/own";
    reported.push_back(std::move(series));
  }
  return reported;
}

/// The certified solver with tighter and tighter tolerances. Its meshes and degrees adapt: no order is declared.
std::vector<Series> tolerance_series(const Case& one, const std::vector<double>& tolerances) {
  const RegisteredSolver& solver = certified_solver();
  auto list = film_series(one, solver.name, solver.name + ", asked for more and more digits: ");
  for (Series& series : list) {
    series.abscissa = "unknowns";
    series.geometric = true;
  }
  for (const double tolerance : tolerances) {
    const ContactRun run = run_contact(one, solver, {.tolerance = tolerance});
    for (Series& series : list)
      if (const Expectation* truth = certified(one, series.quantity))
        add_point(series, run, *truth, run.solution.record.cost.nodes);
  }
  // Two tolerances may end on one mesh: the tighter one is kept.
  for (Series& series : list) {
    std::vector<SeriesPoint> points;
    for (const SeriesPoint& point : series.points) {
      if (!points.empty() && points.back().n >= point.n) points.pop_back();
      points.push_back(point);
    }
    series.points = std::move(points);
  }
  return list;
}

// -- manufactured solutions ---------------------------------------------------------------------------------------

Series manufactured(const std::string& id, const std::string& title, const std::string& solver,
                    const ManufacturedContact& contact, const std::string& quantity) {
  return {.id = fmt::format("manufactured/{}/{}", contact.name, id),
          .title = title,
          .solver = solver,
          .contact_case = "manufactured, " + contact.name,
          .quantity = quantity};
}

void add_error(Series& series, double n, double error) {
  if (std::isfinite(error)) series.points.push_back({.n = n, .error = error});
}

std::vector<Series> manufactured_solver(const ManufacturedContact& contact, const RegisteredSolver& solver) {
  const exact::Manufactured truth = contact.make();
  std::vector<Series> list;
  for (const auto& [quantity, member] : manufactured_quantities) {
    list.push_back(manufactured(solver.name + "/" + quantity,
                                fmt::format("{}: manufactured {}, {}", solver.name, quantity, contact.name),
                                solver.name, contact, quantity));
    list.back().declared_order = solver.description.formal_order;
  }
  for (const int intervals : manufactured_grids) {
    const ManufacturedErrors errors = errors_of_solver(solver, truth, intervals);
    for (std::size_t i = 0; i < list.size(); ++i)
      add_error(list[i], intervals, errors.*manufactured_quantities[i].second);
  }
  return list;
}

std::vector<Series> manufactured_in_h(const ManufacturedContact& contact, int degree) {
  const exact::Manufactured truth = contact.make();
  const std::string& name = certified_solver().name;
  Series series =
      manufactured(fmt::format("collocation/degree-{}", degree),
                   fmt::format("{}'s collocation, degree {}: manufactured pressure, {}", name, degree, contact.name),
                   name, contact, "pressure");
  series.abscissa = "unknowns";
  series.declared_order = degree + 1;
  for (const int elements : collocation_elements)
    add_error(series, elements * degree, errors_of_collocation(truth, elements, degree).pressure);
  return {series};
}

std::vector<Series> manufactured_in_p(const ManufacturedContact& contact) {
  const exact::Manufactured truth = contact.make();
  const std::string& name = certified_solver().name;
  Series series = manufactured("collocation/spectral",
                               fmt::format("{}'s collocation on {} elements: manufactured pressure, {}", name,
                                           collocation_elements_in_p, contact.name),
                               name, contact, "pressure");
  series.abscissa = "degree";
  series.geometric = true;
  series.declared_factor = bernstein_factor(truth, collocation_elements_in_p);
  for (const int degree : collocation_degrees)
    add_error(series, degree, errors_of_collocation(truth, collocation_elements_in_p, degree).pressure);
  return {series};
}

/// Intervals of a study, each twice those before. Equal cells need more to resolve the inlet.
std::vector<int> grids_of(const RegisteredSolver& solver, bool quick) {
  const int first = solver.uses_fft && on_equal_cells(solver) ? 128 : 64;
  const int last = first * (solver.dense() ? (quick ? 4 : 16) : (quick ? 16 : 128));
  std::vector<int> grids;
  for (int intervals = first; intervals <= last; intervals *= 2) grids.push_back(intervals);
  return grids;
}

}  // namespace

FigurePart convergence_part(bool with_manufactured, bool with_grids, bool quick) {
  FigurePart part{.name = "convergence"};
  using Results = std::vector<std::vector<Series>>;
  auto results = std::make_shared<Results>();
  const auto add = [&](const std::string& name, std::function<std::vector<Series>()> make) {
    const std::size_t i = results->size();
    results->emplace_back();
    part.work.push_back({"convergence of " + name, [results, i, make = std::move(make)] { (*results)[i] = make(); }});
  };
  if (with_grids) {
    std::vector<std::string> ids{"own-moes-20-10"};
    if (!quick) ids.insert(ids.end(), {"own-moes-5-5", "own-barus-20-5", "own-moes-200-15"});
    std::vector<double> tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    if (quick) tolerances.resize(4);
    for (const std::string& id : ids) {
      const std::filesystem::path file = cases_folder() / (id + ".toml");
      std::error_code missing;
      if (!std::filesystem::exists(file, missing)) continue;  // another folder of cases
      for (const RegisteredSolver* solver : second_order_solvers())
        add(solver->name + " on " + id,
            [file, solver, grids = grids_of(*solver, quick)] { return grid_series(read_case(file), *solver, grids); });
      add(certified_solver().name + " on " + id,
          [file, tolerances] { return tolerance_series(read_case(file), tolerances); });
    }
  }
  if (with_manufactured) {
    for (const ManufacturedContact& contact : manufactured_contacts) {
      if (quick && contact.name != manufactured_contacts[0].name) continue;
      for (const RegisteredSolver* solver : second_order_solvers()) {
        if (quick && solver->dense()) continue;  // dense grids take seconds
        add(solver->name + ", manufactured", [&contact, solver] { return manufactured_solver(contact, *solver); });
      }
      if (!quick)
        for (const int degree : {2, 3})
          add("collocation in h", [&contact, degree] { return manufactured_in_h(contact, degree); });
      add("collocation in p", [&contact] { return manufactured_in_p(contact); });
    }
  }
  part.finish = [results](Json& figures) {
    Json list = Json::array();
    for (const auto& made : *results)
      for (const Series& series : made)
        if (!series.points.empty()) list.push_back(to_json(series));
    if (!list.empty()) figures["convergence"] = std::move(list);
  };
  return part;
}

}  // namespace ehd::verification
