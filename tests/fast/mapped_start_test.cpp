// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_start.hpp"

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using fast::Care;

namespace {

Care care_at(double M, double L, const Request& request) {
  return fast::care_for(request, roelands_problem(M, L, Flooded{}).groups);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(mapped_start)

BOOST_AUTO_TEST_CASE(each_film_asks_for_the_care_that_it_needs) {
  constexpr double mild = 8, narrow = 21;
  struct Row {
    double L;
    FilmTolerances asked;
    Care care;
  };
  // As a curve of a bearing asks: H_cen depends little on the map.
  const FilmTolerances curve(1e-3, 1e-4);
  const Row rows[] = {{mild, curve, Care::least},
                      {narrow, curve, Care::little},
                      {narrow, {1e-3, 4e-5}, Care::full},
                      {narrow, {2e-4, 1e-3}, Care::full},
                      {narrow, 2e-4, Care::full},
                      {narrow, 1e-3, Care::little},
                      {narrow, 5e-3, Care::least},
                      {narrow, {5e-3, 1e-4}, Care::little},
                      {mild, {std::nullopt, 1e-6}, Care::least},
                      {narrow, {std::nullopt, 1e-4}, Care::little},
                      {narrow, {std::nullopt, 1e-6}, Care::full}};
  for (const auto& [L, asked, care] : rows)
    BOOST_TEST((care_at(20, L, {.tolerance = asked}) == care),
               "L " << L << ", H_min " << asked.minimum.value_or(0) << ", H_cen " << asked.central.value_or(0));
  BOOST_TEST((care_at(20, mild, {.tolerance = {}, .nodes = 512}) == Care::full));
  BOOST_TEST((care_at(2e4, narrow, {.tolerance = 5e-3}) == Care::full));  // beyond the calibrated range
}

BOOST_AUTO_TEST_SUITE_END()
