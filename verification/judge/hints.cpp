// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "workflow/registry.hpp"

namespace ehd::judging {

namespace {

constexpr double far_off = 0.02;  // films of light contacts that are swapped differ by a few per cent
/// A mistake explains a number where it leaves less than this error, and less than a fifth of the number's own.
constexpr double explained = 0.05, explained_share = 0.2;
constexpr double speed_tolerance = 1e-3;  // of the films at another speed

bool explains(double left, double error) { return left < explained && left < explained_share * error; }

/// A mistake that would explain the films that are far off, and the largest error that it leaves.
struct Guess {
  double left = 0;
  std::string words;
};

bool is_wrong_film(const Compared& one) { return is_film(one.number.quantity) && one.error() > far_off; }
bool is_right_film(const Compared& one) { return is_film(one.number.quantity) && one.error() <= far_off; }

/// Keeps the mistake if it explains every film that is far off. `mistaken`: what a film would be by the mistake.
/// `words`: what the films fit.
void guess(std::vector<Guess>& guesses, const std::vector<Compared>& numbers, const std::string& words,
           const std::function<std::optional<double>(const Compared&)>& mistaken) {
  double left = -1;
  std::vector<std::string> wrong;
  for (const Compared& one : numbers) {
    if (!is_wrong_film(one)) continue;
    const auto meant = mistaken(one);
    if (!meant || !explains(relative_error(one.value, *meant), one.error())) return;
    left = std::max(left, relative_error(one.value, *meant));
    wrong.emplace_back(to_string(one.number.quantity));
  }
  if (wrong.empty()) return;
  const bool some_are_right = std::any_of(numbers.begin(), numbers.end(), is_right_film);
  const std::string films = some_are_right ? list(wrong) : "the films";
  guesses.push_back({left, fmt::format("{} fit{} {}", films, some_are_right && wrong.size() == 1 ? "s" : "", words)});
}

void guess_scaling(std::vector<Guess>& guesses, const CaseScales& scales, const std::vector<Compared>& numbers) {
  const auto first = std::find_if(numbers.begin(), numbers.end(), is_wrong_film);
  for (const Scaling other : all_scalings) {
    guess(guesses, numbers,
          fmt::format("the scaling \"{}\", but \"{}\" is named: which one is right?", to_string(other),
                      to_string(first->number.scaling)),
          [&](const Compared& one) -> std::optional<double> {
            const auto named = scales.unit(one.number.quantity, one.number.scaling),
                       meant = scales.unit(one.number.quantity, other);
            if (!named || !meant || other == one.number.scaling) return std::nullopt;
            return one.certified.value * *meant / *named;
          });
  }
}

void guess_prefix(std::vector<Guess>& guesses, const std::vector<Compared>& numbers) {
  constexpr struct {
    double factor;
    const char* unit;
  } prefixes[] = {{1e9, "nm"}, {1e6, "um"}, {1e3, "mm"}};
  for (const auto& prefix : prefixes)
    guess(guesses, numbers, fmt::format("{}; the scaling SI means m", prefix.unit),
          [&](const Compared& one) -> std::optional<double> {
            if (one.number.scaling != Scaling::SI) return std::nullopt;
            return one.certified.value * prefix.factor;
          });
}

/// Every film that is far off is the certified value of another film, or of the offset H_0.
void guess_swap(std::vector<Guess>& guesses, const std::vector<Compared>& numbers,
                const std::vector<Certified>& certified) {
  Guess found;
  for (const Compared& one : numbers) {
    if (!is_wrong_film(one)) continue;
    const Certified* closest = nullptr;
    for (const Certified& other : certified) {
      if (other.quantity == one.number.quantity) continue;
      if (!is_film(other.quantity) && other.quantity != Quantity::film_offset) continue;
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
  guesses.push_back(std::move(found));
}

/// A film in Moes units is h/R (E'R/(eta_0 u))^(1/2): over the same film in the unit of another speed, `factor` u.
double moes_unit_ratio(double factor) { return 1 / std::sqrt(factor); }

/// The film itself is right, and another speed stands in its unit.
void guess_moes_unit(std::vector<Guess>& guesses, const std::vector<Compared>& numbers) {
  constexpr struct {
    double factor;
    const char* words;
  } mistakes[] = {
      {0.5, "Moes units of half the speed: did you put the mean speed where the sum u_1 + u_2 belongs?"},
      {2, "Moes units of twice the speed: is your u the mean speed? Here these have the sum u_1 + u_2"},
  };
  for (const auto& mistake : mistakes)
    guess(guesses, numbers, mistake.words, [&](const Compared& one) -> std::optional<double> {
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
  const Solution solution =
      default_solver().solve(problem, Request{.tolerance = speed_tolerance, .time_limit_s = limit_s});
  return solution.record.status == StopReason::converged ? std::optional(solution) : std::nullopt;
}

/// Every film of a solve at another speed is off: a right one says that the speed is right.
void guess_speed(std::vector<Guess>& guesses, const Case& contact_case, const std::vector<Compared>& numbers) {
  if (std::any_of(numbers.begin(), numbers.end(), is_right_film)) return;
  constexpr struct {
    double factor;
    const char* question;
  } mistakes[] = {
      {2, "twice the speed: is your u the mean speed? Here M, L and lambda have the sum u_1 + u_2"},
      {0.5, "half the speed: did you put the mean speed where the sum u_1 + u_2 belongs?"},
  };
  for (const auto& mistake : mistakes) {
    const auto solution = at_speed(contact_case, mistake.factor);
    if (!solution) continue;
    // Who makes the Moes unit of a film from the same wrong speed has another unit too.
    for (const double unit : {1.0, moes_unit_ratio(mistake.factor)})
      guess(guesses, numbers, mistake.question, [&](const Compared& one) -> std::optional<double> {
        const auto at = solution->observables.find(one.number.quantity);
        if (at == solution->observables.end()) return std::nullopt;
        return at->second.value * (one.number.scaling == Scaling::moes ? unit : 1);
      });
  }
}

/// The best guess, and those that the films cannot tell from it.
std::vector<std::string> likely(std::vector<Guess> guesses) {
  std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.left < b.left; });
  std::vector<std::string> hints;
  for (const Guess& one : guesses) {
    if (one.left > 2 * guesses.front().left + speed_tolerance) break;
    if (std::find(hints.begin(), hints.end(), one.words) == hints.end()) hints.push_back(one.words);
  }
  return hints;
}

}  // namespace

bool needs_hint(const std::vector<Compared>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), is_wrong_film);
}

std::vector<std::string> hints_for(const Case& contact_case, const CaseScales& scales,
                                   const std::vector<Compared>& numbers, bool may_solve) {
  if (!needs_hint(numbers)) return {};
  std::vector<Guess> guesses;
  guess_scaling(guesses, scales, numbers);
  guess_prefix(guesses, numbers);
  if (may_solve) guess_speed(guesses, contact_case, numbers);
  guess_moes_unit(guesses, numbers);
  guess_swap(guesses, numbers, certified_numbers(contact_case, scales));
  return likely(std::move(guesses));
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

std::optional<std::string> mirror_hint(const SubmittedProfile& profile, const Profile& certified, double error) {
  const Profile turned{-profile.X.reverse(), profile.P.reverse()};
  if (!explains(relative_l2_error(turned, certified), error)) return std::nullopt;
  return "P of the profile fits with X turned round: here X increases from the inlet to the exit";
}

}  // namespace ehd::judging
