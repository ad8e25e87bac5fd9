// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_datum.hpp"

#include <variant>

#include "bearing/force_law.hpp"
#include "contact/approach.hpp"

namespace ehd {

namespace {

using bearing::BothRaceways;
using bearing::RacewayContact;

/// A visit: a new kind of datum does not compile until it has a length and a note.
struct DatumFrom {
  const BearingSetup& setup;
  double largest_dry_N;

  [[nodiscard]] DatumOfCase operator()(const LengthDatum& given) const {
    return {{given.x0_m, given.x0_m}, {note::Datum::From::stated}};
  }
  [[nodiscard]] DatumOfCase operator()(const LundbergDatum&) const {
    return {lengths(), {note::Datum::From::lundberg}};
  }
  [[nodiscard]] DatumOfCase operator()(const PalmgrenDatum& palmgren) const {
    // Without a radial load the dry rollers press on the outer ring alone.
    const double load_N = palmgren.load_N.value_or(largest_dry_N > 0 ? largest_dry_N : setup.loading.centrifugal_N);
    if (!(load_N > 0)) return {lengths(), {note::Datum::From::without_a_force}};
    const auto at = [load_N](const RacewayContact& contact) {
      return datum_from_dry_approach_m(contact.at(load_N), bearing::palmgren_law(contact.length_m).approach(load_N));
    };
    return {{at(setup.contacts.inner), at(setup.contacts.outer)}, {note::Datum::From::palmgren, load_N}};
  }

 private:
  [[nodiscard]] BothRaceways<double> lengths() const {
    return {setup.contacts.inner.length_m, setup.contacts.outer.length_m};
  }
};

}  // namespace

DatumOfCase datum_of(const BearingSetup& setup, double largest_dry_N) {
  return std::visit(DatumFrom{setup, largest_dry_N}, setup.body.datum);
}

}  // namespace ehd
