// SPDX-License-Identifier: GPL-3.0-or-later
// The two tables of laws, and that a law which leaves out an answer is no law: the program then does not compile.
#include "contact/oil_laws.hpp"

#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tests/check.hpp"

namespace {

using namespace ehd;

// ---- what does not compile ---------------------------------------------------------------------------------------

/// All that a viscosity law must answer. Each struct below hides one answer behind another type.
struct WholeLaw : Barus {
  [[nodiscard]] static WholeLaw from(const LawInputs& /*inputs*/) { return {}; }
  [[nodiscard]] WholeLaw in_units_of(double /*unit*/) const { return {}; }
};
template <class Law>
struct Answering : WholeLaw {
  [[nodiscard]] static Law from(const LawInputs& /*inputs*/) { return {}; }
  [[nodiscard]] Law in_units_of(double /*unit*/) const { return {}; }
};
struct Foreign {};
struct WithoutKeys : Answering<WithoutKeys> {
  static constexpr std::nullptr_t keys = nullptr;
};
struct WithoutParameters : Answering<WithoutParameters> {
  void parameters() const {}
};
struct WithoutFormula : Answering<WithoutFormula> {
  static constexpr int formula = 0;
};
struct WithoutAmbientSlope : Answering<WithoutAmbientSlope> {
  void ambient_slope() const {}
};
struct WithoutValues : Answering<WithoutValues> {
  int evaluate = 0;
};
struct WithoutTrivial : Answering<WithoutTrivial> {
  static constexpr std::nullptr_t trivial = nullptr;
};

static_assert(ViscosityFormula<WholeLaw>);
static_assert(!ViscosityFormula<Foreign> && !DensityFormula<Foreign>);
static_assert(!ViscosityFormula<WithoutKeys>);
static_assert(!ViscosityFormula<WithoutParameters>);
static_assert(!ViscosityFormula<WithoutFormula>);
static_assert(!ViscosityFormula<WithoutAmbientSlope>);
static_assert(!ViscosityFormula<WithoutValues>);
static_assert(!ViscosityFormula<WithoutTrivial>);
static_assert(!ViscosityFormula<DowsonHigginson>, "a density law is no viscosity law");

template <class Law>
concept Evaluable = requires(const Law& law, const Array& pressure, LawValues<double>& out) {
  evaluate(law, pressure, out);
};
static_assert(Evaluable<Viscosity> && Evaluable<Density>);
static_assert(!Evaluable<Foreign>);

// ---- rows --------------------------------------------------------------------------------------------------------

template <class Law, std::size_t... Places>
std::vector<Law> alternatives(std::index_sequence<Places...>) {
  return {Law{std::in_place_index<Places>}...};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(oil_laws)

BOOST_AUTO_TEST_CASE(every_law_has_one_row_and_its_name_is_read_back) {
  for (const auto& row : viscosity_laws()) {
    BOOST_TEST_CONTEXT(row.name) {
      BOOST_TEST((viscosity_law_from(row.name) == row.law));
      BOOST_TEST(to_string(row.law) == row.name);
      BOOST_TEST(name(row.from({})) == row.name);
      BOOST_TEST((row.keys.alpha_per_Pa || row.keys.z || row.keys.p0_Pa) == !is_trivial(row.from({})));
    }
  }
  for (const auto& row : density_laws()) {
    BOOST_TEST_CONTEXT(row.name) {
      BOOST_TEST((density_law_from(row.name) == row.law));
      BOOST_TEST(to_string(row.law) == row.name);
    }
  }
  BOOST_TEST(viscosity_laws().size() == 3);
  BOOST_TEST(density_laws().size() == 3);
  BOOST_TEST(!viscosity_law_from("dowson-higginson"));
  BOOST_TEST(!viscosity_law_from("Barus"));
  BOOST_TEST(!density_law_from("barus"));
  BOOST_TEST(!density_law_from(""));
}

BOOST_AUTO_TEST_CASE(a_viscosity_law_is_made_from_the_keys_that_it_names) {
  const LawInputs inputs{.alpha = 1.9, .p0 = 0.23, .z = 0.61};
  BOOST_TEST(cache_key(row_of(ViscosityLaw::isoviscous).from(inputs)) == std::vector<double>{0},
             boost::test_tools::per_element());
  BOOST_TEST(cache_key(row_of(ViscosityLaw::barus).from(inputs)) == (std::vector<double>{1, 1.9}),
             boost::test_tools::per_element());
  BOOST_TEST(cache_key(row_of(ViscosityLaw::roelands).from(inputs)) == (std::vector<double>{2, 1.9, 0.23, 0.61}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_key_of_a_cache_holds_every_number_of_a_law) {
  BOOST_TEST(cache_key(Density{DowsonHigginson{.a = 0.4, .c = 0.7}}) == (std::vector<double>{1, 0.4, 0.7}),
             boost::test_tools::per_element());
  // The key has the law's place first and then one number a member of its struct.
  int laws = 0;
  for (const auto& law : alternatives<Viscosity>(std::make_index_sequence<std::variant_size_v<Viscosity>>{})) {
    BOOST_TEST(cache_key(law).front() == static_cast<double>(law.index()));
    const std::size_t members = std::visit(
        [](const auto& formula) {
          using Law = std::decay_t<decltype(formula)>;
          return std::is_empty_v<Law> ? 0 : sizeof(Law) / sizeof(double);
        },
        law);
    BOOST_TEST(cache_key(law).size() == 1 + members);
    ++laws;
  }
  BOOST_TEST(laws == 3);
}

BOOST_AUTO_TEST_SUITE_END()
