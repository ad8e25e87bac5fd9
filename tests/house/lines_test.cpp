// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts, C, Makefile, CMake files and CI steps have lines of at most 120 columns. clang-format holds those of C++.
// README.md has at most 120 lines. No program that a compiler made lies among the sources.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr std::ptrdiff_t widest = 120;

/// The numbers of the lines that are wider, from 1. A character in UTF-8 is a column.
std::vector<int> wide_lines(std::istream& text) {
  std::vector<int> found;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const auto columns = std::count_if(line.begin(), line.end(),
                                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
    if (columns > widest) found.push_back(number);
  }
  return found;
}

const std::filesystem::path top(EHD_SOURCE_DIR);
constexpr std::array folders{".ci",      "bearing", "bindings", "cases",     "cli",   "cmake",        "contact", "docs",
                             "examples", "fast",    "io",       "reference", "tests", "verification", "workflow"};

/// Does it begin as programs and objects of this machine do?
bool is_compiled(const std::filesystem::path& file) {
  std::ifstream text(file, std::ios::binary);
  std::array<char, 4> begin{};
  text.read(begin.data(), begin.size());
  return text && std::string_view(begin.data(), begin.size()) ==
                     "\x7f"
                     "ELF";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lines)

BOOST_AUTO_TEST_CASE(no_compiled_program_is_committed) {
  int files = 0;
  const auto read = [&](const std::filesystem::directory_entry& entry) {
    if (!entry.is_regular_file()) return;
    ++files;
    if (is_compiled(entry.path()))
      BOOST_ERROR(std::filesystem::relative(entry.path(), top).string() << ": a compiled program among the sources");
  };
  BOOST_TEST(is_compiled("/proc/self/exe"));
  for (const auto& entry : std::filesystem::directory_iterator(top)) read(entry);
  for (const char* folder : folders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / folder)) read(entry);
  BOOST_CHECK_MESSAGE(files >= 1000, files << " files: were the folders read?");
}

BOOST_AUTO_TEST_CASE(a_wide_line_is_found) {
  std::istringstream text("short\n" + std::string(120, 'a') + "\n" + std::string(121, 'a') + "\n" +
                          std::string(119, 'a') + "\u00b5\n");
  BOOST_TEST(wide_lines(text) == std::vector<int>{3}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_script_has_one) {
  const std::set<std::string> endings{".py", ".sh", ".c", ".m", ".f90", ".cmake"},
      names{"CMakeLists.txt", "steps.toml"};
  int files = 0;
  const auto read = [&](const std::filesystem::path& file) {
    ++files;
    std::ifstream text(file);
    for (const int line : wide_lines(text))
      BOOST_ERROR(std::filesystem::relative(file, top).string() << ":" << line << ": wider than 120 columns");
  };
  for (const char* file : {"Makefile", "CMakeLists.txt"}) read(top / file);
  for (const char* folder : folders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / folder))
      if (endings.contains(entry.path().extension().string()) || names.contains(entry.path().filename().string()))
        read(entry.path());
  BOOST_CHECK_MESSAGE(files >= 50, files << " scripts: were the folders read?");
}

BOOST_AUTO_TEST_CASE(the_root_readme_stays_short) {
  constexpr int most = 120;
  std::ifstream text(top / "README.md");
  int lines = 0;
  for (std::string line; std::getline(text, line);) ++lines;
  BOOST_CHECK_MESSAGE(lines > 0, "README.md was not read");
  BOOST_CHECK_MESSAGE(lines <= most, "README.md has " << lines << " lines; allowed are " << most
                                                      << ": what is longer belongs on a page of docs/");
}

BOOST_AUTO_TEST_SUITE_END()
