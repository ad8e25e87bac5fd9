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
 * PREFIX_error[film]: the stated error. A line above has the errors next to a bend, where there is one.
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

static double PREFIX_edge(int degree, const double *c, const double *y, const double *y_slope, double *slope)
{
  double sum = 0.0;
  int j;
  *slope = 0.0;
  for (j = 0; j <= degree; ++j) {
    sum += c[j] * y[j];
    *slope += c[j] * y_slope[j];
  }
  return sum;
}

int PREFIX_film(int film, double M, double L, double *value, double *by_M, double *by_L);

int PREFIX_film(int film, double M, double L, double *value, double *by_M, double *by_L)
{
  double x[PREFIX_SIZE], x_slope[PREFIX_SIZE], y[PREFIX_SIZE], y_slope[PREFIX_SIZE];
  double sum = 0.0, sum_by_x = 0.0, sum_by_y = 0.0, h;
  double log_M, low = 0.0, high = 0.0, low_slope = 0.0, high_slope = 0.0, s, root, x_at, x_by_s = 2.0, x_by_y, y_by_L;
  const double *c;
  int p, i, j;
  if (film < 0 || film > 3) return 2;
  if (!(M >= PREFIX_range[0] && M <= PREFIX_range[1] && L >= PREFIX_range[2] && L <= PREFIX_range[3])) return 1;
  log_M = log(M);
  for (p = 0; p < PREFIX_PANELS; ++p) {
    if (p + 1 < PREFIX_PANELS && !(L >= PREFIX_panel[p].L_low && L <= PREFIX_panel[p].L_high)) continue;
    PREFIX_basis(PREFIX_panel[p].degree_y, 2.0 * (log1p(L) - PREFIX_panel[p].log_L) / PREFIX_panel[p].along - 1.0, y,
                 y_slope);
    high = PREFIX_edge(PREFIX_panel[p].degree_high, PREFIX_panel[p].high, y, y_slope, &high_slope);
    if (log_M <= high || p + 1 == PREFIX_PANELS) break;
  }
  low = PREFIX_edge(PREFIX_panel[p].degree_low, PREFIX_panel[p].low, y, y_slope, &low_slope);
  s = (log_M - low) / (high - low);
  x_at = 2.0 * s - 1.0;
  if (PREFIX_panel[p].map != 0) { /* a square root at the low edge (1) or the high one (2) */
    root = sqrt(fmax(0.0, PREFIX_panel[p].map == 2 ? 1.0 - s : s));
    x_at = PREFIX_panel[p].map == 2 ? 1.0 - 2.0 * root : 2.0 * root - 1.0;
    x_by_s = 1.0 / fmax(root, PREFIX_LEAST_ROOT);
  }
  x_by_y = -x_by_s * (low_slope + s * (high_slope - low_slope)) / (high - low);
  y_by_L = 2.0 / (PREFIX_panel[p].along * (1.0 + L));
  PREFIX_basis(PREFIX_panel[p].degree_M, x_at, x, x_slope);
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
  if (by_M) *by_M = h * sum_by_x * x_by_s / ((high - low) * M);
  if (by_L) *by_L = h * (sum_by_x * x_by_y + sum_by_y) * y_by_L;
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

std::string array_text(const std::string& name, const std::vector<double>& values) {
  return fmt::format("static const double {}[{}] = {};\n", name, values.size(), braced(values));
}

/// The highest degree in y: of the films and of the edges.
int degree_y(const FilmPanel& panel) {
  return std::max(panel.degree_L, static_cast<int>(std::max(panel.shape.low.size(), panel.shape.high.size())) - 1);
}

std::string panels(const FilmTable& table) {
  std::string edges,
      text =
          "static const struct {\n  double L_low, L_high, log_L, along;\n  int map, degree_M, degree_L, degree_y;\n"
          "  int degree_low, degree_high;\n  const double *low, *high;\n"
          "  const double *coefficients[4];\n} PREFIX_panel[PREFIX_PANELS] = {\n";
  for (std::size_t p = 0; p < table.panels.size(); ++p) {
    const FilmPanel& panel = table.panels[p];
    const PanelShape& shape = panel.shape;
    edges += array_text(fmt::format("PREFIX_low{}", p), shape.low);
    edges += array_text(fmt::format("PREFIX_high{}", p), shape.high);
    const double log_L = std::log1p(shape.L_low);
    text += fmt::format("  {{{}, {}, {}, {},\n   {}, {}, {}, {}, {}, {}, ", exact_number(shape.L_low),
                        exact_number(shape.L_high), exact_number(log_L), exact_number(std::log1p(shape.L_high) - log_L),
                        static_cast<int>(shape.map), panel.degree_M, panel.degree_L, degree_y(panel),
                        shape.low.size() - 1, shape.high.size() - 1);
    text += fmt::format(
        "PREFIX_low{0}, PREFIX_high{0},\n   {{PREFIX_c{0}_0, PREFIX_c{0}_1, PREFIX_c{0}_2, PREFIX_c{0}_3}}}},\n", p);
  }
  return edges + text + "};\n";
}

}  // namespace

std::string film_table_c_prefix(const FilmTable& table) { return "ehd_" + identifier(table.case_id); }

std::string film_table_c(const FilmTable& table) {
  int highest = 1;
  std::vector<double> shifts, errors;
  for (const FilmPanel& panel : table.panels) highest = std::max({highest, panel.degree_M, degree_y(panel)});
  for (std::size_t k = 0; k < table_film_count; ++k) {
    shifts.push_back(table_shift(table_films[k]));
    errors.push_back(table.errors[k].stated);
  }
  const FilmRange& range = table.range;
  // Words of the user keep their letters.
  std::string words = fmt::format("/* Films of a lubricated line contact. C99; needs math.h alone. Schema {}.\n *\n",
                                  film_table_schema);
  for (const std::string& line : film_table_words(table)) words += " * " + in_c_comment(line) + "\n";
  std::string text = how_to_use;
  text += fmt::format("#include <math.h>\n\nenum {{ PREFIX_SIZE = {}, PREFIX_PANELS = {} }};\n", highest + 1,
                      table.panels.size());
  text += fmt::format("#define PREFIX_LEAST_ROOT {}\n\n", exact_number(least_root));
  text += fmt::format("extern const double PREFIX_error[4];\nconst double PREFIX_error[4] = {};\n", braced(errors));
  text += fmt::format("static const double PREFIX_range[4] = {}; /* of M, of L */\n",
                      braced({range.M_low, range.M_high, range.L_low, range.L_high}));
  text += fmt::format("static const double PREFIX_shift[4] = {};\n\n", braced(shifts));
  text += fmt::format("{}\n{}{}", coefficient_arrays(table), panels(table), evaluator);
  return words + with_prefix(std::move(text), film_table_c_prefix(table));
}

}  // namespace ehd
