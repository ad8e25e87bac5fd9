// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/svg.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "contact/text.hpp"

namespace ehd::report {

namespace {

/// A part of a label with one style.
struct Run {
  std::string text;
  bool italic = false;
  int level = 0;  ///< -1 below the line, 1 above
};

std::vector<Run> runs_of(std::string_view markup) {
  std::vector<Run> runs(1);
  bool italic = false;
  int level = 0;
  const auto next = [&] { runs.push_back({"", italic, level}); };
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    if (c == '\\' && i + 1 < markup.size()) {
      runs.back().text += markup[++i];
    } else if (c == '*') {
      italic = !italic;
      next();
    } else if ((c == '_' || c == '^') && i + 1 < markup.size() && markup[i + 1] == '{' && level == 0) {
      level = c == '_' ? -1 : 1;
      next();
      ++i;
    } else if (c == '}' && level != 0) {
      level = 0;
      next();
    } else {
      runs.back().text += c;
    }
  }
  std::erase_if(runs, [](const Run& run) { return run.text.empty(); });
  return runs;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// The name and the value of each custom property in "--a: b; --c: d;".
std::vector<std::pair<std::string, std::string>> variables(const std::string& declarations) {
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t at = 0; (at = declarations.find("--", at)) != std::string::npos;) {
    const std::size_t colon = declarations.find(':', at), end = declarations.find(';', at);
    if (colon == std::string::npos || end == std::string::npos) break;
    const std::size_t value = declarations.find_first_not_of(' ', colon + 1);
    found.emplace_back(declarations.substr(at, colon - at), declarations.substr(value, end - value));
    at = end;
  }
  return found;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      result += "\uFFFD";
      text.remove_prefix(1);
      continue;
    }
    const char c = text.front();
    if (length > 1) {
      result += text.substr(0, length);
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (c == '\'') {
      result += "&#39;";
    } else if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f) {
      result += ' ';
    } else {
      result += c;
    }
    text.remove_prefix(length);
  }
  return result;
}

std::string pixels(double value) {
  if (!std::isfinite(value)) throw std::logic_error("a coordinate of a picture is not finite");
  std::string result = fixed(value, 2);
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string with_minus_sign(const std::string& number) { return replaced(number, "-", "\u2212"); }

std::string number_markup(double value, int digits) {
  if (!std::isfinite(value)) return "?";
  constexpr double with_power = 1e-3;  // below: errors of one table look alike, 10^{-4} and 10^{-5}
  const bool small = value != 0 && std::abs(value) < with_power;
  std::string text = small ? scientific(value, digits - 1) : plain(value, digits);
  std::string power;
  if (const auto e = text.find('e'); e != std::string::npos) {
    power = std::to_string(std::atoi(text.c_str() + e + 1));
    text.erase(e);
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of(".0") + 1);
  }
  text = with_minus_sign(text);
  if (power.empty()) return text;
  power = "10^{" + with_minus_sign(power) + "}";
  return text == "1" ? power : text + "\u2009\u00b7\u2009" + power;
}

std::string literal(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '^' || c == '\\' || c == '}') result += '\\';
    result += c;
  }
  return result;
}

std::string markup_to_svg(std::string_view markup) {
  std::string result;
  int level = 0;
  for (const Run& run : runs_of(markup)) {
    std::string attributes, text = run.text;
    // dy, because not every program draws baseline-shift. It moves the following text too.
    if (run.level != level) {
      constexpr double shift_em[] = {0.22, 0, -0.36};  // below, on, above the line
      constexpr double small = 0.75;                   // dy counts in the run's own size
      const double dy = shift_em[run.level + 1] - shift_em[level + 1];
      attributes += " dy=\"" + pixels(dy / (run.level == 0 ? 1 : small)) + "em\"";
      if (text.size() > 1 && text.front() == ' ') {  // librsvg drops a blank that begins such a run
        result += ' ';
        text.erase(0, 1);
      }
    }
    if (run.level != 0) attributes += " font-size=\"75%\"";
    if (run.italic) attributes += " font-style=\"italic\"";
    result += attributes.empty() ? escaped(text) : fmt::format("<tspan{}>{}</tspan>", attributes, escaped(text));
    level = run.level;
  }
  return result;
}

std::string markup_to_html(std::string_view markup) {
  std::string result;
  for (const Run& run : runs_of(markup)) {
    std::string text = escaped(run.text);
    if (run.italic) text = "<i>" + text + "</i>";
    if (run.level != 0) text = (run.level < 0 ? "<sub>" : "<sup>") + text + (run.level < 0 ? "</sub>" : "</sup>");
    result += text;
  }
  return result;
}

std::string markup_to_text(std::string_view markup) {
  std::string result;
  for (const Run& run : runs_of(markup)) result += (run.level > 0 ? "^" : run.level < 0 ? "_" : "") + run.text;
  return result;
}

double text_width(std::string_view markup, double size) {
  double width = 0;
  for (const Run& run : runs_of(markup)) {
    double em = 0;
    std::string_view rest = run.text;
    while (!rest.empty()) {
      const std::size_t length = std::max<std::size_t>(1, utf8_length(rest));
      const char c = rest.front();
      if (length > 1) {
        em += 0.6;
      } else if (std::string_view("ijlt.,:;'|()[]!fI ").find(c) != std::string_view::npos) {
        em += 0.3;
      } else if (std::string_view("mwMW%@").find(c) != std::string_view::npos) {
        em += 0.86;
      } else if (c >= 'A' && c <= 'Z') {
        em += 0.7;
      } else {
        em += 0.56;
      }
      rest.remove_prefix(length);
    }
    width += em * (run.level == 0 ? 1 : 0.75);
  }
  return width * size;
}

std::string light_colours() {
  return "--paper: #ffffff; --ink: #1a1a1a; --soft: #595959; --grid: #dedede; --s1: #0b4f9e; --s2: #c04a00; "
         "--s3: #1d7a3a; --s4: #7b2d8e; --s5: #8a6500; --s6: #006d77;";
}

std::string dark_colours() {
  return "--paper: #15181c; --ink: #ececec; --soft: #b0b4ba; --grid: #353a41; --s1: #79b8ff; --s2: #ff9d5c; "
         "--s3: #6fd08c; --s4: #d79bea; --s5: #e3c04d; --s6: #5fd0d9;";
}

std::string picture_style() {
  std::string style =
      "svg.plot{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;font-size:12px;fill:var(--ink)}"
      "svg.plot text{fill:var(--ink)}"
      "svg.plot .soft{fill:var(--soft)}"
      "svg.plot .small{font-size:11px}"
      "svg.plot .head{font-weight:bold}"
      "svg.plot .halo{paint-order:stroke;stroke:var(--paper);stroke-width:3px;stroke-linejoin:round}"
      "svg.plot .grid{stroke:var(--grid);stroke-width:.75;fill:none}"
      "svg.plot .axis{stroke:var(--ink);stroke-width:1;fill:none}"
      "svg.plot .rule{stroke:var(--soft);stroke-width:1;stroke-dasharray:6 3;fill:none}"
      "svg.plot .line{fill:none;stroke-width:1.7;stroke-linejoin:round}"
      "svg.plot .contour{fill:none;stroke:#000;stroke-linejoin:round}"
      "svg.plot .contour-halo{fill:none;stroke:#fff;stroke-linejoin:round;stroke-opacity:.75}"
      "svg.plot .cell{stroke:none}"
      "svg.plot .cell-text{paint-order:stroke;stroke-width:3.5px;stroke-linejoin:round;pointer-events:none}"
      "svg.plot .blank{fill:none;stroke:var(--grid);stroke-width:.75}"
      "svg.plot .hollow{fill:var(--paper)}";
  for (int i = 1; i <= 6; ++i) {
    style += fmt::format(
        "svg.plot .s{0} .line{{stroke:var(--s{0})}}svg.plot .s{0} "
        ".mark{{fill:var(--s{0});stroke:var(--s{0});stroke-width:1.2}}svg.plot .s{0} "
        ".mark.hollow{{fill:var(--paper)}}svg.plot .s{0} .label{{fill:var(--s{0})}}",
        i);
  }
  return style;
}

std::string picture(const Picture& frame, const std::string& content, Place place) {
  const std::string id = escaped(frame.id), width = pixels(frame.width), height = pixels(frame.height);
  std::string result = fmt::format(
      "<svg class=\"plot\" id=\"{}\" role=\"img\" viewBox=\"0 0 {} {}\" aria-labelledby=\"{}-title {}-desc\"", id,
      width, height, id, id);
  if (place == Place::file) {
    result = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{} xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" "
        "height=\"{}\"",
        result, width, height);
  } else {
    std::string axes;
    for (const std::string& one : frame.axes)
      axes += (axes.empty() ? "" : "|") + replaced(markup_to_text(one), "|", "/");
    result += fmt::format("{} style=\"max-width:{}px\"", axes.empty() ? "" : " data-axes=\"" + escaped(axes) + "\"",
                          pixels(1.2 * frame.width));
  }
  result += fmt::format(">\n<title id=\"{}-title\">{}</title><desc id=\"{}-desc\">{}</desc>\n", id,
                        escaped(frame.title), id, escaped(frame.description));
  if (place == Place::file) {
    std::string style = picture_style();
    for (const auto& [name, value] : variables(light_colours())) style = replaced(style, "var(" + name + ")", value);
    result +=
        fmt::format("<style>{}</style>\n<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", style, width, height);
  }
  return result + content + "</svg>\n";
}

}  // namespace ehd::report
