// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance is a number with the reason for it; there is no constructor from double.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace ehd::verification {

class Tolerance {
 public:
  /// operations * eps * condition: what rounding alone may do.
  [[nodiscard]] static Tolerance round_off(double operations, double condition = 1) {
    return {operations * condition * std::numeric_limits<double>::epsilon(), "round-off",
            text(operations) + " operations, condition " + text(condition)};
  }
  /// An algebraic residual (relative) that the iteration was stopped at, times what it does to the observable.
  [[nodiscard]] static Tolerance iteration(double residual, double amplification = 1) {
    return {residual * amplification, "iteration",
            "stopped at residual " + text(residual) + ", amplification " + text(amplification)};
  }
  /// An estimated discretisation error with a safety factor.
  [[nodiscard]] static Tolerance discretisation(double estimate, double safety) {
    return {estimate * safety, "discretisation", "estimate " + text(estimate) + " x safety " + text(safety)};
  }
  /// Relative half unit of the last digit of a decimal text ("0.0741" -> 0.00005/0.0741).
  [[nodiscard]] static Tolerance published_digits(std::string_view digits) {
    return {half_unit(digits), "published digits", "half a unit of the last digit of " + std::string(digits)};
  }
  /// The remainder of an asymptotic expansion.
  [[nodiscard]] static Tolerance asymptotic(double remainder, std::string why) {
    return {remainder, "asymptotic", std::move(why)};
  }
  /// A number measured once and kept, with the record of the measurement.
  [[nodiscard]] static Tolerance calibrated(double value, std::string record) {
    return {value, "calibrated", std::move(record)};
  }
  /// A bound that the project promised beforehand, with the place where it did.
  [[nodiscard]] static Tolerance required(double value, std::string where) {
    return {value, "required", std::move(where)};
  }

  /// Two reasons that act together.
  [[nodiscard]] friend Tolerance operator+(const Tolerance& one, const Tolerance& other) {
    return {one.value_ + other.value_, one.basis_ == other.basis_ ? one.basis_ : one.basis_ + " + " + other.basis_,
            one.reason_ + "; " + other.reason_};
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const std::string& basis() const { return basis_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// Relative half unit of the last digit; 0 for a text without digits, absolute where the number is 0.
  [[nodiscard]] static double half_unit(std::string_view digits);

 private:
  Tolerance(double value, std::string basis, std::string reason)
      : value_(value), basis_(std::move(basis)), reason_(std::move(reason)) {}
  [[nodiscard]] static std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", value);
    return buffer;
  }
  double value_;
  std::string basis_;
  std::string reason_;
};

inline double Tolerance::half_unit(std::string_view digits) {
  const auto exponent_at = digits.find_first_of("eE");
  const std::string_view mantissa = digits.substr(0, exponent_at);
  const double exponent =
      exponent_at == std::string_view::npos ? 0 : std::stod(std::string(digits.substr(exponent_at + 1)));
  const auto point = mantissa.find('.');
  const double decimals =
      point == std::string_view::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  const double half = 0.5 * std::pow(10.0, exponent - decimals);
  const double value = std::abs(std::stod(std::string(digits)));
  return value > 0 ? half / value : half;
}

enum class Verdict { pass, fail, inconclusive };

/// pass iff error + uncertainty <= tolerance; fail iff error - uncertainty > tolerance; else (and for NaN)
/// inconclusive. An unconverged solve must be given as NaN.
[[nodiscard]] inline Verdict judge(double error, double uncertainty, const Tolerance& tolerance) {
  if (error + uncertainty <= tolerance.value()) return Verdict::pass;
  if (error - uncertainty > tolerance.value()) return Verdict::fail;
  return Verdict::inconclusive;
}

[[nodiscard]] inline std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::inconclusive: return "inconclusive";
  }
  return "";
}

}  // namespace ehd::verification
