// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/scalings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"

namespace ehd {

namespace {

using std::numbers::pi;

// Roots are not constexpr in C++20.
constexpr double root_of_2_pi = 2.5066282746310002;
constexpr double root_of_8_over_pi = 1.5957691216057308;

//                                 w     E'     R    eta_0   u_s  alpha
constexpr Exponents power_of_M{1, -0.5, -0.5, -0.5, -0.5, 0};
constexpr Exponents power_of_L{0, 0.75, -0.25, 0.25, 0.25, 1};

constexpr std::array table{
    ScaledNumber{.name = "M", .unit = "", .meaning = "Moes' load group, sum speed", .exponents = power_of_M},
    ScaledNumber{.name = "L", .unit = "", .meaning = "Moes' lubricant group, sum speed", .exponents = power_of_L},
    ScaledNumber{.name = "lambda",
                 .unit = "",
                 .meaning = "Hertz (Kostreva): 6 eta_0 u_s R^2/(b^3 p_H)",
                 .constant = 3 * pi * pi / 8,
                 .exponents = {-2, 1, 1, 1, 1, 0}},
    ScaledNumber{.name = "alpha_p_H",
                 .unit = "",
                 .meaning = "Hertz (Kostreva): alpha times p_H",
                 .constant = 1 / root_of_2_pi,
                 .exponents = {0.5, 0.5, -0.5, 0, 0, 1}},
    ScaledNumber{.name = "W", .unit = "", .meaning = "Dowson and Hamrock: w/(E'R)", .exponents = {1, -1, -1, 0, 0, 0}},
    ScaledNumber{.name = "U_mean",
                 .unit = "",
                 .meaning = "Dowson and Hamrock: eta_0 u_s/(2E'R), mean speed",
                 .constant = 0.5,
                 .exponents = {0, -1, -1, 1, 1, 0}},
    ScaledNumber{.name = "G", .unit = "", .meaning = "Dowson and Hamrock: alpha E'", .exponents = {0, 1, 0, 0, 0, 1}},
    ScaledNumber{.name = "load_N_per_m", .unit = "N/m", .meaning = "w", .exponents = {1, 0, 0, 0, 0, 0}},
    ScaledNumber{.name = "reduced_modulus_Pa", .unit = "Pa", .meaning = "E'", .exponents = {0, 1, 0, 0, 0, 0}},
    ScaledNumber{.name = "reduced_radius_m", .unit = "m", .meaning = "R", .exponents = {0, 0, 1, 0, 0, 0}},
    ScaledNumber{.name = "viscosity_Pa_s", .unit = "Pa s", .meaning = "eta_0", .exponents = {0, 0, 0, 1, 0, 0}},
    ScaledNumber{
        .name = "speed_sum_m_per_s", .unit = "m/s", .meaning = "u_s = u_1 + u_2", .exponents = {0, 0, 0, 0, 1, 0}},
    ScaledNumber{.name = "alpha_per_Pa", .unit = "1/Pa", .meaning = "alpha", .exponents = {0, 0, 0, 0, 0, 1}},
    ScaledNumber{.name = "viscosity_times_speed_N_per_m",
                 .unit = "N/m",
                 .meaning = "eta_0 u_s",
                 .exponents = {0, 0, 0, 1, 1, 0}},
    ScaledNumber{.name = "hertz_pressure_Pa",
                 .unit = "Pa",
                 .meaning = "p_H",
                 .constant = 1 / root_of_2_pi,
                 .exponents = {0.5, 0.5, -0.5, 0, 0, 0}},
    ScaledNumber{.name = "half_width_m",
                 .unit = "m",
                 .meaning = "b",
                 .constant = root_of_8_over_pi,
                 .exponents = {0.5, -0.5, 0.5, 0, 0, 0}},
    ScaledNumber{.name = "film_moes_per_hertz",
                 .unit = "",
                 .meaning = "film in Moes units over Hertz units: 8M/pi",
                 .constant = 8 / pi,
                 .exponents = power_of_M},
    ScaledNumber{.name = "film_m_per_hertz",
                 .unit = "m",
                 .meaning = "film in metres over Hertz units: b^2/R",
                 .constant = 8 / pi,
                 .exponents = {1, -1, 0, 0, 0, 0}},
};

constexpr Exponents only_alpha{0, 0, 0, 0, 0, 1};

/// Exponents are multiples of 1/4: what elimination leaves of a zero is far smaller.
constexpr double negligible = 1e-9;

/// exponents . logarithms of the six base quantities = value.
struct Equation {
  Exponents exponents;
  double value = 0;
  [[nodiscard]] std::size_t leading() const {  // the place of the first exponent; 6 where all are zero
    const auto* const at =
        std::find_if(exponents.begin(), exponents.end(), [](double e) { return std::abs(e) > negligible; });
    return static_cast<std::size_t>(at - exponents.begin());
  }
  void subtract(const Equation& other, double times) {
    for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] -= times * other.exponents[i];
    value -= times * other.value;
  }
};

/// The given numbers as independent equations, each with another leading place.
class KnownEquations {
 public:
  /// The equation with all that is known taken out; its exponents are zero where it says nothing new.
  [[nodiscard]] Equation reduced(Equation equation) const {
    for (const Equation& known : known_) {
      const std::size_t at = known.leading();
      equation.subtract(known, equation.exponents[at] / known.exponents[at]);
    }
    return equation;
  }
  /// False where it says nothing new.
  bool add(const Equation& equation) {
    const Equation rest = reduced(equation);
    if (rest.leading() == rest.exponents.size()) return false;
    // Eliminate the new leading unknown from the earlier equations, so that one pass reduces any equation.
    const std::size_t at = rest.leading();
    for (Equation& known : known_) known.subtract(rest, known.exponents[at] / rest.exponents[at]);
    known_.push_back(rest);
    return true;
  }

 private:
  std::vector<Equation> known_;
};

std::string names() {
  std::string all;
  for (const ScaledNumber& row : table) all += (all.empty() ? "" : ", ") + std::string(row.name);
  return all;
}

/// A number with the digits that are known: logarithms are up to 50, of 16 digits two are lost in them.
double rounded(double value) {
  constexpr int known_digits = 14;
  return number_in(plain(value, known_digits));
}

std::optional<double> value_by(const KnownEquations& known, const ScaledNumber& row) {
  const Equation rest = known.reduced({.exponents = row.exponents, .value = 0});
  if (rest.leading() != rest.exponents.size()) return std::nullopt;
  const double value = row.constant * std::exp(-rest.value);
  if (!std::isnormal(value))
    throw StatementError(
        std::string(row.name),
        "leaves the range of numbers, 1e-307 to 1e308; allowed are numbers nearer to those of a contact");
  return rounded(value);
}

}  // namespace

std::span<const ScaledNumber> scaled_numbers() { return table; }

std::vector<std::optional<double>> in_all_scalings(const std::vector<GivenNumber>& given) {
  KnownEquations known;
  bool isoviscous = false, alpha_is_stated = false;
  for (const GivenNumber& one : given) {
    const auto* const row =
        std::find_if(table.begin(), table.end(), [&](const ScaledNumber& each) { return each.name == one.name; });
    if (row == table.end()) throw StatementError(one.name, "is unknown; allowed is " + names());
    const bool vanishes = one.value == 0 && row->may_vanish();
    if (!vanishes && !(one.value > 0 && std::isfinite(one.value)))
      throw StatementError(one.name, "is not positive; allowed is a number above 0");
    // alpha = 0 says nothing of the other five quantities.
    const Equation equation = vanishes
                                  ? Equation{.exponents = only_alpha, .value = 0}
                                  : Equation{.exponents = row->exponents, .value = std::log(one.value / row->constant)};
    const auto follows = [&](double value) {
      return StatementError(one.name, "the numbers before it fix it already, at " + plain(value) +
                                          "; allowed is without one of these numbers");
    };
    if (isoviscous && row->may_vanish()) throw follows(0);
    if (vanishes && alpha_is_stated)
      throw StatementError(
          one.name, "is 0, so alpha is 0; but a number before it needs an alpha above 0; allowed is one or the other");
    if (!known.add(equation)) throw follows(*value_by(known, *row));
    isoviscous = isoviscous || vanishes;
    alpha_is_stated = alpha_is_stated || row->may_vanish();
  }
  std::vector<std::optional<double>> values;
  values.reserve(table.size());
  for (const ScaledNumber& row : table) {
    const auto stated = std::find_if(given.begin(), given.end(), [&](const auto& one) { return one.name == row.name; });
    if (stated != given.end())
      values.emplace_back(stated->value);
    else
      values.push_back(isoviscous && row.may_vanish() ? std::optional(0.0) : value_by(known, row));
  }
  return values;
}

}  // namespace ehd
