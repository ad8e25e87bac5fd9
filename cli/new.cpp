// SPDX-License-Identifier: GPL-3.0-or-later
// ehd new: a commented case to start from, and the table of all keys.
#include <memory>
#include <optional>
#include <string>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/case_template.hpp"
#include "io/case_text.hpp"
#include "io/output_file.hpp"

namespace ehd::cli {

namespace {

struct NewOptions {
  std::string what;
  std::optional<std::string> file;
};

const char* const new_examples = R"(
Examples:
  ehd new contact my-contact.toml      a contact in SI, its oil by ISO VG grade
  ehd new bearing my-bearing.toml      a cylindrical roller bearing
  ehd new bearing                      the same on standard output
  ehd new keys                         every key of a case as a table (Markdown)

Each key stands with its unit, default and meaning. Optional keys, and the other ways to state the same, are comments.
A file that exists is never overwritten. No option names the type of a bearing. NU, NJ, NUP, N and NA have one template:
they differ in flanges, and a radial load does not use these. docs/your-bearing.md shows how to state the other types,
and goes through one case. docs/your-contact.md goes through a contact.)";

std::string text_of(const NewOptions& options, const std::string& id) {
  if (options.what == "contact") return case_template(CaseKind::contact, id);
  if (options.what == "bearing") return case_template(CaseKind::bearing, id);
  if (options.what == "keys" && !options.file) return case_key_tables();
  if (options.what == "keys")
    throw option_error("WHAT", options.what, "is for standard output; allowed is no FILE with it");
  throw unknown_word_error("WHAT", options.what, "contact, bearing, keys");
}

int make_new(const NewOptions& options) {
  if (!options.file) {
    print(text_of(options, "my-" + options.what));
    return success;
  }
  const std::filesystem::path file = *options.file;
  if (file.extension() != ".toml")
    throw option_error("FILE", *options.file, "is no name of a case file; allowed is NAME.toml");
  write_new_file(file, text_of(options, id_of_file(file)));
  return success;
}

}  // namespace

void describe_new(Command& command) {
  auto options = std::make_shared<NewOptions>();
  command.summary("A commented case file to start from");
  command.examples(new_examples);
  command.text("WHAT", options->what, "contact, bearing, or keys").required();
  command.text("FILE", options->file, "a new file, NAME.toml (standard output)");
  command.runs([options] { return make_new(*options); });
}

}  // namespace ehd::cli
