// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of --plot: SVG or PNG by the end of the name, with and without the program that makes PNG.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd::verification;

namespace {

const std::string plotted = "solve dry-steel --plot ";
const std::string png_signature = "\x89PNG\r\n\x1a\n";

/// Another PATH for the programs that the test starts.
class Path {
 public:
  explicit Path(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
  ~Path() { ::setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_ = std::getenv("PATH");
};

/// A folder with an rsvg-convert that does this, as the PATH wants it, before /bin.
std::string converter_that(const test::Folder& folder, const std::string& script) {
  const auto program = folder.write("rsvg-convert", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return folder.path().string() + ":/bin";
}

/// Four bytes, the most significant first.
int number_at(const std::string& bytes, std::size_t at) {
  int number = 0;
  for (std::size_t i = at; i < at + 4; ++i) number = 256 * number + static_cast<unsigned char>(bytes[i]);
  return number;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(picture_file)

BOOST_AUTO_TEST_CASE(the_end_of_the_name_says_what_the_picture_is) {
  const test::Folder folder;
  for (const char* name : {"a.svg", "b.SVG", "without-ending"}) {
    const auto file = folder.path() / name;
    BOOST_TEST(test::ehd_run(folder, plotted + file.string()).exit_code == 0);
    BOOST_TEST(test::read(file).find("<svg") != std::string::npos);
  }
  for (const char* name : {"a.pdf", "a.PDF", "a.svg.gz"})
    test::check_refused(folder, plotted + (folder.path() / name).string(), "allowed is .svg or .png");
  test::check_refused(folder, "bearing na4908 --plot " + (folder.path() / "a.pdf").string(), "allowed is .svg or .png");
}

BOOST_AUTO_TEST_CASE(every_panel_of_a_bearing_has_a_title) {
  const test::Folder folder;
  const auto file = folder.path() / "a.svg";
  const auto titles = [&](const std::string& cases, const std::vector<std::string>& named) {
    BOOST_TEST(test::ehd_run(folder, "bearing " + cases + " --law hertz --plot " + file.string()).exit_code == 0);
    const std::string picture = test::read(file);
    for (const std::string& title : named) BOOST_TEST(picture.find(">" + title) != std::string::npos, title);
  };
  titles("iso-6-rollers", {"Contact force of each roller; the external load points down",
                           "Contact force over the azimuth", "Displacement over the azimuth"});
  titles("iso-6-rollers na4908", {"iso-6-rollers: contact force", "na4908: contact force",
                                  "iso-6-rollers: displacement", "na4908: displacement"});
}

BOOST_AUTO_TEST_CASE(a_png_has_two_pixels_for_each_unit_of_the_figure) {
  if (std::system("command -v rsvg-convert > /dev/null") != 0) {
    BOOST_TEST_MESSAGE("skipped: rsvg-convert is not installed (librsvg2-bin)");
    return;
  }
  const test::Folder folder;
  for (const std::string& command : {plotted, std::string("bearing iso-6-rollers --law hertz --plot ")}) {
    const auto png = folder.path() / "a.png", svg = folder.path() / "a.svg";
    BOOST_TEST(test::ehd_run(folder, command + png.string()).exit_code == 0);
    BOOST_TEST(test::ehd_run(folder, command + svg.string()).exit_code == 0);
    const std::string bytes = test::read(png), text = test::read(svg);
    BOOST_REQUIRE(bytes.starts_with(png_signature));
    const int width = std::atoi(text.c_str() + text.find(" width=\"") + 8);
    BOOST_TEST(number_at(bytes, 16) == 2 * width);  // IHDR begins with the width
    BOOST_TEST(bytes.find("IEND") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(without_the_program_that_makes_png_one_line_names_its_package) {
  const test::Folder folder, nothing;
  const auto png = folder.path() / "a.png";
  const Path path(nothing.path().string());
  test::check_refused(folder, plotted + png.string(), "librsvg2-bin");
  BOOST_TEST(!std::filesystem::exists(png));
  BOOST_TEST(test::ehd_run(folder, plotted + (folder.path() / "a.svg").string()).exit_code == 0);
}

BOOST_AUTO_TEST_CASE(the_program_that_makes_png_reads_the_svg_and_its_bytes_are_the_file) {
  const test::Folder folder, programs;
  const auto png = folder.path() / "a.PNG", svg = folder.path() / "a.svg";
  const Path path(converter_that(programs, "echo \"$@\"; cat"));
  BOOST_TEST(test::ehd_run(folder, plotted + png.string()).exit_code == 0);
  BOOST_TEST(test::ehd_run(folder, plotted + svg.string()).exit_code == 0);
  BOOST_TEST(test::read(png) == "--format=png --zoom=2\n" + test::read(svg));
}

BOOST_AUTO_TEST_CASE(a_program_that_fails_leaves_the_file_that_was_there) {
  const test::Folder folder, programs;
  const auto png = folder.write("a.png", "the picture before");
  const Path path(converter_that(programs, "[ \"$1\" = --version ] && exit 0; printf part; echo no fonts >&2; exit 3"));
  test::check_refused(folder, plotted + png.string(), "a.png: rsvg-convert: exit code 3: no fonts");
  BOOST_TEST(test::read(png) == "the picture before");
  BOOST_TEST(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 3);  // and the two outputs
}

BOOST_AUTO_TEST_SUITE_END()
