// SPDX-License-Identifier: GPL-3.0-or-later
// A submission made from the atlas with known errors is scored exactly as it has to be.
#include "verification/judge/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/nondimensional.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "verification/judge/first_cases.hpp"
#include "verification/judge/hints.hpp"
#include "verification/judge/judgement_text.hpp"
#include "verification/median.hpp"
#include "verification/report/judge_page.hpp"
#include "workflow/registry.hpp"

namespace ehd::judging {

namespace {

namespace test = verification::test;
using nlohmann::json;
using verification::Tolerance;

Case case_called(const std::string& id) { return read_case(find_case(id)); }

double digits_in(const std::string& id, Quantity quantity) {
  for (const Expectation& one : case_called(id).expectations)
    if (one.quantity == to_string(quantity)) return one.value;
  BOOST_FAIL(id + " has no " + std::string(to_string(quantity)));
  return 0;
}

/// In the scaling of the case's own digits.
json result_of(const std::string& id) {
  const Case one = case_called(id);
  return {{"case", id}, {"version", one.version}, {"scaling", to_string(one.expectations.front().scaling)}};
}

json submission_of(const std::vector<json>& results) {
  return {{"schema", "ehd-submission-1"}, {"solver", {{"name", "made"}}}, {"results", results}};
}

Judgement judged(const test::Folder& folder, const std::vector<json>& results) {
  return judgement_of(read_submission(folder.write("made.json", submission_of(results).dump())));
}

const JudgedCase& of_case(const Judgement& judgement, const std::string& id) {
  for (const JudgedCase& one : judgement.cases)
    if (one.id == id) return one;
  BOOST_FAIL(id + " is not judged");
  return judgement.cases.front();
}

const Score& score_in(const JudgedCase& one, Quantity quantity) {
  for (const Score& score : one.scores)
    if (score.certified.quantity == quantity) return score;
  BOOST_FAIL(one.id + " certifies no " + std::string(to_string(quantity)));
  return one.scores.front();
}

/// Rounding of a double, as it moves -log10 of an error.
Tolerance rounding_of_digits(double error) { return Tolerance::round_off(16, 1 / error); }

constexpr auto minimum = Quantity::film_minimum, central = Quantity::film_central;

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_judgement)

BOOST_AUTO_TEST_CASE(known_errors_in_the_digits_of_the_atlas_are_scored_exactly) {
  constexpr double stated = 1e-5;  // between both errors
  const std::string off_3 = "atlas-roelands-m20-l10-flooded", off_6 = "atlas-barus-m100-l10-flooded",
                    swapped = "atlas-roelands-m10-l10-flooded", exact = "atlas-isoviscous-m5-l0-flooded";
  const test::Folder folder;
  std::vector<json> results;
  for (const auto& [id, off] : {std::pair(off_3, 1e-3), std::pair(off_6, -1e-6), std::pair(exact, 0.0)}) {
    json one = result_of(id);
    one["film.minimum"] = digits_in(id, minimum) * (1 + off);
    one["film.central"] = digits_in(id, central) * (1 - off);
    one["stated_error"] = stated;
    results.push_back(one);
  }
  json wrong = result_of(swapped);
  wrong["film.minimum"] = digits_in(swapped, central);
  wrong["film.central"] = digits_in(swapped, minimum);
  results.push_back(wrong);
  const Judgement judgement = judged(folder, results);

  for (const auto& [id, off] : {std::pair(off_3, 1e-3), std::pair(off_6, 1e-6)}) {
    for (const Quantity film : {minimum, central}) {
      const Score& score = score_in(of_case(judgement, id), film);
      BOOST_REQUIRE(score.certified.uncertainty < off);
      EHD_CHECK(std::abs(score.digits + std::log10(off)), rounding_of_digits(off));
      BOOST_TEST((score.honesty == (off < stated ? Honesty::met : Honesty::missed)));
    }
    BOOST_TEST(of_case(judgement, id).hints.empty());
    const Score& missing = score_in(of_case(judgement, id), Quantity::pressure_exit);
    BOOST_TEST(missing.missing());
    BOOST_TEST(missing.digits == 0);
  }
  // The certified digits themselves score what is known of them, and no more.
  const Score& known = score_in(of_case(judgement, exact), minimum);
  EHD_CHECK(std::abs(known.digits + std::log10(known.certified.uncertainty)), Tolerance::round_off(16));

  const Score& mistaken = score_in(of_case(judgement, swapped), minimum);
  const double error = digits_in(swapped, central) / digits_in(swapped, minimum) - 1;
  EHD_CHECK(std::abs(mistaken.digits + std::log10(error)), rounding_of_digits(error));
  BOOST_REQUIRE(of_case(judgement, swapped).hints.size() == 1u);
  BOOST_TEST(of_case(judgement, swapped).hints[0].find("swapped") != std::string::npos);
  BOOST_TEST(judgement.met + judgement.missed + judgement.undecided == 6u);
  BOOST_TEST(judgement.missed == 2u);
}

BOOST_AUTO_TEST_CASE(every_first_case_certifies_both_films_to_seven_digits) {
  for (const FirstCase& first : first_cases) {
    const Case one = case_called(std::string(first.id));
    const auto digits = certified_numbers(one, CaseScales(std::get<ContactCase>(one.body)));
    for (const Quantity film : {minimum, central}) {
      const auto at = std::find_if(digits.begin(), digits.end(), [&](const auto& any) { return any.quantity == film; });
      BOOST_REQUIRE_MESSAGE(at != digits.end(), first.id);
      BOOST_CHECK_MESSAGE(at->uncertainty <= 1e-7, first.id << ": " << at->digits << ", " << at->uncertainty);
    }
  }
}

// The words about the heaviest case name what a kept submission scores.
BOOST_AUTO_TEST_CASE(the_last_first_case_says_what_the_small_solvers_leave) {
  const std::filesystem::path kept = std::filesystem::path(EHD_SOURCE_DIR) / "cases" / "submissions";
  const FirstCase& last = first_cases.back();
  const Judgement fortran = judgement_of(read_submission(kept / "line-contact-f90.json"), {});
  BOOST_TEST(std::string(last.tests)
                 .ends_with(fmt::format("cells of line_contact.f90 leave {:.1f} digits",
                                        score_in(of_case(fortran, std::string(last.id)), minimum).digits)),
             last.tests);
}

BOOST_AUTO_TEST_CASE(a_missing_first_case_scores_nothing_and_says_missing) {
  const test::Folder folder;
  std::vector<json> results;
  for (const FirstCase& first : first_cases) {
    if (first.id == first_cases[4].id) continue;
    const std::string id(first.id);
    json one = result_of(id);
    one["film.minimum"] = digits_in(id, minimum);
    one["film.central"] = digits_in(id, central);
    results.push_back(one);
  }
  const Judgement judgement = judged(folder, results);
  BOOST_REQUIRE(judgement.cases.size() == first_cases.size());
  std::size_t missing = 0;
  for (std::size_t i = 0; i < first_cases.size(); ++i) {
    BOOST_TEST(judgement.cases[i].id == first_cases[i].id);  // from easy to hard
    BOOST_TEST(judgement.cases[i].submitted == (i != 4));
    for (const Score& score : judgement.cases[i].scores) {
      const bool film = score.certified.quantity == minimum || score.certified.quantity == central;
      BOOST_TEST(score.missing() == !(film && i != 4));
      BOOST_TEST((score.digits > 0) == (film && i != 4));
      missing += score.missing() ? 1 : 0;
    }
  }
  std::size_t counted = 0;
  for (const RegimeDigits& row : judgement.regimes) {
    counted += row.missing;
    BOOST_TEST((row.worst == 0) == (row.missing > 0));
  }
  BOOST_TEST(counted == missing);
  BOOST_TEST(human_text(judgement).find("missing") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_median_by_regime_counts_a_missing_number_as_0) {
  BOOST_TEST(verification::median({3, 1, 2}) == 2);
  BOOST_TEST(verification::median({4, 1, 2, 3}) == 2.5);
  const test::Folder folder;
  const std::string id = "atlas-isoviscous-m20-l0-flooded";  // the only one of its regime beside the first case
  json one = result_of(id);
  for (const Quantity quantity : {minimum, central})
    one[std::string(to_string(quantity))] = digits_in(id, quantity) * (1 + 1e-4);
  const Judgement judgement = judged(folder, {one});
  const auto row = std::find_if(judgement.regimes.begin(), judgement.regimes.end(), [](const RegimeDigits& entry) {
    return entry.regime == Regime{.load = Load::moderate, .material = Material::low};
  });
  BOOST_REQUIRE(row != judgement.regimes.end());
  BOOST_TEST(row->numbers == row->missing + 2);
  BOOST_TEST(row->worst == 0);
  BOOST_TEST(row->median == 0);
  BOOST_REQUIRE(row->median_given.has_value());
  EHD_CHECK(std::abs(*row->median_given - 4), rounding_of_digits(1e-4));
}

BOOST_AUTO_TEST_CASE(stated_errors_are_met_missed_or_undecided) {
  BOOST_TEST((honesty_of(1e-4, 1e-6, 2e-4) == Honesty::met));
  BOOST_TEST((honesty_of(1e-4, 1e-6, 5e-5) == Honesty::missed));
  BOOST_TEST((honesty_of(1e-4, 1e-6, 1.005e-4) == Honesty::undecided));
  BOOST_TEST(log_relative_error(10, 1e-9) == 0);
  BOOST_TEST(log_relative_error(0, 0) < 16);
}

BOOST_AUTO_TEST_CASE(a_case_that_certifies_nothing_says_why) {
  const test::Folder folder;
  for (const auto& [id, why] :
       {std::pair("biboulet-houpert-rigid", "the case has a published fit and no certified digits: nothing is scored"),
        std::pair("venner1991-waiting", "the case has no digits yet: nothing is scored")}) {
    json one = result_of(id);
    one["scaling"] = "hertz";
    one["film.minimum"] = 1.0;
    const auto judgement = judged(folder, {one});
    BOOST_REQUIRE(of_case(judgement, id).hints.size() == 1u);
    BOOST_TEST(of_case(judgement, id).hints[0] == why);
    BOOST_TEST(human_text(judgement).find("film.minimum is not scored: the case certifies no digits of it") !=
               std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(usual_mistakes_of_unit_get_a_hint) {
  const test::Folder folder;
  const std::string id = "own-moes-20-10", in_SI = "own-steel-20-10";
  const double film = digits_in(id, minimum), middle = digits_in(id, central);
  const auto hint_of = [&](json one, double first, double second) {
    one["film.minimum"] = first;
    one["film.central"] = second;
    const Judgement judgement = judged(folder, {one});
    const auto& hints = of_case(judgement, one["case"]).hints;
    return hints.empty() ? std::string() : hints[0];
  };
  const double moes = 8 * 20 / M_PI;
  BOOST_TEST(hint_of(result_of(id), film * moes, middle * moes).find("\"moes\"") != std::string::npos);
  BOOST_TEST(hint_of(result_of(id), film * 2, middle * 2).find("\"kostreva\"") != std::string::npos);
  BOOST_TEST(hint_of(result_of(id), film, middle) == "");
  BOOST_TEST(hint_of(result_of(id), film * 1.5, middle * 1.3) == "");  // wrong, but in no usual way

  // The same contact with the mean speed where the sum belongs, and the sum where the mean speed does.
  const Case stated = case_called(id);
  const auto& contact = std::get<ContactCase>(stated.body);
  for (const auto& [factor, question] :
       {std::pair(2.0, "is your u the mean speed?"), std::pair(0.5, "did you put the mean speed where")}) {
    Problem problem = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem;
    const HertzGroups groups{.lambda = factor * problem.groups.lambda, .alpha_p_H = problem.groups.alpha_p_H};
    problem.groups = groups_from(groups);
    const auto films = default_solver().solve(problem, Request{.tolerance = 1e-3}).observables;
    BOOST_TEST(hint_of(result_of(id), films.at(minimum).value, films.at(central).value).find(question) !=
               std::string::npos);
  }

  // The same in Moes units: of the case, or of the wrong speed.
  for (const char* const each :
       {"own-moes-20-10", "own-moes-5-5", "own-moes-100-10", "own-barus-3-4-flooded", "own-isoviscous-10-0"}) {
    const Case one = case_called(each);
    const auto& body = std::get<ContactCase>(one.body);
    json in_moes = result_of(each);
    in_moes["scaling"] = "moes";
    for (const auto& [factor, question] : {std::pair(2.0, "twice the speed: is your u the mean speed?"),
                                           std::pair(0.5, "half the speed: did you put")}) {
      Problem problem = nondimensionalise(body.statement, *body.lubricant, *body.inlet).problem;
      const double M_of_case = problem.groups.M;
      problem.groups =
          groups_from(HertzGroups{.lambda = factor * problem.groups.lambda, .alpha_p_H = problem.groups.alpha_p_H});
      const auto films = default_solver().solve(problem, Request{.tolerance = 1e-3}).observables;
      for (const double M : {M_of_case, problem.groups.M}) {
        const double unit = moes_film_per_hertz_film(M);
        const std::string hint = hint_of(in_moes, films.at(minimum).value * unit, films.at(central).value * unit);
        BOOST_CHECK_MESSAGE(hint.find(question) != std::string::npos, each << ", M = " << M << ": " << hint);
      }
    }
    const CaseScales scales(body);
    const auto digits = certified_numbers(one, scales);
    BOOST_REQUIRE(digits.size() >= 2u);
    const double root_2 = std::sqrt(2), unit = *scales.unit(minimum, Scaling::moes);
    const auto of_unit = [&](double off) { return hint_of(in_moes, digits[0].value * off, digits[1].value * off); };
    BOOST_TEST(of_unit(unit * root_2).find("Moes units of half the speed") != std::string::npos);
    BOOST_TEST(of_unit(unit / root_2).find("Moes units of twice the speed") != std::string::npos);
  }
  // A film that is close to another one is no swap where the other film is explained by nothing.
  BOOST_TEST(hint_of(result_of(id), middle, middle * 1.5) == "");

  json micrometres = result_of(in_SI);
  micrometres["scaling"] = "SI";
  const CaseScales scales(std::get<ContactCase>(case_called(in_SI).body));
  const double metres = *scales.unit(minimum, Scaling::SI);
  const auto certified = certified_numbers(case_called(in_SI), scales);
  BOOST_REQUIRE(certified.size() >= 2u);
  BOOST_TEST(hint_of(micrometres, certified[0].value * metres * 1e6, certified[1].value * metres * 1e6).find("um") !=
             std::string::npos);
}

// Where the bodies hardly deform, the film is proportional to the speed, and Kostreva's film is twice that of Hertz.
BOOST_AUTO_TEST_CASE(twice_the_speed_of_a_light_contact_is_not_mistaken_for_another_scaling) {
  const test::Folder folder;
  const auto hints_of = [&](const std::string& id, double factor, bool speed) {
    const Case stated = case_called(id);
    const auto& contact = std::get<ContactCase>(stated.body);
    Problem problem = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem;
    if (speed)
      problem.groups =
          groups_from(HertzGroups{.lambda = factor * problem.groups.lambda, .alpha_p_H = problem.groups.alpha_p_H});
    const auto films = default_solver().solve(problem, Request{.tolerance = 1e-4}).observables;
    json one = result_of(id);
    one["scaling"] = "hertz";
    for (const Quantity film : {minimum, central})
      one[std::string(to_string(film))] = films.at(film).value * (speed ? 1 : factor);
    return of_case(judged(folder, {one}), id).hints;
  };
  const auto named = [](const std::vector<std::string>& hints, const std::string& words) {
    return std::any_of(hints.begin(), hints.end(),
                       [&](const std::string& hint) { return hint.find(words) != std::string::npos; });
  };
  for (const char* const id : {"atlas-barus-m0.05-l2.5-flooded", "atlas-isoviscous-m0.2-l0-flooded",
                               "atlas-roelands-m0.2-l2.5-flooded", "atlas-isoviscous-m0.5-l0-flooded"}) {
    BOOST_CHECK_MESSAGE(named(hints_of(id, 2, true), "twice the speed"), id);
    BOOST_CHECK_MESSAGE(named(hints_of(id, 0.5, true), "half the speed"), id);
    BOOST_CHECK_MESSAGE(named(hints_of(id, 2, false), "\"kostreva\""), id);
  }
  // The films of the lightest contact differ too little between the two mistakes: both are named.
  BOOST_TEST(hints_of("atlas-isoviscous-m0.05-l0-flooded", 2, true).size() == 2u);
  BOOST_TEST(hints_of("atlas-isoviscous-m0.5-l0-flooded", 2, true).size() == 1u);
  BOOST_TEST(hints_of("atlas-isoviscous-m0.5-l0-flooded", 2, false).size() == 1u);
}

BOOST_AUTO_TEST_CASE(one_film_in_another_unit_is_named_beside_right_ones) {
  const test::Folder folder;
  const std::string id = "own-moes-20-10";
  const auto hints_of = [&](const std::string& rows) {
    const auto file = folder.write("mine.csv", "case,version,quantity,value,scaling\n" + rows);
    return of_case(judgement_of(read_submission(file)), id).hints;
  };
  const std::string right = fmt::format("{},1,film.minimum,{},hertz\n", id, digits_in(id, minimum));
  const auto hints = hints_of(
      fmt::format("{}{},1,film.central,{},hertz\n", right, id, digits_in(id, central) * moes_film_per_hertz_film(20)));
  BOOST_REQUIRE(hints.size() == 1u);
  BOOST_TEST(hints[0] == "film.central fits the scaling \"moes\", but \"hertz\" is named: which one is right?");
  // One film only is not from a solve at another speed.
  BOOST_TEST(hints_of(fmt::format("{}{},1,film.central,{},hertz\n", right, id, digits_in(id, central) * 1.6)).empty());

  const std::string with_offset = "kostreva-100lb-500rpm";
  json offset = result_of(with_offset);
  offset["film.minimum"] = digits_in(with_offset, minimum);
  offset["film.central"] = digits_in(with_offset, Quantity::film_offset);
  const auto offset_hints = of_case(judged(folder, {offset}), with_offset).hints;
  BOOST_REQUIRE(offset_hints.size() == 1u);
  BOOST_TEST(offset_hints[0].starts_with("film.central is close to the certified film.offset"));

  const std::string in_SI = "own-steel-20-10";
  const CaseScales scales(std::get<ContactCase>(case_called(in_SI).body));
  const auto certified = certified_numbers(case_called(in_SI), scales);
  BOOST_REQUIRE(certified.size() >= 2u);
  const double metres = *scales.unit(certified[1].quantity, Scaling::SI);
  const auto file =
      folder.write("SI.csv", fmt::format("case,version,quantity,value,scaling\n{0},1,{1},{2},hertz\n{0},1,{3},{4},SI\n",
                                         in_SI, to_string(certified[0].quantity), certified[0].value,
                                         to_string(certified[1].quantity), certified[1].value * metres * 1e6));
  const auto micrometres = of_case(judgement_of(read_submission(file)), in_SI).hints;
  BOOST_REQUIRE(micrometres.size() == 1u);
  BOOST_TEST(micrometres[0] == fmt::format("{} fits um; the scaling SI means m", to_string(certified[1].quantity)));
}

BOOST_AUTO_TEST_CASE(the_pressure_of_a_profile_is_compared_with_the_certified_solver_s) {
  const test::Folder folder;
  const std::string id = "own-barus-5-5";
  const Fields fields = run_contact(case_called(id), certified_solver(), Request{.tolerance = 1e-6}).solution.fields;
  json one = result_of(id);
  one["profile"] = "p.csv";
  const auto error_of_multiple = [&](double factor) {
    std::string rows = "X,P,H\n";
    for (Eigen::Index i = 0; i < fields.X.size(); ++i)
      rows += fmt::format("{},{},{}\n", fields.X[i], fields.P[i] * factor, fields.H[i]);
    (void)folder.write("p.csv", rows);
    const Judgement judgement = judged(folder, {one});
    BOOST_TEST(human_text(judgement).find("P (L2)") != std::string::npos);
    return of_case(judgement, id).profile.value().pressure_error.value();
  };
  // The solver's P is a polynomial between these nodes, a profile's is linear there.
  const double interpolation = error_of_multiple(1), off = 0.1;
  EHD_CHECK(interpolation, Tolerance::required(1e-3, "the profile is the solver's own"));
  EHD_CHECK(std::abs(error_of_multiple(1 + off) - off), Tolerance::discretisation(interpolation, 1 + off));
}

BOOST_AUTO_TEST_CASE(a_cut_profile_is_not_compared_and_a_mirrored_one_gets_a_hint) {
  const test::Folder folder;
  const std::string id = "own-moes-20-10";
  const Fields fields = run_contact(case_called(id), default_solver(), Request{.tolerance = 1e-4}).solution.fields;
  json one = result_of(id);
  one["profile"] = "p.csv";
  const auto judged_with = [&](const Array& X, const Array& P, const Array& H, bool says_cut) {
    std::string rows = "X,P,H,P_unresolved\n";
    for (Eigen::Index i = 0; i < X.size(); ++i)
      rows += fmt::format("{},{},{},{}\n", X[i], P[i], H[i], says_cut && P[i] == P.maxCoeff() ? 1 : 0);
    (void)folder.write("p.csv", rows);
    return of_case(judged(folder, {one}), id);
  };
  const Array cut = fields.P.min(0.5);
  BOOST_TEST(judged_with(fields.X, cut, fields.H, false).profile->pressure_error.has_value());
  BOOST_TEST(!judged_with(fields.X, cut, fields.H, true).profile->pressure_error.has_value());

  const JudgedCase right = judged_with(fields.X, fields.P, fields.H, false);
  BOOST_TEST(right.hints.empty());
  const JudgedCase mirrored = judged_with(-fields.X.reverse(), fields.P.reverse(), fields.H.reverse(), false);
  for (const Gate& gate : mirrored.profile->gates) BOOST_TEST((gate.verdict == verification::Verdict::pass));
  BOOST_REQUIRE(mirrored.hints.size() == 1u);
  BOOST_TEST(mirrored.hints[0].find("X turned round") != std::string::npos);

  // Without a film.minimum beside it, the film of a profile is held against the certified one.
  const JudgedCase raised = judged_with(fields.X, fields.P, fields.H + 0.5, false);
  BOOST_REQUIRE(raised.hints.size() == 1u);
  BOOST_TEST(raised.hints[0].find("but the certified film.minimum is 0.07414") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_profile_that_contradicts_its_films_gets_a_hint) {
  const test::Folder folder;
  const std::string id = "own-moes-20-10";
  const Fields fields = run_contact(case_called(id), default_solver(), Request{.tolerance = 1e-4}).solution.fields;
  json one = result_of(id);
  one["film.minimum"] = digits_in(id, minimum);
  one["profile"] = "p.csv";
  const auto judged_with = [&](const Array& P, const Array& H) {
    std::string rows = "X,P,H\n";
    for (Eigen::Index i = 0; i < H.size(); ++i) rows += fmt::format("{},{},{}\n", fields.X[i], P[i], H[i]);
    (void)folder.write("p.csv", rows);
    return judged(folder, {one});
  };
  BOOST_TEST(of_case(judged_with(fields.P, fields.H), id).hints.empty());

  // The film equation holds whatever H_0 is.
  const Judgement raised = judged_with(fields.P, fields.H + 0.5);
  BOOST_TEST(raised.gates_hold());
  BOOST_REQUIRE(of_case(raised, id).hints.size() == 1u);
  const std::string& hint = of_case(raised, id).hints[0];
  BOOST_TEST(hint.find("smallest H of the profile is 0.574") != std::string::npos);
  BOOST_TEST(hint.find("film.minimum is 0.07414") != std::string::npos);

  const Judgement in_moes = judged_with(fields.P, fields.H * moes_film_per_hertz_film(20));
  BOOST_TEST(!in_moes.gates_hold());
  BOOST_REQUIRE(of_case(in_moes, id).hints.size() == 1u);
  BOOST_TEST(of_case(in_moes, id).hints[0].find("H of the profile fits the scaling \"moes\"") != std::string::npos);

  const Judgement empty = judged_with(Array::Zero(fields.P.size()), fields.H);
  BOOST_TEST(!empty.gates_hold());
  BOOST_TEST(human_text(empty).find("film equation: no pressure to judge\n") != std::string::npos);
  const Json document = to_json(empty);
  BOOST_REQUIRE(document["cases"][4]["case"] == id);
  for (const auto& gate : document["cases"][4]["profile"]["gates"]) BOOST_TEST(gate["error"] == 1.0);
}

BOOST_AUTO_TEST_CASE(the_page_and_the_badge_show_every_submission_and_no_total) {
  const test::Folder folder;
  json one = result_of("own-barus-5-5");
  one["film.minimum"] = digits_in("own-barus-5-5", minimum) * (1 + 1e-4);
  json hostile = submission_of({one});
  hostile["solver"]["name"] = "<script>alert(1)</script>";
  const Json judgement = to_json(judgement_of(read_submission(folder.write("made.json", hostile.dump()))));
  const std::string page = report::judge_page({judgement, judgement});
  BOOST_TEST(page.find("alert(1)") != std::string::npos);
  BOOST_TEST(page.find("<script>alert") == std::string::npos);
  BOOST_TEST(page.find("own-barus-5-5") != std::string::npos);
  BOOST_TEST(page.find("4.0") != std::string::npos);
  // No column without a number: none has a time or a profile. A number that a case does not have stands where numbers
  // do.
  for (const char* absent : {"time [s]", "P, L2", "<td>-</td>", "<td class=\"name\">-</td>"})
    BOOST_TEST(page.find(absent) == std::string::npos, absent);
  const std::string badge = report::judge_badge(judgement);
  BOOST_TEST(badge.starts_with("<svg"));
  BOOST_TEST(badge.find("<script>") == std::string::npos);
  BOOST_TEST(badge.find("moderate 4.0 | ") != std::string::npos);
  BOOST_TEST(badge.find("light") == std::string::npos);  // nothing light was given: that is no score of 0
  BOOST_TEST(badge.find(" missing") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::judging
