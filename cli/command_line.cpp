// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/completion.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "cli/usage.hpp"
#include "io/case_keys.hpp"
#include "io/near_miss.hpp"

namespace ehd::cli {

namespace {

/// The first line of a message of CLI11, which adds its help to some. "--json: 1 required TEXT missing" becomes
/// "--json: has no value", and "--json: At Most 1 required but received 2" becomes "--json: is given more than once".
std::string said_by(const CLI::ParseError& error) {
  const std::string text = error.what(), line = text.substr(0, text.find('\n'));
  const std::size_t none = line.find(": 1 required "), several = line.find(": At Most 1 required ");
  if (none != std::string::npos && line.ends_with(" missing")) return line.substr(0, none) + ": has no value";
  return several == std::string::npos ? line : line.substr(0, several) + ": is given more than once";
}

/// What may stand where an unknown word stands: options for one that begins with a dash, else subcommands.
std::vector<std::string> names_like(const std::string& word, CLI::App& app) {
  std::vector<std::string> names;
  if (word.starts_with('-')) {
    for (const CLI::Option* option : app.get_options())
      if (!option->get_positional()) names.push_back(option->get_name());
  } else {
    for (const CLI::App* subcommand : app.get_subcommands({})) names.push_back(subcommand->get_name());
  }
  return names;
}

/// The arguments of a command without a dash: "one CASE", "WHAT, CASE".
std::string arguments_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) names.push_back(option->get_name());
  return names.empty() ? "options alone" : (names.size() == 1 ? "one " : "") + list(names);
}

/// "--tolerence: unknown; did you mean --tolerance? ..." `command`: "ehd solve", whose help shows what is allowed.
std::string unknown_word(CLI::App& app, const std::string& command) {
  const std::string given = app.remaining().front();
  if (!given.starts_with('-') && app.get_subcommands({}).empty())
    return fmt::format("{}: is one argument too many; allowed is {}; {} --help shows more", given, arguments_of(app),
                       command);
  const std::string word = given.substr(0, given.starts_with("--") ? given.find('=') : std::string::npos);
  return fmt::format("{}: unknown; {}{} --help shows what is allowed", word, did_you_mean(word, names_like(word, app)),
                     command);
}

/// "--json: stands before solve; allowed is behind it, ehd solve --help shows what"
std::string word_before(const std::string& word, const std::string& subcommand, const std::string& command) {
  return fmt::format("{}: stands before {}; allowed is behind it, {} --help shows what", word, subcommand, command);
}

/// What takes less memory, of the options that the command has. Empty: none.
std::string needs_less_memory(const CLI::App& app) {
  std::string advice;
  for (const char* less : {"a smaller --nodes", "a larger --tolerance", "a smaller --threads"}) {
    const std::string name = less + std::string_view(less).find("--");
    const CLI::Option* nodes = app.get_option_no_throw("--nodes");
    if (name == "--tolerance" && nodes && nodes->count() > 0) continue;  // they exclude each other
    if (app.get_option_no_throw(name)) advice += (advice.empty() ? "" : " or ") + std::string(less);
  }
  return advice.empty() ? "" : advice + " needs less";
}

/// The options of a command with their names, for the shell that completes them.
CommandWords words_of(const std::string& name, const CLI::App& app, const WordsOfOptions& values) {
  CommandWords words{.name = name, .options = {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      words.takes_cases = words.takes_cases || option->get_name() == "CASE" || option->get_name() == "ID";
      if (const auto known = values.find(option); known != values.end()) words.first = known->second;
      continue;
    }
    words.options.push_back(option->get_name());
    if (const auto known = values.find(option); known != values.end())
      words.with_word.emplace_back(option->get_name(), known->second);
    else if (option->get_items_expected_max() > 0)
      (option->get_type_name() == "CASE" ? words.with_case : words.with_value).push_back(option->get_name());
  }
  return words;
}

std::vector<CommandWords> words_of(const CLI::App& app, const WordsOfOptions& values) {
  std::vector<CommandWords> words{words_of("", app, values)};
  for (const CLI::App* subcommand : app.get_subcommands({}))
    words.push_back(words_of(subcommand->get_name(), *subcommand, values));
  return words;
}

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

Option& Option::completed_by(const std::string& words) {
  words_[&option_] = words;
  return *this;
}

void Command::summary(const std::string& line) { app_.description(line); }

void Command::examples(const std::string& text) { app_.footer(text); }

Option Command::text(const std::string& name, std::string& value, const std::string& help) {
  return {*app_.add_option(name, value, help), words_};
}

Option Command::text(const std::string& name, std::optional<std::string>& value, const std::string& help) {
  return {*app_.add_option(name, value, help), words_};
}

Option Command::list(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  CLI::Option* option = app_.add_option(name, values, help);
  if (name.starts_with("--")) option->allow_extra_args(false);
  return {*option, words_};
}

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return {*app_.add_flag(name, value, help), words_};
}

void Command::runs(std::function<int()> body) {
  app_.callback([&app = app_, &exit_code = exit_code_, body = std::move(body)] {
    exit_code = run_guarded(body, needs_less_memory(app));
  });
}

int run_command_line(const Program& program, int argc, char** argv) {
  int exit_code = success;
  WordsOfOptions words;
  CLI::App app(program.summary, program.name);
  app.set_version_flag(
      "--version", [&program] { return program.name + " " + program.version(); }, "Print the version");
  std::optional<std::string> shell;
  app.add_option("--completion", shell, std::string("Print a completion script for a shell: ") + completion_shells)
      ->type_name("SHELL");
  app.footer(program.examples);
  app.require_subcommand(0, 1);
  for (const Subcommand& subcommand : program.subcommands) {
    Command command(*app.add_subcommand(subcommand.name), exit_code, words);
    subcommand.describe(command);
  }
  const auto chosen = [&]() -> CLI::App& {
    const auto subcommands = app.get_subcommands();
    return subcommands.empty() ? app : *subcommands.front();
  };
  const auto show_help = [&] { print(help_page(&chosen() == &app ? app.help() : chosen().help(program.name))); };
  const auto refuse = [&](const CLI::ParseError* error) {
    const std::string command = program.name + (&chosen() == &app ? "" : " " + chosen().get_name());
    std::string why;
    if (error)
      why = fmt::format("{}; {} --help shows what is allowed", said_by(*error), command);
    else if (chosen().remaining().empty())  // the word that is too many stands before the subcommand
      why = word_before(app.remaining().front(), chosen().get_name(), command);
    else
      why = unknown_word(chosen(), command);
    complain(program.name + ": " + why);
    return bad_input;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return success;
  } catch (const CLI::Success&) {  // --help, of the program or of a subcommand
    if (&chosen() == &app && !app.remaining().empty()) return refuse(nullptr);  // ehd frobnicate --help
    show_help();
    return success;
  } catch (const CLI::ExtrasError&) {
    if (app.remaining() != std::vector<std::string>{"help"} ||
        chosen().remaining().size() > (&chosen() == &app ? 1 : 0))
      return refuse(nullptr);
    show_help();  // ehd help, ehd help solve
    return success;
  } catch (const CLI::ParseError& error) {
    return refuse(&error);
  }
  if (shell)
    return run_guarded([&] {
      print(completion_script(program.name, words_of(app, words), *shell));
      return success;
    });
  if (!app.get_subcommands().empty()) return exit_code;
  if (argc > 1) {  // ehd -- solve
    complain(fmt::format("{0}: {1}: is no subcommand; {0} --help shows what is allowed", program.name, argv[1]));
    return bad_input;
  }
  show_help();
  return success;
}

}  // namespace ehd::cli
