// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "contact/overloaded.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

using OfRing = BearingQuantityRow::OfRing;
using OfContact = BearingQuantityRow::OfContact;

constexpr std::array<BearingQuantityRow, 4> quantity_rows{{
    {.name = "displacement",
     .meaning = "of the inner ring along the load",
     .unit = "m",
     .read = OfRing{[](const BearingResult& result) { return std::optional(result.displacement_m); }}},
    {.name = "force", .meaning = "contact force", .unit = "N", .read = OfContact{[](const ContactRow& contact) {
                                                                 return std::optional(contact.force_N);
                                                               }}},
    {.name = "displacement",
     .meaning = "approach of roller and ring",
     .unit = "m",
     .read = OfContact{[](const ContactRow& contact) { return std::optional(contact.displacement_m); }}},
    {.name = "film.minimum",
     .meaning = "smallest film thickness",
     .unit = "m",
     .read = OfContact{[](const ContactRow& contact) { return contact.film_minimum_m; }}},
}};

constexpr std::string_view roller_prefix = "roller.";

const BearingQuantityRow* find(std::string_view name, bool of_contact) {
  const auto* const at = std::find_if(quantity_rows.begin(), quantity_rows.end(), [&](const BearingQuantityRow& row) {
    return row.of_contact() == of_contact && row.name == name;
  });
  return at == quantity_rows.end() ? nullptr : at;
}

/// Removes `prefix` from the beginning of `text`; false where the text begins otherwise.
bool cut(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// A roller's number, from 1, without leading zeros. Removes it from the beginning of `text`.
std::optional<int> cut_roller(std::string_view& text) {
  if (text.empty() || text.front() < '1' || text.front() > '9') return std::nullopt;
  int roller = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), roller);
  if (parsed.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
  return roller;
}

std::optional<double> value_in(const BearingResult& result, const BearingQuantity& quantity) {
  return std::visit(Overloaded{[&](OfRing read) { return read(result); },
                               [&](OfContact read) -> std::optional<double> {
                                 const auto number = static_cast<std::size_t>(quantity.roller);
                                 if (number > result.rollers.size()) return std::nullopt;
                                 const RollerRow& roller = result.rollers[number - 1];
                                 return read(quantity.raceway == bearing::Raceway::inner ? roller.inner : roller.outer);
                               }},
                    quantity.row->read);
}

}  // namespace

std::span<const BearingQuantityRow> bearing_quantities() { return quantity_rows; }

std::optional<BearingQuantity> bearing_quantity_from(std::string_view name) {
  if (const auto* row = find(name, false)) return BearingQuantity{.row = row};
  if (!cut(name, roller_prefix)) return std::nullopt;
  const auto roller = cut_roller(name);
  if (!roller) return std::nullopt;
  const bool inner = cut(name, ".inner.");
  if (!inner && !cut(name, ".outer.")) return std::nullopt;
  const auto* row = find(name, true);
  if (!row) return std::nullopt;
  return BearingQuantity{
      .row = row, .roller = *roller, .raceway = inner ? bearing::Raceway::inner : bearing::Raceway::outer};
}

std::string names_of_bearing_quantities() {
  std::string names;
  const auto add = [&](const std::string& name) {
    if (!names.empty()) names += ", ";
    names += name;
  };
  const char* explained = " (N from 1)";  // once, at the first N
  for (const BearingQuantityRow& row : quantity_rows) {
    if (!row.of_contact()) {
      add(std::string(row.name));
      continue;
    }
    add(fmt::format("{}N.inner.{}{}", roller_prefix, row.name, explained));
    add(fmt::format("{}N.outer.{}", roller_prefix, row.name));
    explained = "";
  }
  return names;
}

std::optional<double> measure(const std::vector<BearingResult>& results, const Expectation& expectation) {
  const auto quantity = bearing_quantity_from(expectation.quantity);
  if (!quantity) return std::nullopt;
  for (const BearingResult& result : results) {
    if (to_string(result.law) == expectation.law && !result.rollers.empty()) return value_in(result, *quantity);
  }
  return std::nullopt;
}

}  // namespace ehd
