// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/submission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/file_text.hpp"
#include "io/find_case.hpp"
#include "io/near_miss.hpp"

namespace ehd::judging {

namespace {

constexpr std::size_t longest_message = 400, most_quoted = 60;  // bytes
constexpr double largest_number = 1e100;                        // relative errors of it are finite

bool can_be_submitted(Quantity quantity) { return !is_self_check(quantity); }

std::string quoted(const std::string& text) { return shortened(text, most_quoted); }

}  // namespace

CaseError refusal(const std::string& place, const std::string& what) {
  return CaseError(shortened(one_line(place + ": " + what), longest_message));
}

std::string submitted_text(const std::filesystem::path& file, const FileKind& kind) {
  std::string text = text_of_file(file, kind);
  if (text.find('\0') != std::string::npos)
    throw refusal(file.string(), "is binary, or UTF-16; required is UTF-8 text: " + std::string(kind.name));
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

Quantity submitted_quantity(const std::string& place, const std::string& name) {
  const auto quantity = quantity_from(name);
  if (!quantity || !can_be_submitted(*quantity))
    throw refusal(place, quoted(name) + ": " + is_unknown(name, names_of_quantities(can_be_submitted)));
  return *quantity;
}

Scaling submitted_scaling(const std::string& place, const std::string& name) {
  const auto scaling = scaling_from(name);
  if (scaling) return *scaling;
  std::vector<std::string> names;
  for (const Scaling one : all_scalings) names.emplace_back(to_string(one));
  throw refusal(place, fmt::format("scaling = {}: {}", quoted(name), is_unknown(name, list(names))));
}

void require_case_id(const std::string& place, const std::string& id) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
  if (id.empty() || id.front() == '.' || id.find_first_not_of(letters) != std::string::npos)
    throw refusal(place, fmt::format("case = {}: is no id; allowed is {}", quoted(id), allowed_id));
}

void require_number(const std::string& place, const SubmittedNumber& number) {
  const std::string name(to_string(number.quantity));
  const auto refuse = [&](const std::string& key, double value, const char* what) {
    throw refusal(place, fmt::format("{} = {}: {}", key, plain(value), what));
  };
  if (!std::isfinite(number.value)) refuse(name, number.value, "is not finite; allowed is a finite number");
  if (std::abs(number.value) > largest_number)
    refuse(name, number.value, "is out of range; allowed is a size up to 1e100");
  if (is_film(number.quantity) && !(number.value > 0))
    refuse(name, number.value, "is not positive; allowed is a film thickness above 0");
  if (number.stated_error && !(*number.stated_error > 0 && *number.stated_error <= 1))
    refuse("stated_error", *number.stated_error, "is out of range; allowed is a relative error above 0, up to 1");
}

bool is_csv(const std::filesystem::path& file) { return file.extension() == ".csv" || file.extension() == ".CSV"; }

Submission read_submission(const std::filesystem::path& file) {
  return is_csv(file) ? read_submission_csv(file) : read_submission_json(file);
}

}  // namespace ehd::judging
