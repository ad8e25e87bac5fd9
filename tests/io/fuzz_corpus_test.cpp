// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs that fuzzing starts from, those that it once found, and every benchmark case, through the promises that
// fuzzing checks (docs/fuzzing.md).
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/fuzz/case_promises.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

const std::filesystem::path sources = EHD_SOURCE_DIR;

void check_promises(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    const std::string broken = promises::broken(test::read(file));
    BOOST_CHECK_MESSAGE(broken.empty(), file.filename().string() << ": " << broken);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fuzz_corpus)

BOOST_AUTO_TEST_CASE(inputs_that_fuzzing_starts_from_keep_every_promise_and_are_cases) {
  const auto corpus = files_in(sources / "tests" / "fuzz" / "corpus");
  BOOST_TEST(corpus.size() >= 8u);
  check_promises(corpus);
  for (const auto& file : corpus) {
    const std::string text = test::read(file);
    BOOST_CHECK_NO_THROW((void)read_case(text, promises::file_name_for(text)));
  }
}

BOOST_AUTO_TEST_CASE(inputs_that_fuzzing_found_keep_every_promise) {
  const auto found = files_in(sources / "tests" / "fuzz" / "found");
  BOOST_TEST(!found.empty());
  check_promises(found);
}

BOOST_AUTO_TEST_CASE(benchmark_cases_keep_every_promise) {
  const auto cases = files_in(sources / "cases");
  BOOST_TEST(cases.size() > 300u);
  check_promises(cases);
}

BOOST_AUTO_TEST_CASE(a_text_is_read_like_the_file_that_holds_it) {
  const auto file = sources / "cases" / "own-steel-20-10.toml";
  const Case from_file = read_case(file), from_text = read_case(test::read(file), file);
  BOOST_TEST(from_text.id == from_file.id);
  BOOST_TEST(from_text.title == from_file.title);
  BOOST_TEST((from_text.lines == from_file.lines));
  BOOST_TEST((from_text.texts == from_file.texts));
}

BOOST_AUTO_TEST_CASE(a_broken_promise_would_be_seen) {
  using promises::broken_by_refusal;
  const std::string file = "mine.toml", two_lines = "a\nb";
  BOOST_TEST(broken_by_refusal("mine.toml:2: b: is wrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(broken_by_refusal("mine.toml: is empty; allowed is a case file", file, "").empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:3: b: is wrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:0: b: is wrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:2 b: is wrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:2: b: is wrong", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:2: b: is\nwrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("other.toml:2: b: is wrong; allowed is c", file, two_lines).empty());
  BOOST_TEST(!broken_by_refusal("mine.toml:2: b: is wrong; allowed is nan to inf", file, two_lines).empty());
  BOOST_TEST(!promises::broken_by_problem(ehd::Problem{}).empty());
  BOOST_TEST(!promises::broken_by_scales(ehd::Scales{}).empty());
  BOOST_TEST(!promises::broken_by_plan(ehd::Plan{}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
