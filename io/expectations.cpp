// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/expectations.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include "bearing/law_table.hpp"
#include "contact/nondimensional.hpp"
#include "contact/quantities.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"
#include "workflow/bearing_quantities.hpp"

namespace ehd {

namespace {

constexpr Interval value_sizes{.low = 1e-100, .high = 1e100};  // of an expected value, beside 0

/// A decimal number as people print it: [+-] digits [. digits] [e [+-] at most three digits], with at least one digit
/// before the exponent.
class Decimal {
 public:
  [[nodiscard]] static bool is(std::string_view text) {
    constexpr std::size_t longest = 40;
    return text.size() <= longest && Decimal(text).matches();
  }

 private:
  explicit Decimal(std::string_view text) : rest_(text) {}

  bool matches() {
    skip_one_of("+-");
    std::size_t count = skip_digits();
    if (skip_one_of(".")) count += skip_digits();
    if (count == 0) return false;
    if (skip_one_of("eE")) {
      skip_one_of("+-");
      const std::size_t exponent = skip_digits();
      if (exponent < 1 || exponent > 3) return false;
    }
    return rest_.empty();
  }
  bool skip_one_of(std::string_view characters) {
    if (rest_.empty() || characters.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::size_t skip_digits() {
    const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    rest_.remove_prefix(count);
    return count;
  }

  std::string_view rest_;
};

void read_value(const CaseTree& tree, const std::string& path, Expectation& expectation) {
  const std::string key = path + ".value";
  expectation.digits = text(tree, key);
  const std::string& digits = expectation.digits;
  if (!Decimal::is(digits))
    tree.fail(key, "is not a decimal number; allowed is " + text_of(row_of_case_key(key).allowed));
  const char* begin = digits.data() + (digits.front() == '+' ? 1 : 0);
  const auto parsed = std::from_chars(begin, digits.data() + digits.size(), expectation.value);
  const double size = std::abs(expectation.value);
  if (parsed.ec != std::errc() || !(size == 0 || value_sizes.contains(size)))
    tree.fail(key, "is out of range; allowed is a size of 0, or " + value_sizes.text());
  expectation.uncertainty = relative_half_unit(digits);
  // Half a digit of 0e300 is 5e299: every measured value would agree.
  if (!(expectation.uncertainty <= value_sizes.high))
    tree.fail(key, "has a last digit that is out of range; allowed is a zero like \"0.000\"");
}

// -- contacts

bool can_be_expected(Quantity quantity) { return !is_self_check(quantity); }
bool can_be_expected_when_dry(Quantity quantity) { return can_be_expected(quantity) && exists_when_dry(quantity); }
bool has_moes_units(Quantity quantity) { return row_of(quantity).in_moes_units; }

std::string contact_quantity(const CaseTree& tree, const std::string& key, const ContactCase& contact) {
  const auto all = [] { return names_of_quantities(can_be_expected); };
  std::string name = text(tree, key, all);
  const auto quantity = quantity_from(name);
  if (!quantity || !can_be_expected(*quantity)) tree.fail(key, "is unknown in a contact case; allowed is " + all());
  if (contact.dry() && !exists_when_dry(*quantity))
    tree.fail(key, "does not exist in a dry contact; allowed is " + names_of_quantities(can_be_expected_when_dry));
  return name;
}

/// The statement fixes pressures in Pa.
bool has_pressure_scale(const ContactCase& contact) {
  if (std::holds_alternative<Conditions>(contact.statement)) return true;
  return nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).scales.has_value();
}

void require_SI(const CaseTree& tree, const std::string& key, const ContactCase& contact, SIScale scale) {
  if (scale == SIScale::none) tree.fail(key, "does not exist for this quantity; allowed is \"hertz\"");
  const bool known =
      scale == SIScale::pressure ? has_pressure_scale(contact) : std::holds_alternative<Conditions>(contact.statement);
  if (!known)
    tree.fail(key,
              "needs SI scales, which this statement leaves open; allowed is \"hertz\", or the contact as "
              "[conditions]");
}

void require_scaling(const CaseTree& tree, const std::string& key, const ContactCase& contact,
                     const Expectation& expectation) {
  const QuantityRow& row = row_of(*quantity_from(expectation.quantity));
  switch (expectation.scaling) {
    case Scaling::hertz: return;
    case Scaling::moes:
      if (!row.in_moes_units || contact.dry())
        tree.fail(key, "does not exist for this quantity; allowed is moes for " + names_of_quantities(has_moes_units));
      return;
    case Scaling::kostreva:
      if (!row.kostreva_factor)
        tree.fail(key,
                  "does not exist for this quantity; allowed is kostreva for films (h_K = 2H, k = 2H_0) and pressures");
      return;
    case Scaling::SI: require_SI(tree, key, contact, row.SI); return;
  }
}

// -- bearings

std::string bearing_quantity(const CaseTree& tree, const std::string& key, const BearingCase& bearing) {
  std::string name = text(tree, key, names_of_bearing_quantities);
  const auto quantity = bearing_quantity_from(name);
  if (!quantity) tree.fail(key, "is unknown in a bearing case; allowed is " + names_of_bearing_quantities());
  if (quantity->roller > bearing.geometry.rollers)
    tree.fail(key, fmt::format("names a roller that does not exist; allowed is 1 to {}", bearing.geometry.rollers));
  return name;
}

std::string bearing_law(const CaseTree& tree, const std::string& key, const BearingCase& bearing) {
  std::string name = word(tree, key);
  const bearing::Law law = *bearing::law_from(name);
  if (needs_film(law) && !bearing.lubricant)
    tree.fail(key, "needs a lubricant; allowed is a dry law in a case without [lubricant]: " +
                       bearing::names_of(bearing::Laws::dry, " or "));
  if (needs_ring_thickness(law) && !bearing.ring_thickness_m)
    tree.fail(key, fmt::format("needs bearing.ring_thickness_m; allowed is {} in a case without it",
                               bearing::names_of(bearing::Laws::dry_without_ring_thickness, " or ")));
  return name;
}

// -- what differs between the two, by overloading

void read_subject(const CaseTree& tree, const std::string& path, const ContactCase& contact, Expectation& made) {
  made.quantity = contact_quantity(tree, path + ".quantity", contact);
  if (tree.has(path + ".law"))
    tree.fail(path + ".law", "belongs to a bearing case; allowed is no law in a contact case");
}

void read_subject(const CaseTree& tree, const std::string& path, const BearingCase& bearing, Expectation& made) {
  made.quantity = bearing_quantity(tree, path + ".quantity", bearing);
  made.law = bearing_law(tree, path + ".law", bearing);
}

void require_scaling(const CaseTree& tree, const std::string& key, const BearingCase&, const Expectation& made) {
  if (made.scaling != Scaling::SI) tree.fail(key, "does not exist in a bearing case; allowed is \"SI\" (m and N)");
}

template <class Body>
Expectation read_expectation(const CaseTree& tree, const std::string& path, const Body& body) {
  Expectation made;
  made.line = tree.line_of(path);
  read_subject(tree, path, body, made);
  const std::string status = path + ".status", scaling = path + ".scaling", kind = path + ".kind";
  if (tree.has(status)) {
    (void)word(tree, status);
    if (tree.has(path + ".value"))
      tree.fail(status, "stands beside a value; allowed is either value or status = \"waiting\"");
    made.waiting = true;
  } else {
    read_value(tree, path, made);
  }
  // Without a value, scaling and kind may be left out: only the missing source would tell them.
  if (!made.waiting || tree.has(scaling)) {
    made.scaling = *scaling_from(word(tree, scaling));
    require_scaling(tree, scaling, body, made);
  }
  if (!made.waiting || tree.has(kind)) made.kind = *expectation_kind_from(word(tree, kind));
  made.uncertainty = maybe_number(tree, path + ".uncertainty").value_or(made.uncertainty);
  return made;
}

template <class Body>
std::vector<Expectation> read_all(const CaseTree& tree, const Body& body) {
  std::vector<Expectation> expectations;
  for (std::size_t i = 0; i < tree.expectations(); ++i)
    expectations.push_back(read_expectation(tree, fmt::format("expect.{}", i), body));
  return expectations;
}

}  // namespace

std::vector<Expectation> read_expectations(const CaseTree& tree, const ContactCase& of) { return read_all(tree, of); }
std::vector<Expectation> read_expectations(const CaseTree& tree, const BearingCase& of) { return read_all(tree, of); }

}  // namespace ehd
