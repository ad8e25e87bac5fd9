// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and film of each contact case by both solvers, and how far they are apart.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "contact/stated_error.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "verification/studies/figures/curves.hpp"
#include "verification/studies/figures/parts.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd::verification {

namespace {

constexpr Request profile_request{.tolerance = 1e-4, .time_limit_s = 60};
constexpr double chord_error = 1e-3;  ///< of a drawn chord: share of the largest pressure, and of the local film
constexpr std::size_t most_points = 400;
constexpr double moderate_M = 60;  ///< above it `reference` takes seconds: left out with --quick

bool only_waits(const Case& one) {
  return !one.expectations.empty() && std::all_of(one.expectations.begin(), one.expectations.end(),
                                                  [](const Expectation& expectation) { return expectation.waiting; });
}

/// Fields as functions, between the nodes too.
struct Functions {
  explicit Functions(const ContactRun& run)
      : pressure(run.solution.fields.X, run.solution.fields.P, run.solution.fields.elements),
        film(run.solution.fields.X, run.solution.fields.H, run.solution.fields.elements),
        cut(pressure_cut(run)) {}
  Profile pressure, film;
  std::optional<double> cut;  ///< pressures are shown up to here

  [[nodiscard]] double shown(double P) const { return cut ? std::min(P, *cut) : P; }

  [[nodiscard]] std::pair<double, double> at(double X) const {
    std::size_t low = 0, high = pressure.pieces();
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (pressure.end(middle) <= X ? low : high) = middle;
    }
    return {shown(pressure.value(low, X)), film.value(low, X)};
  }
};

std::optional<Functions> functions_of(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  if (run.status() == StopReason::diverged || fields.X.size() < 2) return std::nullopt;
  if (!fields.P.allFinite() || !fields.H.allFinite() || !(fields.H.minCoeff() > 0)) return std::nullopt;
  return Functions(run);
}

/// The drawn part of X: from a hundredth of the largest pressure (at most -2, at least the inlet) to 0.3 max(1, X*)
/// behind the exit.
struct Region {
  double left = 0, right = 0;
};
Region region_of(const Fields& fields) {
  constexpr double share = 0.01, usual_left = -2, behind = 0.3;
  const double threshold = share * fields.P.maxCoeff();
  Eigen::Index first = 0;
  while (first + 1 < fields.X.size() && fields.P[first] < threshold) ++first;
  const double exit = fields.X[fields.X.size() - 1];
  return {std::max(fields.X[0], std::min(usual_left, fields.X[first])), exit + behind * std::max(1.0, exit)};
}

/// Abscissae so close that curves look straight between them: the nodes, and points within elements.
std::vector<double> dense_places(const Fields& fields, double left) {
  std::vector<double> places;
  const Eigen::Index last = fields.X.size() - 1;
  const auto take = [&](double X) {
    if (X > left && (places.empty() || X > places.back())) places.push_back(X);
  };
  places.push_back(left);
  if (fields.elements.empty()) {
    for (Eigen::Index i = 0; i <= last; ++i) take(fields.X[i]);
  } else {
    for (std::size_t k = 0; k + 1 < fields.elements.size(); ++k) {
      const double from = fields.X[fields.elements[k]], to = fields.X[fields.elements[k + 1]];
      const auto parts = 6 * (fields.elements[k + 1] - fields.elements[k]);
      for (Eigen::Index i = 0; i <= parts; ++i)
        take(i == parts ? to : from + (to - from) * static_cast<double>(i) / static_cast<double>(parts));
    }
  }
  return places;
}

std::vector<double> taken(const std::vector<double>& values, const Thinning& thinning) {
  std::vector<double> kept;
  for (const std::size_t i : thinning.kept) kept.push_back(values[i]);
  return kept;
}

void put_curves(Json& json, const Fields& fields, const Functions& functions) {
  const Region region = region_of(fields);
  std::vector<double> X = dense_places(fields, region.left), P, H;
  for (const double x : X) {
    const auto [pressure, film] = functions.at(x);
    P.push_back(pressure);
    H.push_back(film);
  }
  P.back() = 0;  // the exit
  constexpr int gap_points = 60;
  const double exit = X.back(), exit_film = H.back();
  for (int i = 1; i <= gap_points; ++i) {
    const double t = static_cast<double>(i) / gap_points;
    X.push_back(exit + (region.right - exit) * t * t);  // closer at the exit, where the gap bends
    P.push_back(0);
    H.push_back(exit_film + gap_behind_exit(functions.pressure, X.back()));
  }
  ThinnedCurve pressure{.values = P,
                        .allowed = std::vector<double>(P.size(), chord_error * functions.shown(fields.P.maxCoeff()))};
  ThinnedCurve film{.values = H, .allowed = H};
  for (double& allowed : film.allowed) allowed *= chord_error;
  const Thinning thinning = thin(X, {pressure, film}, most_points);
  json["chord_error"] = chord_error * thinning.factor;
  json["X"] = taken(X, thinning);
  json["P"] = taken(P, thinning);
  json["H"] = taken(H, thinning);
}

Json solver_json(const ContactRun& run) {
  Json whole = to_json(run), json = Json::object();
  json["solver"] = run.solver;
  json["tolerance"] = profile_request.tolerance.tightest();
  json["status"] = to_string(run.status());
  if (!run.solution.record.reason.empty()) json["reason"] = run.solution.record.reason;
  const Cost& cost = run.solution.record.cost;
  put(json, "wall_s", cost.wall_s);
  if (cost.nodes > 0) {
    put(json, "work_units", cost.work_units);
    json["nodes"] = cost.nodes;
  }
  json["newton_iterations"] = cost.newton_iterations;
  for (const char* film : {"minimum", "central"})
    if (whole.contains("film") && whole["film"].contains(film)) json["film"][film] = whole["film"][film];
  if (whole.contains("pressure")) json["pressure"] = whole["pressure"];
  put(json, "field_error", field_error(run.solution));
  put(json, "pressure_cut", pressure_cut(run));
  return json;
}

/// fast - reference on the nodes of fast, between the later inlet and the earlier exit. Only the reference is
/// interpolated, by its own polynomials.
std::optional<Json> difference_json(const ContactRun& reference, const Functions& truth, const ContactRun& fast,
                                    const Functions& other) {
  const Fields& fields = fast.solution.fields;
  const double left = region_of(reference.solution.fields).left;
  std::vector<double> X, P, H;
  for (Eigen::Index i = 0; i < fields.X.size(); ++i) {
    if (fields.X[i] < std::max(left, truth.pressure.first()) || fields.X[i] > truth.pressure.last()) continue;
    const auto [pressure, film] = truth.at(fields.X[i]);
    X.push_back(fields.X[i]);
    P.push_back(other.shown(fields.P[i]) - pressure);
    H.push_back(fields.H[i] / film - 1);
  }
  if (X.size() < 2) return std::nullopt;
  const auto curve = [](const std::vector<double>& values) {
    double largest = std::numeric_limits<double>::min();
    for (const double value : values) largest = std::max(largest, std::abs(value));
    constexpr double share = 0.01;  // a difference is drawn for its size and place
    return ThinnedCurve{.values = values, .allowed = std::vector<double>(values.size(), share * largest)};
  };
  const Thinning thinning = thin(X, {curve(P), curve(H)}, most_points);
  Json json = {{"of", fast.solver + " - " + reference.solver},
               {"X", taken(X, thinning)},
               {"P", taken(P, thinning)},
               {"H_relative", taken(H, thinning)}};
  std::optional<double> stated;
  for (const auto& [quantity, key] :
       {std::pair{Quantity::film_minimum, "film_minimum"}, std::pair{Quantity::film_central, "film_central"}}) {
    const auto a = reference.solution.observables.find(quantity), b = fast.solution.observables.find(quantity);
    if (a == reference.solution.observables.end() || b == fast.solution.observables.end()) continue;
    put(json, key, b->second.value / a->second.value - 1);
    if (a->second.error && b->second.error) stated = std::max(stated.value_or(0), *a->second.error + *b->second.error);
  }
  put(json, "stated", stated);
  return json;
}

/// A string of a case file without its quotation marks.
std::string unquoted(const std::string& text) {
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

Json case_json(const Case& one) {
  const auto& contact = std::get<ContactCase>(one.body);
  const ContactRun reference = run_contact(one, certified_solver(), profile_request),
                   fast = run_contact(one, default_solver(), profile_request);
  Json json = Json::object();
  json["id"] = one.id;
  json["version"] = one.version;
  json["title"] = one.title;
  json["source"] = one.source;
  json["viscosity"] = unquoted(one.places.at("lubricant.viscosity").text);
  json["density"] = unquoted(one.places.at("lubricant.density").text);
  const auto* cut = std::get_if<TruncatedAt>(&*contact.inlet);
  json["inlet"] = cut ? Json(cut->x) : Json("flooded");
  if (reference.groups) {
    put(json, "M", reference.groups->M);
    put(json, "L", reference.groups->L);
  }
  if (reference.scales) {
    if (reference.scales->hertz_pressure_Pa > 0) put(json, "p_H_Pa", reference.scales->hertz_pressure_Pa);
    put(json, "half_width_m", reference.scales->half_width_m);
  }
  const auto truth = functions_of(reference), other = functions_of(fast);
  json["solvers"] = Json::array();
  for (const auto& [run, functions] : {std::pair{&reference, &truth}, std::pair{&fast, &other}}) {
    Json solver = solver_json(*run);
    if (*functions) put_curves(solver, run->solution.fields, **functions);
    json["solvers"].push_back(std::move(solver));
  }
  if (truth && other) {
    if (auto difference = difference_json(reference, *truth, fast, *other)) json["difference"] = std::move(*difference);
  }
  return json;
}

}  // namespace

FigurePart profile_part(const std::vector<Case>& cases, bool quick) {
  FigurePart part{.name = "cases"};
  auto results = std::make_shared<std::vector<Json>>(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto* contact = std::get_if<ContactCase>(&cases[i].body);
    if (!contact || contact->dry() || only_waits(cases[i])) continue;
    const double M = nondimensionalise(contact->statement, *contact->lubricant, *contact->inlet).problem.groups.M;
    if (quick && M > moderate_M) continue;
    part.work.push_back(
        {"profiles of " + cases[i].id, [results, i, one = cases[i]] { (*results)[i] = case_json(one); }});
  }
  part.finish = [results](Json& figures) {
    Json list = Json::array();
    for (Json& one : *results)
      if (!one.is_null()) list.push_back(std::move(one));
    if (!list.empty()) figures["cases"] = std::move(list);
  };
  return part;
}

}  // namespace ehd::verification
