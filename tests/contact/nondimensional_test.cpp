// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/nondimensional.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using std::numbers::pi;
using verification::Tolerance;

const Tolerance few_operations = Tolerance::round_off(64);  // a dozen pow, sqrt and divisions, half an ulp to 4 each

Conditions steel() {
  return {.load_N_per_m = 1.3e5,
          .reduced_radius_m = 1.1e-2,
          .reduced_modulus_Pa = 2.27e11,
          .speed_sum_m_per_s = 3.7,
          .viscosity_Pa_s = 0.021};
}

Lubricant roelands(std::optional<double> alpha, std::optional<double> z) {
  return {.viscosity = ViscosityLaw::roelands,
          .density = DensityLaw::dowson_higginson,
          .alpha_per_Pa = alpha,
          .z = z,
          .p0_Pa = 1.96e8};
}

Lubricant barus(std::optional<double> alpha, DensityLaw density = DensityLaw::incompressible) {
  return {.viscosity = ViscosityLaw::barus, .density = density, .alpha_per_Pa = alpha, .z = {}, .p0_Pa = 1.9e8};
}

/// The key that a refused statement blames; "" where it is not refused.
std::string refused_key(const Statement& statement, const Lubricant& lubricant) {
  try {
    (void)nondimensionalise(statement, lubricant, Flooded{});
  } catch (const StatementError& refusal) {
    BOOST_TEST(std::string(refusal.what()) != "");
    return refusal.key();
  }
  return "";
}

double difference(const Groups& a, const Groups& b) {
  return std::max({error(a.M, b.M), error(a.L, b.L), error(a.lambda, b.lambda), error(a.alpha_p_H, b.alpha_p_H)});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(nondimensional)

// Groups and scales from SI, in other units and with the mean speed are judged by the claims inputs/*
// (verification/claims/inputs.cpp and laws.cpp).

BOOST_AUTO_TEST_CASE(moes_and_hertz_groups_are_inverse) {
  int rows = 0;
  for (const MoesGroups moes : {MoesGroups{0.05, 0.7}, MoesGroups{3.3, 4.1}, MoesGroups{1700, 23}}) {
    const Groups there = groups_from(moes);
    EHD_CHECK(error(there.lambda * moes.M * moes.M, 3 * pi * pi / 8), few_operations);
    EHD_CHECK(error(there.alpha_p_H, moes.L * std::sqrt(moes.M / (2 * pi))), few_operations);
    const Groups back = groups_from(HertzGroups{.lambda = there.lambda, .alpha_p_H = there.alpha_p_H});
    EHD_CHECK(difference(back, there), few_operations);
    ++rows;
  }
  BOOST_TEST(rows == 3);
}

BOOST_AUTO_TEST_CASE(dowson_and_moes_groups_are_inverse) {
  int rows = 0;
  for (const MoesGroups moes : {MoesGroups{0.2, 21}, MoesGroups{20, 10}, MoesGroups{900, 3}}) {
    for (const double G : {2500.0, 5000.0}) {
      const DowsonGroups groups = dowson_from(moes, G);
      const MoesGroups back = moes_from(groups);
      EHD_CHECK(error(back.M, moes.M), few_operations);
      EHD_CHECK(error(back.L, moes.L), few_operations);
      EHD_CHECK(error(groups.G, G), Tolerance::round_off(1));
      ++rows;
    }
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(groups_and_an_oil_fix_pressures_in_pascal_and_no_length) {
  const auto from_SI = nondimensionalise(steel(), roelands(2.1e-8, 0.63), Flooded{});
  const Groups groups = from_SI.problem.groups;
  int rows = 0;
  for (const Statement& statement :
       {Statement{MoesGroups{groups.M, groups.L}}, Statement{HertzGroups{groups.lambda, groups.alpha_p_H}}}) {
    const auto made = nondimensionalise(statement, roelands(2.1e-8, 0.63), Flooded{});
    const auto& density = std::get<DowsonHigginson>(made.problem.density);
    EHD_CHECK(error(density.a, std::get<DowsonHigginson>(from_SI.problem.density).a), few_operations);
    EHD_CHECK(error(density.c, std::get<DowsonHigginson>(from_SI.problem.density).c), few_operations);
    EHD_CHECK(error(made.scales.value().hertz_pressure_Pa, from_SI.scales->hertz_pressure_Pa), few_operations);
    BOOST_TEST(!made.scales->half_width_m.has_value());
    BOOST_TEST(!made.scales->film_m_per_hertz_film().has_value());
    ++rows;
  }
  BOOST_TEST(rows == 2);
}

BOOST_AUTO_TEST_CASE(each_density_name_gives_its_own_law) {
  const double p_H = nondimensionalise(steel(), barus(1.8e-8), Flooded{}).scales->hertz_pressure_Pa;
  const auto law = [&](DensityLaw density) {
    return std::get<DowsonHigginson>(nondimensionalise(steel(), barus(1.8e-8, density), Flooded{}).problem.density);
  };
  EHD_CHECK(error(law(DensityLaw::dowson_higginson).c, p_H / 5.9e8), few_operations);
  EHD_CHECK(error(law(DensityLaw::dowson_higginson_1977).c, 1.7e-9 * p_H), few_operations);
  BOOST_TEST(
      std::holds_alternative<Incompressible>(nondimensionalise(steel(), barus(1.8e-8), Flooded{}).problem.density));
}

BOOST_AUTO_TEST_CASE(roelands_relation_supplies_what_is_left_out) {
  const double span = std::log(0.021) + 9.67;
  const auto with_z = nondimensionalise(steel(), roelands({}, 0.63), Flooded{});
  EHD_CHECK(error(with_z.problem.groups.alpha_p_H, 0.63 * span / 1.96e8 * with_z.scales->hertz_pressure_Pa),
            few_operations);
  const auto with_alpha = nondimensionalise(steel(), roelands(2.1e-8, {}), Flooded{});
  EHD_CHECK(error(std::get<Roelands>(with_alpha.problem.viscosity).z, 2.1e-8 * 1.96e8 / span), few_operations);
  BOOST_TEST(with_z.notes.empty());
  BOOST_TEST(with_alpha.notes.empty());

  const auto with_both = nondimensionalise(steel(), roelands(2.1e-8, 0.63), Flooded{});
  EHD_CHECK(error(std::get<Roelands>(with_both.problem.viscosity).z, 0.63), Tolerance::round_off(1));
  EHD_CHECK(error(with_both.problem.groups.alpha_p_H, 2.1e-8 * with_both.scales->hertz_pressure_Pa), few_operations);
  BOOST_REQUIRE(with_both.notes.size() == 1U);  // how far they are from the relation
  BOOST_TEST(with_both.notes[0].find('%') != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_number_that_the_viscosity_law_does_not_read_is_noted) {
  Lubricant oil = barus(1.8e-8);
  oil.p0_Pa = roelands_pressure_Pa;
  BOOST_TEST(nondimensionalise(steel(), oil, Flooded{}).notes.empty());
  oil.z = 0.63;
  oil.p0_Pa = 1.7e8;
  for (const Statement& statement : {Statement(steel()), Statement(MoesGroups{20, 10})}) {
    const auto notes = nondimensionalise(statement, oil, Flooded{}).notes;
    BOOST_REQUIRE(notes.size() == 2U);
    BOOST_TEST(notes[0] == "z = 0.63 has no effect: the viscosity law barus does not read it");
    BOOST_TEST(notes[1] == "p0_Pa = 1.7e8 Pa has no effect: the viscosity law barus does not read it");
  }
  oil.viscosity = ViscosityLaw::roelands;
  for (const std::string& note : nondimensionalise(steel(), oil, Flooded{}).notes)
    BOOST_TEST(note.find("has no effect") == std::string::npos, note);
}

BOOST_AUTO_TEST_CASE(at_L_zero_groups_are_solved_isoviscous_and_incompressible) {
  const auto made = nondimensionalise(MoesGroups{7, 0}, roelands(2.1e-8, 0.63), Flooded{});
  BOOST_TEST(is_trivial(made.problem.viscosity));
  BOOST_TEST(is_trivial(made.problem.density));
  BOOST_TEST(made.notes.size() == 1U);
  BOOST_TEST(!made.scales.has_value());

  const Lubricant plain{.viscosity = ViscosityLaw::isoviscous, .density = {}, .alpha_per_Pa = {}, .z = {}};
  BOOST_TEST(nondimensionalise(MoesGroups{7, 0}, plain, Flooded{}).notes.empty());

  // In SI the pressure is known, so the density stays what it is.
  Lubricant dense = plain;
  dense.density = DensityLaw::dowson_higginson;
  const auto in_SI = nondimensionalise(steel(), dense, Flooded{});
  EHD_CHECK(in_SI.problem.groups.L, Tolerance::round_off(0));
  BOOST_TEST(is_trivial(in_SI.problem.viscosity));
  BOOST_TEST(!is_trivial(in_SI.problem.density));
}

BOOST_AUTO_TEST_CASE(barus_needs_no_pressure_in_pascal) {
  const auto made = nondimensionalise(MoesGroups{20, 10}, barus({}), Flooded{});
  EHD_CHECK(error(std::get<Barus>(made.problem.viscosity).alpha, 10 * std::sqrt(20 / (2 * pi))), few_operations);
  BOOST_TEST(!made.scales.has_value());
}

BOOST_AUTO_TEST_CASE(a_statement_that_makes_no_problem_names_the_key_at_fault) {
  const Lubricant isoviscous{.viscosity = ViscosityLaw::isoviscous, .density = {}, .alpha_per_Pa = {}, .z = {}};
  Conditions no_speed = steel(), no_viscosity = steel(), thin = steel(), still = steel(), unloaded = steel();
  no_speed.speed_sum_m_per_s.reset();
  no_viscosity.viscosity_Pa_s.reset();
  thin.viscosity_Pa_s = 5e-5;  // below e^-9.67, where Roelands' relation changes sign
  still.speed_sum_m_per_s = 0;
  unloaded.load_N_per_m = 0;
  const double nan = std::nan("");
  Lubricant bad_p0 = roelands(2.1e-8, 0.63);
  bad_p0.p0_Pa = 0;
  struct Row {
    const char* what;
    Statement statement;
    Lubricant lubricant;
    const char* key;
  };
  const std::vector<Row> rows = {
      {"isoviscous with L > 0", MoesGroups{20, 10}, isoviscous, "lubricant.viscosity"},
      {"isoviscous with alpha p_H > 0", HertzGroups{0.3, 2.8}, isoviscous, "lubricant.viscosity"},
      {"roelands without p_H", MoesGroups{20, 10}, roelands({}, 0.68), "lubricant.viscosity"},
      {"density without p_H", MoesGroups{20, 10}, barus({}, DensityLaw::dowson_higginson), "lubricant.density"},
      {"roelands without z or eta_0", MoesGroups{20, 10}, roelands(2.1e-8, {}), "lubricant.z"},
      {"roelands with neither", steel(), roelands({}, {}), "lubricant.alpha_per_Pa"},
      {"roelands with z = 0", MoesGroups{20, 10}, roelands(2.1e-8, 0.0), "lubricant.z"},
      {"roelands with p_0 = 0", MoesGroups{20, 10}, bad_p0, "lubricant.p0_Pa"},
      {"z from a thin oil", thin, roelands(2.1e-8, {}), "lubricant.z"},
      {"alpha from a thin oil", thin, roelands({}, 0.6), "lubricant.alpha_per_Pa"},
      {"barus without alpha", steel(), barus({}), "lubricant.alpha_per_Pa"},
      {"no speed", no_speed, barus(2e-8), "conditions.speed_sum_m_per_s"},
      {"no viscosity", no_viscosity, barus(2e-8), "conditions.viscosity_Pa_s"},
      {"at rest", still, barus(2e-8), "M"},
      {"no load", unloaded, barus(2e-8), "M"},
      {"M too small", MoesGroups{0.9e-3, 1}, barus({}), "M"},
      {"M too large", MoesGroups{1.1e6, 1}, barus({}), "M"},
      {"M negative", MoesGroups{-20, 1}, barus({}), "M"},
      {"M not a number", MoesGroups{nan, 1}, barus({}), "M"},
      {"L too large", MoesGroups{20, 100.5}, barus({}), "L"},
      {"L negative", MoesGroups{20, -1}, barus({}), "L"},
      {"L not a number", MoesGroups{20, nan}, barus({}), "L"},
      {"L denormal", MoesGroups{20, 1e-320}, roelands(2.1e-8, 0.63), "L"},
      {"lambda zero", HertzGroups{0, 1}, barus({}), "M"},
      {"lambda negative", HertzGroups{-1, 1}, barus({}), "M"},
  };
  for (const auto& row : rows) {
    BOOST_TEST_CONTEXT(row.what) { BOOST_TEST(refused_key(row.statement, row.lubricant) == row.key); }
  }
  BOOST_TEST(rows.size() == 25U);
  BOOST_TEST(refused_key(MoesGroups{20, 10}, barus({})) == "");  // the helper can tell
}

BOOST_AUTO_TEST_SUITE_END()
