// SPDX-License-Identifier: GPL-3.0-or-later
// Submissions are read as strictly as case files: one line, or a result.
#include "verification/judge/submission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/profile_csv.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "verification/judge/judgement.hpp"
#include "verification/judge/profile_gates.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::judging {

namespace {

namespace test = verification::test;

/// The message of a refusal; a submission that is accepted fails the test.
std::string refusal_of(const test::Folder& folder, const std::string& name, const std::string& text) {
  try {
    (void)judgement_of(read_submission(folder.write(name, text)));
  } catch (const CaseError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find('\n') == std::string::npos);
    BOOST_TEST(message.starts_with(folder.path().string()));  // the submission, or its profile
    BOOST_TEST(message.size() < 700u);
    return message;
  }
  BOOST_ERROR("accepted: " << text);
  return "";
}

std::string submission_with(const std::string& result) {
  return R"({"schema": "ehd-submission-1", "solver": {"name": "n"}, "results": [)" + result + "]}";
}

const std::string good = R"("case": "own-barus-5-5", "version": 1, "scaling": "hertz", "film.minimum": 0.2467)";

SubmittedProfile solved_profile(const std::string& id, double tolerance) {
  const Case one = read_case(find_case(id));
  const ContactRun run = run_contact(one, default_solver(), Request{.tolerance = tolerance});
  BOOST_REQUIRE((run.status() == StopReason::converged));
  const Fields& fields = run.solution.fields;
  return {.X = fields.X, .P = fields.P, .H = fields.H};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_submission)

BOOST_AUTO_TEST_CASE(bad_json_is_one_line) {
  const test::Folder folder;
  const auto refused = [&](const std::string& text, const std::string& says) {
    const std::string message = refusal_of(folder, "bad.json", text);
    BOOST_CHECK_MESSAGE(message.find(says) != std::string::npos, says << " is not in: " << message);
  };
  refused("", "is no JSON: the file is empty");
  refused("\xEF\xBB\xBF \n", "is no JSON: the file is empty");
  refused(std::string("{\0}\0", 4), "is binary, or UTF-16");
  refused("[1", "is no JSON");
  refused("{}", "schema: is missing");
  refused(R"({"schema": "ehd-submission-2", "solver": {"name": "n"}, "results": []})",
          "did you mean ehd-submission-1? allowed is ehd-submission-1");
  refused(R"({"shema": "ehd-submission-1", "results": []})",
          "shema: is unknown; did you mean schema? allowed is schema");
  refused(R"({"schema": "ehd-submission-1", "results": []})", "solver: is missing");
  refused(R"({"schema": "ehd-submission-1", "solver": {"name": "n"}, "results": []})", "results: is missing or empty");
  refused(submission_with("{" + good + R"(, "film.minimun": 1})"),
          "film.minimun: is unknown; did you mean film.minimum? allowed");
  refused(submission_with("{" + good + R"(, "load_error": 1})"), "load_error: is unknown");
  refused(submission_with("{" + good + R"(, "film.central": NaN})"), "NaN at byte");
  refused(submission_with("{" + good + R"(, "film.central": "NaN"})"), "required is a number");
  refused(submission_with("{" + good + R"(, "film.central": null})"), "is null");
  refused(submission_with("{" + good + R"(, "film.central": 1e999})"), "out of range");
  refused(submission_with("{" + good + R"(, "film.central": -0.1})"), "is not positive");
  refused(submission_with("{" + good + R"(, "film.central": 1e101})"), "film.central = 1e101: is out of range");
  refused(submission_with("{" + good + R"(, "stated_error": 0})"), "stated_error = 0");
  refused(submission_with("{" + good + R"(, "wall_s": -1})"), "wall_s = -1");
  refused(submission_with("{" + good + R"(, "profile": "../p.csv"})"), "allowed is a file beside the submission");
  refused(submission_with("{" + good + R"(, "profile": "/etc/passwd"})"), "allowed is a file beside the submission");
  refused(submission_with("{" + good + R"(, "profile": "none.csv"})"), "there is no such file");
  refused(submission_with(fmt::format("{{{}}}, {{{}}}", good, good)), "is there twice");
  refused(submission_with(R"({"case": "own-barus-5-5", "version": 1, "scaling": "hertz"})"), "has no quantity");
  refused(submission_with(R"({"case": "own-barus-5-5", "version": 2, "scaling": "hertz", "film.minimum": 1})"),
          "is not the version of own-barus-5-5");
  refused(
      submission_with(R"({"case": "own-barus-5-6", "version": 1, "scaling": "hertz", "film.minimum": 1})"),
      "there is no such case; did you mean own-barus-5-5? allowed is an id that `ehd cases` or `ehd cases --atlas`");
  refused(submission_with(R"({"case": "own-barus-5-5", "version": 1, "scaling": "herz", "film.minimum": 1})"),
          "scaling = herz: is unknown; did you mean hertz? allowed is hertz");
  refused(submission_with(R"({"case": "../own", "version": 1, "scaling": "hertz", "film.minimum": 1})"), "is no id");
  refused(submission_with(R"({"case": "na4908", "version": 1, "scaling": "hertz", "film.minimum": 1})"),
          "is a bearing");
  refused(submission_with(R"({"case": "own-barus-5-5", "version": 1, "scaling": "inch", "film.minimum": 1})"),
          "scaling = inch: is unknown");
  refused(submission_with(R"({"case": "own-barus-5-5", "version": 1, "scaling": "SI", "film.minimum": 1})"),
          "has no such scale");
  // In scaling moes the films are right; the exit alone has no such scale.
  refused(submission_with(
              R"({"case": "own-barus-5-5", "version": 1, "scaling": "moes", "film.minimum": 3, "pressure.exit": 1})"),
          "leave it out (each row of a CSV has a scaling of its own)");
  refused(R"({"schema": "ehd-submission-1", "solver": {"name": "a\u001b[31m"}, "results": []})", "control character");
  refused(R"({"schema": "ehd-submission-1", "solver": {"name": ")" + std::string(300, 'x') + R"("}, "results": []})",
          "is too long");
}

BOOST_AUTO_TEST_CASE(bad_csv_is_one_line_with_its_number) {
  const test::Folder folder;
  const std::string header = "case,version,quantity,value,scaling\n";
  const auto refused = [&](const std::string& text, const std::string& says) {
    const std::string message = refusal_of(folder, "bad.csv", text);
    BOOST_CHECK_MESSAGE(message.find(says) != std::string::npos, says << " is not in: " << message);
  };
  refused("", "is empty");
  refused(header, "has no rows");
  refused("case,version,quantity,value\n", "column scaling is missing");
  refused("case,version,quantity,value,scaling,note\n", "column note: is unknown");
  refused("case,version,quantity,value,scalling\n",
          "column scalling: is unknown; did you mean scaling? allowed is case");
  refused(header + "own-barus-5-5,1,film.minimum,nan,hertz\n", "bad.csv:2: value = nan: is not finite");
  refused(header + "own-barus-5-5,1,film.minimum,0.2x,hertz\n", "is not a number");
  refused(header + "own-barus-5-5,1,film.minimum\n", "bad.csv:2: has 3 cells");
  refused(header + "own-barus-5-5,1,film.min,0.2,hertz\n", "film.min: is unknown; did you mean film.minimum? allowed");
  refused(header + "own-barus-5-5,1,film.minimum,0.2,hertz\n\nown-barus-5-5,1,film.minimum,0.2,hertz\n",
          "bad.csv:4: quantity = film.minimum: is there twice");
  refused(header + "own-barus-5-5,1,film.minimum,0.2,hertz\nown-barus-5-5,2,film.central,0.2,hertz\n",
          "differs from the version 1 of the case at");
  refused(header + "\"own-barus-5-5\n\",1,film.minimum,0.2,hertz\n", "case = own-barus-5-5\\n: is no id");
  refused(header + "own-barus-5-5,1,film.minimum,\"0,2\",hertz\n", "value = 0,2: is not a number");
  refused(header + "own-barus-5-5,1,film.minimum,-1e200,hertz\n", "film.minimum = -1e200: is out of range");
  std::string wide = "case";
  for (int i = 0; i < 100; ++i) wide += ",c" + std::to_string(i);
  refused(wide + "\n", "bad.csv:1: has 101 columns; allowed are up to 64");
}

BOOST_AUTO_TEST_CASE(all_faults_of_a_csv_are_named_at_once) {
  const test::Folder folder;
  const auto lines_of = [&](const std::string& text) {
    std::vector<std::string> lines;
    try {
      (void)read_submission(folder.write("bad.csv", text));
    } catch (const CaseError& error) {
      lines.emplace_back(error.what());
      lines.insert(lines.end(), error.more().begin(), error.more().end());
    }
    for (std::string& line : lines) line.erase(0, (folder.path() / "bad.csv").string().size());
    return lines;
  };
  const auto check = [&](const std::string& text, const std::vector<std::string>& beginnings) {
    const auto lines = lines_of(text);
    BOOST_REQUIRE(lines.size() == beginnings.size());
    for (std::size_t i = 0; i < lines.size(); ++i) BOOST_TEST(lines[i].starts_with(beginnings[i]), lines[i]);
  };
  check("case,solver,vallue,wall\n",
        {":1: column solver: is unknown", ":1: column vallue: is unknown; did you mean value?",
         ":1: column wall: is unknown", ":1: column version is missing", ":1: column quantity is missing",
         ":1: column scaling is missing"});
  const std::string header = "case,version,quantity,value,scaling\n", good = "own-barus-5-5,1,film.minimum,0.2,hertz\n";
  check(header + good + "own-barus-5-5,0.5,film.central,1,hertz\nown-barus-5-5,1,film.central,1\n" +
            "own-moes-5-5,x,film.central,1,hertz\nown-moes-5-5,1,film.central,nan,hertz\n",
        {":3: version = 0.5: is no version", ":4: has 4 cells", ":5: version = x: is not a number",
         ":6: value = nan: is not finite"});
  check(header + "own-barus-5-5,1,film.min,1,hertz\n\"own", {":2: film.min: is unknown", ":3: has a quotation mark"});
  // Which of the rows is wrong is not known: one line for a case.
  check(header + "own-moes-5-5,2,film.central,1,hertz\nown-moes-5-5,1,film.minimum,1,hertz\n" +
            "own-moes-5-5,1,film.couette,1,hertz\n",
        {":3: version = 1: differs from the version 2"});
  std::string many = header;
  for (int row = 0; row < 100; ++row) many += "own-barus-5-5,1,film.minimum,x,hertz\n";
  const auto lines = lines_of(many);
  BOOST_REQUIRE(lines.size() == 21U);
  BOOST_TEST(lines.back() == ":21: up to here; the lines behind are not read");
}

BOOST_AUTO_TEST_CASE(the_two_forms_say_the_same) {
  const test::Folder folder;
  const auto by_json =
      judgement_of(read_submission(folder.write("a.json", submission_with("{" + good + R"(, "stated_error": 1e-3})"))));
  const auto by_csv = judgement_of(read_submission(
      folder.write("a.csv",
                   "\xEF\xBB\xBF"
                   "quantity, case, value, version, scaling, stated_error\r\nfilm.minimum, own-barus-5-5, 0.2467, 1, "
                   "hertz, 1e-3\r\n")));
  BOOST_REQUIRE(by_json.cases.size() == by_csv.cases.size());
  for (std::size_t i = 0; i < by_json.cases.size(); ++i)
    for (std::size_t k = 0; k < by_json.cases[i].scores.size(); ++k) {
      BOOST_TEST(by_json.cases[i].scores[k].digits == by_csv.cases[i].scores[k].digits);
      BOOST_TEST((by_json.cases[i].scores[k].honesty == by_csv.cases[i].scores[k].honesty));
    }
  BOOST_TEST(by_csv.met == 1u);

  // The same files as other programs write them.
  const auto digits = [](const std::filesystem::path& file) {
    const JudgedCase second = judgement_of(read_submission(file)).cases[1];  // a copy: the judgement is a temporary
    BOOST_TEST(second.id == "own-barus-5-5");
    return second.scores[0].digits;
  };
  const double expected = by_json.cases[1].scores[0].digits;
  BOOST_TEST(expected > 4);
  BOOST_TEST(digits(folder.write("b.json", "\xEF\xBB\xBF" + submission_with("{" + good + "}"))) == expected);
  BOOST_TEST(digits(folder.write("B.CSV",
                                 "\"case\",\"version\",\"quantity\",\"value\",\"scaling\"\r\"own-barus-5-5\",\"1\","
                                 "\"film.minimum\",\"0.2467\",\"hertz\"\r")) == expected);
}

BOOST_AUTO_TEST_CASE(a_bad_profile_is_one_line) {
  const test::Folder folder;
  const auto refused = [&](const std::string& text, const std::string& says) {
    (void)folder.write("p.csv", text);
    try {
      (void)read_profile(folder.path() / "p.csv");
      BOOST_ERROR("accepted: " << text);
    } catch (const CaseError& error) {
      const std::string message = error.what();
      BOOST_CHECK_MESSAGE(message.find(says) != std::string::npos, says << " is not in: " << message);
    }
  };
  refused("X,P\n", "column H is missing");
  refused("X [x/b],P,H\n0,1,1\n0,1,1\n", "p.csv:3: X = 0: is not above the X before it");
  refused("X,P,H\n1,1,1\n0,1,1\n", "p.csv:3: X = 0: is not above");
  refused("X,P,H\n0,inf,1\n", "is not finite");
  refused("X,P,H\n0,1,1\n", "required are 16 at least");
  refused("X,P,H\n1e9,1,1\n", "is far outside");
  refused("X,P,H\n0,1e308,1\n", "is far outside; allowed is P = p/p_H");
  refused("X,P,H\n0,1,1e308\n", "is far outside; allowed is H = h R/b^2");
  std::string long_one = "X,P,H\n";
  for (int i = 0; i <= 100000; ++i) long_one += std::to_string(i) + ",0,1\n";
  refused(long_one, "has more than 100000 rows; allowed are at most 100000");
  refused(std::string(std::size_t{40} << 20, 'x'), "is larger than 32 MiB");
}

BOOST_AUTO_TEST_CASE(a_profile_may_be_quoted) {
  const test::Folder folder;
  std::string plain = "X,P,H,note\n", quoted = "\"X [x/b]\",\"P\",\"H\",\"note\"\r\n";
  for (int i = 0; i < 20; ++i) {
    plain += fmt::format("{},0.5,1,\n", i);
    quoted += fmt::format("\"{}\", \"0.5\",1,\"row {},\r\n \"\"{}\"\"\"\r\n", i, i, i);
  }
  const SubmittedProfile one = read_profile(folder.write("a.csv", plain)),
                         two = read_profile(folder.write("b.csv", quoted));
  BOOST_TEST(one.X.size() == 20);
  BOOST_TEST(((one.X == two.X).all() && (one.P == two.P).all() && (one.H == two.H).all()));
}

BOOST_AUTO_TEST_CASE(gates_hold_for_a_solution_and_fail_for_each_wrong_equation) {
  const auto verdicts = [](const SubmittedProfile& profile) {
    std::vector<verification::Verdict> all;
    for (const Gate& gate : gates_of(profile, 0)) all.push_back(gate.verdict);
    return all;
  };
  using verification::Verdict;
  constexpr auto load = 0U, film = 1U, sign = 2U;
  for (const char* id : {"own-moes-20-10", "own-barus-3-4-flooded", "own-moes-100-10"}) {
    BOOST_TEST_CONTEXT(id) {
      const SubmittedProfile right = solved_profile(id, 1e-4);
      for (const Gate& gate : gates_of(right, 0))
        BOOST_CHECK_MESSAGE(gate.verdict == Verdict::pass,
                            gate.name << ": " << gate.error << " > " << gate.tolerance.value());
      SubmittedProfile wrong = right;
      wrong.P *= 1.01;
      BOOST_TEST((verdicts(wrong)[load] == Verdict::fail));
      wrong = right;
      wrong.H *= 1.1;
      BOOST_TEST((verdicts(wrong)[film] == Verdict::fail));
      wrong = right;
      wrong.P[2] = -1e-3;
      BOOST_TEST((verdicts(wrong)[sign] == Verdict::fail));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_profile_without_pressure_or_without_a_film_fails_the_film_equation) {
  constexpr Eigen::Index nodes = 20;
  const SubmittedProfile flat{.X = Array::LinSpaced(nodes, -2, 1), .P = Array::Ones(nodes), .H = Array::Ones(nodes)};
  SubmittedProfile negative = flat, peak = flat, other_peak = flat, closed = flat;
  negative.P = -1;
  peak.P = 0;
  peak.P[5] = 1;          // not a node of the halved profile
  other_peak.P[6] = 1e5;  // H_0 is fitted: at one node alone nothing would be left
  closed.H = 0;
  for (const SubmittedProfile& wrong : {negative, peak, other_peak, closed}) {
    const std::vector<Gate> gates = gates_of(wrong, 0);
    BOOST_TEST(gates[1].name == "film equation");
    BOOST_TEST((gates[1].verdict == verification::Verdict::fail));
    BOOST_TEST(!gates[1].judged);
    BOOST_TEST(gates[1].error == 1);
    for (const Gate& gate : gates) BOOST_TEST(std::isfinite(gate.tolerance.value()));
  }
  SubmittedProfile zeros = flat;
  zeros.P = 0;
  for (const std::size_t gate : {1U, 2U}) BOOST_TEST(gates_of(zeros, 0)[gate].quadrature == "no pressure to judge");
}

BOOST_AUTO_TEST_CASE(a_dry_contact_and_a_cut_spike_are_no_faults) {
  using verification::Verdict;
  constexpr auto film = 1U;
  const SubmittedProfile dry = solved_profile("dry-steel", 1e-3);
  BOOST_TEST((gates_of(dry, 0, true)[film].verdict == Verdict::pass));
  SubmittedProfile wrong = dry;
  wrong.H += 0.1 * wrong.X;
  BOOST_TEST((gates_of(wrong, 0, true)[film].verdict == Verdict::fail));

  SubmittedProfile cut = solved_profile("own-moes-20-10", 1e-4);
  cut.P = cut.P.min(0.5);
  BOOST_TEST((gates_of(cut, 0)[film].verdict == Verdict::fail));
  cut.cut = cut.P >= 0.5;
  BOOST_TEST((gates_of(cut, 0)[film].verdict == Verdict::inconclusive));
}

BOOST_AUTO_TEST_CASE(a_cut_excuses_no_more_than_its_rows_can_hold) {
  using verification::Verdict;
  constexpr auto load = 0U, film = 1U;
  const test::Folder folder;
  const auto times = [](SubmittedProfile profile, double factor) {
    profile.P *= factor;
    return gates_of(profile, 0);
  };
  const auto integral = [](const Array& X, const Array& y) {
    const Eigen::Index last = X.size() - 1;
    return ((X.tail(last) - X.head(last)) * (y.tail(last) + y.head(last)) / 2).sum();
  };
  for (const auto& [id, tolerance] : {std::pair("own-barus-20-10", 1e-2), std::pair("own-barus-20-10", 1e-3),
                                      std::pair("own-barus-20-10", 1e-4), std::pair("own-barus-20-10-flooded", 1e-4)}) {
    BOOST_TEST_CONTEXT(id << " at " << tolerance) {
      // The program's own profile, whose spike is not resolved.
      const ContactRun run = run_contact(read_case(find_case(id)), default_solver(), Request{.tolerance = tolerance});
      const SubmittedProfile shown = read_profile(folder.write("p.csv", profile_csv(run)));
      BOOST_REQUIRE(shown.cut.any());
      for (const Gate& gate : gates_of(shown, 0))
        BOOST_CHECK_MESSAGE(gate.verdict != Verdict::fail,
                            gate.name << ": " << gate.error << " > " << gate.tolerance.value());
      // Too much load is no cut.
      BOOST_TEST((times(shown, 1.3)[load].verdict == Verdict::fail));
      BOOST_TEST((times(shown, 1.3)[film].verdict == Verdict::fail));
      // A spike may hold the load that is missing; but then the film has another shape.
      BOOST_TEST((times(shown, 0.9)[load].verdict == Verdict::inconclusive));
      BOOST_TEST((times(shown, 0.9)[film].verdict == Verdict::fail));
      // No spike is taller than 100 p_H: a tenth more is missing than such spikes would hold in the cut rows.
      const double taller =
          (std::numbers::pi / 2 - 110 * integral(shown.X, shown.cut.cast<double>())) / integral(shown.X, shown.P);
      BOOST_TEST((times(shown, std::min(0.7, taller))[load].verdict == Verdict::fail));
    }
  }
  // A row that shows less than the largest P is not cut, whatever it says.
  SubmittedProfile flagged = solved_profile("own-moes-20-10", 1e-4);
  flagged.cut = ArrayOf<bool>::Constant(flagged.X.size(), false);
  flagged.cut[0] = flagged.cut[flagged.cut.size() - 1] = true;
  for (const double factor : {1.3, 0.7})
    for (const std::size_t gate : {load, film}) BOOST_TEST((times(flagged, factor)[gate].verdict == Verdict::fail));
  flagged.cut = true;
  BOOST_TEST((times(flagged, 1.3)[load].verdict == Verdict::fail));
  for (const double factor : {1.3, 0.7}) BOOST_TEST((times(flagged, factor)[film].verdict == Verdict::fail));
}

BOOST_AUTO_TEST_CASE(a_large_stated_error_lets_no_wrong_profile_through) {
  SubmittedProfile wrong = solved_profile("own-moes-20-10", 1e-4);
  wrong.P *= 1.3;
  for (const double stated : {0.1, 0.5, 1.0})
    for (const std::size_t gate : {0U, 1U})
      BOOST_TEST((gates_of(wrong, stated)[gate].verdict == verification::Verdict::fail));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::judging
