// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rheology.hpp"

#include <cmath>
#include <vector>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using verification::Tolerance;

Array pressures_Pa() {
  Array p(7);
  p << -3e7, -1e3, 0.0, 2.5e6, 1.7e8, 1.3e9, 3.9e9;
  return p;
}

struct ViscosityRow {
  const char* name;
  Viscosity law;
  double ambient_slope;
};

std::vector<ViscosityRow> viscosity_rows() {
  return {{"isoviscous", Isoviscous{}, 0.0},
          {"barus", Barus{1.9e-8}, 1.9e-8},
          {"roelands", Roelands{.alpha = 1.93e-8, .p0 = 1.98e8, .z = 0.61}, 1.93e-8}};
}

struct DensityRow {
  const char* name;
  Density law;
  double ambient_slope, limit;
};

std::vector<DensityRow> density_rows() {
  return {{"incompressible", Incompressible{}, 0.0, 1.0},
          {"dowson-higginson", dowson_higginson_per_Pa(), 0.34 / 5.9e8, 1.34},
          {"dowson-higginson-1977", dowson_higginson_1977_per_Pa(), 0.6e-9, 1 + 0.6 / 1.7}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rheology)

// The laws as printed, and their slopes, are judged by the claims inputs/laws/* (verification/claims/laws.cpp).

BOOST_AUTO_TEST_CASE(below_zero_pressure_laws_continue_along_their_tangent) {
  Array p(2);
  p << -4.1e7, -2.05e7;
  int rows = 0;
  for (const auto& row : viscosity_rows()) {
    const auto values = evaluate(row.law, p);
    EHD_CHECK(error(ambient_slope(row.law), row.ambient_slope), Tolerance::round_off(4));
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      EHD_CHECK(error(values.value[i], row.ambient_slope * p[i]), Tolerance::round_off(8));
      EHD_CHECK(error(values.slope[i], row.ambient_slope), Tolerance::round_off(8));
      ++rows;
    }
  }
  for (const auto& row : density_rows()) {
    const auto values = evaluate(row.law, p);
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      EHD_CHECK(error(values.value[i], 1 + row.ambient_slope * p[i]), Tolerance::round_off(8));
      EHD_CHECK(error(values.slope[i], row.ambient_slope), Tolerance::round_off(8));
      ++rows;
    }
  }
  BOOST_TEST(rows == 12);
}

BOOST_AUTO_TEST_CASE(the_two_dowson_higginson_forms_have_different_limits) {
  const Array huge = Array::Constant(1, 1e19);  // Pa; what is left of the limit is 0.4 * 6e8/1e19
  int rows = 0;
  for (const auto& row : density_rows()) {
    BOOST_TEST_CONTEXT(row.name) {
      EHD_CHECK(error(evaluate(row.law, huge).value[0], row.limit), Tolerance::asymptotic(1e-10, "c p = 1.7e10"));
    }
    ++rows;
  }
  BOOST_TEST(rows == 3);
  EHD_CHECK(std::abs(density_rows()[1].limit - 1.340), Tolerance::published_digits("1.340"));
  EHD_CHECK(std::abs(density_rows()[2].limit - 1.353), Tolerance::published_digits("1.353"));
}

BOOST_AUTO_TEST_CASE(roelands_becomes_barus_as_the_pressure_vanishes) {
  const double p_0 = 1.7e8, alpha = 2.3e-8, z = 0.57, p = 1.7e3;
  const Array pressure = Array::Constant(1, p);
  const double roelands = evaluate(Viscosity{Roelands{.alpha = alpha, .p0 = p_0, .z = z}}, pressure).value[0];
  EHD_CHECK(error(roelands, alpha * p),
            Tolerance::asymptotic((1 - z) / 2 * p / p_0 * 1.01, "(1-z)/2 p/p_0, next term"));
  BOOST_TEST(roelands < alpha * p);
}

BOOST_AUTO_TEST_CASE(a_law_in_other_units_has_the_same_values_at_the_same_pressure) {
  const double unit = 0.87e9;  // Pa
  const Array p = pressures_Pa();
  const Array P = p / unit;
  int rows = 0;
  const auto compare = [&](const auto& law, const char* name) {
    const auto in_Pa = evaluate(law, p);
    const auto in_units = evaluate(in_units_of(law, unit), P);
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      BOOST_TEST_CONTEXT(name << " at " << p[i] << " Pa") {
        EHD_CHECK(std::abs(in_units.value[i] - in_Pa.value[i]),
                  Tolerance::round_off(16, 10 + std::abs(in_Pa.value[i])));
        EHD_CHECK(error(in_units.slope[i], in_Pa.slope[i] * unit), Tolerance::round_off(16));
      }
      ++rows;
    }
  };
  for (const auto& row : viscosity_rows()) compare(row.law, row.name);
  for (const auto& row : density_rows()) compare(row.law, row.name);
  BOOST_TEST(rows == 42);
}

BOOST_AUTO_TEST_CASE(where_eta_would_overflow_its_logarithm_is_finite) {
  // Barus at (M, L) = (5000, 30): alpha p_H = 846, e^846 is beyond double.
  const auto values = evaluate(Viscosity{Barus{846.0}}, Array(Array::Constant(3, 1.0)));
  for (const double value : values.value) EHD_CHECK(error(value, 846.0), Tolerance::round_off(1));
  BOOST_TEST(std::isinf(std::exp(values.value[0])));
}

BOOST_AUTO_TEST_CASE(storage_of_the_result_is_reused) {
  LawValues<double> out;
  evaluate(Viscosity{Barus{3.0}}, Array(Array::Constant(5, 0.25)), out);
  const double* value = out.value.data();
  evaluate(Viscosity{Roelands{.alpha = 3.0, .p0 = 0.2, .z = 0.68}}, Array(Array::Constant(5, 0.5)), out);
  BOOST_TEST(out.value.data() == value);
  BOOST_TEST(out.value.size() == 5);
}

BOOST_AUTO_TEST_CASE(only_constant_laws_are_trivial) {
  BOOST_TEST(is_trivial(Viscosity{Isoviscous{}}));
  BOOST_TEST(!is_trivial(Viscosity{Barus{1}}));
  BOOST_TEST(!is_trivial(Viscosity{Roelands{1, 1, 1}}));
  BOOST_TEST(is_trivial(Density{Incompressible{}}));
  BOOST_TEST(!is_trivial(Density{dowson_higginson_per_Pa()}));
  BOOST_TEST(name(Viscosity{Roelands{1, 1, 1}}) == "roelands");
  BOOST_TEST(name(Density{dowson_higginson_1977_per_Pa()}) == "dowson-higginson");
}

BOOST_AUTO_TEST_SUITE_END()
