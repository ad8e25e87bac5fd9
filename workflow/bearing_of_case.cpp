// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_of_case.hpp"

#include <limits>

namespace ehd {

using bearing::RacewayContact;

bearing::RollerContact roller_contact_of(const BearingCase& body) {
  return {.force_N = 0,
          .length_m = body.geometry.length_m,
          .roller_diameter_m = body.geometry.roller_diameter_m,
          .pitch_diameter_m = body.geometry.pitch_diameter_m,
          .modulus_Pa = body.modulus_Pa,
          .poisson = body.poisson,
          .ring_thickness_m = body.ring_thickness_m.value_or(std::numeric_limits<double>::quiet_NaN())};
}

bearing::Speeds speeds_of(const BearingCase& body) {
  return bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm);
}

namespace {

RacewayContact contact_of(const BearingCase& body, bearing::Raceway raceway) {
  const bearing::Geometry& geometry = body.geometry;
  return {.length_m = geometry.length_m,
          .reduced_radius_m = bearing::reduced_radius_m(geometry, raceway),
          .reduced_modulus_Pa = bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson),
          .speed_sum_m_per_s = bearing::sum_speed_m_per_s(geometry, speeds_of(body)),
          .viscosity_Pa_s = body.lubricant ? body.lubricant->viscosity_Pa_s : 0};
}

}  // namespace

bearing::BothRaceways<RacewayContact> raceway_contacts_of(const BearingCase& body) {
  return {contact_of(body, bearing::Raceway::inner), contact_of(body, bearing::Raceway::outer)};
}

bool at_rest(const BearingCase& body) { return !(bearing::sum_speed_m_per_s(body.geometry, speeds_of(body)) > 0); }

bool datum_from_dry(const BearingCase& body) {
  const auto* palmgren = std::get_if<PalmgrenDatum>(&body.datum);
  return palmgren && !palmgren->load_N;
}

}  // namespace ehd
