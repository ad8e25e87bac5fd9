// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that a caller frees is really freed. `make sanitize` runs a small part of this under LeakSanitizer.
#include <malloc.h>

#include <boost/test/unit_test.hpp>
#include <string>

#include "tests/bindings/held.hpp"
#include "tests/sanitizer.hpp"

using namespace ehd::c::test;

namespace {

/// Bytes that malloc has given out.
std::size_t bytes_in_use() { return ::mallinfo2().uordblks; }

}  // namespace

BOOST_AUTO_TEST_SUITE(memory)

BOOST_AUTO_TEST_CASE(a_hundred_thousand_results_leave_nothing_behind) {
  constexpr int asked_every = 100;  // of the results the JSON and a field are asked for
  const std::string dry = case_text("dry-steel"), wrong = dry.substr(0, dry.size() / 2);
  bool as_expected = true;
  const auto make_and_free = [&](int times) {
    for (int i = 0; i < times; ++i) {
      const Held one = solve(dry);
      as_expected = as_expected && one.code == EHD_OK;
      if (i % asked_every != 0) continue;
      as_expected = as_expected && one.field("P").size() > 100 && ehd_json(one.result.get()) != nullptr;
      as_expected = as_expected && solve(wrong).code == EHD_BAD_INPUT;
    }
  };
  make_and_free(asked_every);  // what the library keeps for good
  constexpr int many = ehd::testing::address_sanitizer ? 1000 : 100000;
  const std::size_t before = bytes_in_use();
  make_and_free(many);
  const std::size_t after = bytes_in_use();
  BOOST_TEST(as_expected);
  BOOST_TEST(after < before + many, "one byte that a result keeps would be " << many << " bytes");
}

BOOST_AUTO_TEST_CASE(solved_contacts_and_bearings_leave_nothing_behind) {
  const std::string contact = case_text("own-moes-5-5"), roller = case_text("na4908");
  constexpr int times = ehd::testing::address_sanitizer ? 2 : 40;
  bool as_expected = true;
  const auto make_and_free = [&] {
    for (int i = 0; i < times; ++i) {
      const Held one = solve(contact, "fast", 1e-2), balanced = bearing(roller, "hertz");
      as_expected = as_expected && one.get("film.minimum.hertz") > 0 && balanced.get("rollers.0.inner.force_N") > 0;
    }
  };
  make_and_free();
  const std::size_t before = bytes_in_use();
  make_and_free();
  BOOST_TEST(as_expected);
  // A solver's workspace may grow for good, by less than the fields of one solve in all.
  constexpr std::size_t fields_of_a_solve = 3 * 129 * sizeof(double);
  BOOST_TEST(bytes_in_use() < before + fields_of_a_solve);
}

BOOST_AUTO_TEST_SUITE_END()
