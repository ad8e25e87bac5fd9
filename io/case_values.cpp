// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/overloaded.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/near_miss.hpp"
#include "io/substitution.hpp"

namespace ehd {

namespace {

/// What the key's row allows. Only a refusal needs these words: making them costs more than reading the value.
std::string allowed_of(std::string_view key) { return text_of(row_of_case_key(key).allowed); }

/// One line of text; allowed() gives the words for a refusal.
template <class Allowed>
std::string plain_text(const CaseTree& tree, std::string_view key, const Allowed& allowed) {
  const CaseNode* node = tree.find(key);
  if (!node) tree.fail(key, "is missing; required is " + allowed());
  const auto* content = std::get_if<std::string>(&node->content);
  if (!content) {
    const char* const a_text = allowed().starts_with("a text") ? "" : "a text, ";
    tree.fail(key, fmt::format("is {}; allowed is {}{}", node->type, a_text, allowed()));
  }
  if (content->find_first_not_of(" \t") == std::string::npos) tree.fail(key, "is empty; allowed is " + allowed());
  if (one_line(*content) != *content) tree.fail(key, "is not one line of plain text; allowed is " + allowed());
  return *content;
}

/// What is wrong with a text in the place of a number: "1e5 N", "0x10", "1 000", "1e400", "20.". "is a text" where the
/// text does not begin with a number, and where it is one in quotation marks.
std::string fault_of_text(std::string_view text) {
  if (text.empty()) return "is empty";
  text = without_plus(text);
  double value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view rest = text.substr(static_cast<std::size_t>(parsed.ptr - text.data()));
  if (rest.empty()) {
    if (parsed.ec == std::errc::result_out_of_range) return "is out of range";
    return std::holds_alternative<std::string>(toml_value(text)) ? "is no number in TOML" : "is a text";
  }
  if (rest.size() == text.size()) return "is a text";
  if (rest.front() == ',') return several_numbers;
  if (value == 0 && std::string_view("xob").find(rest.front()) != std::string_view::npos) return "is no decimal number";
  const char unit = rest[std::min(rest.find_first_not_of(' '), rest.size() - 1)];
  const bool letter = (unit >= 'a' && unit <= 'z') || (unit >= 'A' && unit <= 'Z') || unit == '%';
  return letter && !begins_exponent(rest) ? "has a unit, which belongs to the key's name" : "is no number";
}

/// What is wrong with a value in the place of a number, and what is allowed.
std::string no_number(const CaseNode& node, const std::string& allowed) {
  const auto* text = std::get_if<std::string>(&node.content);
  if (const std::string comma = text ? comma_in_number(*text) : ""; !comma.empty()) return comma;
  return fmt::format("{}; allowed is {}", text ? fault_of_text(*text) : "is " + node.type, allowed);
}

/// "-4" in quotation marks.
bool is_quoted_number(const std::string& word) {
  double x = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(without_plus(word).data(), end, x);
  return !word.empty() && read.ptr == end && read.ec == std::errc();
}

/// "did you mean 32 or 46? " for 45: the neighbours among a few numbers that increase. A text may hold the number:
/// "46", "VG 46".
std::string near_numbers(const CaseNode& node, std::span<const double> few) {
  double value = node.number().value_or(0);
  if (const auto* text = std::get_if<std::string>(&node.content)) {
    const std::size_t digits = std::min(text->find_first_of("0123456789"), text->size());
    std::from_chars(text->data() + digits, text->data() + text->size(), value);
  }
  if (!(value > 0) || !std::isfinite(value)) return "";
  const auto above = std::lower_bound(few.begin(), few.end(), value);
  const bool exactly = above != few.end() && *above == value;
  std::string meant = above == few.end() ? "" : plain(*above);
  if (above != few.begin() && !exactly) meant = plain(*(above - 1)) + (meant.empty() ? "" : " or ") + meant;
  return "did you mean " + meant + "? ";
}

}  // namespace

double number(const CaseTree& tree, std::string_view key) {
  return number_in(tree, key, required(tree, key), interval_of(key));
}

std::optional<double> maybe_number(const CaseTree& tree, std::string_view key) {
  return maybe_number(tree, key, interval_of(key));
}

std::optional<double> maybe_number(const CaseTree& tree, std::string_view key, const Interval& interval) {
  const CaseNode* node = tree.find(key);
  if (!node) return std::nullopt;
  return number_in(tree, key, *node, interval);
}

double number_or_standard(const CaseTree& tree, std::string_view key) {
  return maybe_number(tree, key).value_or(row_of_case_key(key).standard.value());
}

double number_in(const CaseTree& tree, std::string_view key, const CaseNode& node, const Interval& interval) {
  const auto stated = node.number();
  if (!stated) tree.fail(key, no_number(node, "a number, " + interval.text()));
  const double value = *stated;
  if (!std::isfinite(value)) tree.fail(key, "is not finite; allowed is " + interval.text());
  if (interval.contains(value)) return value;
  const bool wrong_sign = value < 0 && interval.low >= 0;
  const bool zero = value == 0 && interval.low > 0;
  const char* const what = wrong_sign ? "is negative" : zero ? "is zero" : "is out of range";
  tree.fail(key, fmt::format("{}; allowed is {}", what, interval.text()));
}

std::optional<double> maybe_one_of(const CaseTree& tree, std::string_view key) {
  const CaseNode* node = tree.find(key);
  if (!node) return std::nullopt;
  const Allowed& allowed = row_of_case_key(key).allowed;
  const auto few = std::get<allowed::OneOf>(allowed).numbers();
  const auto value = node->number();
  if (value && std::find(few.begin(), few.end(), *value) != few.end()) return value;
  tree.fail(key, fmt::format("is {}; {}allowed is {}", value ? "none of the allowed numbers" : node->type,
                             near_numbers(*node, few), text_of(allowed)));
}

int integer(const CaseTree& tree, std::string_view key) {
  const auto& range = std::get<allowed::Integer>(row_of_case_key(key).allowed);
  const CaseNode& node = required(tree, key);
  if (const auto stated = node.number(); stated && (*stated < range.low || *stated > range.high))
    tree.fail(key, "is out of range; allowed is " + allowed_of(key));
  const auto* value = std::get_if<std::int64_t>(&node.content);
  if (!value) tree.fail(key, no_number(node, allowed_of(key)));
  return static_cast<int>(*value);
}

std::string text(const CaseTree& tree, std::string_view key) {
  return plain_text(tree, key, [&] { return allowed_of(key); });
}

std::string text(const CaseTree& tree, std::string_view key, const std::function<std::string()>& allowed) {
  return plain_text(tree, key, allowed);
}

std::string word(const CaseTree& tree, std::string_view key) {
  const std::vector<std::string> words = std::get<allowed::Word>(row_of_case_key(key).allowed).words();
  const std::string chosen = text(tree, key);
  if (std::find(words.begin(), words.end(), chosen) == words.end()) tree.fail(key, is_unknown(chosen, allowed_of(key)));
  return chosen;
}

Inlet inlet(const CaseTree& tree, std::string_view key) {
  const CaseKey& row = row_of_case_key(key);
  const auto& range = std::get<allowed::Inlet>(row.allowed);
  const auto refuse = [&](const std::string& what) { tree.fail(key, what + "; allowed is " + text_of(row.allowed)); };
  const CaseNode& node = required(tree, key);
  if (const auto* word = std::get_if<std::string>(&node.content)) {
    if (*word == range.word) return Flooded{};
    if (const std::string comma = comma_in_number(*word); !comma.empty()) tree.fail(key, comma);
    if (is_quoted_number(*word)) refuse("is a text; a number has no quotation marks, " + *word);
    tree.fail(key, fmt::format("is unknown; {}allowed is {}", did_you_mean(*word, {std::string(range.word)}),
                               text_of(row.allowed)));
  }
  const auto x = node.number();
  if (!x) refuse("is " + node.type);
  if (!std::isfinite(*x)) refuse("is not finite");
  if (!(*x < range.edge)) refuse("lies inside or behind the contact");
  if (*x < range.farthest) refuse("is out of range");
  return TruncatedAt{*x};
}

void check_value(const CaseTree& tree, std::string_view key) {
  std::visit(Overloaded{[&](const Interval&) { (void)number(tree, key); },
                        [&](const allowed::Integer&) { (void)integer(tree, key); },
                        [&](const allowed::OneOf&) { (void)maybe_one_of(tree, key); },
                        [&](const allowed::Word&) { (void)word(tree, key); },
                        [&](const allowed::Text&) { (void)text(tree, key); },
                        [&](const allowed::Inlet&) { (void)inlet(tree, key); }, [](const allowed::Pair&) {}},
             row_of_case_key(key).allowed);
}

const CaseNode& required(const CaseTree& tree, std::string_view key) {
  const CaseNode* node = tree.find(key);
  if (!node) tree.fail(key, "is missing; required is " + allowed_of(key));
  return *node;
}

void fail_statement(const CaseTree& tree, std::string_view key, const StatementError& error) {
  const std::string what = error.what();
  if (what.find("allowed is") != std::string::npos || key.find('.') == std::string::npos) tree.fail(key, what);
  tree.fail(key, what + "; allowed is " + text_of(row_of_case_key(key).allowed));
}

const Interval& interval_of(std::string_view key) { return std::get<Interval>(row_of_case_key(key).allowed); }

}  // namespace ehd
