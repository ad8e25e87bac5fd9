// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of --plot: SVG or PNG by the end of the name, with and without the program that makes PNG.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"
#include "verification/report/heading.hpp"
#include "verification/report/svg.hpp"

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

struct Title {
  std::string text;
  double left = 0, figure_width = 0;
};

/// The titles of all figures within a picture, with the width of the figure that holds each.
std::vector<Title> titles_of(const std::string& picture) {
  std::vector<Title> titles;
  std::vector<double> widths;  // of the figures around
  const auto number_behind = [&](const std::string& word, std::size_t at) {
    return std::stod(picture.substr(picture.find(word, at) + word.size()));
  };
  for (std::size_t at = 0; (at = picture.find('<', at)) != std::string::npos; ++at) {
    if (picture.compare(at, 5, "<svg ") == 0) widths.push_back(number_behind("viewBox=\"0 0 ", at));
    if (picture.compare(at, 6, "</svg>") == 0) widths.pop_back();
    const std::size_t begin = picture.find('>', at) + 1;
    if (picture.compare(at, 6, "<text ") != 0 ||
        picture.substr(at, begin - at).find("class=\"head\"") == std::string::npos)
      continue;
    std::string text = picture.substr(begin, picture.find("</text>", begin) - begin);
    text = std::regex_replace(text, std::regex("<[^>]*>"), "");
    text = std::regex_replace(text, std::regex("&[a-z]+;"), "&");  // as wide as the widest of < > &
    titles.push_back({text, number_behind(" x=\"", at), widths.back()});
  }
  return titles;
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
  titles("iso-6-rollers", {"Contact force of each roller;</text>", "the external load points down</text>",
                           "Contact force over the azimuth", "Displacement over the azimuth"});
  titles("iso-6-rollers na4908", {"iso-6-rollers: contact force", "na4908: contact force",
                                  "iso-6-rollers: displacement", "na4908: displacement"});
}

// A bare Debian draws them in DejaVu Sans Bold, the widest type of the list.
BOOST_AUTO_TEST_CASE(every_title_fits_its_figure) {
  const test::Folder folder;
  const std::string long_id = "a-needle-roller-bearing-of-the-gearbox-with-the-widest-name-of-all";
  const auto made = [&](const std::string& from, const std::string& id, const std::string& title) {
    std::string text = test::read(std::filesystem::path(EHD_SOURCE_DIR) / "cases" / (from + ".toml"));
    const auto set = [&](const std::string& key, const std::string& value) {
      const auto at = text.find("\n" + key + " = ") + 1;
      text.replace(at, text.find('\n', at) - at, key + " = \"" + value + "\"");
    };
    set("id", id), set("title", title);
    return folder.write(id + ".toml", text).string();
  };
  const std::string wide_title =
      "WWWWWWWW MMMMMMMM of a wide title, < & >: " + std::string(60, 'W') + " at the heaviest load of all";
  const std::string contact = made("dry-steel", "wide-contact", wide_title),
                    bearing = made("na4908", long_id, wide_title);
  const auto file = folder.path() / "a.svg";
  (void)test::ehd_run(folder, "solve " + contact + " --plot " + file.string());
  const std::vector<Title> whole = titles_of(test::read(file));  // to its end, in several lines
  BOOST_TEST(std::any_of(whole.begin(), whole.end(), [](const Title& line) { return line.text.ends_with(" of all"); }));
  const std::vector<std::string> figures{"solve dry-steel",
                                         "solve own-moes-5-5 --tolerance 1e-2",
                                         "solve " + contact,
                                         "bearing na4908 --law hertz",
                                         "bearing " + bearing + " --law hertz",
                                         "bearing na4908 na4908-10um --law hertz",
                                         "bearing " + bearing + " na4908 --law hertz",
                                         "bearing na4908 na4908-2.5um na4908-10um " + bearing + " --law hertz"};
  for (const std::string& figure : figures) {
    BOOST_TEST(test::ehd_run(folder, figure + " --plot " + file.string()).exit_code == 0, figure);
    const std::vector<Title> titles = titles_of(test::read(file));
    BOOST_TEST(!titles.empty(), figure);
    for (const Title& title : titles)
      BOOST_TEST(title.left + ehd::report::heading_width(ehd::report::literal(title.text)) <= title.figure_width,
                 figure + ": " + title.text + " is wider than its figure");
  }
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
