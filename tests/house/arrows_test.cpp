// SPDX-License-Identifier: GPL-3.0-or-later
// Which room may include which. A room includes its own headers and those of the rooms below it, never one above:
//
//   contact <- reference | fast | bearing <- workflow <- io <- verification | bindings;  verification <- cli
//
// reference/ and fast/ never see each other, io/ knows solvers by workflow/registry.hpp alone, and verification/report/
// knows JSON alone.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// A room or a part of one, with the rooms that it may include beside itself.
const std::map<std::string, std::set<std::string>> allowed_includes{
    {"contact", {}},
    {"reference", {"contact"}},
    {"fast", {"contact"}},
    {"bearing", {"contact"}},
    {"workflow", {"contact", "reference", "fast", "bearing"}},
    {"io", {"contact", "bearing", "workflow"}},
    {"bindings", {"contact", "bearing", "workflow", "io"}},
    {"verification/report", {"contact", "bearing", "workflow", "io"}},
    {"verification", {"contact", "reference", "fast", "bearing", "workflow", "io", "verification/report"}},
    {"cli", {"contact", "bearing", "workflow", "io", "verification/report", "verification"}},
};

/// The longest name in `allowed_includes` that the path begins with; empty for a header from outside.
std::string room_of(const std::string& path) {
  std::string room;
  for (const auto& arrow : allowed_includes)
    if (path.starts_with(arrow.first + "/") && arrow.first.size() > room.size()) room = arrow.first;
  return room;
}

/// A header of this project that no room holds: cmake/commit.cmake writes it into the build folder.
const std::string generated = "ehd_commit.hpp";

/// The includes of a source text that its room must not have. A header in quotes names its room; so a path that is
/// relative, or within the room, is one of them.
std::vector<std::string> forbidden(const std::string& room, std::istream& source) {
  const std::regex include(R"(^\s*#\s*include\s*(["<])([^">]+)[">].*)");
  std::vector<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(source, line);) {
    if (!std::regex_match(line, match, include)) continue;
    const std::string header = match[2], other = room_of(header);
    const bool outside = other.empty() && (match[1] == "<" || header == generated);
    if (outside || other == room || (!other.empty() && allowed_includes.at(room).contains(other))) continue;
    found.push_back(header);
  }
  return found;
}

bool is_source(const std::filesystem::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp" || file.extension() == ".ipp" ||
         file.extension() == ".h";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(arrows)

BOOST_AUTO_TEST_CASE(an_include_against_the_arrows_is_found) {
  std::istringstream upwards("#include <map>\n#include \"io/json.hpp\"\n#include \"contact/hertz.hpp\"\n");
  BOOST_TEST(forbidden("workflow", upwards) == std::vector<std::string>{"io/json.hpp"},
             boost::test_tools::per_element());
  std::istringstream sideways("#include \"fast/mapped.hpp\"\n");
  BOOST_TEST(forbidden("reference", sideways).size() == 1);
  std::istringstream into_the_report("#include \"verification/claim.hpp\"\n");
  BOOST_TEST(forbidden("verification/report", into_the_report).size() == 1);
}

BOOST_AUTO_TEST_CASE(every_way_to_write_an_include_is_read) {
  std::istringstream written(
      "#include <io/json.hpp>\n  #  include \"io/csv.hpp\"  // why\n#include \"../io/text.hpp\"\n"
      "#include \"hertz.hpp\"\n#include <fmt/format.h>\n#include \"ehd_commit.hpp\"\n");
  const std::vector<std::string> found{"io/json.hpp", "io/csv.hpp", "../io/text.hpp", "hertz.hpp"};
  BOOST_TEST(forbidden("workflow", written) == found, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_room_includes_one_above_it) {
  const std::filesystem::path top(EHD_SOURCE_DIR);
  std::map<std::string, int> files;
  for (const auto& arrow : allowed_includes)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / arrow.first)) {
      const std::string name = std::filesystem::relative(entry.path(), top).string();
      if (!is_source(entry.path()) || room_of(name) != arrow.first) continue;
      ++files[arrow.first];
      std::ifstream source(entry.path());
      for (const std::string& header : forbidden(arrow.first, source))
        BOOST_ERROR(name << " includes " << header << ", which " << arrow.first
                         << "/ must not see, or which does not begin with its room");
    }
  for (const auto& arrow : allowed_includes)
    BOOST_CHECK_MESSAGE(files[arrow.first] >= 5,
                        arrow.first << "/ has " << files[arrow.first] << " sources: was it read?");
}

BOOST_AUTO_TEST_SUITE_END()
