// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_datum.hpp"

#include <variant>

#include "bearing/approach_formulas.hpp"
#include "bearing/force_law.hpp"
#include "contact/approach.hpp"
#include "workflow/bearing_notes.hpp"

namespace ehd {

namespace {

using bearing::BothRaceways;
using bearing::RacewayContact;

/// A visit: a new kind of datum does not compile until it has a length and a note.
struct DatumFrom {
  const BearingSetup& setup;
  double largest_dry_N;

  [[nodiscard]] DatumOfCase operator()(const LengthDatum& given) const {
    return with_note("x_0 given", {given.x0_m, given.x0_m});
  }
  [[nodiscard]] DatumOfCase operator()(const LundbergDatum&) const { return with_note("lundberg, x_0 = l", lengths()); }
  [[nodiscard]] DatumOfCase operator()(const PalmgrenDatum& palmgren) const {
    // Without a radial load the dry rollers press on the outer ring alone.
    const double load_N = palmgren.load_N.value_or(largest_dry_N > 0 ? largest_dry_N : setup.loading.centrifugal_N);
    if (!(load_N > 0)) return with_note(note::no_force_for_palmgren, lengths());  // the datum has no effect
    const auto at = [load_N](const RacewayContact& contact) {
      return datum_from_dry_approach_m(contact.at(load_N), bearing::palmgren_law(contact.length_m).approach(load_N));
    };
    return with_note(note::palmgren_at(load_N), {at(setup.contacts.inner), at(setup.contacts.outer)});
  }

 private:
  [[nodiscard]] BothRaceways<double> lengths() const {
    return {setup.contacts.inner.length_m, setup.contacts.outer.length_m};
  }
  [[nodiscard]] static DatumOfCase with_note(const std::string& name, const BothRaceways<double>& x0_m) {
    return {x0_m, note::datum(name, x0_m)};
  }
};

}  // namespace

DatumOfCase datum_of(const BearingSetup& setup, double largest_dry_N) {
  return std::visit(DatumFrom{setup, largest_dry_N}, setup.body.datum);
}

}  // namespace ehd
