// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_template.hpp"

#include <fmt/format.h>

#include "bearing/geometry.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"

namespace ehd {

namespace {

constexpr std::size_t widest = 100;  // characters of a comment line

/// The text in lines that begin with "# ", broken between words.
std::string comment(const std::string& text) {
  std::string lines, line = "#";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (line.size() + 1 + word.size() > widest) {
      lines += line + "\n";
      line = "#  ";
    }
    line += " " + word;
    begin = end + 1;
  }
  return lines + line + "\n";
}

/// "default 95", "needed where ...", "without it: ..."; empty for a key that every case has.
std::string need_of(const CaseKey& key) {
  switch (key.need) {
    case Need::always: return "";
    case Need::sometimes: return fmt::format("needed where {}", key.condition);
    case Need::never:
      return key.standard ? "default " + plain(*key.standard) : fmt::format("without it: {}", key.otherwise);
  }
  return "";
}

std::string unit_of(const CaseKey& key) { return key.unit.empty() ? "" : fmt::format(" [{}]", key.unit); }

/// The comment above a key: meaning, unit, what is allowed, default.
std::string explained(const CaseKey& key) {
  const std::string need = need_of(key);
  return comment(
      fmt::format("{}{}; {}{}{}", key.meaning, unit_of(key), text_of(key.allowed), need.empty() ? "" : "; ", need));
}

/// An example of io/case_keys, which is a number.
double example_number(std::string_view table, std::string_view key) {
  return number_in(row_of_case_key(fmt::format("{}.{}", table, key)).example);
}

/// How many rollers of the example's diameters fit without a cage.
int full_complement() {
  return bearing::most_rollers(example_number("bearing", "pitch_diameter_m"),
                               example_number("bearing", "roller_diameter_m"));
}

/// What a key means in a bearing of this type, where that is something else than in one row between two rings.
std::string remark_on(const BearingType& type, std::string_view key) {
  const bool several = type.rows > 1;
  if (key == "rollers" && type.full_complement)
    return fmt::format("{}without a cage at most {} fit: the whole part of pi/asin(roller_diameter_m/pitch_diameter_m)",
                       several ? "of one row; " : "", full_complement());
  if (key == "rollers" || key == "length_m") return several ? "of one row" : "";
  if (key == "radial_load_N" && several)
    return fmt::format("of one row: 1/{} of the bearing's load, if the rows share it", type.rows);
  return key == "clearance_m" ? std::string(type.clearance) : "";
}

/// What a new case has as keys; all else is a comment in it.
bool is_written(const CaseKey& key) { return key.need == Need::always || key.in_new; }

/// The table that states a new case: the contact in SI, whose numbers people know.
bool is_written(const CaseTable& table, CaseKind kind) {
  if (table.role == TableRole::statement) return table.name == (kind == CaseKind::contact ? "conditions" : "bearing");
  if (table.role == TableRole::companion) return table.required || table.name == "lubricant" || table.name == "domain";
  return table.role == TableRole::heading;
}

/// In place of the examples of io/case_keys, which are those of a cylindrical roller bearing: needles of 2 mm on a
/// shaft of 20 mm.
struct NeedleExample {
  std::string_view key, value;
};
constexpr NeedleExample needle_examples[] = {{"rollers", "20"},
                                             {"pitch_diameter_m", "0.022"},
                                             {"roller_diameter_m", "0.002"},
                                             {"length_m", "0.015"},
                                             {"ring_thickness_m", "0.001"}};

/// `type`: of a bearing; null where none is asked for.
std::string value_of(const CaseKey& key, CaseKind kind, const std::string& id, const BearingType* type) {
  if (key.name == "rollers" && type && type->full_complement) return std::to_string(full_complement());
  if (type && type->needles)
    for (const NeedleExample& example : needle_examples)
      if (key.name == example.key) return std::string(example.value);
  if (key.name == "id") return "\"" + id + "\"";
  if (key.name == "title") return kind == CaseKind::contact ? "\"a contact\"" : "\"a bearing\"";
  // Of [[expect]]: the rows' examples are those of a contact.
  if (kind == CaseKind::bearing && key.name == "quantity") return "\"displacement\"";
  if (kind == CaseKind::bearing && key.name == "value") return "\"4.1e-5\"";
  if (kind == CaseKind::bearing && key.name == "scaling") return "\"SI\"";
  return std::string(key.example);
}

std::string written(const CaseTable& table, CaseKind kind, const std::string& id, const BearingType* type) {
  const bool whole = is_written(table, kind);
  const std::string off = whole ? "" : "# ";
  std::string text = "\n";
  if (!table.name.empty()) {
    const bool list = table.role == TableRole::expectation;
    text += comment(std::string(table.meaning) +
                    (table.role == TableRole::statement && !whole ? ": another way to state the same" : ""));
    text += fmt::format("{}{}{}{}\n", off, list ? "[[" : "[", table.name, list ? "]]" : "]");
  }
  for (const CaseKey& key : table.keys) {
    if (key.bearing_only && kind == CaseKind::contact) continue;
    text += explained(key);
    if (const std::string remark = type ? remark_on(*type, key.name) : ""; !remark.empty())
      text += comment(fmt::format("{}: {}", type->name, remark));
    text += fmt::format("{}{} = {}\n", whole && is_written(key) ? "" : "# ", key.name, value_of(key, kind, id, type));
  }
  return text;
}

std::string heading_of(const CaseTable& table) {
  const bool list = table.role == TableRole::expectation;
  if (table.name.empty()) return "above the first table";
  return list ? "`[[expect]]`" : fmt::format("`[{}]`", table.name);
}

/// "|" would end a cell.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string default_of(const CaseKey& key) { return key.need == Need::always ? "needed" : need_of(key); }

/// `of_kind`: the lines of the head that only this kind of case has.
std::string template_of(CaseKind kind, const std::string& id, const std::string& of_kind,
                        const BearingType* type = nullptr) {
  std::string text =
      comment(
          fmt::format("A {} case for ehd. Lines with # are comments: meaning [unit]; what is allowed; default. Every "
                      "number is an example: replace it by your own.",
                      kind == CaseKind::contact ? "contact" : "bearing")) +
      comment(fmt::format("Then: ehd {} FILE", kind == CaseKind::contact ? "solve" : "bearing")) + of_kind;
  for (const CaseTable& table : case_tables())
    if (kind == CaseKind::contact ? table.in_contact : table.in_bearing) text += written(table, kind, id, type);
  return text;
}

}  // namespace

std::string case_template(CaseKind kind, const std::string& id) {
  return template_of(kind, id,
                     kind == CaseKind::contact
                         ? ""
                         : comment("One row of rollers between two rings. ehd new types: how to state the others."));
}

std::string bearing_template(const BearingType& type, const std::string& id) {
  return template_of(CaseKind::bearing, id, comment(fmt::format("{}: {}. {}", type.name, type.what, type.stated)),
                     &type);
}

std::string case_key_tables() {
  std::string text;
  for (const CaseTable& table : case_tables()) {
    const char* const where = !table.in_bearing ? " (contact)" : !table.in_contact ? " (bearing)" : "";
    text += fmt::format("{}### {}{}: {}\n\n| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n",
                        text.empty() ? "" : "\n", heading_of(table), where, table.meaning);
    for (const CaseKey& key : table.keys)
      text += fmt::format("| `{}` | {} | {} | {} | {}{} |\n", key.name, key.unit, cell(text_of(key.allowed)),
                          cell(default_of(key)), cell(std::string(key.meaning)),
                          key.bearing_only ? "; in a bearing case" : "");
  }
  return text;
}

}  // namespace ehd
