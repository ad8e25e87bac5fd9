// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/c/call.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <new>
#include <string_view>

#include "bindings/c/ehd/ehd.h"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::c {

namespace {

/// The callback is asked so often at most; 50 times a second costs nothing and is soon enough for a person.
constexpr std::chrono::milliseconds between_questions{20};

struct Callback {
  int (*function)(double done, void* user) = nullptr;
  void* user = nullptr;
};

/// One place for good, so that a pointer to it never dangles, and a message needs no memory. Messages have a few
/// hundred bytes.
thread_local std::array<char, 4096> last_error{};
thread_local Callback callback;

/// One behind the other. Leaves out what does not fit.
void copy_last_error(std::initializer_list<std::string_view> parts) noexcept {
  char* at = last_error.data();
  for (const std::string_view part : parts) {
    const auto room = static_cast<std::size_t>(last_error.data() + last_error.size() - 1 - at);
    at = std::copy_n(part.begin(), std::min(part.size(), room), at);
  }
  *at = '\0';
}

int refuse(int code, std::string_view prefix, std::string_view line) noexcept {
  copy_last_error({prefix, line});
  return code;
}

/// The first of the errors of a case, and how many more there are.
int refuse(const CaseError& error) noexcept {
  std::array<char, 20> count{};
  const auto end = std::to_chars(count.data(), count.data() + count.size(), error.more().size()).ptr;
  const std::string_view more(count.data(), static_cast<std::size_t>(end - count.data()));
  if (error.more().empty())
    copy_last_error({error.what()});
  else
    copy_last_error({error.what(), " (and ", more, " more)"});
  return EHD_BAD_INPUT;
}

}  // namespace

int refused() noexcept {
  try {
    throw;
  } catch (const CaseError& error) {
    return refuse(error);
  } catch (const BadArgument& error) {
    return refuse(EHD_BAD_INPUT, "ehd: ", error.what());
  } catch (const std::bad_alloc&) {
    return refuse(EHD_NOT_MET, "ehd: ", "memory is exhausted");
  } catch (const std::exception& error) {
    return refuse(EHD_NOT_MET, "ehd: internal error: ", error.what());
  } catch (...) {
    return refuse(EHD_NOT_MET, "ehd: ", "the callback threw an exception");
  }
}

void set_last_error(const std::string& line) { copy_last_error({one_line(line)}); }

int ended(const std::string& what, StopReason status, const std::string& reason) {
  if (status == StopReason::converged) return EHD_OK;
  set_last_error(fmt::format("ehd: {}: {}{}{}", what, to_string(status), reason.empty() ? "" : ": ", reason));
  return EHD_NOT_MET;
}

void require_pointer(const void* pointer, const char* name) {
  if (!pointer) throw BadArgument(fmt::format("{} = NULL: is a null pointer; allowed is any other", name));
}

void require_in(const char* name, double value, const Interval& allowed) {
  const char* const fault = !std::isfinite(value) ? "is not finite" : "is out of range";
  if (!std::isfinite(value) || !allowed.contains(value))
    throw BadArgument(fmt::format("{} = {}: {}; allowed is {}", name, plain(value), fault, text_of(allowed)));
}

BadArgument unknown_name(const char* argument, const char* name, const std::string& fault) {
  constexpr std::size_t longest_name = 60;
  return BadArgument(fmt::format("{} = {}: {}", argument, shortened(one_line(name), longest_name), fault));
}

void require_tolerance(double tolerance) {
  require_in("tolerance", tolerance, {.low = 0, .high = loosest_tolerance, .open_low = true});
}

Progress::Progress() { ask(); }

bool Progress::cancelled() {
  if (!cancelled_ && std::this_thread::get_id() == caller_ && callback.function &&
      Clock::now() - asked_ >= between_questions)
    ask();
  return cancelled_;
}

void Progress::ask() {
  if (!callback.function) return;
  asked_ = Clock::now();
  if (callback.function(done_, callback.user) != 0) cancelled_ = true;
}

}  // namespace ehd::c

const char* ehd_last_error(void) { return ehd::c::last_error.data(); }

void ehd_set_progress(int (*callback)(double done, void* user), void* user) {
  ehd::c::callback = {.function = callback, .user = user};
}
