// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/usage.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <new>
#include <system_error>

#include "cli/output.hpp"
#include "contact/nondimensional.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

UsageError option_error(const std::string& option, const std::string& value, const std::string& message) {
  return UsageError(option + " = " + value + ": " + message);
}

int run_guarded(const std::function<int()>& body) {
  const auto refuse = [&](const std::string& line) {
    complain(line);
    return bad_input;
  };
  try {
    return body();
  } catch (const CaseError& error) {
    return refuse(error.what());
  } catch (const UsageError& error) {
    return refuse("ehd: " + std::string(error.what()));
  } catch (const OutputError& error) {
    return refuse("ehd: " + std::string(error.what()));
  } catch (const StatementError& error) {
    return refuse("ehd: " + error.key() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    complain("ehd: memory is exhausted; a smaller --nodes or a larger --tolerance needs less");
    return not_met;
  }
}

double parse_number(const std::string& option, const std::string& text) {
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(begin, end, value);
  if (parsed.ec == std::errc::result_out_of_range)
    throw option_error(option, text, "is out of range; allowed is a number");
  if (parsed.ec != std::errc() || parsed.ptr != end)
    throw option_error(option, text, "is not a number; allowed is a number");
  if (!std::isfinite(value)) throw option_error(option, text, "is not finite; allowed is a finite number");
  return value;
}

int parse_integer(const std::string& option, const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end)
    throw option_error(
        option, text,
        "is not an integer; allowed is an integer up to " + std::to_string(std::numeric_limits<int>::max()));
  return value;
}

}  // namespace ehd::cli
