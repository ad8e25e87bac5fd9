// SPDX-License-Identifier: GPL-3.0-or-later
// Convergence: error over intervals, degree or unknowns, with declared and fitted orders.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

struct Study {
  std::string title, solver, where, abscissa;
  bool geometric = false;
  std::vector<View> entries;
};

std::vector<Study> studies_of(const std::vector<View>& entries) {
  std::vector<Study> studies;
  for (const View& entry : entries) {
    Study study{.title = entry.text("title"),
                .solver = entry.text("solver"),
                .where = entry.text("case"),
                .abscissa = entry.text("abscissa"),
                .geometric = entry.text("kind") == "geometric",
                .entries = {entry}};
    bool known = false;
    for (Study& other : studies) {
      if (other.solver != study.solver || other.where != study.where || other.abscissa != study.abscissa ||
          other.geometric != study.geometric)
        continue;
      constexpr std::size_t most = 4;  // curves in a panel
      if (other.entries.size() >= most) continue;
      other.entries.push_back(entry);
      known = true;
      break;
    }
    if (!known) studies.push_back(std::move(study));
  }
  return studies;
}

/// A triangle at the middle of the first curve, below all curves.
std::optional<SlopeTriangle> triangle_below(const std::vector<Series>& curves, double order) {
  const auto& x = curves.front().x;
  if (x.size() < 2) return std::nullopt;
  const std::size_t k = (x.size() - 1) / 2;
  const double factor = x[k + 1] / x[k];
  if (!(factor > 1)) return std::nullopt;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Series& curve : curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      // The long side falls with the order from (x_k, y). Each curve point near the triangle bounds y from above.
      if (curve.x[i] < x[k] / factor || curve.x[i] > x[k + 1] * factor || !(curve.y[i] > 0)) continue;
      lowest = std::min(lowest, curve.y[i] * std::pow(std::clamp(curve.x[i] / x[k], 1.0, factor), order));
    }
  }
  constexpr double clear_of = 0.35;
  return std::isfinite(lowest) ? std::optional(SlopeTriangle{x[k], clear_of * lowest, factor, order}) : std::nullopt;
}

std::string abscissa_label(const std::string& abscissa) {
  if (abscissa == "degree") return "polynomial degree *p*";
  if (abscissa == "unknowns") return "unknowns *N*";
  if (abscissa == "intervals") return "intervals *n*";
  return literal(abscissa);
}

/// The quantity. Where a figure has the extrapolated film and that of each grid, it says which is which.
std::string curve_name(const View& entry, const Study& study) {
  const std::string quantity = entry.text("quantity");
  if (quantity.empty()) return entry.text("title");
  if (entry.text("id").ends_with("/own")) return quantity + ", each grid";
  const bool own_too = std::any_of(study.entries.begin(), study.entries.end(), [&](const View& other) {
    return other.text("quantity") == quantity && other.text("id").ends_with("/own");
  });
  return own_too ? quantity + ", extrapolated" : quantity;
}

/// Unknowns (or degrees) for one more digit, by least squares over the filled marks; at least four, as for an order.
std::optional<double> unknowns_a_digit(const Series& curve) {
  constexpr double least = 4;
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.hollow_at[i] || !(curve.y[i] > 0)) continue;
    const double digits = -std::log10(curve.y[i]);
    count += 1;
    x += curve.x[i];
    y += digits;
    xx += curve.x[i] * curve.x[i];
    xy += curve.x[i] * digits;
  }
  const double slope = (count * xy - x * y) / (count * xx - x * x);
  return count >= least && std::isfinite(slope) && slope > 0 ? std::optional(1 / slope) : std::nullopt;
}

/// Error over n. Hollow points: the solve did not converge, or the error is below three uncertainties of the truth.
Series curve_of(const View& entry, const Study& study, std::size_t number) {
  const Look look = look_of_curve(number);
  Series series{.line = look.line, .marker = look.marker, .colour = look.colour};
  for (const View& point : entry.list("points")) {
    const auto n = point.number("n"), error = point.number("error");
    if (!n || !error) continue;
    series.x.push_back(*n);
    series.y.push_back(*error);
    constexpr double clearly = 3;
    const std::string status = point.text("status");
    series.hollow_at.push_back(!(*error > clearly * point.number("uncertainty").value_or(0)) ||
                               !(status.empty() || status == "converged"));
  }
  series.name = literal(curve_name(entry, study));
  if (study.geometric) {
    const auto rate = unknowns_a_digit(series);
    series.name += rate ? ": a digit every " + number_markup(*rate, 2) : "";
    if (rate && study.abscissa == "degree") series.name += " in *p*";
    if (!rate) series.line = Line::none;  // marks without a line: nothing is claimed between them
  } else if (const auto fitted = entry.number("fitted_order")) {
    series.name += ": fitted " + number_markup(*fitted, 3);
  }
  return series;
}

std::vector<TableCell> orders_row(const Study& study, const View& entry, const Series& curve) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double error : curve.y)
    if (error > 0) smallest = std::min(smallest, error);
  const auto order = [&](const char* key, int digits) {
    return study.geometric ? words("") : number_cell(entry.number(key), digits);
  };
  return {{escaped(entry.text("title").empty() ? entry.text("id") : entry.text("title")), ""},
          words(study.solver),
          words(study.where),
          words(entry.text("quantity")),
          words(curve.line == Line::none ? "no rate" : entry.text("kind")),
          order("declared_order", 3),
          order("fitted_order", 4),
          integer_cell(static_cast<double>(entry.list("points").size())),
          number_cell(smallest, 2)};
}

/// Two marks show no curve.
bool shows_a_curve(const Study& study) {
  constexpr std::size_t fewest_points = 3;
  return std::any_of(study.entries.begin(), study.entries.end(),
                     [](const View& entry) { return entry.list("points").size() >= fewest_points; });
}

void add_study(Page& page, const Study& study, Table& table) {
  const View& first = study.entries.front();
  std::string where = study.solver;
  if (!study.where.empty()) where += (where.empty() ? "" : ", ") + study.where;
  const bool manufactured = first.text("id").starts_with("manufactured");
  Figure figure{.id = fmt::format("fig-convergence-{}-{}-{}", study.solver, study.where, study.abscissa),
                .title = "Convergence: " + where,
                .description = (manufactured ? "Absolute error over " : "Relative error over ") + study.abscissa +
                               ", with declared and fitted orders."};
  Panel panel;
  panel.title = literal(where);
  panel.x = {.label = abscissa_label(study.abscissa), .scale = study.geometric ? Scale::linear : Scale::logarithmic};
  panel.y = {.label = manufactured ? "error [Hertz units]" : "relative error", .scale = Scale::logarithmic};
  std::string declared;
  for (const View& entry : study.entries) {
    panel.series.push_back(curve_of(entry, study, panel.series.size()));
    table.rows.push_back(orders_row(study, entry, panel.series.back()));
    if (const auto order = entry.number("declared_order"); order && !study.geometric)
      declared +=
          fmt::format("{}{} for {}", declared.empty() ? "" : ", ", plain(*order, 3), escaped(curve_name(entry, study)));
  }
  const auto declares = std::find_if(study.entries.begin(), study.entries.end(),
                                     [](const View& one) { return one.number("declared_order").value_or(0) > 0; });
  if (!study.geometric && declares != study.entries.end()) {
    const auto order = declares->number("declared_order");
    if (const auto triangle = triangle_below(panel.series, *order)) panel.triangles.push_back(*triangle);
  }
  figure.panels.push_back(std::move(panel));
  const std::string order = study.geometric    ? "errors fall geometrically, without an order"
                            : declared.empty() ? "no order is declared"
                                               : "declared order: " + declared;
  if (shows_a_curve(study))
    page.figure(std::move(figure),
                fmt::format("<b>{}</b>: {} over {}; {}.", escaped(where),
                            manufactured ? "absolute error" : "relative error", escaped(study.abscissa), order));
}

}  // namespace

void add_convergence(Page& page, const View& results) {
  page.section("convergence", "Convergence");
  const auto entries = results["figures"].list("convergence");
  if (entries.empty()) {
    page.absent("Convergence studies are", "ehd verify --output DIR");
    return;
  }
  page.paragraph(
      "Errors against a more accurate solution, over the size of the grid. They are relative; against a manufactured "
      "solution they are absolute, in Hertz units. A triangle shows the order that the scheme declares, and the legend "
      "the order that is fitted to the last four points. Where errors fall geometrically, the legend says how many "
      "unknowns add a digit. Both need four filled marks; with fewer, such marks are not joined. No order is declared "
      "of <i>H</i><sub>min</sub> beside a pressure spike, nor of extrapolated films. A mark is filled if "
      "the "
      "solve converged and its error is above rounding and above the uncertainty of the truth, else hollow. A study of "
      "fewer than three grids stands in the table alone.");
  Table table;
  table.caption = "Orders, declared and fitted";
  table.columns = {"study", "solver", "case", "quantity", "kind", "declared", "fitted", "points", "smallest error"};
  const auto studies = studies_of(entries);
  const auto figures = std::count_if(studies.begin(), studies.end(), shows_a_curve);
  page.begin_fold(fmt::format("{} figures: errors over the size of the grid", figures), "convergence-figures");
  page.begin_figures();
  for (const Study& study : studies) add_study(page, study, table);
  page.end_figures();
  page.end_fold();
  page.add_folded(fmt::format("Orders as a table: {} curves", table.rows.size()), table);
}

}  // namespace ehd::report
