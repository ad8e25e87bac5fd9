// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs that fuzzing starts from, those that it once found, and every benchmark case, through the promises that
// fuzzing checks (docs/fuzzing.md). Results and the atlas: tests/verification/fuzz_corpus_test.cpp.
#include <filesystem>
#include <string>

#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/fuzz/case_promises.hpp"
#include "tests/fuzz/kept_inputs.hpp"
#include "tests/fuzz/row_promises.hpp"
#include "tests/fuzz/sweep_promises.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

const std::filesystem::path sources = EHD_SOURCE_DIR;
const std::filesystem::path corpus = sources / "tests" / "fuzz" / "corpus",
                            found = sources / "tests" / "fuzz" / "found";

}  // namespace

BOOST_AUTO_TEST_SUITE(fuzz_corpus)

BOOST_AUTO_TEST_CASE(inputs_that_fuzzing_starts_from_keep_every_promise_and_are_cases) {
  BOOST_TEST(test::keep_promises(corpus / "case", promises::case_broken) >= 8u);
  for (const auto& file : test::files_in(corpus / "case")) {
    const std::string text = test::read(file);
    BOOST_CHECK_NO_THROW((void)read_case(text, promises::file_name_for(text)));
  }
}

BOOST_AUTO_TEST_CASE(inputs_that_fuzzing_found_keep_every_promise) {
  BOOST_TEST(test::keep_promises(found / "case", promises::case_broken) >= 4u);
  test::keep_promises(found / "sweep", promises::sweep_broken);
  BOOST_TEST(test::keep_promises(found / "row", promises::row_broken) >= 1u);
}

BOOST_AUTO_TEST_CASE(sweeps_that_fuzzing_starts_from_keep_every_promise) {
  BOOST_TEST(test::keep_promises(corpus / "sweep", promises::sweep_broken) >= 3u);
  BOOST_TEST(test::keep_promises(sources / "examples" / "sweeps", promises::sweep_broken) >= 3u);
}

BOOST_AUTO_TEST_CASE(stored_rows_that_fuzzing_starts_from_keep_every_promise) {
  BOOST_TEST(test::keep_promises(corpus / "row", promises::row_broken) >= 3u);
}

BOOST_AUTO_TEST_CASE(benchmark_cases_keep_every_promise) {
  BOOST_TEST(test::keep_promises(sources / "cases", promises::case_broken) > 300u);
}

BOOST_AUTO_TEST_CASE(a_text_is_read_like_the_file_that_holds_it) {
  const auto file = sources / "cases" / "own-steel-20-10.toml";
  const Case from_file = read_case(file), from_text = read_case(test::read(file), file);
  BOOST_TEST(from_text.id == from_file.id);
  BOOST_TEST(from_text.title == from_file.title);
  BOOST_TEST((from_text.places == from_file.places));
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
