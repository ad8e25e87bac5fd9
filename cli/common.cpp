// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/common.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

constexpr int fewest_nodes = 16;
constexpr double longest_time_s = 1e9;  // what a clock can count

}  // namespace

void complain(const std::string& line) { std::cerr << one_line(line) << std::endl; }

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw OutputError("standard output: cannot be written (the device is full or closed)");
}

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

void RequestOptions::add_to(Command& command, bool with_accuracy) {
  if (with_accuracy) {
    command.text("--tolerance", tolerance, "relative error allowed in the minimum and central film (1e-3)").called("T");
    command.text("--nodes", nodes, "intervals on the finest grid instead, inlet to exit, at least 16").called("N");
  }
  command.text("--max-iterations", max_iterations, "Newton iterations over all grids (2000)").called("I");
  command.text("--time-limit", time_limit, "seconds for each solve (300)").called("S");
}

Request RequestOptions::request() const {
  Request request;
  if (tolerance && nodes) throw UsageError("--tolerance and --nodes exclude each other; allowed is one of them");
  if (tolerance) {
    request.tolerance = parse_number("--tolerance", *tolerance);
    if (!(*request.tolerance > 0))
      throw option_error("--tolerance", *tolerance, "is not positive; allowed is a number > 0");
  }
  if (nodes) {
    request.nodes = parse_integer("--nodes", *nodes);
    request.tolerance.reset();
    if (*request.nodes < fewest_nodes)
      throw option_error("--nodes", *nodes, "is too few; allowed is an integer from " + std::to_string(fewest_nodes));
  }
  if (max_iterations) {
    request.max_iterations = parse_integer("--max-iterations", *max_iterations);
    if (request.max_iterations < 1)
      throw option_error("--max-iterations", *max_iterations, "is too few; allowed is an integer from 1");
  }
  if (time_limit) {
    request.time_limit_s = parse_number("--time-limit", *time_limit);
    if (!(request.time_limit_s > 0 && request.time_limit_s <= longest_time_s))
      throw option_error("--time-limit", *time_limit,
                         "is out of range; allowed is more than 0, up to " + plain(longest_time_s) + " seconds");
  }
  return request;
}

const RegisteredSolver& solver_named(const std::string& name) {
  const auto* solver = find_solver(name);
  if (!solver) throw option_error("--solver", name, "is unknown; allowed is " + solver_names());
  return *solver;
}

Wanted quantities_named(const std::vector<std::string>& names) {
  if (names.empty()) return want_everything();
  Wanted wanted;
  for (const auto& name : names) {
    const auto quantity = quantity_from(name);
    if (!quantity) {
      std::string allowed;
      for (const Quantity known : all_quantities)
        allowed += (allowed.empty() ? "" : ", ") + std::string(to_string(known));
      throw option_error("--quantity", name, "is unknown; allowed is " + allowed);
    }
    wanted.insert(*quantity);
  }
  return wanted;
}

void require_memory(const RegisteredSolver& solver, const Request& request) {
  if (!request.nodes) return;
  constexpr double gigabyte = 1e9;
  const double needed = solver.memory_bytes(*request.nodes);
  const double available = available_memory_bytes();
  if (needed <= available) return;
  int fitting = *request.nodes;
  while (fitting > fewest_nodes && solver.memory_bytes(fitting) > available) fitting /= 2;
  throw option_error("--nodes", std::to_string(*request.nodes),
                     "would not fit into memory (" + solver.name + " needs about " + plain(needed / gigabyte, 2) +
                         " GB, available are " + plain(available / gigabyte, 2) + " GB); allowed is up to about " +
                         std::to_string(fitting));
}

void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  const auto whole = [](const std::filesystem::path& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto canonical = std::filesystem::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : canonical;  // a path that cannot be followed cannot be written either
  };
  std::vector<NamedFile> taken;
  for (const NamedFile& input : inputs) taken.push_back({input.name, whole(input.path)});
  for (const NamedFile& output : outputs) {
    if (output.path == "-" && output.name != "--json")
      throw option_error(output.name, "-", "is no file; allowed is a file's name (only --json knows standard output)");
    if (output.path.empty() || output.path == "-") continue;  // nothing, standard output
    const auto path = whole(output.path);
    for (const NamedFile& other : taken) {
      if (other.path == path)
        throw option_error(output.name, output.path.string(),
                           "is the same file as " + other.name + "; allowed is a file of its own");
    }
    taken.push_back({output.name, path});
  }
}

void Progress::show(const std::string& line) {
  if (!::isatty(STDERR_FILENO)) return;
  // Spaces and carriage returns only, so that it needs no terminal codes.
  constexpr std::size_t widest = 79;
  const std::string text = shortened(one_line(line), widest - 3);
  std::cerr << '\r' << text << std::string(shown_ > text.size() ? shown_ - text.size() : 0, ' ') << '\r' << text
            << std::flush;
  if (text.empty() && shown_ > 0) std::cerr << '\r' << std::flush;
  shown_ = text.size();
}

bool styled_output() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal && std::string_view(terminal) == "dumb";
  return ::isatty(STDOUT_FILENO) && !(no_color && *no_color) && !dumb;
}

OutputFolder::OutputFolder(const std::string& name) : path_(name) {
  std::error_code error;
  const auto whole = std::filesystem::absolute(path_, error).lexically_normal();
  for (auto above = whole; !above.empty() && !std::filesystem::exists(above, error); above = above.parent_path())
    made_.push_back(above);
  std::filesystem::create_directories(path_, error);
  if (error) {
    const std::string why = error.message();
    remove_empty();
    throw option_error("--output", name, why + "; allowed is a folder");
  }
}

void OutputFolder::remove_empty() {
  std::error_code not_empty;
  for (const auto& folder : made_) std::filesystem::remove(folder, not_empty);  // the deepest first
  made_.clear();
}

JsonTarget::JsonTarget(const std::optional<std::string>& option) : asked_(option.has_value()) {
  if (option && *option != "-") file_.emplace(*option);
}

void JsonTarget::write(const Json& json) {
  const std::string text = json_text(json);
  if (file_) {
    file_->commit(text);
  } else if (asked_) {
    print(text);
  }
}

}  // namespace ehd::cli
