// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>

#include "cli/output.hpp"
#include "cli/usage.hpp"

namespace ehd::cli {

namespace {

/// CLI11 adds its help to some messages: only the first line is wanted.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

Option& Option::called(const std::string& value_name) {
  option_.type_name(value_name);
  return *this;
}

Option& Option::required() {
  option_.required();
  return *this;
}

Option& Option::showing_default() {
  option_.capture_default_str();
  return *this;
}

Option& Option::excluding(const Option& other) {
  option_.excludes(&other.option_);
  return *this;
}

void Command::summary(const std::string& line) { app_.description(line); }

void Command::examples(const std::string& text) { app_.footer(text); }

Option Command::text(const std::string& name, std::string& value, const std::string& help) {
  return Option(*app_.add_option(name, value, help));
}

Option Command::text(const std::string& name, std::optional<std::string>& value, const std::string& help) {
  return Option(*app_.add_option(name, value, help));
}

Option Command::list(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  CLI::Option* option = app_.add_option(name, values, help);
  if (name.starts_with("--")) option->allow_extra_args(false);
  return Option(*option);
}

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(*app_.add_flag(name, value, help));
}

void Command::runs(std::function<int()> body) {
  app_.callback([&exit_code = exit_code_, body = std::move(body)] { exit_code = run_guarded(body); });
}

int run_command_line(const Program& program, int argc, char** argv) {
  int exit_code = success;
  CLI::App app(program.summary, program.name);
  app.set_version_flag("--version", program.name + " " + program.version, "Print the version");
  app.footer(program.examples);
  app.require_subcommand(0, 1);
  for (const Subcommand& subcommand : program.subcommands) {
    Command command(*app.add_subcommand(subcommand.name), exit_code);
    subcommand.describe(command);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return success;
  } catch (const CLI::Success&) {  // --help, of the program or of a subcommand
    const auto chosen = app.get_subcommands();
    print(chosen.empty() ? app.help() : chosen.front()->help(program.name));
    return success;
  } catch (const CLI::ParseError& error) {
    complain(program.name + ": " + first_line(error.what()) + "; " + program.name + " --help shows what is allowed");
    return bad_input;
  }
  if (app.get_subcommands().empty()) print(app.help());
  return exit_code;
}

}  // namespace ehd::cli
