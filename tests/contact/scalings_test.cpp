// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/scalings.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

std::optional<double> found(const std::vector<GivenNumber>& given, std::string_view name) {
  const auto values = in_all_scalings(given);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (scaled_numbers()[i].name == name) return values[i];
  return std::nullopt;
}

const Conditions steel{.load_N_per_m = 1.1e5,
                       .reduced_radius_m = 1.2e-2,
                       .reduced_modulus_Pa = 2.2e11,
                       .speed_sum_m_per_s = 3.1,
                       .viscosity_Pa_s = 0.021};
const std::vector<GivenNumber> steel_and_oil{{"load_N_per_m", 1.1e5},        {"reduced_radius_m", 1.2e-2},
                                             {"reduced_modulus_Pa", 2.2e11}, {"speed_sum_m_per_s", 3.1},
                                             {"viscosity_Pa_s", 0.021},      {"alpha_per_Pa", 2.3e-8}};

/// Through logarithms, which are up to 30.
Tolerance through_logarithms() { return Tolerance::round_off(64, 30); }

}  // namespace

BOOST_AUTO_TEST_SUITE(scalings)

BOOST_AUTO_TEST_CASE(SI_fixes_everything_and_agrees_with_the_formulas_elsewhere) {
  for (const auto& value : in_all_scalings(steel_and_oil)) BOOST_TEST(value.has_value());
  EHD_CHECK(error(*found(steel_and_oil, "hertz_pressure_Pa"), hertz::pressure_Pa(steel)), through_logarithms());
  EHD_CHECK(error(*found(steel_and_oil, "half_width_m"), hertz::half_width_m(steel)), through_logarithms());
  const double b = hertz::half_width_m(steel);
  EHD_CHECK(error(*found(steel_and_oil, "film_m_per_hertz"), b * b / steel.reduced_radius_m), through_logarithms());
  const double M = *found(steel_and_oil, "M");
  EHD_CHECK(error(*found(steel_and_oil, "film_moes_per_hertz"), moes_film_per_hertz_film(M)), through_logarithms());
}

BOOST_AUTO_TEST_CASE(each_group_way_gives_the_others) {
  const Groups groups = groups_from(MoesGroups{.M = 20, .L = 10});
  EHD_CHECK(error(*found({{"lambda", groups.lambda}, {"alpha_p_H", groups.alpha_p_H}}, "L"), 10), through_logarithms());
  const DowsonGroups dowson = dowson_from({.M = 20, .L = 10}, 4800);
  EHD_CHECK(error(*found({{"W", dowson.W}, {"U_mean", dowson.U_mean}, {"G", dowson.G}}, "M"), 20),
            through_logarithms());
  EHD_CHECK(error(*found({{"M", 20}, {"L", 10}, {"G", 4800}}, "W"), dowson.W), through_logarithms());
}

// Exact: what is stated comes back as it was stated, and what follows has no digits that nobody knows.
BOOST_AUTO_TEST_CASE(stated_numbers_come_back_and_others_have_the_digits_that_are_known) {
  for (const GivenNumber& one : steel_and_oil) BOOST_TEST(*found(steel_and_oil, one.name.c_str()) == one.value);
  BOOST_TEST(*found({{"W", 3e-5}, {"reduced_modulus_Pa", 2e11}, {"reduced_radius_m", 0.01}}, "load_N_per_m") == 6e4);
}

BOOST_AUTO_TEST_CASE(what_is_open_is_absent) {
  BOOST_TEST(found({{"M", 20}}, "lambda").has_value());
  BOOST_TEST(!found({{"M", 20}}, "alpha_p_H").has_value());
  BOOST_TEST(!found({{"M", 20}, {"L", 10}}, "W").has_value());
  // With E', R and alpha the product of viscosity and speed is known, but neither of the two.
  const std::vector<GivenNumber> given{
      {"M", 20}, {"L", 10}, {"reduced_radius_m", 0.01}, {"reduced_modulus_Pa", 2.2e11}, {"alpha_per_Pa", 2e-8}};
  BOOST_TEST(found(given, "viscosity_times_speed_N_per_m").has_value());
  BOOST_TEST(found(given, "half_width_m").has_value());
  BOOST_TEST(!found(given, "viscosity_Pa_s").has_value());
}

BOOST_AUTO_TEST_CASE(a_number_that_follows_from_others_or_is_none_is_refused) {
  const std::vector<std::pair<std::vector<GivenNumber>, std::string>> rows{
      {{{"M", 20}, {"lambda", 0.1}}, "the numbers before it fix it already, at 0.00925"},
      {{{"N", 20}}, "is unknown; allowed is M, L"},
      {{{"M", -1}}, "is not positive"},
      {{{"M", 0}}, "is not positive"},
      {{{"L", 0}, {"alpha_p_H", 1}}, "the numbers before it fix it already, at 0"},
      {{{"G", 5000}, {"L", 0}}, "is 0, so alpha is 0; but a number before it"},
      {{{"M", std::numeric_limits<double>::infinity()}}, "is not positive"},
      {{{"M", 1e160}, {"L", 1}}, "leaves the range of numbers"},
      {{{"W", 1e-320}, {"reduced_modulus_Pa", 1}, {"reduced_radius_m", 1}}, "leaves the range of numbers"},
  };
  for (const auto& [given, phrase] : rows) {
    const auto says = [&phrase = phrase](const StatementError& wrong) {
      return std::string(wrong.what()).find(phrase) != std::string::npos;
    };
    BOOST_CHECK_EXCEPTION((void)in_all_scalings(given), StatementError, says);
  }
}

// Exact: with alpha = 0 all numbers with alpha in them are 0, and the others are as without it.
BOOST_AUTO_TEST_CASE(an_isoviscous_contact_is_converted) {
  const auto values = in_all_scalings({{"L", 0}, {"M", 20}}), without = in_all_scalings({{"M", 20}});
  int zeros = 0, known = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (scaled_numbers()[i].may_vanish()) {
      BOOST_TEST(values[i].value() == 0.0, scaled_numbers()[i].name);
      ++zeros;
    } else {
      BOOST_TEST((values[i] == without[i]), scaled_numbers()[i].name);
      known += values[i].has_value();
    }
  }
  BOOST_TEST(zeros == 4);
  BOOST_TEST(known == 3);  // M, lambda, film_moes_per_hertz
}

BOOST_AUTO_TEST_SUITE_END()
