// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "contact/profile.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "verification/judge/first_cases.hpp"
#include "verification/judge/hints.hpp"
#include "verification/median.hpp"
#include "workflow/registry.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd::judging {

namespace {

constexpr double truth_tolerance = 1e-6;       // of the certified pressure: profiles are printed with six digits
constexpr double truth_limit_s = 60;           // the slowest of the first ten cases takes a second
constexpr std::size_t most_speed_checks = 12;  // a mistake of units is the same in every case

/// The case of a result, checked. Throws CaseError.
Case case_of(const SubmittedResult& result) {
  const auto refuse = [&](const std::string& what) {
    return refusal(result.place, fmt::format("case = {}: {}", result.case_id, what));
  };
  const auto unknown = [&] {
    return refuse(fmt::format("there is no such case; {}allowed is {}", did_you_mean_case(result.case_id), allowed_id));
  };
  std::filesystem::path file;
  try {
    file = find_case(result.case_id);
  } catch (const CaseError&) {
    throw unknown();
  }
  if (!file.has_parent_path()) throw unknown();
  Case found = read_case(file);
  if (!std::holds_alternative<ContactCase>(found.body)) throw refuse("is a bearing; allowed is a contact");
  if (result.version != found.version)
    throw refusal(
        result.place,
        fmt::format(
            "version = {}: is not the version of {}; allowed is {}, whose numbers may be others: solve it again",
            result.version, found.id, found.version));
  return found;
}

/// A number in a scaling that the case does not have for it. The other numbers of a JSON result may be right as they
/// are.
CaseError no_such_scale(const SubmittedResult& result, const SubmittedNumber& number, const CaseScales& scales) {
  std::string allowed;
  for (const Scaling other : all_scalings)
    if (scales.unit(number.quantity, other)) allowed += (allowed.empty() ? "" : ", ") + std::string(to_string(other));
  std::string message = fmt::format("scaling = {}: {} has no such scale in this case; allowed is {}",
                                    to_string(number.scaling), to_string(number.quantity), allowed);
  if (!is_film(number.quantity)) message += "; else leave it out (each row of a CSV has a scaling of its own)";
  return refusal(result.place, message);
}

std::vector<Compared> compared_numbers(const SubmittedResult& result, const CaseScales& scales,
                                       const std::vector<Certified>& certified, JudgedCase& judged) {
  std::vector<Compared> all;
  for (const SubmittedNumber& number : result.numbers) {
    const auto unit = scales.unit(number.quantity, number.scaling);
    if (!unit) throw no_such_scale(result, number, scales);
    const auto at = std::find_if(certified.begin(), certified.end(),
                                 [&](const Certified& one) { return one.quantity == number.quantity; });
    if (at == certified.end()) {
      judged.not_certified.emplace_back(to_string(number.quantity));
    } else {
      all.push_back({.number = number, .value = number.value / *unit, .certified = *at});
    }
  }
  return all;
}

Score score_of(const Certified& certified, const std::vector<Compared>& numbers) {
  Score score{.certified = certified};
  for (const Compared& one : numbers) {
    if (one.certified.quantity != certified.quantity) continue;
    score.value = one.value;
    score.error = one.error();
    score.digits = log_relative_error(one.error(), certified.uncertainty);
    score.stated_error = one.number.stated_error;
    if (score.stated_error) score.honesty = honesty_of(one.error(), certified.uncertainty, *score.stated_error);
  }
  return score;
}

/// P beside the certified solver's. Nothing is compared where one of the two profiles is cut at its spike: the cut
/// would be most of the difference.
void compare_pressure(const Case& contact_case, const SubmittedProfile& profile, JudgedProfile& judged,
                      std::vector<std::string>& hints) {
  if (is_cut(profile)) return;
  const RegisteredSolver& solver = certified_solver();
  const ContactRun run =
      run_contact(contact_case, solver, Request{.tolerance = truth_tolerance, .time_limit_s = truth_limit_s});
  if (run.status() != StopReason::converged || pressure_cut(run)) return;
  const Profile certified = pressure_profile(run.solution.fields);
  const double error = relative_l2_error({profile.X, profile.P}, certified);
  if (!std::isfinite(error)) return;
  judged.pressure_error = error;
  judged.truth = (run.solver.empty() ? "Hertz" : run.solver + " at " + plain(truth_tolerance));
  if (auto hint = mirror_hint(profile, certified, error)) hints.push_back(std::move(*hint));
}

/// The film.minimum of a result; where it has none, the certified one.
std::optional<FilmMinimum> minimum_of(const SubmittedResult& result, const CaseScales& scales,
                                      const std::vector<Score>& scores) {
  for (const SubmittedNumber& number : result.numbers) {
    const auto unit = scales.unit(number.quantity, number.scaling);
    if (number.quantity == Quantity::film_minimum && unit) return FilmMinimum{.value = number.value / *unit};
  }
  for (const Score& score : scores)
    if (score.certified.quantity == Quantity::film_minimum)
      return FilmMinimum{.value = score.certified.value, .submitted = false};
  return std::nullopt;
}

JudgedProfile judged_profile(const Case& contact_case, const CaseScales& scales, const SubmittedResult& result,
                             JudgedCase& of) {
  JudgedProfile judged{.file = result.profile->filename().string(), .gates = {}, .truth = {}};
  const SubmittedProfile profile = read_profile(*result.profile);
  double stated = 0;
  for (const SubmittedNumber& number : result.numbers) stated = std::max(stated, number.stated_error.value_or(0));
  const bool dry = std::get<ContactCase>(contact_case.body).dry();
  judged.gates = gates_of(profile, stated, dry);
  const auto minimum = minimum_of(result, scales, of.scores);
  if (!dry)
    for (std::string& hint : profile_hints(profile, judged.gates, scales, minimum, stated))
      of.hints.push_back(std::move(hint));
  compare_pressure(contact_case, profile, judged, of.hints);
  return judged;
}

/// Why a case without certified numbers scores nothing.
std::string nothing_scored(const Case& contact_case) {
  const auto& all = contact_case.expectations;
  const bool fit =
      std::any_of(all.begin(), all.end(), [](const auto& one) { return one.kind == ExpectationKind::fit; });
  return fit ? "the case has a published fit and no certified digits: nothing is scored"
             : "the case has no digits yet: nothing is scored";
}

JudgedCase judged_case(const SubmittedResult& result, std::size_t& speed_checks) {
  const Case contact_case = case_of(result);
  const CaseScales scales(std::get<ContactCase>(contact_case.body));
  JudgedCase judged{.id = contact_case.id,
                    .version = contact_case.version,
                    .title = contact_case.title,
                    .groups = scales.groups(),
                    .scores = {},
                    .wall_s = result.wall_s};
  const auto certified = certified_numbers(contact_case, scales);
  const auto numbers = compared_numbers(result, scales, certified, judged);
  for (const Certified& one : certified) judged.scores.push_back(score_of(one, numbers));
  if (certified.empty()) judged.hints.push_back(nothing_scored(contact_case));
  if (needs_hint(numbers)) {
    const bool may_solve = scales.groups().has_value() && speed_checks < most_speed_checks;
    if (may_solve) ++speed_checks;
    judged.hints = hints_for(contact_case, scales, numbers, may_solve);
  }
  if (result.profile) judged.profile = judged_profile(contact_case, scales, result, judged);
  return judged;
}

/// A first case that the submission leaves out: every number is missing.
JudgedCase left_out(const FirstCase& first) {
  std::size_t none = most_speed_checks;
  const Case contact_case = read_case(find_case(std::string(first.id)));
  JudgedCase judged = judged_case(
      {.case_id = contact_case.id, .version = contact_case.version, .numbers = {}, .place = contact_case.id}, none);
  judged.submitted = false;
  return judged;
}

std::vector<RegimeDigits> digits_by_regime(const std::vector<JudgedCase>& cases) {
  std::vector<RegimeDigits> table;
  for (const Regime& regime : all_regimes) {
    std::vector<double> digits, given;
    RegimeDigits row{.regime = regime};
    for (const JudgedCase& one : cases) {
      if (!one.groups || regime_of(*one.groups) != regime) continue;
      for (const Score& score : one.scores) {
        digits.push_back(score.digits);
        if (!score.missing()) given.push_back(score.digits);
      }
    }
    if (digits.empty()) continue;
    row.numbers = digits.size();
    row.missing = digits.size() - given.size();
    if (!given.empty()) row.median_given = verification::median(std::move(given));
    row.worst = *std::min_element(digits.begin(), digits.end());
    row.median = verification::median(std::move(digits));
    table.push_back(row);
  }
  return table;
}

}  // namespace

bool Judgement::gates_hold() const {
  for (const JudgedCase& one : cases) {
    if (!one.profile) continue;
    for (const Gate& gate : one.profile->gates)
      if (gate.verdict == verification::Verdict::fail) return false;
  }
  return true;
}

Judgement judgement_of(const Submission& submission, const JudgeRequest& request) {
  // All cases are looked up before the first profile is read: a wrong id is found at once.
  for (const SubmittedResult& result : submission.results) (void)case_of(result);
  std::map<std::string, JudgedCase> judged;
  std::size_t speed_checks = 0;
  for (const SubmittedResult& result : submission.results) {
    if (request.progress) request.progress(result.case_id, judged.size(), submission.results.size());
    judged.emplace(result.case_id, judged_case(result, speed_checks));
  }
  Judgement judgement{.submission = submission, .cases = {}, .regimes = {}};
  for (const FirstCase& first : first_cases) {
    const auto at = judged.find(std::string(first.id));
    judgement.cases.push_back(at == judged.end() ? left_out(first) : std::move(at->second));
    if (at != judged.end()) judged.erase(at);
  }
  for (auto& [id, one] : judged) judgement.cases.push_back(std::move(one));
  judgement.regimes = digits_by_regime(judgement.cases);
  for (const JudgedCase& one : judgement.cases) {
    for (const Score& score : one.scores) {
      judgement.met += score.honesty == Honesty::met ? 1 : 0;
      judgement.missed += score.honesty == Honesty::missed ? 1 : 0;
      judgement.undecided += score.honesty == Honesty::undecided ? 1 : 0;
    }
  }
  return judgement;
}

}  // namespace ehd::judging
