// SPDX-License-Identifier: GPL-3.0-or-later
// The report as one HTML page: its blocks, style and script. Everything that comes from a file passes through escaped()
// or literal().
#pragma once

#include <set>
#include <string>
#include <vector>

#include "verification/report/document.hpp"
#include "verification/report/heat_map.hpp"
#include "verification/report/plot.hpp"
#include "verification/report/polar_plot.hpp"

namespace ehd::report {

/// A cell of a table: HTML, ready.
struct TableCell {
  std::string html;
  std::string css = {};  ///< class: "number", "pass", "fail", ...
};
[[nodiscard]] TableCell words(std::string_view text);  ///< escaped
[[nodiscard]] TableCell number_cell(const std::optional<double>& value, int digits = 4);
[[nodiscard]] TableCell integer_cell(const std::optional<double>& value);
[[nodiscard]] TableCell verdict_cell(const std::string& verdict);

/// From SI to the units of the page: um, mm, kN.
inline constexpr double micro = 1e6, milli = 1e3, kilo = 1e-3;
/// Values in another unit.
[[nodiscard]] std::vector<double> scaled(std::vector<double> values, double factor);
[[nodiscard]] std::optional<double> scaled(std::optional<double> value, double factor);

struct Table {
  std::string caption = {};               ///< HTML
  std::vector<std::string> columns = {};  ///< HTML
  std::vector<std::vector<TableCell>> rows = {};
  std::string css = {};
  bool first_is_heading = true;  ///< the first cell of a row heads it
};
[[nodiscard]] std::string html(const Table& table);

/// Collects the page. Every section and figure gets an id of its own.
class Page {
 public:
  void section(const std::string& id, const std::string& title);
  void heading(const std::string& title);  ///< HTML, below a section
  void paragraph(const std::string& html, const std::string& css = "");
  void add(const std::string& html) { body_ += html; }
  void add(const Table& table) { body_ += html(table); }
  void add_folded(const std::string& summary, const Table& table);  ///< shown where the reader opens it
  /// A line that names an absent part and the command that makes it.
  void absent(const std::string& what, const std::string& command);

  /// Figures between begin_figures and end_figures stand side by side where there is room.
  void begin_figures(const std::string& css = "");
  void end_figures();
  void figure(Figure figure, const std::string& caption_html);
  void figure(HeatMap map, const std::string& caption_html);
  void figure(PolarPlot plot, const std::string& caption_html);

  [[nodiscard]] std::string document(const std::string& title) const;

 private:
  [[nodiscard]] std::string unique(const std::string& wanted);
  void put_figure(const std::string& svg, const std::string& caption_html, const std::string& css);
  std::string body_, navigation_;
  std::set<std::string> ids_;
  bool open_ = false;
};

/// Letters, digits and hyphens of a name, for an id.
[[nodiscard]] std::string slug(std::string_view name);

[[nodiscard]] const char* page_style();  ///< without the pictures' rules
[[nodiscard]] const char* page_script();

}  // namespace ehd::report
