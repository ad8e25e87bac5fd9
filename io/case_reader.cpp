// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <system_error>

#include "bearing/law_table.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/problem.hpp"
#include "contact/text.hpp"
#include "io/case_text.hpp"
#include "io/toml.hpp"

namespace ehd {

namespace {

/// What a number may be. The bounds of physical quantities are wide on purpose: they keep every product of them away
/// from overflow and underflow, and nothing that turns or flows lies outside.
struct Interval {
  double low = 0;
  double high = 0;
  bool open_low = false;  ///< low itself is not allowed
  bool or_zero = false;   ///< 0 is allowed beside low..high
  [[nodiscard]] bool contains(double x) const {
    return (or_zero && x == 0) || ((open_low ? x > low : x >= low) && x <= high);
  }
  [[nodiscard]] std::string text() const {
    return std::string(or_zero ? "0, or " : "") + (open_low ? "more than " : "") + plain(low) + " to " + plain(high);
  }
};

constexpr Interval lengths{1e-9, 1e6};                                 // m
constexpr Interval moduli{1e3, 1e15};                                  // Pa
constexpr Interval line_loads{1e-6, 1e12};                             // N/m
constexpr Interval forces{1e-9, 1e12};                                 // N
constexpr Interval loads{.low = 1e-9, .high = 1e12, .or_zero = true};  // N; a bearing may turn without one
constexpr Interval speeds{1e-12, 1e6};                                 // m/s
constexpr Interval speeds_or_rest{.low = 1e-12, .high = 1e6, .or_zero = true};
constexpr Interval viscosities{1e-12, 1e9};                                    // Pa s
constexpr Interval coefficients{.low = 1e-15, .high = 1e-3, .or_zero = true};  // alpha, 1/Pa
constexpr Interval exponents{1e-3, 10};                                        // z
constexpr Interval reference_pressures{1e3, 1e15};                             // p_0, Pa
constexpr Interval M_range{smallest_M, largest_M};
// Below 1e-12 nothing would depend on L any more, and p_H in Pa would leave the range of numbers.
constexpr Interval L_range{.low = 1e-12, .high = largest_L, .or_zero = true};
constexpr Interval lambda_range{1e-12, 1e7};  // wider than M_range, which decides
constexpr Interval alpha_p_H_range{.low = 1e-12, .high = 1e6, .or_zero = true};
constexpr double farthest_inlet = -1e6;
constexpr double contact_edge = -1;                                     // the inlet lies before it
constexpr Interval densities{1e-3, 1e6};                                // kg/m3
constexpr Interval clearances{-1e-1, 1e-1};                             // m; negative: preload
constexpr Interval azimuths{-360, 360};                                 // degrees
constexpr Interval turning{.low = 1e-9, .high = 1e7, .or_zero = true};  // rpm, with a direction given by `rotating`
constexpr Interval signed_turning{-1e7, 1e7};                           // rpm
constexpr Interval poisson_ratios{.low = -1, .high = 0.5, .open_low = true};
constexpr Interval relative_uncertainties{0, 1};
constexpr int fewest_rollers = 3, most_rollers = 400;
constexpr int fewest_fit_points = 3, most_fit_points = 200;
constexpr double narrowest_fit = 1.01;  // high over low
constexpr int largest_version = 1000000;
constexpr std::size_t longest_text = 60;  // of a value in a message

const std::vector<std::string> top_keys{"id", "version", "title", "source"};
const std::vector<std::string> statement_tables{"moes", "conditions", "hertz", "bearing"};
const std::vector<std::string> contact_tables{"lubricant", "domain"};
const std::vector<std::string> bearing_tables{"operation", "material", "lubricant", "datum", "fit"};
std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const bearing::LawRow& row : bearing::law_rows()) names.emplace_back(row.name);
  return names;
}

/// The keys of each table: what is not here is unknown.
const std::map<std::string, std::vector<std::string>> schema{
    {"moes", {"M", "L"}},
    {"conditions", {"load_N_per_m", "reduced_radius_m", "reduced_modulus_Pa", "speed_sum_m_per_s", "viscosity_Pa_s"}},
    {"hertz", {"lambda", "alpha_p_H"}},
    {"bearing",
     {"rollers", "pitch_diameter_m", "roller_diameter_m", "length_m", "clearance_m", "rotating", "density_kg_per_m3",
      "first_azimuth_deg", "ring_thickness_m", "roughness_m"}},
    {"lubricant", {"viscosity", "density", "alpha_per_Pa", "z", "p0_Pa", "viscosity_Pa_s"}},
    {"domain", {"inlet"}},
    {"operation", {"speed_rpm", "inner_speed_rpm", "outer_speed_rpm", "radial_load_N"}},
    {"material", {"modulus_Pa", "poisson"}},
    {"datum", {"law", "load_N", "x0_m"}},
    {"fit", {"load_N", "points"}},
    {"expect", {"quantity", "law", "value", "scaling", "uncertainty", "kind", "status"}},
};

std::string list(const std::vector<std::string>& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

bool among(const std::vector<std::string>& items, std::string_view item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

/// `table.key` for a key of a table, `key` at the top.
std::string dotted(const std::string& table, std::string_view key) {
  return table.empty() ? std::string(key) : table + "." + std::string(key);
}

/// Reads one file into one Case. Keys are addressed by their dotted path, "lubricant.z"; the tables of the array
/// [[expect]] are "expect.0", "expect.1", ….
class Reader {
 public:
  /// `text` as checked_case_text leaves it.
  Reader(const std::string& text, const std::filesystem::path& file,
         const std::vector<Substitution>& substitutions = {}) {
    case_.file = file;
    case_.lines[""] = 1;
    lines_ = lines_of(text);
    root_ = parse_toml(text, file);
    substitute(substitutions);
    index_top();
  }

  [[nodiscard]] Case read() {
    read_heading();
    const std::string statement = only_statement();
    if (statement == "bearing") {
      case_.body = read_bearing();
    } else {
      case_.body = read_contact(statement);
    }
    for (std::size_t i = 0; i < expectations_; ++i) {
      case_.expectations.push_back(read_expectation("expect." + std::to_string(i), statement == "bearing"));
    }
    return std::move(case_);
  }

 private:
  // -- the text as a tree ---------------------------------------------------------------------------------------

  [[nodiscard]] std::string place(int line) const { return case_.file.string() + ":" + std::to_string(line); }

  void record(const std::string& path, const toml::node& node) {
    nodes_[path] = &node;
    const auto substituted = substituted_.find(path);
    case_.lines[path] = substituted == substituted_.end() ? line_of(node) : substituted->second.line;
    if (!node.is_table())
      case_.texts[path] = substituted == substituted_.end() ? text_of(node, lines_) : substituted->second.text;
  }

  /// Puts values into the tree, in the place of the file's own or beside them. What the file expects of its own numbers
  /// is no longer said of these.
  void substitute(const std::vector<Substitution>& substitutions) {
    if (substitutions.empty()) return;
    root_.erase("expect");
    for (const Substitution& substitution : substitutions) {
      const auto dot = substitution.key.find('.');
      const std::string table_name = substitution.key.substr(0, dot);
      const std::string key = dot == std::string::npos ? "" : substitution.key.substr(dot + 1);
      if (!schema.contains(table_name) || table_name == "expect" || !among(schema.at(table_name), key))
        throw CaseError(one_line(shortened(substitution.key, longest_text) +
                                 ": is no key of a case that can be given another value; allowed is " +
                                 (schema.contains(table_name) && table_name != "expect"
                                      ? "in [" + table_name + "] " + list(schema.at(table_name))
                                      : "table.key with one of the tables " + list(substitutable_tables()))));
      toml::node* node = root_.get(table_name);
      if (!node) node = &root_.insert(table_name, toml::table{}).first->second;
      toml::table* table = node->as_table();
      if (!table) continue;  // index_top says what the file has there
      const toml::node* present = table->get(key);
      substituted_[substitution.key] = {.line = line_of(present ? *present : *table),
                                        .text = toml_text(substitution.value)};
      std::visit([&](const auto& value) { table->insert_or_assign(key, value); }, substitution.value);
    }
  }

  [[nodiscard]] static std::vector<std::string> substitutable_tables() {
    std::vector<std::string> names;
    for (const auto& entry : schema)
      if (entry.first != "expect") names.push_back(entry.first);
    return names;
  }

  /// The first unknown key in the order of the file is the one to name.
  void refuse_unknown(const toml::table& table, const std::string& path, const std::vector<std::string>& allowed) {
    const toml::node* first = nullptr;
    std::string first_key;
    for (auto&& [key, node] : table) {
      if (among(allowed, key.str())) continue;
      if (!first || line_of(node) < line_of(*first)) {
        first = &node;
        first_key = std::string(key.str());
      }
    }
    if (!first) return;
    const std::string value = first->is_table() ? "" : " = " + text_of(*first, lines_);
    const std::string name = first->is_table() && path.empty() ? "[" + first_key + "]" : first_key + value;
    throw CaseError(one_line(place(line_of(*first)) + ": " + shortened(name, 2 * longest_text) + ": is unknown" +
                             (path.empty() ? "" : " in " + table_name(path)) + "; allowed is " + list(allowed)));
  }

  static std::string table_name(const std::string& path) {
    return path.starts_with("expect") ? "[[expect]]" : "[" + path + "]";
  }

  void index_table(const toml::table& table, const std::string& path, const std::vector<std::string>& allowed) {
    refuse_unknown(table, path, allowed);
    for (auto&& [key, node] : table) record(dotted(path, key.str()), node);
  }

  void index_top() {
    std::vector<std::string> allowed = top_keys;
    for (const auto& entry : schema) allowed.push_back(entry.first);
    index_table(root_, "", allowed);
    for (const auto& [name, keys] : schema) {
      const auto at = nodes_.find(name);
      if (at == nodes_.end()) continue;
      const toml::node& node = *at->second;
      if (name == "expect") {
        const toml::array* array = node.as_array();
        if (!array || !std::all_of(array->begin(), array->end(), [](const toml::node& n) { return n.is_table(); }))
          fail(name, "is " + type_of(node) + "; allowed is [[expect]], a table for each expectation");
        for (const toml::node& entry : *array) {
          const std::string path = "expect." + std::to_string(expectations_++);
          record(path, entry);
          index_table(*entry.as_table(), path, keys);
        }
      } else {
        if (!node.is_table()) fail(name, "is " + type_of(node) + "; allowed is a table, [" + name + "]");
        index_table(*node.as_table(), name, keys);
      }
    }
  }

  // -- one key --------------------------------------------------------------------------------------------------

  [[noreturn]] void fail(const std::string& key, const std::string& message) const {
    throw case_error(case_, key, message);
  }

  [[nodiscard]] const toml::node* find(const std::string& key) const {
    const auto at = nodes_.find(key);
    return at == nodes_.end() ? nullptr : at->second;
  }
  [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }

  [[nodiscard]] const toml::node& required(const std::string& key, const std::string& allowed) const {
    const toml::node* node = find(key);
    if (!node) fail(key, "is missing; required is " + allowed);
    return *node;
  }

  [[nodiscard]] double number_in(const std::string& key, const toml::node& node, const Interval& interval) const {
    double value = 0;
    if (const auto* integer = node.as_integer()) {
      value = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
      value = real->get();
    } else {
      fail(key, "is " + type_of(node) + "; allowed is a number, " + interval.text());
    }
    if (!std::isfinite(value)) fail(key, "is not finite; allowed is " + interval.text());
    if (!interval.contains(value)) {
      const bool sign = value < 0 && interval.low >= 0;
      const bool zero = value == 0 && interval.low > 0;
      fail(key, std::string(sign   ? "is negative"
                            : zero ? "is zero"
                                   : "is out of range") +
                    "; allowed is " + interval.text());
    }
    return value;
  }

  [[nodiscard]] double number(const std::string& key, const Interval& interval) const {
    return number_in(key, required(key, "a number, " + interval.text()), interval);
  }

  [[nodiscard]] std::optional<double> maybe_number(const std::string& key, const Interval& interval) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    return number_in(key, *node, interval);
  }

  [[nodiscard]] int integer(const std::string& key, int low, int high) const {
    const std::string allowed = "an integer, " + std::to_string(low) + " to " + std::to_string(high);
    const toml::node& node = required(key, allowed);
    const auto* value = node.as_integer();
    if (!value) fail(key, "is " + type_of(node) + "; allowed is " + allowed);
    if (value->get() < low || value->get() > high) fail(key, "is out of range; allowed is " + allowed);
    return static_cast<int>(value->get());
  }

  /// A text on one line, without control characters: it goes into tables and bibliographies.
  [[nodiscard]] std::string text(const std::string& key, const std::string& allowed) const {
    const toml::node& node = required(key, allowed);
    const auto* value = node.as_string();
    if (!value)
      fail(key, "is " + type_of(node) + "; allowed is " + (allowed.starts_with("a text") ? "" : "a text, ") + allowed);
    const std::string& content = value->get();
    if (content.find_first_not_of(" \t") == std::string::npos) fail(key, "is empty; allowed is " + allowed);
    if (one_line(content) != content) fail(key, "is not one line of plain text; allowed is " + allowed);
    return content;
  }

  [[nodiscard]] std::string choice(const std::string& key, const std::vector<std::string>& choices) const {
    std::string quoted;
    for (const auto& item : choices) quoted += (quoted.empty() ? "\"" : ", \"") + item + "\"";
    const std::string chosen = text(key, quoted);
    if (!among(choices, chosen)) fail(key, "is unknown; allowed is " + quoted);
    return chosen;
  }

  // -- the parts of a case --------------------------------------------------------------------------------------

  void read_heading() {
    const std::string stem = case_.file.stem().string();
    case_.id = text("id", "the file's name without .toml");
    if (case_.id != stem) fail("id", "differs from the file's name; allowed is \"" + stem + "\"");
    case_.version = integer("version", 1, largest_version);
    case_.title = text("title", "a title");
    case_.source = text("source", "\"own\", or \"bibkey, the exact place\"");
  }

  /// The name of the one table that states the problem.
  [[nodiscard]] std::string only_statement() const {
    std::vector<std::string> present;
    for (const auto& name : statement_tables) {
      if (has(name)) present.push_back(name);
    }
    const std::string allowed = "exactly one of [moes], [conditions], [hertz] and [bearing]";
    if (present.empty()) fail("", "the problem is missing; required is " + allowed);
    std::sort(present.begin(), present.end(),
              [&](const std::string& a, const std::string& b) { return case_.lines.at(a) < case_.lines.at(b); });
    if (present.size() > 1)
      fail(present[1], "states the problem again, beside [" + present[0] + "]; allowed is " + allowed);
    const bool bearing = present[0] == "bearing";
    const auto& companions = bearing ? bearing_tables : contact_tables;
    for (const auto& entry : schema) {
      const std::string& name = entry.first;
      if (!has(name) || name == present[0] || name == "expect" || among(companions, name)) continue;
      fail(name, std::string("does not belong to a ") + (bearing ? "bearing" : "contact") + " case; allowed is " +
                     list(companions) + ", expect");
    }
    return present[0];
  }

  [[nodiscard]] Lubricant read_lubricant() const {
    Lubricant lubricant;
    lubricant.viscosity = *viscosity_law_from(choice("lubricant.viscosity", {"isoviscous", "barus", "roelands"}));
    lubricant.density =
        *density_law_from(choice("lubricant.density", {"incompressible", "dowson-higginson", "dowson-higginson-1977"}));
    lubricant.alpha_per_Pa = maybe_number("lubricant.alpha_per_Pa", coefficients);
    lubricant.z = maybe_number("lubricant.z", exponents);
    lubricant.p0_Pa = maybe_number("lubricant.p0_Pa", reference_pressures).value_or(roelands_pressure_Pa);
    return lubricant;
  }

  [[nodiscard]] Inlet read_inlet() const {
    const std::string allowed =
        "\"flooded\", or X = x/b before the contact, " + plain(farthest_inlet) + " to less than " + plain(contact_edge);
    const toml::node& node = required("domain.inlet", allowed);
    if (const auto* word = node.as_string()) {
      if (word->get() == "flooded") return Flooded{};
      fail("domain.inlet", "is unknown; allowed is " + allowed);
    }
    double x = 0;
    if (const auto* whole = node.as_integer()) {
      x = static_cast<double>(whole->get());
    } else if (const auto* real = node.as_floating_point()) {
      x = real->get();
    } else {
      fail("domain.inlet", "is " + type_of(node) + "; allowed is " + allowed);
    }
    if (!std::isfinite(x)) fail("domain.inlet", "is not finite; allowed is " + allowed);
    if (!(x < contact_edge)) fail("domain.inlet", "lies inside or behind the contact; allowed is " + allowed);
    if (x < farthest_inlet) fail("domain.inlet", "is out of range; allowed is " + allowed);
    return TruncatedAt{x};
  }

  [[nodiscard]] Statement read_statement(const std::string& name, bool dry) const {
    if (name == "moes") return MoesGroups{.M = number("moes.M", M_range), .L = number("moes.L", L_range)};
    if (name == "hertz")
      return HertzGroups{.lambda = number("hertz.lambda", lambda_range),
                         .alpha_p_H = number("hertz.alpha_p_H", alpha_p_H_range)};
    Conditions conditions;
    conditions.load_N_per_m = number("conditions.load_N_per_m", line_loads);
    conditions.reduced_radius_m = number("conditions.reduced_radius_m", lengths);
    conditions.reduced_modulus_Pa = number("conditions.reduced_modulus_Pa", moduli);
    if (dry) {
      conditions.speed_sum_m_per_s = maybe_number("conditions.speed_sum_m_per_s", speeds_or_rest);
      conditions.viscosity_Pa_s = maybe_number("conditions.viscosity_Pa_s", viscosities);
    } else {
      conditions.speed_sum_m_per_s = number("conditions.speed_sum_m_per_s", speeds);
      conditions.viscosity_Pa_s = number("conditions.viscosity_Pa_s", viscosities);
    }
    return conditions;
  }

  [[nodiscard]] ContactCase read_contact(const std::string& name) {
    ContactCase contact;
    const bool dry = name == "conditions" && !has("lubricant") && !has("domain");
    if (!dry) {
      for (const auto& table : contact_tables) {
        if (!has(table))
          fail(table, std::string("is missing; required is [lubricant] with [domain]") +
                          (name == "conditions" ? ", or neither for a dry contact" : ""));
      }
      if (has("lubricant.viscosity_Pa_s"))
        fail("lubricant.viscosity_Pa_s", "is unknown in the [lubricant] of a contact; allowed is " +
                                             list({"viscosity", "density", "alpha_per_Pa", "z", "p0_Pa"}) +
                                             " (eta_0 stands in [conditions])");
    }
    contact.statement = read_statement(name, dry);
    if (dry) return contact;
    contact.lubricant = read_lubricant();
    contact.inlet = read_inlet();
    require_pressure_scale(contact);
    try {
      scales_ = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).scales;
    } catch (const StatementError& error) {
      fail(key_at_fault(error.key(), name), error.what());
    }
    return contact;
  }

  /// Groups alone fix no pressure in Pa; alpha does, and is then a key that is missing.
  void require_pressure_scale(const ContactCase& contact) const {
    const auto* moes = std::get_if<MoesGroups>(&contact.statement);
    const auto* hertz = std::get_if<HertzGroups>(&contact.statement);
    const bool piezoviscous = (moes && moes->L > 0) || (hertz && hertz->alpha_p_H > 0);
    if (!piezoviscous || contact.lubricant->alpha_per_Pa) return;
    const bool roelands = contact.lubricant->viscosity == ViscosityLaw::roelands;
    if (!roelands && contact.lubricant->density == DensityLaw::incompressible) return;
    fail("lubricant.alpha_per_Pa", "is missing; required is a number, " + coefficients.text() + ", since " +
                                       (roelands ? "roelands" : std::string(to_string(contact.lubricant->density))) +
                                       " needs pressures in Pa");
  }

  /// The line to name for a group that follows from others: the key that holds it, else the table that it follows from.
  [[nodiscard]] static std::string key_at_fault(const std::string& key, const std::string& statement) {
    if (key != "M" && key != "L") return key;
    if (statement == "moes") return "moes." + key;
    if (statement == "hertz") return key == "M" ? "hertz.lambda" : "hertz.alpha_p_H";
    return statement;
  }

  [[nodiscard]] BearingCase read_bearing() {
    BearingCase bearing;
    BearingGeometry& geometry = bearing.geometry;
    // Whether the rollers find room side by side is not asked: many overlapping ones are the way to Sjovall's integral.
    geometry.rollers = integer("bearing.rollers", fewest_rollers, most_rollers);
    geometry.pitch_diameter_m = number("bearing.pitch_diameter_m", lengths);
    geometry.roller_diameter_m = number("bearing.roller_diameter_m", lengths);
    if (!(geometry.roller_diameter_m < geometry.pitch_diameter_m))
      fail("bearing.roller_diameter_m",
           "is not smaller than the pitch circle; allowed is less than pitch_diameter_m = " +
               plain(geometry.pitch_diameter_m));
    geometry.length_m = number("bearing.length_m", lengths);
    geometry.clearance_m = number("bearing.clearance_m", clearances);
    geometry.density_kg_per_m3 = number("bearing.density_kg_per_m3", densities);
    geometry.first_azimuth_deg = maybe_number("bearing.first_azimuth_deg", azimuths).value_or(0);
    geometry.ring_thickness_m = maybe_number("bearing.ring_thickness_m", lengths);
    geometry.roughness_m = maybe_number("bearing.roughness_m", lengths);
    read_speeds(bearing.operation);
    bearing.operation.radial_load_N = number("operation.radial_load_N", loads);
    bearing.modulus_Pa = number("material.modulus_Pa", moduli);
    bearing.poisson = number("material.poisson", poisson_ratios);
    if (has("lubricant")) {
      bearing.lubricant = BearingLubricant{.lubricant = read_lubricant(),
                                           .viscosity_Pa_s = number("lubricant.viscosity_Pa_s", viscosities)};
      check_bearing_lubricant(bearing);
    }
    read_datum(bearing);
    read_fit(bearing);
    return bearing;
  }

  void read_speeds(BearingOperation& operation) const {
    const std::string allowed =
        "bearing.rotating with operation.speed_rpm, or operation.inner_speed_rpm and "
        "operation.outer_speed_rpm";
    const bool both = has("operation.inner_speed_rpm") || has("operation.outer_speed_rpm");
    if (both) {
      for (const char* key : {"operation.speed_rpm", "bearing.rotating"}) {
        if (has(key)) fail(key, "contradicts the speeds of both rings; allowed is " + allowed);
      }
      operation.inner_speed_rpm = number("operation.inner_speed_rpm", signed_turning);
      operation.outer_speed_rpm = number("operation.outer_speed_rpm", signed_turning);
      return;
    }
    if (!has("operation.speed_rpm")) fail("operation.speed_rpm", "is missing; required is " + allowed);
    const double speed = number("operation.speed_rpm", turning);
    if (!has("bearing.rotating")) fail("bearing.rotating", "is missing; required is " + allowed);
    const bool inner = choice("bearing.rotating", {"inner", "outer"}) == "inner";
    (inner ? operation.inner_speed_rpm : operation.outer_speed_rpm) = speed;
  }

  /// What is wrong with the lubricant itself shows on any contact; the groups wait for the roller loads.
  void check_bearing_lubricant(const BearingCase& bearing) const {
    const BearingGeometry& geometry = bearing.geometry;
    Conditions any;
    constexpr double some_N = 1;  // where the bearing carries none
    const double load_N = bearing.operation.radial_load_N;
    any.load_N_per_m = (load_N > 0 ? load_N : some_N) / geometry.length_m;
    any.reduced_radius_m = geometry.roller_diameter_m / 2;
    any.reduced_modulus_Pa = bearing.modulus_Pa / (1 - bearing.poisson * bearing.poisson);
    any.speed_sum_m_per_s = 1;
    any.viscosity_Pa_s = bearing.lubricant->viscosity_Pa_s;
    try {
      (void)nondimensionalise(any, bearing.lubricant->lubricant, Flooded{});
    } catch (const StatementError& error) {
      if (error.key().starts_with("lubricant.")) fail(error.key(), error.what());
    }
  }

  void read_datum(BearingCase& bearing) const {
    const auto load = maybe_number("datum.load_N", forces);
    const auto x0 = maybe_number("datum.x0_m", lengths);
    const std::string law = has("datum") ? choice("datum.law", {"palmgren", "lundberg", "x0"}) : "palmgren";
    if (law == "palmgren") bearing.datum = PalmgrenDatum{.load_N = load};
    if (law == "lundberg") bearing.datum = LundbergDatum{};
    if (law == "x0") {
      if (!x0) fail("datum.x0_m", "is missing; required with law = \"x0\" is a length, " + lengths.text());
      bearing.datum = LengthDatum{.x0_m = *x0};
    }
  }

  void read_fit(BearingCase& bearing) const {
    if (has("fit.points")) bearing.fit.points = integer("fit.points", fewest_fit_points, most_fit_points);
    const toml::node* node = find("fit.load_N");
    if (!node) return;
    const std::string allowed = "[low, high], contact forces with 0 < low < high";
    const toml::array* pair = node->as_array();
    if (!pair) fail("fit.load_N", "is " + type_of(*node) + "; allowed is " + allowed);
    if (pair->size() != 2)
      fail("fit.load_N", "holds " + std::to_string(pair->size()) + " values; allowed is " + allowed);
    const double low = number_in("fit.load_N", *pair->get(0), forces);
    const double high = number_in("fit.load_N", *pair->get(1), forces);
    if (!(low < high)) fail("fit.load_N", "is not increasing; allowed is " + allowed);
    if (!(high >= narrowest_fit * low))  // a straight line through one load says nothing
      fail("fit.load_N", "spans less than 1 %; allowed is " + allowed + ", high at least 1 % above low");
    bearing.fit.load_N = std::pair{low, high};
  }

  // -- expectations ---------------------------------------------------------------------------------------------

  [[nodiscard]] Expectation read_expectation(const std::string& path, bool of_bearing) const {
    Expectation expectation;
    expectation.line = case_.lines.at(path);
    const std::string quantity_key = path + ".quantity";
    expectation.quantity = text(quantity_key, of_bearing ? bearing_quantities() : contact_quantities());
    if (of_bearing) {
      check_bearing_quantity(quantity_key, expectation.quantity);
      expectation.law = choice(path + ".law", law_names());
      const bearing::Law law = *bearing::law_from(expectation.law);
      if (needs_film(law) && !has("lubricant"))
        fail(path + ".law", "needs a lubricant; allowed is a dry law in a case without [lubricant]: " +
                                bearing::names_of(bearing::Laws::dry, " or "));
      if (needs_ring_thickness(law) && !has("bearing.ring_thickness_m"))
        fail(path + ".law", "needs bearing.ring_thickness_m; allowed is " +
                                bearing::names_of(bearing::Laws::dry_without_ring_thickness, " or ") +
                                " in a case without it");
    } else {
      check_contact_quantity(quantity_key, expectation.quantity);
      if (has(path + ".law")) fail(path + ".law", "belongs to a bearing case; allowed is no law in a contact case");
    }

    if (has(path + ".status")) {
      (void)choice(path + ".status", {"waiting"});
      if (has(path + ".value"))
        fail(path + ".status", "stands beside a value; allowed is either value or status = \"waiting\"");
      expectation.waiting = true;
    } else {
      read_value(path, expectation);
    }
    // An expectation that waits may leave open what only the digits' source can tell.
    if (!expectation.waiting || has(path + ".scaling")) read_scaling(path, expectation, of_bearing);
    if (!expectation.waiting || has(path + ".kind")) {
      const std::string kind = choice(path + ".kind", {"exact", "published", "computed", "fit"});
      expectation.kind = kind == "exact"       ? ExpectationKind::exact
                         : kind == "published" ? ExpectationKind::published
                         : kind == "fit"       ? ExpectationKind::fit
                                               : ExpectationKind::computed;
    }
    if (const auto uncertainty = maybe_number(path + ".uncertainty", relative_uncertainties))
      expectation.uncertainty = *uncertainty;
    return expectation;
  }

  static std::string contact_quantities() {
    return "film.minimum, film.central, film.couette, film.offset, pressure.maximum, pressure.spike, pressure.exit, "
           "approach, rolling_force";
  }
  static std::string bearing_quantities() {
    return "displacement, roller.N.inner.force (N from 1), roller.N.outer.force, roller.N.inner.displacement, "
           "roller.N.outer.displacement, roller.N.inner.film, roller.N.outer.film";
  }

  void check_contact_quantity(const std::string& key, const std::string& name) const {
    const auto quantity = quantity_from(name);
    if (!quantity || *quantity == Quantity::load_error || *quantity == Quantity::flux_variation)
      fail(key, "is unknown in a contact case; allowed is " + contact_quantities());
    if (has("lubricant")) return;
    const bool dry = *quantity == Quantity::film_offset || *quantity == Quantity::pressure_maximum ||
                     *quantity == Quantity::pressure_exit || *quantity == Quantity::approach;
    if (!dry)
      fail(key, "does not exist in a dry contact; allowed is film.offset, pressure.maximum, pressure.exit, approach");
  }

  void check_bearing_quantity(const std::string& key, const std::string& name) const {
    if (name == "displacement") return;
    constexpr std::string_view prefix = "roller.";
    const int rollers = static_cast<int>(find("bearing.rollers")->as_integer()->get());
    const auto dot = name.find('.', prefix.size());
    if (name.starts_with(prefix) && dot != std::string::npos) {
      int roller = 0;
      const char* begin = name.data() + prefix.size();
      const char* end = name.data() + dot;
      const auto parsed = std::from_chars(begin, end, roller);
      const std::string rest = name.substr(dot + 1);
      if (parsed.ec == std::errc() && parsed.ptr == end && *begin != '-' && *begin != '0' &&
          among({"inner.force", "outer.force", "inner.displacement", "outer.displacement", "inner.film", "outer.film"},
                rest)) {
        if (roller >= 1 && roller <= rollers) return;
        fail(key, "names a roller that does not exist; allowed is 1 to " + std::to_string(rollers));
      }
    }
    fail(key, "is unknown in a bearing case; allowed is " + bearing_quantities());
  }

  void read_value(const std::string& path, Expectation& expectation) const {
    const std::string key = path + ".value";
    const std::string allowed = "a text like \"0.07414\", whose digits count, or status = \"waiting\" in its place";
    expectation.digits = text(key, allowed);
    if (!is_decimal(expectation.digits)) fail(key, "is not a decimal number; allowed is " + allowed);
    const std::string& digits = expectation.digits;
    const char* begin = digits.data() + (digits.front() == '+' ? 1 : 0);
    const auto parsed = std::from_chars(begin, digits.data() + digits.size(), expectation.value);
    constexpr Interval values{1e-100, 1e100};
    const double size = std::abs(expectation.value);
    if (parsed.ec != std::errc() || !(size == 0 || values.contains(size)))
      fail(key, "is out of range; allowed is a size of 0, or " + values.text());
    expectation.uncertainty = relative_half_unit(digits);
  }

  /// [+-] digits [. digits] [e [+-] at most three digits], at least one digit before the exponent.
  static bool is_decimal(std::string_view s) {
    constexpr std::size_t longest = 40;
    if (s.size() > longest) return false;
    std::size_t i = 0;
    const auto digits = [&] {
      const std::size_t begin = i;
      while (i < s.size() && s[i] >= '0' && s[i] <= '9') ++i;
      return i - begin;
    };
    const auto sign = [&] {
      if (i < s.size() && (s[i] == '+' || s[i] == '-')) ++i;
    };
    sign();
    std::size_t count = digits();
    if (i < s.size() && s[i] == '.') {
      ++i;
      count += digits();
    }
    if (count == 0) return false;
    if (i < s.size() && (s[i] == 'e' || s[i] == 'E')) {
      ++i;
      sign();
      const std::size_t exponent = digits();
      if (exponent < 1 || exponent > 3) return false;
    }
    return i == s.size();
  }

  void read_scaling(const std::string& path, Expectation& expectation, bool bearing) const {
    const std::string key = path + ".scaling";
    const std::string scaling = choice(key, {"hertz", "moes", "SI", "kostreva"});
    expectation.scaling = scaling == "moes"       ? Scaling::moes
                          : scaling == "SI"       ? Scaling::SI
                          : scaling == "kostreva" ? Scaling::kostreva
                                                  : Scaling::hertz;
    const std::string& quantity = expectation.quantity;
    if (bearing) {
      if (scaling != "SI") fail(key, "does not exist in a bearing case; allowed is \"SI\" (m and N)");
      return;
    }
    const bool film = quantity.starts_with("film.");
    const bool pressure = quantity.starts_with("pressure.");
    if (scaling == "moes" && (!film || quantity == "film.offset" || !has("lubricant")))
      fail(key, "does not exist for this quantity; allowed is moes for film.minimum, film.central and film.couette");
    if (scaling == "kostreva" && !film && !pressure)
      fail(key, "does not exist for this quantity; allowed is kostreva for films (h_K = 2H, k = 2H_0) and pressures");
    if (scaling == "SI") {
      if (quantity == "film.offset" || quantity == "rolling_force")
        fail(key, "does not exist for this quantity; allowed is \"hertz\"");
      const bool needs_metres = film || quantity == "approach" || quantity == "pressure.exit";
      const bool metres = has("conditions");
      if (needs_metres ? !metres : !(metres || scales_))
        fail(key,
             "needs SI scales, which this statement leaves open; allowed is \"hertz\", or the contact as "
             "[conditions]");
    }
  }

  Case case_;
  std::vector<std::string> lines_;
  toml::table root_;
  struct Substituted {
    int line = 1;
    std::string text;
  };
  std::map<std::string, Substituted> substituted_;
  std::map<std::string, const toml::node*> nodes_;
  std::size_t expectations_ = 0;
  std::optional<Scales> scales_;
};

}  // namespace

Case read_case(const std::filesystem::path& file) { return Reader(read_case_text(file), file).read(); }

Case read_case(std::string text, const std::filesystem::path& file) {
  return Reader(checked_case_text(std::move(text), file), file).read();
}

Case read_case(std::string text, const std::filesystem::path& file, const std::vector<Substitution>& substitutions) {
  return Reader(checked_case_text(std::move(text), file), file, substitutions).read();
}

std::string toml_text(const TomlValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) {
    if (!std::isfinite(*real)) return std::isnan(*real) ? "nan" : *real > 0 ? "inf" : "-inf";
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, *real).ptr;
    const std::string shortest(text, end);
    return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
  }
  std::string text = "\"";
  for (const char c : std::get<std::string>(value))
    text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return text + "\"";
}

}  // namespace ehd
