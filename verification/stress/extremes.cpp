// SPDX-License-Identifier: GPL-3.0-or-later
// (g) Inputs that nobody should give: random SI cases over many decades; every number of a statement replaced by zero,
// a negative, a denormal, a huge number and NaN; limits of time and iterations. Inside the box the answer must be
// right, outside right or refused. NaN and hangs are failures everywhere. Each batch runs in a process of its own with
// an alarm, so that a crash or a hang becomes a row.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <numbers>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/json.hpp"
#include "verification/bench/child.hpp"
#include "verification/bench/timing.hpp"
#include "verification/stress/parts.hpp"
#include "verification/stress/stated.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

constexpr unsigned seed = 20261125;
constexpr double asked = 1e-3, time_limit_s = 5, dense_time_limit_s = 30;
/// One in 8 of the cases inside the box is also solved by the certified solver, one in 20 of those outside by another
/// dense one.
constexpr int inside_a_truth = 8, outside_a_truth = 20;
/// How long a solve may run beyond its limit: one step cannot be interrupted (a dense factorisation, a grid's tables),
/// and other processes take time.
constexpr double slack_s = 2;
constexpr unsigned alarm_s = 600;  ///< a batch that takes longer hangs
constexpr const char* limits_kind = "limits";

std::string text_of(const Conditions& c, const Lubricant& l) {
  const auto number = [](const std::optional<double>& value) {
    constexpr int all_digits = 17;
    return value ? plain(*value, all_digits) : std::string("absent");
  };
  return fmt::format("load {} N/m, R {} m, E' {} Pa, u_s {} m/s, eta_0 {} Pa s, {}, {}, alpha {}, z {}, p_0 {}",
                     number(c.load_N_per_m), number(c.reduced_radius_m), number(c.reduced_modulus_Pa),
                     number(c.speed_sum_m_per_s), number(c.viscosity_Pa_s), to_string(l.viscosity),
                     to_string(l.density), number(l.alpha_per_Pa), number(l.z), number(l.p0_Pa));
}

/// M, L and p_H from the stated numbers alone; NaN where one is missing.
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
  return M >= box_lightest_M && M <= box_heaviest_M && L >= 0 && L <= box_largest_L && p_H >= 0 &&
         p_H <= highest_pressure_Pa && z >= 0.1 && z <= 1.2 && lubricant.p0_Pa >= 1e7 && lubricant.p0_Pa <= 1e10 &&
         (L == 0 || std::isfinite(lubricant.p0_Pa / p_H)) &&  // p_0 in units of p_H has to be a number
         (!cut || (M >= 2 && cut->x >= -100 && cut->x <= -2.5));
}

namespace {

/// Makes the problem of a statement and solves it: the row is refused, ended or broken.
ExtremeRow tried(const std::string& kind, const std::string& what, const Statement& statement,
                 const Lubricant& lubricant, const Inlet& inlet, int number) {
  ExtremeRow row{
      .kind = kind, .what = what, .inside = in_the_box(statement, lubricant, inlet), .time_limit_s = time_limit_s};
  const Stopwatch watch;
  try {
    const Nondimensional made = nondimensionalise(statement, lubricant, inlet);
    const Request request{.tolerance = asked, .time_limit_s = time_limit_s};
    row.fast = ended(default_solver().solve(made.problem, request));
    row.wall_s = watch.seconds();
    if (row.inside && number % inside_a_truth == 0)
      row.other =
          ended(certified_solver().solve(made.problem, {.tolerance = asked, .time_limit_s = dense_time_limit_s}));
    else if (!row.inside && number % outside_a_truth == 0)
      row.other = ended(find_solver(quicker_reference)->solve(made.problem, request));
  } catch (const StatementError& refused) {
    row.refused = refused.key() + ": " + refused.what();
  } catch (const std::bad_alloc&) {
    row.lacked_memory = true;
  } catch (const std::exception& thrown) {
    row.broke = std::string("threw ") + thrown.what();
  }
  return row;
}

/// Inputs over many decades: nine of loads, nine of speeds, six of viscosities.
ExtremeRow random_case(Draw& draw, int number) {
  const Conditions SI{.load_N_per_m = draw.logarithmic(1e-1, 1e8),
                      .reduced_radius_m = draw.logarithmic(1e-4, 1),
                      .reduced_modulus_Pa = draw.logarithmic(1e9, 1e12),
                      .speed_sum_m_per_s = draw.logarithmic(1e-6, 1e3),
                      .viscosity_Pa_s = draw.logarithmic(1e-4, 1e2)};
  Lubricant lubricant;
  const int law = draw.integer(0, 7);
  lubricant.viscosity = law == 0 ? ViscosityLaw::isoviscous : law < 4 ? ViscosityLaw::barus : ViscosityLaw::roelands;
  lubricant.density = draw.integer(0, 1) == 0 ? DensityLaw::incompressible : DensityLaw::dowson_higginson;
  lubricant.alpha_per_Pa = law == 0 ? 0 : draw.uniform(0, 4e-8);
  if (lubricant.viscosity == ViscosityLaw::roelands) lubricant.z = draw.uniform(0.3, 1);
  return tried("random SI", text_of(SI, lubricant), SI, lubricant, Flooded{}, number);
}

/// Values that can break a computation.
std::vector<double> wrong_values(bool quick) {
  using limits = std::numeric_limits<double>;
  if (quick) return {0.0, -1.0, limits::denorm_min(), limits::max(), limits::infinity(), limits::quiet_NaN()};
  return {0.0,
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
}

/// One number of a sound statement replaced by each wrong value, in all three ways to state a contact.
std::vector<ExtremeRow> impossible_inputs(const Scope& scope) {
  Lubricant lubricant = oil(true);
  lubricant.alpha_per_Pa = 1.9e-8;
  const std::pair<std::string, Statement> ways[] = {
      {"conditions", ordinary_conditions()}, {"moes", MoesGroups{7, 6}}, {"hertz", HertzGroups{1.51425, 2.832}}};
  std::vector<ExtremeRow> rows;
  for (const auto& [way, statement] : ways) {
    const Stated sound{.statement = statement, .lubricant = lubricant};
    for (const Input& input : inputs_of(sound)) {
      for (const double value : wrong_values(scope.quick)) {
        Stated wrong = sound;
        input.of(wrong) = value;
        rows.push_back(tried("impossible inputs", fmt::format("{}, {} = {}", way, input.name, plain(value, 3)),
                             wrong.statement, wrong.lubricant, TruncatedAt{wrong.inlet}, 0));
      }
    }
  }
  return rows;
}

/// Every solver with little time or few iterations, on a problem that needs more; and with limits that are not valid
/// (zero, negative, not a number).
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
      ExtremeRow row{.kind = limits_kind,
                     .what = fmt::format("{}, tolerance {}, {} s, {} iterations", solver.name, plain(limit.tolerance),
                                         plain(limit.seconds), limit.iterations)};
      row.time_limit_s = limit.seconds > 0 ? limit.seconds : 0;
      const Stopwatch watch;
      try {
        row.fast = ended(solver.solve(
            hard, {.tolerance = limit.tolerance, .max_iterations = limit.iterations, .time_limit_s = limit.seconds}));
      } catch (const std::bad_alloc&) {
        row.lacked_memory = true;
      } catch (const std::exception& thrown) {
        row.broke = std::string("threw ") + thrown.what();
      }
      row.wall_s = watch.seconds();
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

// -- to and from the child ----------------------------------------------------------------------------------------

void in_a_process(const std::string& kind, const std::function<std::vector<ExtremeRow>()>& work,
                  std::vector<ExtremeRow>& rows) {
  const ChildEnd child = in_child([&] {
    ::alarm(alarm_s);
    Json json = Json::array();
    for (const ExtremeRow& row : work()) {
      Json one{{"what", row.what},
               {"inside", row.inside},
               {"refused", row.refused},
               {"wall_s", row.wall_s},
               {"limit", row.time_limit_s},
               {"broke", row.broke},
               {"lacked_memory", row.lacked_memory}};
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
                   .broke = one.at("broke"),
                   .lacked_memory = one.at("lacked_memory")};
    if (one.contains("fast")) row.fast = ended_from(one.at("fast"));
    if (one.contains("other")) row.other = ended_from(one.at("other"));
    rows.push_back(std::move(row));
  }
}

}  // namespace

std::vector<ExtremeRow> run_extremes(const Scope& scope) {
  std::vector<ExtremeRow> rows;
  const int batches = scope.quick ? 1 : 10, batch = scope.quick ? 60 : 300;
  for (int b = 0; b < batches; ++b) {
    scope.show(fmt::format("random cases from {}", b * batch));
    in_a_process(
        "random SI",
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
  scope.show("impossible inputs");
  in_a_process(
      "impossible inputs", [&] { return impossible_inputs(scope); }, rows);
  scope.show("limits");
  in_a_process(
      limits_kind, [&] { return hurried(scope); }, rows);
  return rows;
}

namespace {

/// The rows of one kind and place, added up.
struct Sum {
  double tried = 0, refused = 0, converged = 0, ended = 0, held = 0, worst = 0, over = 0, broke = 0;
};

/// Sums by kind and place, in order of appearance.
class Sums {
 public:
  Sum& of(const ExtremeRow& row) {
    const std::pair<std::string, std::string> key{row.kind, row.kind == limits_kind ? ""
                                                            : row.inside            ? "inside, p_H <= 4 GPa"
                                                                                    : "outside"};
    for (auto& [known, sum] : sums_) {
      if (known == key) return sum;
    }
    sums_.push_back({key, {}});
    return sums_.back().second;
  }
  [[nodiscard]] auto begin() const { return sums_.begin(); }
  [[nodiscard]] auto end() const { return sums_.end(); }

 private:
  std::vector<std::pair<std::pair<std::string, std::string>, Sum>> sums_;
};

struct Counts {
  long right = 0, refused = 0, not_finite = 0, late = 0, broke = 0;
};

/// How the solve of a row ended: in time, with finite numbers, and inside the box converged.
void judge_end(const ExtremeRow& row, const std::string& where, Sum& sum, Counts& counts, Tally& tally) {
  const Ended& end = *row.fast;
  const bool converged = end.status == StopReason::converged;
  const std::string status(to_string(end.status));
  (converged ? sum.converged : sum.ended) += 1;
  sum.over = std::max(sum.over, row.wall_s - row.time_limit_s);
  tally.add(row.wall_s, 0,
            Tolerance::required(row.time_limit_s + slack_s, "the time limit and one step that cannot be interrupted"),
            where + ", seconds");
  counts.not_finite += end.finite ? 0 : 1;
  counts.late += row.wall_s <= row.time_limit_s + slack_s ? 0 : 1;
  tally.require(end.finite, fmt::format("{}: a number is not finite ({})", where, status));
  if (converged) {
    tally.require(end.has_films() && *end.film[0] > 0 && *end.film[1] > 0,
                  where + ": converged without a positive film");
    return;
  }
  ++counts.refused;
  tally.require(!end.reason.empty(), fmt::format("{}: ended as {} without a reason", where, status));
  if (row.kind != limits_kind)
    tally.add(holds_in_time(!row.inside, out_of_time(end.status, row.wall_s, row.time_limit_s)),
              fmt::format("{}: ended as {} inside the box", where, status));
}

void judge_against_other(const ExtremeRow& row, const std::string& where, Sum& sum, Counts& counts, Tally& tally) {
  if (!row.other || row.other->status != StopReason::converged) {
    if (row.other && row.inside)
      tally.add(Verdict::inconclusive,
                fmt::format("{}: the other solver ended as {}", where, to_string(row.other->status)));
    return;
  }
  if (!row.fast->has_films()) return;
  ++sum.held;
  const double ratio = over_stated_errors(*row.fast, *row.other);
  sum.worst = std::max(sum.worst, ratio);
  const Verdict verdict = tally.add(ratio, 0, within_stated_errors(), where + ", difference over stated errors");
  counts.right += verdict == Verdict::pass ? 1 : 0;
}

void judge_row(const ExtremeRow& row, Sum& sum, Counts& counts, Tally& tally) {
  const std::string where = row.kind + ", " + row.what;
  ++sum.tried;
  if (!row.broke.empty()) {
    ++sum.broke;
    ++counts.broke;
    tally.require(false, where + ": " + row.broke);
  } else if (row.lacked_memory) {
    tally.add(Verdict::inconclusive, fmt::format("{}: {}", where, memory_is_exhausted));
  } else if (!row.refused.empty()) {
    ++sum.refused;
    ++counts.refused;
    tally.require(row.refused.find('\n') == std::string::npos, where + ": the refusal has more than one line");
    tally.require(!row.inside, where + ": refused inside the box: " + row.refused);
  } else if (!row.fast) {
    tally.add(Verdict::inconclusive, where + ": nothing came back");
  } else {
    judge_end(row, where, sum, counts, tally);
    judge_against_other(row, where, sum, counts, tally);
  }
}

}  // namespace

Part judge_extremes(const std::vector<ExtremeRow>& rows) {
  Part part{.id = "g",
            .name = "extremes",
            .question = "Do extreme, impossible and hurried inputs end in a right answer or a clear refusal?"};
  part.tolerance = within_stated_errors();
  part.settings = {{"seed", seed}, {"tolerance", asked}, {"time_limit_s", time_limit_s}, {"slack_s", slack_s}};
  part.table.columns = columns_of(
      "kind | where | tried | refused at once | converged | not converged | held against another | difference/stated "
      "[most] | over the limit [s, most] | broke");
  Tally tally;
  Sums sums;
  Counts counts;
  for (const ExtremeRow& row : rows) judge_row(row, sums.of(row), counts, tally);
  double held = 0, held_inside = 0;
  for (const auto& [key, sum] : sums) {
    const auto& [kind, where] = key;
    held += sum.held;
    if (where.starts_with("inside")) held_inside += sum.held;
    part.table.rows.push_back(
        {kind, where, sum.tried, sum.refused, sum.converged, sum.ended, sum.held, sum.worst, sum.over, sum.broke});
  }
  if (held_inside == 0) tally.add(Verdict::inconclusive, "no contact inside the box was held against another solver");
  tally.close(part);
  part.summary = fmt::format(
      "{} inputs: {} refused, {} of {} that were held against another solver agree within what both state; {} with a "
      "number that is not finite, {} beyond their time, {} crashed",
      rows.size(), counts.refused, counts.right, plain(held), counts.not_finite, counts.late, counts.broke);
  return part;
}

}  // namespace ehd::verification::stress
