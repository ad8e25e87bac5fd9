// SPDX-License-Identifier: GPL-3.0-or-later
// A law's table as source: the data, and an evaluator that does what TabulatedLaw::at does (bearing/tabulated_law.cpp).
#include <fmt/format.h>

#include <cmath>

#include "contact/text.hpp"
#include "io/law_export_text.hpp"
#include "io/program_text.hpp"

namespace ehd {

namespace {

constexpr const char* c_usage = R"( *
 * int PREFIX_law(double delta_m, double *force_N, double *stiffness_N_per_m, double *film_minimum_m,
 *                double *damping_N_s_per_m);
 *
 * Returns 0; 1 where delta_m is outside the table or no number: then nothing is written. Null where a number is not
 * wanted. The damping is NAN where it is not known.
 * PREFIX_error: the table's errors of force, stiffness, film, damping; -1 where not known.
 * PREFIX_range: the smallest and the largest delta_m.
 */
#include <math.h>
)";

constexpr const char* c_evaluator = R"(
static double PREFIX_cubic(const double *left, const double *right, double width, double t, double *slope)
{
  const double secant = (right[0] - left[0]) / width;
  const double c2 = 3.0 * secant - 2.0 * left[1] - right[1], c3 = left[1] + right[1] - 2.0 * secant;
  *slope = left[1] + t * (2.0 * c2 + t * 3.0 * c3);
  return left[0] + width * t * (left[1] + t * (c2 + t * c3));
}

int PREFIX_law(double delta_m, double *force_N, double *stiffness_N_per_m, double *film_minimum_m,
               double *damping_N_s_per_m);

int PREFIX_law(double delta_m, double *force_N, double *stiffness_N_per_m, double *film_minimum_m,
               double *damping_N_s_per_m)
{
  int low = 0, high = PREFIX_KNOTS - 1;
  double width, t, slope, force;
  if (!(delta_m >= PREFIX_range[0] && delta_m <= PREFIX_range[1])) return 1;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (delta_m >= PREFIX_delta[middle])
      low = middle;
    else
      high = middle;
  }
  width = PREFIX_delta[high] - PREFIX_delta[low];
  t = (delta_m - PREFIX_delta[low]) / width;
  force = exp(PREFIX_cubic(PREFIX_log_force[low], PREFIX_log_force[high], width, t, &slope));
  if (force_N) *force_N = force;
  if (stiffness_N_per_m) *stiffness_N_per_m = force * slope;
  if (film_minimum_m)
    *film_minimum_m = exp(PREFIX_cubic(PREFIX_log_film[low], PREFIX_log_film[high], width, t, &slope));
  if (damping_N_s_per_m)
    *damping_N_s_per_m = PREFIX_cubic(PREFIX_damping[low], PREFIX_damping[high], width, t, &slope);
  return 0;
}
)";

constexpr const char* matlab_evaluator = R"(
  n = size(T, 1);
  d = delta_m(:);
  inside = d >= T(1, 1) & d <= T(n, 1);
  k = min(max(sum(d >= T(:, 1).', 2), 1), n - 1);
  width = T(k + 1, 1) - T(k, 1);
  t = (d - T(k, 1)) ./ width;
  [y, slope] = cubic(T(k, 2:3), T(k + 1, 2:3), width, t);
  y(~inside) = NaN;
  force_N = reshape(exp(y), size(delta_m));
  stiffness_N_per_m = reshape(exp(y) .* slope, size(delta_m));
  y = cubic(T(k, 4:5), T(k + 1, 4:5), width, t);
  y(~inside) = NaN;
  film_minimum_m = reshape(exp(y), size(delta_m));
  y = cubic(T(k, 6:7), T(k + 1, 6:7), width, t);
  y(~inside) = NaN;
  damping_N_s_per_m = reshape(y, size(delta_m));
end

function [y, slope] = cubic(left, right, width, t)
  secant = (right(:, 1) - left(:, 1)) ./ width;
  c2 = 3 * secant - 2 * left(:, 2) - right(:, 2);
  c3 = left(:, 2) + right(:, 2) - 2 * secant;
  slope = left(:, 2) + t .* (2 * c2 + t .* (3 * c3));
  y = left(:, 1) + width .* t .* (left(:, 2) + t .* (c2 + t .* c3));
end
)";

/// A value and a slope at each knot.
using Pairs = std::vector<std::pair<double, double>>;

Pairs pairs_of(const bearing::KnotColumn& column) {
  Pairs pairs;
  for (std::size_t k = 0; k < column.values.size(); ++k) pairs.emplace_back(column.values[k], column.slopes[k]);
  return pairs;
}
Pairs logarithms_of(const bearing::KnotColumn& column) {
  Pairs pairs = pairs_of(column);
  for (auto& [value, slope] : pairs) slope /= value, value = std::log(value);
  return pairs;
}

std::string c_pairs(const std::string& name, const Pairs& pairs) {
  std::string text = fmt::format("static const double PREFIX_{}[PREFIX_KNOTS][2] = {{\n", name);
  for (const auto& [value, slope] : pairs) text += fmt::format("  {},\n", braced({value, slope}));
  return text + "};\n";
}

std::string c_unknown_pairs(std::size_t count) {
  std::string text = "static const double PREFIX_damping[PREFIX_KNOTS][2] = {\n";
  for (std::size_t k = 0; k < count; ++k) text += "  {NAN, NAN},\n";
  return text + "};\n";
}

}  // namespace

std::string law_export_c(const LawExport& law) {
  const bearing::TabulatedLaw& table = law.table;
  const std::size_t knots = table.approach_m.size();
  // Words of the user keep their letters.
  std::string words = "/* Contact force law of a roller bearing. C99; needs math.h alone. Schema ehd-law-1.\n *\n";
  for (const std::string& line : law_export_words(law)) words += " * " + in_c_comment(line) + "\n";
  std::string text = c_usage;
  text += fmt::format("\nenum {{ PREFIX_KNOTS = {} }};\n", knots);
  text += fmt::format(
      "extern const double PREFIX_error[4], PREFIX_range[2];\n"
      "const double PREFIX_error[4] = {};\nconst double PREFIX_range[2] = {};\n",
      braced({table.errors.force, table.errors.stiffness, table.errors.film, table.errors.damping.value_or(-1)}),
      braced({table.approach_m.front(), table.approach_m.back()}));
  text += "static const double PREFIX_delta[PREFIX_KNOTS] = {\n";
  for (const double approach : table.approach_m) text += fmt::format("  {},\n", exact_number(approach));
  text += "};\n/* A value and its slope at each knot. */\n";
  text += c_pairs("log_force", logarithms_of(table.force_N)) + c_pairs("log_film", logarithms_of(table.film_minimum_m));
  text += table.damping_N_s_per_m ? c_pairs("damping", pairs_of(*table.damping_N_s_per_m)) : c_unknown_pairs(knots);
  return words + with_prefix(text + c_evaluator, law_export_prefix(law));
}

std::string law_export_matlab(const LawExport& law) {
  const bearing::TabulatedLaw& table = law.table;
  const std::string prefix = law_export_prefix(law);
  std::string words = fmt::format(
      "function [force_N, stiffness_N_per_m, film_minimum_m, damping_N_s_per_m] = {}_law(delta_m)\n"
      "% Contact force law of a roller bearing, for MATLAB (R2016b on) and Octave. Schema ehd-law-1.\n%\n",
      prefix);
  for (const std::string& line : law_export_words(law)) words += "% " + one_line(line) + "\n";
  std::string text = "%\n% delta_m: of any size. NaN outside the table, and for a damping that is not known.\n";
  text += "  % delta, ln(force) and its slope, ln(film) and its slope, damping and its slope\n  T = [\n";
  const Pairs force = logarithms_of(table.force_N), film = logarithms_of(table.film_minimum_m);
  for (std::size_t k = 0; k < table.approach_m.size(); ++k) {
    text += fmt::format("    {} {} {} {} {}", exact_number(table.approach_m[k]), exact_number(force[k].first),
                        exact_number(force[k].second), exact_number(film[k].first), exact_number(film[k].second));
    text += table.damping_N_s_per_m ? fmt::format(" {} {}\n", exact_number(table.damping_N_s_per_m->values[k]),
                                                  exact_number(table.damping_N_s_per_m->slopes[k]))
                                    : " NaN NaN\n";
  }
  return words + with_prefix(text + "  ];" + matlab_evaluator, prefix);
}

}  // namespace ehd
