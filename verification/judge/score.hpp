// SPDX-License-Identifier: GPL-3.0-or-later
// The score of one number against the certified one: NIST's log relative error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/quantities.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::judging {

/// |value/certified - 1|; |value| where the certified number is 0.
[[nodiscard]] double relative_error(double value, double certified);
/// LRE = -log10(max(error, uncertainty)), 0 at least: the digits that are shown to be right. `uncertainty` is the
/// relative one of the certified number. Both are finite and not negative; rounding of a double bounds the score.
[[nodiscard]] double log_relative_error(double error, double uncertainty);

/// Does the actual error keep to the stated one? It lies between error - uncertainty and error + uncertainty.
enum class Honesty { met, missed, undecided };
[[nodiscard]] std::string_view to_string(Honesty honesty);
[[nodiscard]] Honesty honesty_of(double error, double uncertainty, double stated);

/// A number that a case gives, in Hertz units.
struct Certified {
  Quantity quantity = Quantity::film_minimum;
  double value = 0;
  double uncertainty = 0;  ///< relative
  std::string digits;      ///< as the case file has it
  Scaling scaling = Scaling::hertz;
  ExpectationKind kind = ExpectationKind::computed;
};

/// The scales of a case: groups, and SI where the case states it. Nothing is solved.
class CaseScales {
 public:
  explicit CaseScales(const ContactCase& contact);
  [[nodiscard]] const std::optional<Groups>& groups() const { return run_.groups; }  ///< absent for a dry contact
  /// The value in a scaling of one Hertz unit of the quantity; absent where the case leaves the scale open.
  [[nodiscard]] std::optional<double> unit(Quantity quantity, Scaling scaling) const;

 private:
  ContactRun run_;
};

/// The numbers of a contact case, in the order of the quantities: of several for one quantity that with the smallest
/// uncertainty. Fits, and values that wait for their source, do not count.
[[nodiscard]] std::vector<Certified> certified_numbers(const Case& contact_case, const CaseScales& scales);

}  // namespace ehd::judging
