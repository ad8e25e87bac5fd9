// SPDX-License-Identifier: GPL-3.0-or-later
// The main of every fuzz target: libFuzzer makes up bytes, NAME_broken says which promise they break ("" for none).
// CMake compiles this file once a target, with EHD_PROMISES and EHD_BROKEN. `make fuzz`; docs/fuzzing.md tells what
// becomes of a finding.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include EHD_PROMISES
#include "io/case_text.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

/// A number as a hostile user writes it: the edges of what is allowed and of a double, or any size and sign.
std::string any_number(std::mt19937& random) {
  static const std::vector<std::string> edges{"0",
                                              "-0.0",
                                              "1",
                                              "-1",
                                              "0.5",
                                              "0.49999999999999994",
                                              "3",
                                              "400",
                                              "100",
                                              "100.00000000000001",
                                              "1e-3",
                                              "1e6",
                                              "1e-9",
                                              "1e-6",
                                              "1e-12",
                                              "1e12",
                                              "1e15",
                                              "1e-15",
                                              "1e3",
                                              "1e7",
                                              "1e9",
                                              "-1e6",
                                              "1e-300",
                                              "5e-324",
                                              "1e308",
                                              "nan",
                                              "inf",
                                              "-inf",
                                              "9223372036854775807",
                                              "1.0000000000000002",
                                              "-1.0000000000000002"};
  if (random() % 2 == 0) return edges[random() % edges.size()];
  const int digits = static_cast<int>(random() % 99999) + 1, exponent = static_cast<int>(random() % 41) - 24;
  return fmt::format("{}{}e{}", random() % 8 == 0 ? "-" : "", digits, exponent);
}

/// Gives one number of a line, or what stands behind its first "=", another value.
void change_number(std::string& line, std::mt19937& random) {
  constexpr const char* digits = "0123456789";
  if (line.find_first_of(digits) == std::string::npos) {
    if (const auto sign = line.find('='); sign != std::string::npos)
      line = line.substr(0, sign + 1) + " " + any_number(random);
    return;
  }
  const std::size_t anywhere = random() % line.size();
  std::size_t begin = line.find_first_of(digits, anywhere);
  if (begin == std::string::npos) begin = line.find_first_of(digits);
  const std::size_t end = std::min(line.find_first_not_of("0123456789.eE+-", begin), line.size());
  line = line.substr(0, begin) + any_number(random) + line.substr(end);
}

/// Doubles a line, leaves one out, or changes a number in it. Mutations of bytes rarely do so.
std::string with_another_line(std::string_view text, std::mt19937& random) {
  std::vector<std::string> lines = ehd::lines_of(text);
  const std::size_t at = random() % lines.size();
  switch (random() % 8) {
    case 0: lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(random() % lines.size()), lines[at]); break;
    case 1: lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at)); break;
    default: change_number(lines[at], random);
  }
  std::string mutated;
  for (const auto& line : lines) mutated += line + "\n";
  return mutated;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  std::mt19937 random(seed);
  if (size == 0 || random() % 2 == 0) return LLVMFuzzerMutate(data, size, largest);
  std::string text(reinterpret_cast<const char*>(data), size);
  for (unsigned i = 0; i <= random() % 3; ++i) text = with_another_line(text, random);
  const std::size_t length = std::min(text.size(), largest);
  std::memcpy(data, text.data(), length);
  return length;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string broken = ehd::verification::promises::EHD_BROKEN(bytes);
  if (!broken.empty()) {
    std::fprintf(stderr, "broken promise: %s\n", broken.c_str());
    std::abort();  // libFuzzer keeps the input
  }
  return 0;
}
