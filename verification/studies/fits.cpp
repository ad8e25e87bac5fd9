// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/fits.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace ehd::verification {

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  const double n = static_cast<double>(x.size()), fitted = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return std::isfinite(fitted) ? fitted : std::numeric_limits<double>::quiet_NaN();
}

Claim order_claim(Sentence says, double fitted, double declared, Tolerance tolerance, std::string note) {
  Claim judged = claim(std::move(says), std::abs(fitted - declared), 0, std::move(tolerance), std::move(note));
  judged.measured = fitted;
  judged.expected = declared;
  return judged;
}

}  // namespace ehd::verification
