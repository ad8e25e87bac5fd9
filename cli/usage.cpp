// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/usage.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <new>
#include <system_error>

#include "cli/output.hpp"
#include "contact/nondimensional.hpp"
#include "io/near_miss.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

std::string allowed_is(const Allowed& range) { return "; allowed is " + text_of(range); }

}  // namespace

UsageError option_error(const std::string& option, const std::string& value, const std::string& message) {
  return UsageError(fmt::format("{} = {}: {}", option, value, message));
}

UsageError unknown_word_error(const std::string& option, const std::string& value, const std::string& allowed) {
  return option_error(option, value, is_unknown(value, allowed));
}

int run_guarded(const std::function<int()>& body, const std::string& without_memory) {
  const auto refuse = [&](const std::string& line) {
    complain(line);
    return bad_input;
  };
  try {
    return body();
  } catch (const CaseError& error) {
    complain(error.what());
    for (const std::string& line : error.more()) complain(line);
    return bad_input;
  } catch (const UsageError& error) {
    return refuse("ehd: " + std::string(error.what()));
  } catch (const OutputError& error) {
    return refuse("ehd: " + std::string(error.what()));
  } catch (const StatementError& error) {
    return refuse(fmt::format("ehd: {}: {}", error.key(), error.what()));
  } catch (const std::bad_alloc&) {
    complain("ehd: memory is exhausted" + (without_memory.empty() ? "" : "; " + without_memory));
    return not_met;
  }
}

double parse_number(const std::string& option, const std::string& text, const Interval& range) {
  const auto refuse = [&](const char* what) { return option_error(option, text, what + allowed_is(range)); };
  double value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(without_plus(text).data(), end, value);
  const bool whole = parsed.ptr == end && parsed.ec != std::errc::invalid_argument;
  if (const std::string comma = comma_in_number(text); !comma.empty()) throw option_error(option, text, comma);
  if (!whole) throw refuse(text.find(',') == std::string::npos ? "is not a number" : several_numbers);
  if (parsed.ec == std::errc() && !std::isfinite(value)) throw refuse("is not finite");
  if (parsed.ec != std::errc() || !range.contains(value)) throw refuse("is out of range");
  return value;
}

int parse_integer(const std::string& option, const std::string& text, const allowed::Integer& range) {
  const auto refuse = [&](const char* what) { return option_error(option, text, what + allowed_is(range)); };
  int value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(without_plus(text).data(), end, value);
  const bool whole = parsed.ptr == end && parsed.ec != std::errc::invalid_argument;
  if (!whole) throw refuse(text.find(',') == std::string::npos ? "is not an integer" : several_numbers);
  if (parsed.ec != std::errc() || value < range.low || value > range.high) throw refuse("is out of range");
  return value;
}

}  // namespace ehd::cli
