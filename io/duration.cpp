// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/duration.hpp"

#include "contact/text.hpp"

namespace ehd {

std::string duration(double seconds) {
  if (seconds < 100) return plain(seconds, 2) + " s";
  const double minutes = seconds / 60;
  return minutes < 100 ? plain(minutes, 2) + " min" : plain(minutes / 60, 2) + " h";
}

}  // namespace ehd
