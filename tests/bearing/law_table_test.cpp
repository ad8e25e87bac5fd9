// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/law_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "bearing/approach_formulas.hpp"
#include "bearing/build_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/force_law.hpp"
#include "tests/bearing/synthetic.hpp"
#include "tests/check.hpp"

namespace ehd::bearing {

using synthetic::roller;

BOOST_AUTO_TEST_SUITE(law_table)

BOOST_AUTO_TEST_CASE(every_law_has_one_row_and_is_found_by_its_name) {
  BOOST_REQUIRE(!law_rows().empty());
  std::vector<std::string_view> names;
  for (const LawRow& row : law_rows()) {
    BOOST_TEST((law_from(row.name) == row.law));
    BOOST_TEST(to_string(row.law) == row.name);
    BOOST_TEST(&row_of(row.law) == &row);
    BOOST_TEST(!row.description.empty());
    BOOST_TEST(row.description.find('\n') == std::string_view::npos);
    BOOST_TEST(std::count(names.begin(), names.end(), row.name) == 0);
    names.push_back(row.name);
  }
  BOOST_TEST(!law_from("").has_value());
  BOOST_TEST(!law_from("Hertz").has_value());
  BOOST_CHECK_THROW((void)row_of(static_cast<Law>(names.size())), std::logic_error);
}

// Cases, results and scripts hold these names: a change here changes them.
BOOST_AUTO_TEST_CASE(names_and_needs_are_these) {
  BOOST_TEST(names_of(Laws::all) == "hertz, iso, lundberg, tripp, houpert, ehd-linear, ehd");
  BOOST_TEST(names_of(Laws::dry, " or ") == "hertz, iso, lundberg, tripp or houpert");
  BOOST_TEST(names_of(Laws::dry_without_ring_thickness, " or ") == "hertz, iso or lundberg");
  BOOST_TEST(names_of(Laws::by_default) == "hertz, ehd-linear, ehd");
  BOOST_TEST(names_of(Laws::by_default_dry) == "hertz");
  BOOST_TEST(needs_film(Law::ehd));
  BOOST_TEST(needs_film(Law::ehd_linear));
  BOOST_TEST(!needs_film(Law::houpert));
  BOOST_TEST(needs_ring_thickness(Law::tripp));
  BOOST_TEST(!needs_ring_thickness(Law::lundberg));
}

// The ring's thickness changes the laws that ask for it, and no other.
BOOST_AUTO_TEST_CASE(a_law_needs_the_ring_thickness_where_it_changes_the_law) {
  RollerContact thicker = roller();
  thicker.ring_thickness_m *= 1.5;
  for (const Law law : laws_of(Laws::dry)) BOOST_TEST_CONTEXT(to_string(law)) {
      const LawPair here = dry_laws(law, roller()), there = dry_laws(law, thicker);
      BOOST_TEST(approach(here.inner, 900) == approach(there.inner, 900));
      BOOST_TEST((approach(here.outer, 900) != approach(there.outer, 900)) == needs_ring_thickness(law));
    }
}

// Exact: each dry row makes the law of its name.
BOOST_AUTO_TEST_CASE(dry_rows_make_the_laws_of_their_names) {
  using enum Raceway;
  const auto same = [](Law law, const ForceLaw& inner, const ForceLaw& outer) {
    BOOST_TEST_CONTEXT(to_string(law)) {
      const LawPair made = dry_laws(law, roller());
      BOOST_TEST(approach(made.inner, 4100) == approach(inner, 4100));
      BOOST_TEST(approach(made.outer, 4100) == approach(outer, 4100));
    }
  };
  same(Law::hertz, palmgren_law(0.021), palmgren_law(0.021));
  same(Law::iso, iso_law(0.021), iso_law(0.021));
  same(Law::lundberg, lundberg_law(roller(), inner), lundberg_law(roller(), outer));
  same(Law::tripp, tripp_law(roller(), inner), tripp_law(roller(), outer));
  same(Law::houpert, houpert_law(roller(), inner), houpert_law(roller(), outer));
  BOOST_CHECK_THROW((void)dry_laws(Law::ehd, roller()), std::invalid_argument);
  BOOST_CHECK_THROW((void)dry_laws(Law::ehd_linear, roller()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(rows_with_films_make_lines_of_fits_and_curves_of_data) {
  const LinearFit steep = fit_line({{100, 1e-7}, {400, 2e-7}}), flat = fit_line({{100, 1e-7}, {200, 2e-7}});
  const LawPair lines = std::get<FromFits>(row_of(Law::ehd_linear).make)({steep, flat});
  BOOST_TEST(std::get<LinearLaw>(lines.inner).K_N_per_m == steep.K_N_per_m);
  BOOST_TEST(std::get<LinearLaw>(lines.outer).K_N_per_m == flat.K_N_per_m);

  const SolvableContact contacts = synthetic::contacts();
  const auto built = build_curve(contacts, {.heaviest_N = 12e3});
  const auto curve = std::make_shared<const FilmCurve>(std::get<FilmCurve>(built));
  const FromCurves make = std::get<FromCurves>(row_of(Law::ehd).make);
  const LawPair curves = make({curve, curve}, {0.02, 0.03});
  BOOST_TEST(std::get<CurveLaw>(curves.inner).datum_m() == 0.02);
  BOOST_TEST(std::get<CurveLaw>(curves.outer).datum_m() == 0.03);
  BOOST_CHECK_THROW((void)make({curve, curve}, {1e-6, 0.03}), std::domain_error);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::bearing
