// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/submission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "contact/text.hpp"
#include "io/case_keys.hpp"

namespace ehd::judging {

namespace {

constexpr std::size_t longest_message = 400, most_quoted = 60;  // bytes

bool can_be_submitted(Quantity quantity) { return !is_self_check(quantity); }

std::string quoted(const std::string& text) { return shortened(text, most_quoted); }

}  // namespace

CaseError refusal(const std::string& place, const std::string& what) {
  return CaseError(shortened(one_line(place + ": " + what), longest_message));
}

Quantity submitted_quantity(const std::string& place, const std::string& name) {
  const auto quantity = quantity_from(name);
  if (!quantity || !can_be_submitted(*quantity))
    throw refusal(place, quoted(name) + ": is unknown; allowed is " + names_of_quantities(can_be_submitted));
  return *quantity;
}

Scaling submitted_scaling(const std::string& place, const std::string& name) {
  const auto scaling = scaling_from(name);
  if (scaling) return *scaling;
  std::vector<std::string> names;
  for (const Scaling one : all_scalings) names.emplace_back(to_string(one));
  throw refusal(place, fmt::format("scaling = {}: is unknown; allowed is {}", quoted(name), list(names)));
}

void require_case_id(const std::string& place, const std::string& id) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
  if (id.empty() || id.front() == '.' || id.find_first_not_of(letters) != std::string::npos)
    throw refusal(place, "case = " + quoted(id) + ": is no id; allowed is an id that ehd cases lists");
}

void require_number(const std::string& place, const SubmittedNumber& number) {
  const std::string name(to_string(number.quantity));
  const auto refuse = [&](const std::string& key, double value, const char* what) {
    throw refusal(place, fmt::format("{} = {}: {}", key, plain(value), what));
  };
  if (!std::isfinite(number.value)) refuse(name, number.value, "is not finite; allowed is a finite number");
  if (is_film(number.quantity) && !(number.value > 0))
    refuse(name, number.value, "is not positive; allowed is a film thickness above 0");
  if (number.stated_error && !(*number.stated_error > 0 && *number.stated_error <= 1))
    refuse("stated_error", *number.stated_error, "is out of range; allowed is a relative error above 0, up to 1");
}

Submission read_submission(const std::filesystem::path& file) {
  return file.extension() == ".csv" ? read_submission_csv(file) : read_submission_json(file);
}

}  // namespace ehd::judging
