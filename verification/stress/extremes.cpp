// SPDX-License-Identifier: GPL-3.0-or-later
// (g) Inputs as nobody should give them. Random SI cases over many decades; every number of the interface replaced by
// zero, negative, denormal, huge and not-a-number; limits of time and iterations. Inside the box the answer is right,
// outside right or refused; never NaN, never a hang. Each batch runs in a process of its own with an alarm, so that a
// crash or a hang is a row.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/json.hpp"
#include "verification/bench/child.hpp"
#include "verification/stress/parts.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned seed = 20261125;
constexpr double asked = 1e-3, time_limit_s = 5;
/// Of the random cases inside the box every so many-th is solved by `reference` as well, outside by reference.linear.
constexpr int inside_a_truth = 8, outside_a_truth = 20;
/// A limit may be passed by one step that cannot be interrupted: a dense factorisation, a grid's tables; and by other
/// processes.
constexpr double slack_s = 2;

std::string text_of(const Conditions& c, const Lubricant& l) {
  const auto number = [](const std::optional<double>& value) {
    return value ? plain(*value, 17) : std::string("absent");
  };
  return "load " + plain(c.load_N_per_m, 17) + " N/m, R " + plain(c.reduced_radius_m, 17) + " m, E' " +
         plain(c.reduced_modulus_Pa, 17) + " Pa, u_s " + number(c.speed_sum_m_per_s) + " m/s, eta_0 " +
         number(c.viscosity_Pa_s) + " Pa s, " + std::string(to_string(l.viscosity)) + ", " +
         std::string(to_string(l.density)) + ", alpha " + number(l.alpha_per_Pa) + ", z " + number(l.z) + ", p_0 " +
         plain(l.p0_Pa, 17);
}

/// What the box is about, from what is stated; NaN where something is missing.
struct BoxAxes {
  double M, L, hertz_pressure_Pa;
};

BoxAxes axes_of(const Statement& statement, const Lubricant& lubricant) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const bool piezoviscous = lubricant.viscosity != ViscosityLaw::isoviscous;
  const double alpha = lubricant.alpha_per_Pa.value_or(unknown);
  if (const auto* SI = std::get_if<Conditions>(&statement)) {
    const double w = SI->load_N_per_m, R = SI->reduced_radius_m, E = SI->reduced_modulus_Pa;
    const double eta_u = SI->viscosity_Pa_s.value_or(unknown) * SI->speed_sum_m_per_s.value_or(unknown);
    return {w / std::sqrt(eta_u * E * R), piezoviscous ? alpha * E * std::sqrt(std::sqrt(eta_u / (E * R))) : 0,
            std::sqrt(w * E / (2 * std::numbers::pi * R))};
  }
  const auto* moes = std::get_if<MoesGroups>(&statement);
  const auto* hertz = std::get_if<HertzGroups>(&statement);
  const double pi = std::numbers::pi;
  const double M = moes ? moes->M : pi * std::sqrt(3 / (8 * hertz->lambda));
  const double L = moes ? moes->L : hertz->alpha_p_H * std::sqrt(2 * pi / M);
  const double alpha_p_H = moes ? L * std::sqrt(M / (2 * pi)) : hertz->alpha_p_H;
  return {M, L, L == 0 ? 0 : alpha_p_H / alpha};
}

}  // namespace

bool in_the_box(const Statement& statement, const Lubricant& lubricant, const Inlet& inlet) {
  const auto [M, L, p_H] = axes_of(statement, lubricant);
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  const double z = lubricant.z.value_or(0.6);
  return M >= 0.05 && M <= 5000 && L >= 0 && L <= 30 && p_H >= 0 && p_H <= highest_pressure_Pa && z >= 0.1 &&
         z <= 1.2 && lubricant.p0_Pa >= 1e7 && lubricant.p0_Pa <= 1e10 &&
         (L == 0 || std::isfinite(lubricant.p0_Pa / p_H)) &&  // else pressures in p_H are no numbers
         (!cut || (M >= 2 && cut->x >= -100 && cut->x <= -2.5));
}

namespace {

/// What the interface makes of a statement, and the solvers of the problem.
ExtremeRow tried(const std::string& kind, const std::string& what, const Statement& statement,
                 const Lubricant& lubricant, const Inlet& inlet, int number) {
  ExtremeRow row{
      .kind = kind, .what = what, .inside = in_the_box(statement, lubricant, inlet), .time_limit_s = time_limit_s};
  const auto begin = Clock::now();
  try {
    const Nondimensional made = nondimensionalise(statement, lubricant, inlet);
    const Request request{.tolerance = asked, .time_limit_s = time_limit_s};
    row.fast = ended(find_solver("fast")->solve(made.problem, request));
    row.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
    if (row.inside && number % inside_a_truth == 0)
      row.other = ended(find_solver("reference")->solve(made.problem, {.tolerance = asked, .time_limit_s = 30}));
    else if (!row.inside && number % outside_a_truth == 0)
      row.other = ended(
          find_solver("reference.linear")->solve(made.problem, {.tolerance = asked, .time_limit_s = time_limit_s}));
  } catch (const StatementError& refused) {
    row.refused = refused.key() + ": " + refused.what();
  } catch (const std::exception& thrown) {
    row.broke = std::string("threw ") + thrown.what();
  }
  return row;
}

/// Decades as the task of this part names them: loads nine, speeds nine, viscosities six.
ExtremeRow random_case(Draw& draw, int number) {
  const Conditions SI{.load_N_per_m = draw.logarithmic(1e-1, 1e8),
                      .reduced_radius_m = draw.logarithmic(1e-4, 1),
                      .reduced_modulus_Pa = draw.logarithmic(1e9, 1e12),
                      .speed_sum_m_per_s = draw.logarithmic(1e-6, 1e3),
                      .viscosity_Pa_s = draw.logarithmic(1e-4, 1e2)};
  Lubricant lubricant;
  const int law = draw.index(8);
  lubricant.viscosity = law == 0 ? ViscosityLaw::isoviscous : law < 4 ? ViscosityLaw::barus : ViscosityLaw::roelands;
  lubricant.density = draw.index(2) == 0 ? DensityLaw::incompressible : DensityLaw::dowson_higginson;
  lubricant.alpha_per_Pa = law == 0 ? 0 : draw.uniform(0, 4e-8);
  if (lubricant.viscosity == ViscosityLaw::roelands) lubricant.z = draw.uniform(0.3, 1);
  return tried("random SI", text_of(SI, lubricant), SI, lubricant, Flooded{}, number);
}

/// One number of a sound statement replaced by each value that numbers can go wrong with.
std::vector<ExtremeRow> impossible_inputs(const Scope& scope) {
  using limits = std::numeric_limits<double>;
  std::vector<double> values{0.0,
                             -0.0,
                             -1.0,
                             limits::denorm_min(),
                             limits::min(),
                             1e-200,
                             1e-30,
                             1e30,
                             1e200,
                             limits::max(),
                             -limits::max(),
                             limits::infinity(),
                             -limits::infinity(),
                             limits::quiet_NaN()};
  if (scope.quick) values = {0.0, -1.0, limits::denorm_min(), limits::max(), limits::infinity(), limits::quiet_NaN()};
  struct Stated {
    Conditions SI{.load_N_per_m = 1.1e5,
                  .reduced_radius_m = 0.0113,
                  .reduced_modulus_Pa = 2.26e11,
                  .speed_sum_m_per_s = 2.9,
                  .viscosity_Pa_s = 0.021};
    MoesGroups moes{7, 6};
    HertzGroups hertz{1.51425, 2.832};
    Lubricant lubricant{.viscosity = ViscosityLaw::roelands,
                        .density = DensityLaw::dowson_higginson,
                        .alpha_per_Pa = 1.9e-8,
                        .z = 0.68,
                        .p0_Pa = 1.96e8};
    double inlet = -4;
  };
  struct Place {
    const char* name;
    double& (*of)(Stated&);
  };
  const Place of_SI[] = {{"load", [](Stated& s) -> double& { return s.SI.load_N_per_m; }},
                         {"radius", [](Stated& s) -> double& { return s.SI.reduced_radius_m; }},
                         {"modulus", [](Stated& s) -> double& { return s.SI.reduced_modulus_Pa; }},
                         {"speed", [](Stated& s) -> double& { return *s.SI.speed_sum_m_per_s; }},
                         {"viscosity", [](Stated& s) -> double& { return *s.SI.viscosity_Pa_s; }}};
  const Place of_moes[] = {{"M", [](Stated& s) -> double& { return s.moes.M; }},
                           {"L", [](Stated& s) -> double& { return s.moes.L; }}};
  const Place of_hertz[] = {{"lambda", [](Stated& s) -> double& { return s.hertz.lambda; }},
                            {"alpha_p_H", [](Stated& s) -> double& { return s.hertz.alpha_p_H; }}};
  const Place of_all[] = {{"alpha", [](Stated& s) -> double& { return *s.lubricant.alpha_per_Pa; }},
                          {"z", [](Stated& s) -> double& { return *s.lubricant.z; }},
                          {"p0", [](Stated& s) -> double& { return s.lubricant.p0_Pa; }},
                          {"inlet", [](Stated& s) -> double& { return s.inlet; }}};
  std::vector<ExtremeRow> rows;
  for (const char* way : {"conditions", "moes", "hertz"}) {
    const std::string by = way;
    std::vector<Place> places(std::begin(of_all), std::end(of_all));
    if (by == "conditions") places.insert(places.begin(), std::begin(of_SI), std::end(of_SI));
    if (by == "moes") places.insert(places.begin(), std::begin(of_moes), std::end(of_moes));
    if (by == "hertz") places.insert(places.begin(), std::begin(of_hertz), std::end(of_hertz));
    for (const Place& place : places) {
      for (const double value : values) {
        Stated stated;
        place.of(stated) = value;
        const Statement statement = by == "conditions" ? Statement{stated.SI}
                                    : by == "moes"     ? Statement{stated.moes}
                                                       : Statement{stated.hertz};
        rows.push_back(tried("impossible inputs", by + ", " + place.name + " = " + plain(value, 3), statement,
                             stated.lubricant, TruncatedAt{stated.inlet}, 0));
      }
    }
  }
  return rows;
}

/// Every solver with little time or few iterations, on a problem that needs more, and with limits that are no limits.
std::vector<ExtremeRow> hurried(const Scope& scope) {
  const Lubricant oil{.viscosity = ViscosityLaw::barus};
  const Problem hard = nondimensionalise(MoesGroups{1000, 20}, oil, Flooded{}).problem;
  struct Limit {
    double tolerance, seconds;
    int iterations;
  };
  std::vector<Limit> limits{{1e-11, 1, 2000},
                            {1e-11, 0.05, 2000},
                            {1e-3, 0, 2000},
                            {1e-3, -1, 2000},
                            {1e-3, std::numeric_limits<double>::quiet_NaN(), 2000},
                            {1e-3, 5, 1},
                            {1e-3, 5, 0},
                            {1e-3, 5, -1}};
  if (scope.quick) limits = {limits[1], limits[2], limits[5], limits[6]};
  std::vector<ExtremeRow> rows;
  for (const RegisteredSolver& solver : solvers()) {
    for (const Limit& limit : limits) {
      ExtremeRow row{.kind = "limits",
                     .what = solver.name + ", tolerance " + plain(limit.tolerance) + ", " + plain(limit.seconds) +
                             " s, " + std::to_string(limit.iterations) + " iterations"};
      row.time_limit_s = limit.seconds > 0 ? limit.seconds : 0;
      const auto begin = Clock::now();
      try {
        row.fast = ended(solver.solve(
            hard, {.tolerance = limit.tolerance, .max_iterations = limit.iterations, .time_limit_s = limit.seconds}));
      } catch (const std::exception& thrown) {
        row.broke = std::string("threw ") + thrown.what();
      }
      row.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

// -- to and from the child ----------------------------------------------------------------------------------------

Json json_of(const Ended& end) {
  Json json{
      {"status", static_cast<int>(end.status)}, {"reason", end.reason}, {"finite", end.finite}, {"wall_s", end.wall_s}};
  for (std::size_t k = 0; k < 2; ++k) {
    put(json, "film" + std::to_string(k), end.film[k]);
    put(json, "error" + std::to_string(k), end.error[k]);
  }
  return json;
}

Ended end_of(const Json& json) {
  Ended end{.status = static_cast<StopReason>(json.at("status").get<int>()),
            .reason = json.at("reason").get<std::string>(),
            .finite = json.at("finite").get<bool>()};
  end.wall_s = json.at("wall_s").get<double>();
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string at = std::to_string(k);
    if (json.contains("film" + at)) end.film[k] = json.at("film" + at).get<double>();
    if (json.contains("error" + at)) end.error[k] = json.at("error" + at).get<double>();
  }
  return end;
}

void in_a_process(const std::string& kind, unsigned alarm_s, const std::function<std::vector<ExtremeRow>()>& work,
                  std::vector<ExtremeRow>& rows) {
  const ChildEnd child = in_child([&] {
    ::alarm(alarm_s);
    Json json = Json::array();
    for (const ExtremeRow& row : work()) {
      Json one{{"what", row.what},     {"inside", row.inside},      {"refused", row.refused},
               {"wall_s", row.wall_s}, {"limit", row.time_limit_s}, {"broke", row.broke}};
      if (row.fast) one["fast"] = json_of(*row.fast);
      if (row.other) one["other"] = json_of(*row.other);
      json.push_back(one);
    }
    return json_text(json);
  });
  if (!child.text) {
    rows.push_back({.kind = kind, .what = "the whole batch", .broke = child.why});
    return;
  }
  for (const Json& one : Json::parse(*child.text)) {
    ExtremeRow row{.kind = kind,
                   .what = one.at("what"),
                   .inside = one.at("inside"),
                   .refused = one.at("refused"),
                   .wall_s = one.at("wall_s"),
                   .time_limit_s = one.at("limit"),
                   .broke = one.at("broke")};
    if (one.contains("fast")) row.fast = end_of(one.at("fast"));
    if (one.contains("other")) row.other = end_of(one.at("other"));
    rows.push_back(std::move(row));
  }
}

}  // namespace

std::vector<ExtremeRow> run_extremes(const Scope& scope) {
  std::vector<ExtremeRow> rows;
  const int batches = scope.quick ? 1 : 10, batch = scope.quick ? 60 : 300;
  constexpr unsigned alarm_s = 600;
  for (int b = 0; b < batches; ++b) {
    scope.show("random cases from " + std::to_string(b * batch));
    in_a_process(
        "random SI, batch " + std::to_string(b), alarm_s,
        [&, b] {
          std::vector<ExtremeRow> some(static_cast<std::size_t>(batch));
          in_threads(some.size(), scope.threads, [&](std::size_t i) {
            const int number = b * batch + static_cast<int>(i);
            Draw draw(seed + static_cast<unsigned>(number));  // a case does not depend on the others
            some[i] = random_case(draw, number);
          });
          return some;
        },
        rows);
  }
  for (ExtremeRow& row : rows) row.kind = "random SI";
  scope.show("impossible inputs");
  in_a_process(
      "impossible inputs", alarm_s, [&] { return impossible_inputs(scope); }, rows);
  scope.show("limits");
  in_a_process(
      "limits", alarm_s, [&] { return hurried(scope); }, rows);
  return rows;
}

Part judge_extremes(const std::vector<ExtremeRow>& rows) {
  Part part{.id = "g",
            .name = "extremes",
            .question = "Do extreme, impossible and hurried inputs end in a right answer or a clear refusal?"};
  part.tolerance = Tolerance::required(1, "difference of the films over the sum of the errors that both solvers state");
  part.settings = {{"seed", seed}, {"tolerance", asked}, {"time_limit_s", time_limit_s}, {"slack_s", slack_s}};
  part.table.columns = {{"kind", ""},
                        {"where", ""},
                        {"tried", ""},
                        {"refused at once", ""},
                        {"converged", ""},
                        {"not converged", ""},
                        {"held against another", ""},
                        {"difference/stated", "most"},
                        {"over the limit", "s, most"},
                        {"broke", ""}};
  Tally tally;
  struct Row {
    double tried = 0, refused = 0, converged = 0, ended = 0, held = 0, worst = 0, over = 0, broke = 0;
  };
  std::vector<std::pair<std::pair<std::string, std::string>, Row>> sums;
  const auto sum_of = [&](const std::string& kind, const std::string& where) -> Row& {
    for (auto& [key, row] : sums) {
      if (key == std::pair(kind, where)) return row;
    }
    sums.push_back({{kind, where}, {}});
    return sums.back().second;
  };
  long right = 0, refused = 0, not_finite = 0, late = 0, broke = 0;
  for (const ExtremeRow& row : rows) {
    Row& sum = sum_of(row.kind, row.kind == "limits" ? "" : row.inside ? "inside, p_H <= 4 GPa" : "outside");
    ++sum.tried;
    const std::string where = row.kind + ", " + row.what;
    if (!row.broke.empty()) {
      ++sum.broke;
      ++broke;
      tally.require(false, where + ": " + row.broke);
      continue;
    }
    if (!row.refused.empty()) {
      ++sum.refused;
      ++refused;
      tally.require(row.refused.find('\n') == std::string::npos, where + ": the refusal has more than one line");
      tally.require(!row.inside, where + ": refused inside the box: " + row.refused);
      continue;
    }
    if (!row.fast) {
      tally.add(Verdict::inconclusive, where + ": nothing came back");
      continue;
    }
    const Ended& end = *row.fast;
    const bool converged = end.status == StopReason::converged;
    (converged ? sum.converged : sum.ended) += 1;
    sum.over = std::max(sum.over, row.wall_s - row.time_limit_s);
    tally.add(row.wall_s, 0,
              Tolerance::required(row.time_limit_s + slack_s, "the time limit and one step that cannot be interrupted"),
              where + ", seconds");
    not_finite += end.finite ? 0 : 1;
    late += row.wall_s <= row.time_limit_s + slack_s ? 0 : 1;
    tally.require(end.finite, where + ": a number is not finite (" + std::string(to_string(end.status)) + ")");
    if (converged) {
      tally.require(end.has_films() && *end.film[0] > 0 && *end.film[1] > 0,
                    where + ": converged without a positive film");
    } else {
      ++refused;
      tally.require(!end.reason.empty(),
                    where + ": ended as " + std::string(to_string(end.status)) + " without a reason");
      if (row.kind != "limits")
        tally.require(!row.inside, where + ": ended as " + std::string(to_string(end.status)) + " inside the box");
    }
    if (!row.other || row.other->status != StopReason::converged) {
      if (row.other && row.inside)
        tally.add(Verdict::inconclusive,
                  where + ": the other solver ended as " + std::string(to_string(row.other->status)));
      continue;
    }
    if (!end.has_films()) continue;
    ++sum.held;
    const double ratio = over_stated_errors(end, *row.other);
    sum.worst = std::max(sum.worst, ratio);
    right += tally.add(ratio, 0, *part.tolerance, where + ", difference over stated errors") == Verdict::pass ? 1 : 0;
  }
  double inside = 0, held_inside = 0;
  for (const auto& [key, row] : sums) {
    if (key.second.starts_with("inside")) {
      inside += row.tried;
      held_inside += row.held;
    }
  }
  if (inside == 0 || held_inside == 0)
    tally.add(Verdict::inconclusive, "no contact inside the box was held against another solver");
  for (const auto& [key, row] : sums)
    part.table.rows.push_back({key.first, key.second, row.tried, row.refused, row.converged, row.ended, row.held,
                               row.worst, row.over, row.broke});
  part.verdict = tally.verdict();
  part.failures = tally.failures();
  double held = 0;
  for (const auto& [key, row] : sums) held += row.held;
  part.summary = std::to_string(rows.size()) + " inputs: " + std::to_string(refused) + " refused, " +
                 std::to_string(right) + " of " + plain(held) +
                 " that were held against another solver agree within what both state; " + std::to_string(not_finite) +
                 " with a number that is not finite, " + std::to_string(late) + " beyond their time, " +
                 std::to_string(broke) + " crashed";
  return part;
}

}  // namespace ehd::verification::stress
