// SPDX-License-Identifier: GPL-3.0-or-later
// Results that nobody computed: small, smooth, with every part that a report draws, and with text that would break a
// page if it were not escaped.
#pragma once

#include "io/json.hpp"

namespace ehd::verification::test {

inline const char* const hostile_text = "5 < 7 & \"quotes\" 'and' <script>alert(1)</script> *P*_{x}";

[[nodiscard]] Json made_results();
[[nodiscard]] Json made_bench();
[[nodiscard]] Json made_stress();

}  // namespace ehd::verification::test
