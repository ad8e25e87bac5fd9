// SPDX-License-Identifier: GPL-3.0-or-later
// The shells' completion, as bash runs it.
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/process.hpp"

using namespace ehd::verification;

namespace {

/// What bash offers behind a command line, whose last word is not yet complete.
std::vector<std::string> offered(const std::string& line) {
  const test::Folder folder;
  BOOST_REQUIRE(test::ehd_run(folder, "--completion bash").exit_code == 0);
  const auto out = folder.path() / "offered.txt";
  const auto script = folder.write(
      "completion.sh", test::read(folder.path() / "stdout.txt") + "COMP_WORDS=(" + line +
                           ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_ehd\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  const std::string path = std::filesystem::path(EHD_PROGRAM).parent_path().string();
  const std::string command = fmt::format("PATH='{}':\"$PATH\" bash '{}' > '{}'", path, script.string(), out.string());
  BOOST_REQUIRE(std::system(command.c_str()) == 0);
  std::istringstream lines(test::read(out));
  std::vector<std::string> words;
  for (std::string word; std::getline(lines, word);) words.push_back(word);
  return words;
}

bool offers(const std::string& line, const std::string& word) {
  const auto words = offered(line);
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(completion)

BOOST_AUTO_TEST_CASE(subcommands_options_and_cases_are_offered) {
  BOOST_TEST(offers("ehd so", "solve"));
  BOOST_TEST(!offers("ehd so", "bearing"));
  BOOST_TEST(offers("ehd --", "--version"));
  BOOST_TEST(offers("ehd solve --tol", "--tolerance"));
  BOOST_TEST(offers("ehd solve --tol", "--tolerance-minimum"));
  BOOST_TEST(!offers("ehd solve --", "--cage-positions"));
  BOOST_TEST(offers("ehd bearing --ca", "--cage-positions"));
  BOOST_TEST(offers("ehd solve own-moes-20", "own-moes-20-10"));
  BOOST_TEST(!offers("ehd verify own-moes-20", "own-moes-20-10"));
}

BOOST_AUTO_TEST_CASE(the_value_of_an_option_is_a_case_only_where_it_takes_one) {
  for (const char* const line :
       {"solve --json own-moes-20", "solve --nodes own-moes-20", "bearing --set own-moes-20",
        "solve --json = own-moes-20", "response --omega own-moes-20", "solve --json ''",
        "solve --json =", "solve --set moes.M = own-moes-20", "solve --set moes.M =", "solve --tolerance --"})
    BOOST_CHECK_MESSAGE(offered(fmt::format("ehd {}", line)) == std::vector<std::string>{""}, line);
  for (const char* const line : {"bench --case own-moes-20", "verify --case own-moes-20", "bench --case = own-moes-20",
                                 "solve --dynamic own-moes-20", "solve --json mine.json own-moes-20",
                                 "solve --json = mine.json own-moes-20", "cases own-moes-20"})
    BOOST_CHECK_MESSAGE(offers(fmt::format("ehd {}", line), "own-moes-20-10"), line);
}

BOOST_AUTO_TEST_CASE(solvers_and_laws_are_offered_where_the_option_takes_them) {
  using Words = std::vector<std::string>;
  BOOST_TEST(offered("ehd solve --solver fa") == (Words{"fast", "fast.uniform"}), boost::test_tools::per_element());
  BOOST_TEST(offered("ehd solve --solver = fa") == (Words{"fast", "fast.uniform"}), boost::test_tools::per_element());
  BOOST_TEST(offered("ehd response --solver ''") == (Words{"reference", "fast"}), boost::test_tools::per_element());
  BOOST_TEST(offered("ehd bearing --law eh") == (Words{"ehd-linear", "ehd"}), boost::test_tools::per_element());
  BOOST_TEST(offered("ehd export law na4908 --law ''") == Words{"ehd"}, boost::test_tools::per_element());
  for (const char* const line :
       {"bench --solver ref", "bearing --solver ref", "compare --solver ref", "plan --solver ref"})
    BOOST_CHECK_MESSAGE(offers(fmt::format("ehd {}", line), "reference"), line);
  BOOST_TEST(offers("ehd plan --law her", "hertz"));
  BOOST_TEST(offers("ehd solve --solver fast own-moes-20", "own-moes-20-10"));
}

BOOST_AUTO_TEST_CASE(the_words_of_a_first_argument_are_offered_there_alone) {
  using Words = std::vector<std::string>;
  BOOST_TEST(offered("ehd export f") == Words{"films"}, boost::test_tools::per_element());
  BOOST_TEST(offered("ehd export ''") == (Words{"films", "law"}), boost::test_tools::per_element());
  BOOST_TEST(offered("ehd new ''") == (Words{"contact", "bearing", "keys", "types"}), boost::test_tools::per_element());
  BOOST_TEST(offers("ehd export films own-moes-20", "own-moes-20-10"));
  BOOST_TEST(offers("ehd export --", "--raceway"));
  BOOST_TEST(offered("ehd export law na4908 --raceway ''") == (Words{"inner", "outer"}),
             boost::test_tools::per_element());
  BOOST_TEST(offered("ehd export law na4908 --format m") == Words{"matlab"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(zsh_gets_the_same_by_its_bashcompinit) {
  const test::Folder folder;
  const std::string bash = test::ehd_run(folder, "--completion bash").out;
  const std::string zsh = test::ehd_run(folder, "--completion zsh").out;
  BOOST_TEST(zsh.starts_with("#compdef ehd\n"));
  BOOST_TEST(zsh.ends_with(bash));
  BOOST_TEST(zsh.find("bashcompinit") != std::string::npos);
  test::check_refused(folder, "--completion fish", "--completion = fish: is unknown; allowed is bash, zsh");
}

BOOST_AUTO_TEST_SUITE_END()
