// SPDX-License-Identifier: GPL-3.0-or-later
// One contact in all scalings: SI, Moes, Dowson and Hamrock, Hertz (which Kostreva uses).
//
// Every number here is a constant times powers of load, E', R, viscosity, speed and alpha. So the logarithms of the
// given numbers are linear equations, and a number is known where its own equation is a combination of them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ehd {

/// Exponents of w [N/m], E' [Pa], R [m], eta_0 [Pa s], u_s [m/s] and alpha [1/Pa].
using Exponents = std::array<double, 6>;

/// A row of the table: constant * w^e0 E'^e1 R^e2 eta_0^e3 u_s^e4 alpha^e5.
struct ScaledNumber {
  std::string_view name;  ///< as in case files and in the JSON of results
  std::string_view unit;  ///< empty: a pure number
  std::string_view meaning;
  double constant = 1;
  Exponents exponents = {};
  /// The number is 0 where alpha is 0, for an isoviscous fluid.
  [[nodiscard]] bool may_vanish() const { return exponents.back() > 0; }
};
/// The formulas: docs/theory.md. Groups with U have the MEAN speed where the name says so.
[[nodiscard]] std::span<const ScaledNumber> scaled_numbers();

struct GivenNumber {
  std::string name;
  double value = 0;
};

/// The value of each row of the table; absent where the given numbers leave it open. Throws StatementError, with the
/// name as its key: no such number, not positive (0 is allowed where alpha = 0 makes it), a given number that follows
/// from those before it, or a value that is no normal double.
[[nodiscard]] std::vector<std::optional<double>> in_all_scalings(const std::vector<GivenNumber>& given);

}  // namespace ehd
