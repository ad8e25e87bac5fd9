// SPDX-License-Identifier: GPL-3.0-or-later
// Film curves against contacts below their lightest point, which they have not seen.
#pragma once

#include "bearing/film_curve.hpp"
#include "contact/conditions.hpp"

namespace ehd::verification {

struct UnseenContacts {
  long contacts = 0;  ///< solved; too light ones that no solver takes are left out
  /// The largest error of the curve over the error that it states below its lightest point: of the films and of the
  /// force. The error of the solved contact itself is subtracted. At most 1 where every stated error covers the
  /// true one.
  double worst = 0;
};
/// Solves contacts to 1e-6 at nine loads, from 0.93 to 0.03 of the curve's lightest.
[[nodiscard]] UnseenContacts unseen_below(const bearing::FilmCurve& curve, const Lubricant& lubricant);

}  // namespace ehd::verification
