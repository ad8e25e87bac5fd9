// SPDX-License-Identifier: GPL-3.0-or-later
// Files of every kind: read, or refused before a byte is read. tests/faults/files.py asks the same of the program.
#include "io/file_text.hpp"

#include <sys/stat.h>

#include <boost/test/unit_test.hpp>
#include <string>

#include "tests/files.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using verification::test::Folder;

namespace {

constexpr FileKind small_file{.name = "a small file", .most_bytes = 8};

std::string file_refusal(const std::filesystem::path& file) {
  try {
    (void)text_of_file(file, small_file);
  } catch (const CaseError& error) {
    const std::string what = error.what();
    BOOST_TEST(what.starts_with(file.string() + ": "));
    BOOST_TEST(what.ends_with("; allowed is a small file"));
    return what;
  }
  return "read";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(file_text)

BOOST_AUTO_TEST_CASE(a_file_is_read_up_to_the_size_that_is_allowed) {
  const Folder folder;
  const std::string bytes(
      "ab\0\nef\xff"
      "h",
      8);
  BOOST_TEST(text_of_file(folder.write("eight", bytes), small_file) == bytes);
  BOOST_TEST(text_of_file(folder.write("none", ""), small_file) == "");
  BOOST_TEST(file_refusal(folder.write("nine", bytes + "i")).find("is larger than") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_no_file_is_refused_and_never_waited_for) {
  const Folder folder;
  const auto pipe = folder.path() / "pipe", zero = folder.path() / "zero", loop = folder.path() / "loop";
  BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::filesystem::create_symlink("/dev/zero", zero);
  std::filesystem::create_symlink("loop", loop);
  const auto says = [](const std::string& message, const std::string& text) {
    BOOST_TEST(message.find(text) != std::string::npos, message);
  };
  says(file_refusal(pipe), "is not a regular file");
  says(file_refusal(zero), "is not a regular file");
  says(file_refusal(loop), "cannot be read (");
  says(file_refusal(folder.path()), "is a directory");
  says(file_refusal(folder.path() / "missing"), "there is no such file");
  says(file_refusal(folder.path() / std::string(300, 'n')), "cannot be read (");
}

BOOST_AUTO_TEST_CASE(only_a_missing_file_is_absent) {
  const Folder folder;
  BOOST_TEST(!text_if_there(folder.path() / "missing", small_file));
  BOOST_TEST(text_if_there(folder.write("there", "x"), small_file).value() == "x");
  BOOST_CHECK_THROW((void)text_if_there(folder.path(), small_file), CaseError);
}

BOOST_AUTO_TEST_SUITE_END()
