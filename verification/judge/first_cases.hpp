// SPDX-License-Identifier: GPL-3.0-or-later
// The first ten cases for somebody's own solver, from easy to hard.
#pragma once

#include <array>
#include <string_view>

namespace ehd::judging {

struct FirstCase {
  std::string_view id;
  std::string_view tests;  ///< what goes wrong here first
};

inline constexpr std::array<FirstCase, 10> first_cases{{
    {"own-isoviscous-10-0", "elasticity, load balance and the free exit, without any law of the oil"},
    {"own-barus-5-5", "Barus' law; the pressure is smooth"},
    {"own-moes-5-5", "Roelands' law and a compressible oil"},
    {"own-barus-20-10", "the pressure spike, under Barus' law"},
    {"own-moes-20-10", "a moderate load with all laws; the spike's height"},
    {"own-moes-20-10-flooded", "the flooded inlet: cut at X = -4, the films are 0.2 to 0.3 % too thin"},
    {"own-moes-100-10", "a thin film: the constant of the film equation is 50 times the film"},
    {"own-barus-3-4-flooded", "a light load, flooded: the pressure begins far outside the contact"},
    {"own-moes-200-15-flooded", "a short inlet zone and a sharp spike next to the exit"},
    {"own-moes-1000-20", "a heavy load: 1024 equal cells of line_contact.f90 leave 0.6 digits"},
}};

}  // namespace ehd::judging
