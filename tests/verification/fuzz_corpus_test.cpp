// SPDX-License-Identifier: GPL-3.0-or-later
// The results and atlas tables that fuzzing starts from, and those that it once found, through the promises that
// fuzzing checks (docs/fuzzing.md).
#include <filesystem>

#include "tests/check.hpp"
#include "tests/fuzz/atlas_promises.hpp"
#include "tests/fuzz/kept_inputs.hpp"
#include "tests/fuzz/results_promises.hpp"

using namespace ehd::verification;

namespace {

const std::filesystem::path fuzz_inputs = std::filesystem::path(EHD_SOURCE_DIR) / "tests" / "fuzz";

}  // namespace

BOOST_AUTO_TEST_SUITE(fuzz_corpus)

BOOST_AUTO_TEST_CASE(results_that_fuzzing_starts_from_or_found_keep_every_promise) {
  BOOST_TEST(test::keep_promises(fuzz_inputs / "corpus" / "results", promises::results_broken) >= 2u);
  BOOST_TEST(test::keep_promises(fuzz_inputs / "found" / "results", promises::results_broken) >= 1u);
}

BOOST_AUTO_TEST_CASE(atlas_tables_that_fuzzing_starts_from_or_found_keep_every_promise) {
  BOOST_TEST(test::keep_promises(fuzz_inputs / "corpus" / "atlas", promises::atlas_broken) >= 2u);
  BOOST_TEST(test::keep_promises(fuzz_inputs / "found" / "atlas", promises::atlas_broken) >= 1u);
}

BOOST_AUTO_TEST_SUITE_END()
