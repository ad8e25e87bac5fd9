// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/film_table_c.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/film_table_text.hpp"
#include "io/program_text.hpp"

namespace ehd {

namespace {

constexpr const char* how_to_use = R"( *
 * int PREFIX_film(int film, double M, double L, double *value, double *by_M, double *by_L);
 *
 * film: 0 minimum, 1 central, 2 Couette film, 3 offset H_0. M and L are Moes' groups with the sum speed.
 * *value: the film in units of b^2/R (half width b, reduced radius R); times b^2/R it is a length.
 * *by_M, *by_L: its derivatives; null where they are not wanted.
 * Returns 0; 1 where M or L is outside the table or no number; 2 for an unknown film. After 1 and 2 nothing is written.
 * PREFIX_error[film]: the stated error.
 */
)";

/// The evaluator. It does what films_at of workflow/film_table does, in the same order.
constexpr const char* evaluator = R"(
static void PREFIX_basis(int degree, double t, double *value, double *slope)
{
  int k;
  value[0] = 1.0;
  slope[0] = 0.0;
  value[1] = t;
  slope[1] = 1.0;
  for (k = 1; k < degree; ++k) {
    value[k + 1] = 2.0 * t * value[k] - value[k - 1];
    slope[k + 1] = 2.0 * value[k] + 2.0 * t * slope[k] - slope[k - 1];
  }
}

int PREFIX_film(int film, double M, double L, double *value, double *by_M, double *by_L);

int PREFIX_film(int film, double M, double L, double *value, double *by_M, double *by_L)
{
  double x[PREFIX_SIZE], x_slope[PREFIX_SIZE], y[PREFIX_SIZE], y_slope[PREFIX_SIZE];
  double sum = 0.0, sum_by_x = 0.0, sum_by_y = 0.0, h;
  const double *c;
  int p = 0, i, j;
  if (film < 0 || film > 3) return 2;
  if (!(M >= PREFIX_range[0] && M <= PREFIX_range[1] && L >= PREFIX_range[2] && L <= PREFIX_range[3])) return 1;
  while (p + 1 < PREFIX_PANELS && !(M <= PREFIX_panel[p].M_high)) ++p;
  PREFIX_basis(PREFIX_panel[p].degree_M, 2.0 * (log(M) - PREFIX_panel[p].log_low) / PREFIX_panel[p].across - 1.0, x,
               x_slope);
  PREFIX_basis(PREFIX_panel[p].degree_L, 2.0 * (log1p(L) - PREFIX_log_L[0]) / PREFIX_log_L[1] - 1.0, y, y_slope);
  c = PREFIX_panel[p].coefficients[film];
  for (i = 0; i <= PREFIX_panel[p].degree_M; ++i) {
    double row = 0.0, row_slope = 0.0;
    for (j = 0; j <= PREFIX_panel[p].degree_L; ++j, ++c) {
      row += *c * y[j];
      row_slope += *c * y_slope[j];
    }
    sum += x[i] * row;
    sum_by_x += x_slope[i] * row;
    sum_by_y += x[i] * row_slope;
  }
  h = exp(sum);
  *value = h + PREFIX_shift[film];
  if (by_M) *by_M = h * sum_by_x * 2.0 / (PREFIX_panel[p].across * M);
  if (by_L) *by_L = h * sum_by_y * 2.0 / (PREFIX_log_L[1] * (1.0 + L));
  return 0;
}
)";

/// The coefficients, one array a panel and film, a row a degree of M.
std::string coefficient_arrays(const FilmTable& table) {
  std::string text;
  for (std::size_t p = 0; p < table.panels.size(); ++p) {
    const FilmPanel& panel = table.panels[p];
    const std::size_t row = static_cast<std::size_t>(panel.degree_L) + 1;
    for (std::size_t k = 0; k < table_film_count; ++k) {
      const auto& c = panel.coefficients[k];
      text += fmt::format("static const double PREFIX_c{}_{}[{}] = {{", p, k, c.size());
      for (std::size_t at = 0; at < c.size(); ++at) text += (at % row == 0 ? "\n  " : " ") + exact_number(c[at]) + ",";
      text.back() = '}';
      text += ";\n";
    }
  }
  return text;
}

std::string panels(const FilmTable& table) {
  std::string text =
      "static const struct {\n  double M_high, log_low, across;\n  int degree_M, degree_L;\n"
      "  const double *coefficients[4];\n} PREFIX_panel[PREFIX_PANELS] = {\n";
  for (std::size_t p = 0; p < table.panels.size(); ++p) {
    const FilmPanel& panel = table.panels[p];
    const double low = std::log(panel.M_low);
    text += fmt::format("  {{{}, {}, {}, {}, {}, {{PREFIX_c{}_0, PREFIX_c{}_1, PREFIX_c{}_2, PREFIX_c{}_3}}}},\n",
                        exact_number(panel.M_high), exact_number(low), exact_number(std::log(panel.M_high) - low),
                        panel.degree_M, panel.degree_L, p, p, p, p);
  }
  return text + "};\n";
}

}  // namespace

std::string film_table_c_prefix(const FilmTable& table) { return "ehd_" + identifier(table.case_id); }

std::string film_table_c(const FilmTable& table) {
  int highest = 1;
  std::vector<double> shifts, errors;
  for (const FilmPanel& panel : table.panels) highest = std::max({highest, panel.degree_M, panel.degree_L});
  for (std::size_t k = 0; k < table_film_count; ++k) {
    shifts.push_back(table_shift(table_films[k]));
    errors.push_back(table.errors[k].stated);
  }
  const FilmRange& range = table.range;
  const double log_low = std::log1p(range.L_low);
  // Words of the user keep their letters.
  std::string words = "/* Films of a lubricated line contact. C99; needs math.h alone. Schema ehd-films-1.\n *\n";
  for (const std::string& line : film_table_words(table)) words += " * " + in_c_comment(line) + "\n";
  std::string text = how_to_use;
  text += fmt::format("#include <math.h>\n\nenum {{ PREFIX_SIZE = {}, PREFIX_PANELS = {} }};\n\n", highest + 1,
                      table.panels.size());
  text += fmt::format("extern const double PREFIX_error[4];\nconst double PREFIX_error[4] = {};\n", braced(errors));
  text += fmt::format("static const double PREFIX_range[4] = {}; /* of M, of L */\n",
                      braced({range.M_low, range.M_high, range.L_low, range.L_high}));
  text +=
      fmt::format("static const double PREFIX_log_L[2] = {};\n", braced({log_low, std::log1p(range.L_high) - log_low}));
  text += fmt::format("static const double PREFIX_shift[4] = {};\n\n", braced(shifts));
  text += fmt::format("{}\n{}{}", coefficient_arrays(table), panels(table), evaluator);
  return words + with_prefix(std::move(text), film_table_c_prefix(table));
}

}  // namespace ehd
