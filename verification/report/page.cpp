// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "contact/text.hpp"

namespace ehd::report {

TableCell words(std::string_view text) {
  constexpr std::size_t short_name = 28;  // not broken at its hyphens
  const bool name = text.size() <= short_name && text.find(' ') == std::string_view::npos;
  return {escaped(text), name ? "name" : ""};
}

TableCell number_cell(const std::optional<double>& value, int digits) {
  if (!value || !std::isfinite(*value)) return {"", "number"};
  return {markup_to_html(number_markup(*value, digits)), "number"};
}

TableCell integer_cell(const std::optional<double>& value) {
  constexpr int all_digits = 15;
  return number_cell(value, all_digits);
}

TableCell percent_cell(const std::optional<double>& share) {
  constexpr int digits = 3;
  TableCell cell = number_cell(scaled(share, 100), digits);
  if (!cell.html.empty()) cell.html += "\u2009%";
  return cell;
}

std::string milliseconds_in_full(double seconds, int digits) {
  const double value = 1e3 * seconds;
  return value < std::pow(10, digits) ? plain(value, digits) : fixed(value, 0);
}

TableCell milliseconds_cell(const std::optional<double>& seconds) {
  return {seconds && std::isfinite(*seconds) ? milliseconds_in_full(*seconds) : "", "number"};
}

TableCell verdict_cell(const std::string& verdict) { return {escaped(verdict), slug(verdict)}; }

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

std::optional<double> scaled(std::optional<double> value, double factor) {
  if (value) *value *= factor;
  return value;
}

namespace {

/// The words of a piece of HTML; a line break is a space.
std::string without_tags(const std::string& html) {
  std::string text;
  bool inside = false;
  for (std::size_t at = 0; at < html.size(); ++at) {
    if (html[at] == '<') inside = true;
    if (!inside) text += html[at];
    if (html[at] == '>') inside = false;
    if (html.compare(at, 4, "<br>") == 0) text += ' ';
  }
  return text;
}

/// One cell; `column` is its head, which a folded row repeats before it.
std::string cell_html(const TableCell& cell, bool heads, const std::string& column) {
  const char* const tag = heads ? "th" : "td";
  return fmt::format("<{}{}{}{}>{}</{}>", tag, heads ? " scope=\"row\"" : "",
                     heads || column.empty() ? "" : fmt::format(" data-column=\"{}\"", without_tags(column)),
                     cell.css.empty() ? "" : fmt::format(" class=\"{}\"", escaped(cell.css)), cell.html, tag);
}

/// Characters of the longest piece of a text that no line break parts; an entity counts as one.
std::size_t longest_piece(const std::string& html, bool breaks_at_spaces) {
  std::size_t longest = 0, length = 0;
  bool inside_entity = false;
  for (const char c : without_tags(html)) {
    if (c == ' ' && breaks_at_spaces) length = 0;
    const bool continues = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // of a character of several bytes
    if (!inside_entity && !continues) ++length;
    inside_entity = c == '&' || (inside_entity && c != ';');
    longest = std::max(longest, length);
  }
  return longest;
}

/// Whether a table is wider than a phone's screen, where its columns are as narrow as words and numbers allow.
bool is_wide(const Table& table) {
  constexpr std::size_t phone = 46, gap = 2;  // characters: of 390 pixels, and between two columns
  std::size_t width = 0;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t column = longest_piece(table.columns[i], true);
    for (const auto& row : table.rows)
      if (i < row.size()) {
        const bool whole = row[i].css.starts_with("number") || row[i].css == "name";
        column = std::max(column, row[i].css == "wide" ? phone : longest_piece(row[i].html, !whole));
      }
    width += column + gap;
  }
  return width > phone;
}

}  // namespace

std::string html(const Table& table) {
  const bool folds = is_wide(table);
  const std::string css = table.css + (folds ? (table.css.empty() ? "folds" : " folds") : "");
  std::string text = fmt::format("<div class=\"scroll\" tabindex=\"0\"><table{}>",
                                 css.empty() ? "" : fmt::format(" class=\"{}\"", css));
  if (!table.caption.empty()) text += "<caption>" + table.caption + "</caption>";
  text += "<thead><tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool number =
        !table.rows.empty() && i < table.rows.front().size() && table.rows.front()[i].css.starts_with("number");
    text += fmt::format("<th scope=\"col\"{}>{}</th>", number ? " class=\"number\"" : "", table.columns[i]);
  }
  text += "</tr></thead><tbody>\n";
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    const bool named = k < table.ids.size() && !table.ids[k].empty();
    text += named ? "<tr id=\"" + escaped(table.ids[k]) + "\">" : "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      text += cell_html(row[i], i == 0 && table.first_is_heading,
                        folds && i < table.columns.size() ? table.columns[i] : "");
    text += "</tr>\n";
    if (k < table.below.size())
      text += fmt::format("<tr class=\"below\"><td colspan=\"{}\">{}</td></tr>\n", row.size(), table.below[k]);
  }
  return text + "</tbody></table></div>\n";
}

std::string slug(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && std::isalnum(byte)) {
      result += static_cast<char>(std::tolower(byte));
    } else if (!result.empty() && result.back() != '-') {
      result += '-';
    }
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result.empty() ? "x" : result;
}

namespace {

/// A picture with its caption, and a link to itself.
std::string framed(const std::string& id, const std::string& svg, const std::string& caption_html, const char* css) {
  return fmt::format(
      "<figure class=\"{}\"><div class=\"picture\">{}</div><figcaption>{} <a class=\"anchor\" "
      "href=\"#{}\">link</a></figcaption></figure>\n",
      css, svg, caption_html, id);
}

}  // namespace

std::string Page::unique(const std::string& wanted) {
  const std::string base = slug(wanted);
  std::string id = base;
  for (int k = 2; !ids_.insert(id).second; ++k) id = fmt::format("{}-{}", base, k);
  return id;
}

void Page::section(const std::string& id, const std::string& title, const std::string& in_index) {
  if (open_) body_ += "</section>\n";
  open_ = true;
  const std::string own = unique(id);
  navigation_ += fmt::format("<a href=\"#{}\">{}</a>\n", own, in_index.empty() ? title : in_index);
  body_ += fmt::format("<section id=\"{}\"><h2>{}</h2>\n", own, title);
}

void Page::heading(const std::string& title) {
  body_ += fmt::format("<h3 id=\"{}\">{}</h3>\n", unique(without_tags(title)), title);
}

void Page::paragraph(const std::string& html, const std::string& css) {
  body_ += (css.empty() ? "<p>" : "<p class=\"" + css + "\">") + html + "</p>\n";
}

void Page::begin_fold(const std::string& summary, const std::string& id) {
  body_ +=
      (id.empty() ? "<details>" : "<details id=\"" + unique(id) + "\">") + ("<summary>" + summary + "</summary>\n");
}

void Page::add_folded(const std::string& summary, const Table& table) {
  begin_fold(summary);
  add(table);
  end_fold();
}

void Page::absent(const std::string& what, const std::string& command) {
  paragraph(fmt::format("{} not in this folder: <code>{}</code> makes it.", escaped(what), escaped(command)), "absent");
}

Opener Page::opener(const std::string& id, const std::string& link, const std::string& summary,
                    const std::string& content) {
  const std::string own = unique(id);
  return {.link = fmt::format("<a class=\"opens\" href=\"#{}\">{}</a>", own, link),
          .fold = fmt::format("<details id=\"{}\"><summary>{}</summary>{}</details>", own, summary, content)};
}

void Page::begin_figures(const std::string& css) { body_ += "<div class=\"figures " + css + "\">\n"; }
void Page::end_figures() { body_ += "</div>\n"; }

std::string Page::figure_html(Figure figure, const std::string& caption_html) {
  figure.id = unique(figure.id);
  return framed(figure.id, draw(figure, Place::page), caption_html, "curves");
}

void Page::figure(Figure figure, const std::string& caption_html) {
  body_ += figure_html(std::move(figure), caption_html);
}

void Page::figure(HeatMap map, const std::string& caption_html) {
  map.id = unique(map.id);
  body_ += framed(map.id, draw(map, Place::page), caption_html, "map");
}

void Page::figure(PolarPlot plot, const std::string& caption_html) {
  plot.id = unique(plot.id);
  body_ += framed(plot.id, draw(plot, Place::page), caption_html, "polar");
}

namespace {

/// The end of the element that begins at `at`, if its text is no text of the page: a picture or a script. Else the end
/// of the tag.
std::size_t end_of_tag(const std::string& html, std::size_t at) {
  for (const std::string_view name : {"svg", "script", "style"}) {
    if (html.compare(at + 1, name.size(), name) != 0) continue;
    const std::string end = fmt::format("</{}>", name);
    const std::size_t found = html.find(end, at);
    return found == std::string::npos ? html.size() : found + end.size();
  }
  const std::size_t found = html.find('>', at);
  return found == std::string::npos ? html.size() : found + 1;
}

bool is_in(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

/// A browser breaks a line behind a hyphen. Numbers such as 1e-5 and 8.6(4)e-3 are kept whole.
std::string with_whole_numbers(const std::string& html) {
  constexpr std::string_view digits = "0123456789", of_mantissa = "0123456789.()";
  std::string text;
  for (std::size_t at = 0; at < html.size();) {
    if (html[at] == '<') {
      const std::size_t end = end_of_tag(html, at);
      text.append(html, at, end - at);
      at = end;
      continue;
    }
    std::size_t end = at;
    while (end < html.size() && is_in(html[end], of_mantissa)) ++end;
    const bool number = end > at && is_in(html[at], digits) && html.compare(end, 2, "e-") == 0 &&
                        end + 2 < html.size() && is_in(html[end + 2], digits);
    if (number) {
      end = std::min(html.find_first_not_of(digits, end + 2), html.size());
      text += "<span class=\"whole\">" + html.substr(at, end - at) + "</span>";
    } else {
      end = std::max(end, at + 1);
      text.append(html, at, end - at);
    }
    at = end;
  }
  return text;
}

}  // namespace

std::string Page::document(const std::string& title) const {
  // A page that asks for an icon would look for one on the network. The style of pictures stands apart, since the
  // script puts it into pictures that are saved, with the colours of `data-colours`.
  constexpr const char* whole = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>
:root{{{light}}}
@media screen and (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{dark}}}}}
@media screen{{:root[data-theme=dark]{{{dark}}}}}
{page_style}</style>
<style id="picture-style" data-colours="{light}">{picture_style}</style></head>
<body>
<a class="skip" href="#content">To the content</a>
<nav aria-label="Sections">
{navigation}</nav>
<div class="page"><header><h1>{title}</h1></header>
<main id="content">
{body}{end}</main></div>
<script>
{figure_script}{page_script}</script>
</body></html>
)";
  return fmt::format(whole, fmt::arg("title", escaped(title)), fmt::arg("light", light_colours()),
                     fmt::arg("dark", dark_colours()), fmt::arg("page_style", page_style()),
                     fmt::arg("picture_style", picture_style()), fmt::arg("navigation", navigation_),
                     fmt::arg("body", with_whole_numbers(body_)), fmt::arg("end", open_ ? "</section>\n" : ""),
                     fmt::arg("figure_script", figure_script()), fmt::arg("page_script", page_script()));
}

}  // namespace ehd::report
