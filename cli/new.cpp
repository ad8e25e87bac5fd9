// SPDX-License-Identifier: GPL-3.0-or-later
// ehd new: a commented case to start from, the table of all keys, and the types of bearings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/case_template.hpp"
#include "io/case_text.hpp"
#include "io/output_file.hpp"
#include "io/tables.hpp"

namespace ehd::cli {

namespace {

struct NewOptions {
  std::string what;
  std::optional<std::string> file, type;
};

const char* const new_examples = R"(
Examples:
  ehd new contact my-contact.toml      a contact in SI, its oil by ISO VG grade
  ehd new bearing my-bearing.toml      a cylindrical roller bearing
  ehd new bearing                      the same on standard output
  ehd new bearing --type NN            with a comment that says how two rows are stated
  ehd new types                        the types of bearings, and how each is stated
  ehd new keys                         every key of a case as a table (Markdown)

Each key stands with its unit, default and meaning. Optional keys, and the other ways to state the same, are comments.
A file that exists is never overwritten. The id of a case is the name of its file, also where the shell writes it:
ehd new contact > NAME.toml. In a pipe the case is called my-contact or my-bearing. docs/your-bearing.md and
docs/your-contact.md go through one case each.)";

std::string names_of_types() {
  std::vector<std::string_view> names;
  for (const BearingType& type : bearing_types) names.push_back(type.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string bearing_text(const NewOptions& options, const std::string& id) {
  if (!options.type) return case_template(CaseKind::bearing, id);
  for (const BearingType& type : bearing_types)
    if (type.name == *options.type) return bearing_template(type, id);
  throw unknown_word_error("--type", *options.type, names_of_types());
}

/// A table: type, how it is built, how it is stated.
std::string types_text() {
  std::string text;
  for (const BearingType& type : bearing_types)
    text += wrapped(fmt::format("{:5} {}. {}", type.name, type.what, type.stated), "      ");
  return text;
}

std::string text_of(const NewOptions& options, const std::string& id) {
  if (options.what == "bearing") return bearing_text(options, id);
  if (options.type) throw option_error("--type", *options.type, "is of a bearing; allowed is WHAT = bearing with it");
  if (options.what == "contact") return case_template(CaseKind::contact, id);
  if (options.what != "keys" && options.what != "types")
    throw unknown_word_error("WHAT", options.what, "contact, bearing, keys, types");
  if (options.file) throw option_error("WHAT", options.what, "is for standard output; allowed is no FILE with it");
  return options.what == "keys" ? case_key_tables() : types_text();
}

/// The id of a case on standard output: the name of the file NAME.toml to which the shell sends it, because a case has
/// the name of its file. Absent where standard output is no such file, or where the system does not tell its name.
std::optional<std::string> id_of_standard_output() {
  std::error_code none;
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/fd/1", none);
  if (ending_of(file) != ".toml" || !std::filesystem::is_regular_file(file, none)) return std::nullopt;
  return id_of_file(file);
}

int make_new(const NewOptions& options) {
  if (!options.file) {
    const bool is_case = options.what == "contact" || options.what == "bearing";
    print(text_of(options, (is_case ? id_of_standard_output() : std::nullopt).value_or("my-" + options.what)));
    return success;
  }
  const std::filesystem::path file = *options.file;
  if (ending_of(file) != ".toml")
    throw option_error("FILE", *options.file, "is no name of a case file; allowed is NAME.toml");
  write_new_file(file, text_of(options, id_of_file(file)));
  return success;
}

}  // namespace

void describe_new(Command& command) {
  auto options = std::make_shared<NewOptions>();
  command.summary("A commented case file to start from");
  command.examples(new_examples);
  command.text("WHAT", options->what, "contact, bearing, keys, or types")
      .required()
      .completed_by("contact, bearing, keys, types");
  command.text("FILE", options->file, "a new file, NAME.toml (standard output)");
  command.text("--type", options->type, "of a bearing: NU, NJ, ...; ehd new types shows all");
  command.runs([options] { return make_new(*options); });
}

}  // namespace ehd::cli
