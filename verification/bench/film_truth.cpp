// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/film_truth.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact/text.hpp"
#include "verification/bench/setting.hpp"

namespace ehd::verification {

namespace {

/// Fits and values that still wait for their source do not count.
const Expectation* digits_of(const Case& contact_case, Quantity quantity) {
  const Expectation* best = nullptr;
  for (const Expectation& one : contact_case.expectations) {
    if (one.waiting || one.kind == ExpectationKind::fit || one.value == 0) continue;
    if (one.quantity != to_string(quantity)) continue;
    if (!best || one.uncertainty < best->uncertainty) best = &one;
  }
  return best;
}

/// Digits in the units of the case, turned into Hertz units by a run that has both films.
std::optional<FilmTruth> digits_as_truth(const Case& contact_case, const ContactRun& run) {
  FilmTruth truth;
  for (std::size_t film = 0; film < 2; ++film) {
    const Expectation* const digits = digits_of(contact_case, judged_films[film]);
    const Reading* const reading = reading_of(run.solution, judged_films[film]);
    const auto measured = digits && reading ? measure(run, *digits) : std::nullopt;
    if (!measured) return std::nullopt;
    truth.value[film] = digits->value * (reading->value / measured->value);
    truth.error[film] = digits->uncertainty;
    truth.words[film] =
        fmt::format("the case's {} (relative uncertainty {})", digits->digits, plain(digits->uncertainty, 2));
  }
  return truth;
}

FilmTruth solution_as_truth(const JudgedRun& best, const std::string& which) {
  FilmTruth truth{.solver = best.run.solver, .X = best.run.solution.fields.X};
  for (std::size_t film = 0; film < 2; ++film) {
    const Reading& reading = *reading_of(best.run.solution, judged_films[film]);
    truth.value[film] = reading.value;
    truth.error[film] = *reading.error;
    truth.words[film] = fmt::format("{}{} at {}, which states {}", which, best.run.solver, plain(best.tolerance),
                                    plain(*reading.error, 2));
  }
  return truth;
}

}  // namespace

bool FilmTruth::is(const ContactRun& run) const {
  const Array& other = run.solution.fields.X;
  return !solver.empty() && run.solver == solver && other.size() == X.size() && (other == X).all();
}

std::optional<FilmTruth> film_truth(const Case& contact_case, const std::vector<JudgedRun>& runs,
                                    const std::function<JudgedRun()>& one_more) {
  for (const JudgedRun& one : runs)
    if (auto digits = digits_as_truth(contact_case, one.run)) return digits;
  const JudgedRun extra = one_more();
  const JudgedRun* best = &extra;
  for (const JudgedRun& one : runs)
    if (stated_error(one.run.solution) < stated_error(best->run.solution)) best = &one;
  if (!std::isfinite(stated_error(best->run.solution))) return std::nullopt;
  return solution_as_truth(*best, best == &extra ? "one more run, " : "the tightest run, ");
}

void judge(JudgedRun& run, const FilmTruth& truth) {
  const bool itself = truth.is(run.run);
  for (std::size_t film = 0; film < 2; ++film) {
    const Reading* const reading = reading_of(run.run.solution, judged_films[film]);
    if (!reading || itself) continue;
    run.films[film].achieved = std::abs(reading->value / truth.value[film] - 1);
    run.films[film].truth = truth.error[film];
  }
}

}  // namespace ehd::verification
