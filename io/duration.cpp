// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/duration.hpp"

#include "contact/text.hpp"

namespace ehd {

std::string duration(double seconds) {
  if (seconds < 100) return plain(seconds, 2) + " s";
  const double minutes = seconds / 60;
  return minutes < 100 ? plain(minutes, 2) + " min" : plain(minutes / 60, 2) + " h";
}

std::string computing_time(double seconds, int digits) {
  return seconds < 1 ? milliseconds(seconds, digits) + " ms" : plain(seconds, digits) + " s";
}

std::string milliseconds(double seconds, int digits) { return plain(1e3 * seconds, digits); }

}  // namespace ehd
