// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/solved_contacts.hpp"

#include "contact/hertz.hpp"

namespace ehd::bearing {

double offset_film_m(const RacewayContact& contact, double force_N, const SolvedContact& solved) {
  const double b = hertz::half_width_m(contact.at(force_N));
  return b * b / contact.reduced_radius_m * (solved.offset - hertz::dry_offset());
}

double relative_offset_error(const SolvedContact& solved) {
  return solved.offset_error / (solved.offset - hertz::dry_offset());
}

}  // namespace ehd::bearing
