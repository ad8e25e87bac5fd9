// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance: a number together with its reason. There is no constructor from double.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "contact/text.hpp"

namespace ehd::verification {

class Tolerance {
 public:
  /// operations * eps * condition: a bound of the rounding error.
  [[nodiscard]] static Tolerance round_off(double operations, double condition = 1) {
    return {operations * condition * std::numeric_limits<double>::epsilon(), "round-off",
            fmt::format("{} operations, condition {}", text(operations), text(condition))};
  }
  /// The relative residual at which the iteration stopped, times its effect on the observable.
  [[nodiscard]] static Tolerance iteration(double residual, double amplification = 1) {
    return {residual * amplification, "iteration",
            fmt::format("stopped at residual {}, amplification {}", text(residual), text(amplification))};
  }
  /// An estimated discretisation error with a safety factor.
  [[nodiscard]] static Tolerance discretisation(double estimate, double safety) {
    return {estimate * safety, "discretisation", fmt::format("estimate {} x safety {}", text(estimate), text(safety))};
  }
  /// Relative half unit of the last digit of a decimal text ("0.0741" -> 0.00005/0.0741).
  [[nodiscard]] static Tolerance published_digits(std::string_view digits) {
    return {relative_half_unit(digits), "published digits", "half a unit of the last digit of " + std::string(digits)};
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

  /// What a solver states. For a ratio to what it states: 1.
  [[nodiscard]] static Tolerance stated(double error = 1) { return required(error, "an error bar covers the error"); }

  /// Two reasons that act together.
  [[nodiscard]] friend Tolerance operator+(const Tolerance& one, const Tolerance& other) {
    return {one.value_ + other.value_, one.basis_ == other.basis_ ? one.basis_ : one.basis_ + " + " + other.basis_,
            one.reason_ + "; " + other.reason_};
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const std::string& basis() const { return basis_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  Tolerance(double value, std::string basis, std::string reason)
      : value_(value), basis_(std::move(basis)), reason_(std::move(reason)) {}
  [[nodiscard]] static std::string text(double value) { return plain(value, 3); }
  double value_;
  std::string basis_;
  std::string reason_;
};

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
