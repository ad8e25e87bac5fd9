// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/registry.hpp"

namespace ehd::judging {

namespace {

constexpr double far_off = 0.02;  // films of light contacts that are swapped differ by a few per cent
/// A mistake explains a number where it leaves less than this error, and less than a fifth of the number's own.
constexpr double explained = 0.05, explained_share = 0.2;

bool explains(double left, double error) { return left < explained && left < explained_share * error; }

/// A mistake that would explain the films, and the largest error that it leaves.
struct Guess {
  double left = 0;
  std::string words;
};

/// Keeps the guess if it explains every film better than the one before. `mistaken`: what a film would be by the
/// mistake.
void guess(std::optional<Guess>& best, const std::vector<Compared>& numbers, const std::string& words,
           const std::function<std::optional<double>(const Compared&)>& mistaken) {
  double left = -1;
  for (const Compared& one : numbers) {
    if (!is_film(one.number.quantity)) continue;
    const auto meant = mistaken(one);
    if (!meant || !explains(relative_error(one.value, *meant), one.error())) return;
    left = std::max(left, relative_error(one.value, *meant));
  }
  if (left >= 0 && (!best || left < best->left)) best = Guess{.left = left, .words = words};
}

void guess_scaling(std::optional<Guess>& best, const CaseScales& scales, const std::vector<Compared>& numbers) {
  for (const Scaling other : all_scalings) {
    guess(best, numbers,
          fmt::format("the films fit the scaling \"{}\", but \"{}\" is named: which one are they in?", to_string(other),
                      to_string(numbers.front().number.scaling)),
          [&](const Compared& one) -> std::optional<double> {
            const auto named = scales.unit(one.number.quantity, one.number.scaling),
                       meant = scales.unit(one.number.quantity, other);
            if (!named || !meant || other == one.number.scaling) return std::nullopt;
            return one.certified.value * *meant / *named;
          });
  }
}

void guess_prefix(std::optional<Guess>& best, const std::vector<Compared>& numbers) {
  constexpr struct {
    double factor;
    const char* unit;
  } prefixes[] = {{1e9, "nm"}, {1e6, "um"}, {1e3, "mm"}};
  if (numbers.front().number.scaling != Scaling::SI) return;
  for (const auto& prefix : prefixes)
    guess(best, numbers, fmt::format("the films fit {}; the scaling SI means m", prefix.unit),
          [&](const Compared& one) { return one.certified.value * prefix.factor; });
}

/// Every film that is far off is the certified value of another film.
void guess_swap(std::optional<Guess>& best, const std::vector<Compared>& numbers,
                const std::vector<Certified>& certified) {
  Guess found;
  for (const Compared& one : numbers) {
    if (!is_film(one.number.quantity) || one.error() <= far_off) continue;
    const Certified* closest = nullptr;
    for (const Certified& other : certified) {
      if (other.quantity == one.number.quantity || !is_film(other.quantity)) continue;
      if (!closest || relative_error(one.value, other.value) < relative_error(one.value, closest->value))
        closest = &other;
    }
    if (!closest) return;
    const double left = relative_error(one.value, closest->value);
    if (!explains(left, one.error())) return;
    found.left = std::max(found.left, left);
    found.words += fmt::format("{}{} is close to the certified {}", found.words.empty() ? "" : ", ",
                               to_string(one.number.quantity), to_string(closest->quantity));
  }
  found.words += ": are two films swapped?";
  if (!best || found.left < best->left) best = found;
}

/// A film in Moes units is h/R (E'R/(eta_0 u))^(1/2): over the same film in the unit of another speed, `factor` u.
double moes_unit_ratio(double factor) { return 1 / std::sqrt(factor); }

/// The film itself is right, and another speed stands in its unit.
void guess_moes_unit(std::optional<Guess>& best, const std::vector<Compared>& numbers) {
  constexpr struct {
    double factor;
    const char* words;
  } mistakes[] = {
      {0.5, "the films fit Moes units of half the speed: did you put the mean speed where the sum u_1 + u_2 belongs?"},
      {2, "the films fit Moes units of twice the speed: is your u the mean speed? Here these have the sum u_1 + u_2"},
  };
  for (const auto& mistake : mistakes)
    guess(best, numbers, mistake.words, [&](const Compared& one) -> std::optional<double> {
      if (one.number.scaling != Scaling::moes) return std::nullopt;
      return one.certified.value * moes_unit_ratio(mistake.factor);
    });
}

/// The films of the same contact at another speed. Load, geometry and oil keep p_H and b, so lambda alone changes.
std::optional<Solution> at_speed(const Case& contact_case, double factor) {
  const auto& contact = std::get<ContactCase>(contact_case.body);
  Problem problem = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem;
  const double lambda = problem.groups.lambda * factor;
  problem.groups = groups_from(HertzGroups{.lambda = lambda, .alpha_p_H = problem.groups.alpha_p_H});
  constexpr double limit_s = 20;
  const Solution solution = default_solver().solve(problem, Request{.tolerance = 1e-3, .time_limit_s = limit_s});
  return solution.record.status == StopReason::converged ? std::optional(solution) : std::nullopt;
}

void guess_speed(std::optional<Guess>& best, const Case& contact_case, const std::vector<Compared>& numbers) {
  constexpr struct {
    double factor;
    const char* question;
  } mistakes[] = {
      {2, "the films fit twice the speed: is your u the mean speed? Here M, L and lambda have the sum u_1 + u_2"},
      {0.5, "the films fit half the speed: did you put the mean speed where the sum u_1 + u_2 belongs?"},
  };
  for (const auto& mistake : mistakes) {
    const auto solution = at_speed(contact_case, mistake.factor);
    if (!solution) continue;
    // Who makes the Moes unit of a film from the same wrong speed has another unit too.
    for (const double unit : {1.0, moes_unit_ratio(mistake.factor)})
      guess(best, numbers, mistake.question, [&](const Compared& one) -> std::optional<double> {
        const auto at = solution->observables.find(one.number.quantity);
        if (at == solution->observables.end()) return std::nullopt;
        return at->second.value * (one.number.scaling == Scaling::moes ? unit : 1);
      });
  }
}

}  // namespace

bool needs_hint(const std::vector<Compared>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const Compared& one) { return is_film(one.number.quantity) && one.error() > far_off; });
}

std::vector<std::string> hints_for(const Case& contact_case, const CaseScales& scales,
                                   const std::vector<Compared>& numbers, bool may_solve) {
  std::vector<std::string> hints;
  if (!needs_hint(numbers)) return hints;
  std::optional<Guess> best;
  guess_scaling(best, scales, numbers);
  guess_prefix(best, numbers);
  if (!best && may_solve) guess_speed(best, contact_case, numbers);
  guess_moes_unit(best, numbers);
  guess_swap(best, numbers, certified_numbers(contact_case, scales));
  if (best) hints.push_back(best->words);
  return hints;
}

std::vector<std::string> profile_hints(const SubmittedProfile& profile, const std::vector<Gate>& gates,
                                       const CaseScales& scales, std::optional<FilmMinimum> film_minimum,
                                       double stated_error) {
  const auto film_gate = [](const std::vector<Gate>& all) {
    return *std::find_if(all.begin(), all.end(), [](const Gate& gate) { return gate.name == film_equation; });
  };
  const Gate film = film_gate(gates);
  if (film.verdict == verification::Verdict::fail && film.judged) {
    for (const Scaling other : {Scaling::moes, Scaling::kostreva}) {  // in SI, X and P would not be like this
      const auto unit = scales.unit(Quantity::film_minimum, other);
      if (!unit) continue;
      SubmittedProfile meant = profile;
      meant.H /= *unit;
      if (film_gate(gates_of(meant, stated_error)).verdict == verification::Verdict::pass)
        return {fmt::format("H of the profile fits the scaling \"{}\"; a profile is in Hertz units", to_string(other))};
    }
  }
  if (!film_minimum) return {};
  // The lowest node is above the lowest point between the nodes: half of the nodes show how much.
  double smallest = profile.H[0], smallest_of_half = profile.H[0];
  for (Eigen::Index i = 0; i < profile.H.size(); ++i) {
    smallest = std::min(smallest, profile.H[i]);
    if (i % 2 == 0) smallest_of_half = std::min(smallest_of_half, profile.H[i]);
  }
  const double between_nodes = std::abs(smallest_of_half - smallest) / film_minimum->value,
               allowed = std::max(film.tolerance.value(), film_minimum->submitted ? 0 : far_off);
  if (relative_error(smallest, film_minimum->value) <= allowed + 2 * between_nodes) return {};
  return {fmt::format("the smallest H of the profile is {}, but {} is {} (Hertz units){}", plain(smallest, 4),
                      film_minimum->submitted ? "film.minimum" : "the certified film.minimum",
                      plain(film_minimum->value, 4), film_minimum->submitted ? ": which one is right?" : "")};
}

std::optional<std::string> mirror_hint(const SubmittedProfile& profile, const Profile& certified,
                                       double error) {
  const Profile turned{-profile.X.reverse(), profile.P.reverse()};
  if (!explains(relative_l2_error(turned, certified), error)) return std::nullopt;
  return "P of the profile fits with X turned round: here X increases from the inlet to the exit";
}

}  // namespace ehd::judging
