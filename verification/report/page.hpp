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
[[nodiscard]] TableCell percent_cell(const std::optional<double>& share);  ///< "12.5 %"
/// From seconds, without a power of ten: "0.31", "12.5", "1910".
[[nodiscard]] std::string milliseconds_in_full(double seconds, int digits = 3);
[[nodiscard]] TableCell milliseconds_cell(const std::optional<double>& seconds);
[[nodiscard]] TableCell verdict_cell(const std::string& verdict);

/// From SI to the units of the page: um, mm, kN.
inline constexpr double micro = 1e6, milli = 1e3, kilo = 1e-3;
/// Values in another unit.
[[nodiscard]] std::vector<double> scaled(std::vector<double> values, double factor);
[[nodiscard]] std::optional<double> scaled(std::optional<double> value, double factor);

/// On a phone, a table that would not fit is folded: a row is a paragraph, each cell behind the head of its column.
struct Table {
  std::string caption = {};               ///< HTML
  std::vector<std::string> columns = {};  ///< HTML
  std::vector<std::vector<TableCell>> rows = {};
  std::vector<std::string> ids = {};    ///< of rows, for links to them; "": none
  std::vector<std::string> below = {};  ///< HTML below each row, across all columns
  std::string css = {};
  bool first_is_heading = true;  ///< the first cell of a row heads it
};
[[nodiscard]] std::string html(const Table& table);

/// A cell that opens a row below: for Table::rows and Table::below.
struct Opener {
  std::string link, fold;  ///< HTML
};

/// Collects the page. Every section, heading and figure gets an id of its own.
class Page {
 public:
  /// `in_index`: its name in the index, where the title is long.
  void section(const std::string& id, const std::string& title, const std::string& in_index = "");
  void heading(const std::string& title);  ///< HTML, below a section; its id is its text
  void paragraph(const std::string& html, const std::string& css = "");
  void add(const std::string& html) { body_ += html; }
  void add(const Table& table) { body_ += html(table); }
  /// What follows is closed until the reader opens it, up to end_fold. `summary`: HTML; `id`: of the fold, for links.
  void begin_fold(const std::string& summary, const std::string& id = "");
  void end_fold() { body_ += "</details>\n"; }
  void add_folded(const std::string& summary, const Table& table);
  /// `content` is closed until the reader follows the link; all texts are HTML.
  [[nodiscard]] Opener opener(const std::string& id, const std::string& link, const std::string& summary,
                              const std::string& content);
  /// A line that names an absent part and the command that makes it.
  void absent(const std::string& what, const std::string& command);

  /// Figures between begin_figures and end_figures stand side by side where there is room.
  void begin_figures(const std::string& css = "");
  void end_figures();
  void figure(Figure figure, const std::string& caption_html);
  void figure(HeatMap map, const std::string& caption_html);
  void figure(PolarPlot plot, const std::string& caption_html);
  /// The same as HTML, for another place than the end of the page.
  [[nodiscard]] std::string figure_html(Figure figure, const std::string& caption_html);

  /// An id that nothing else on the page has: the wanted one, or the wanted one with a number.
  [[nodiscard]] std::string unique(const std::string& wanted);

  [[nodiscard]] std::string document(const std::string& title) const;

 private:
  std::string body_, navigation_;
  std::set<std::string> ids_;
  bool open_ = false;
};

/// Letters, digits and hyphens of a name, for an id.
[[nodiscard]] std::string slug(std::string_view name);

[[nodiscard]] const char* page_style();     ///< without the pictures' rules
[[nodiscard]] const char* page_script();    ///< theme, index, legend, read-out, filters, print
[[nodiscard]] std::string figure_script();  ///< zoom of figures, and their data and pictures as files

}  // namespace ehd::report
