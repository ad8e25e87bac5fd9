// SPDX-License-Identifier: GPL-3.0-or-later
// Orders fitted to errors, and the claim that one is as declared.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "verification/claim.hpp"

namespace ehd::verification {

/// The slope of y over x by least squares; NaN where a y is not finite.
inline double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  const double n = static_cast<double>(x.size()), fitted = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return std::isfinite(fitted) ? fitted : std::numeric_limits<double>::quiet_NaN();
}

inline Claim order_claim(Sentence says, double fitted, double declared, Tolerance tolerance, std::string note) {
  Claim judged = claim(std::move(says), std::abs(fitted - declared), 0, std::move(tolerance), std::move(note));
  judged.measured = fitted;
  judged.expected = declared;
  return judged;
}

inline std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2e", value);
  return text;
}

}  // namespace ehd::verification
