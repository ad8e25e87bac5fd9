// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion.hpp"

#include <fmt/format.h>

#include "cli/usage.hpp"

namespace ehd::cli {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string assigned(const char* name, const std::vector<std::string>& words) {
  return words.empty() ? "" : fmt::format("; {}=\"{}\"", name, joined(words));
}

/// The words that may follow the option before the word.
std::string chosen_words(const std::vector<std::pair<std::string, std::string>>& with_word) {
  std::string rows;
  for (const auto& [option, words] : with_word) rows += fmt::format(" {}) words=\"{}\" ;;", option, words);
  std::erase(rows, ',');
  return rows.empty() ? "" : fmt::format("; case \"$before\" in{} esac", rows);
}

/// For bash; zsh runs it too, by its bashcompinit. Names of files complete where no word does. Bash makes "=" a word of
/// its own: --json=FILE is three words, --set KEY=VALUE four.
std::string function_of(const std::string& program, const std::vector<CommandWords>& commands) {
  std::string names, branches;
  for (const CommandWords& command : commands) {
    if (command.name.empty()) continue;
    names += " " + command.name;
    std::string first = command.first;
    std::erase(first, ',');
    branches += fmt::format("    {}) options=\"{}\"{}{}{}{}{} ;;\n", command.name, joined(command.options),
                            assigned("with_case", command.with_case), assigned("with_value", command.with_value),
                            command.takes_cases ? "; cases=yes" : "",
                            first.empty() ? "" : fmt::format("; first=\"{}\"", first), chosen_words(command.with_word));
  }
  constexpr const char* whole = R"sh(_{program}() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="" equals="" options="" with_case="" with_value="" cases="" words=""
  local first=""
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{words}{names}" -- "$word"))
    return
  fi
  before="${{COMP_WORDS[COMP_CWORD-1]}}"
  if [ "$word" = "=" ]; then
    word="" equals=yes
  elif [ "$before" = "=" ]; then
    before="${{COMP_WORDS[COMP_CWORD-2]}}" equals=yes
  fi
  case "$equals$before" in yes-*) ;; yes*) return ;; esac
  case "${{COMP_WORDS[1]}}" in
{branches}  esac
  case "$COMP_CWORD$word" in 2-*) ;; 2*) [ -z "$words" ] && words="$first" ;; esac
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    return
  fi
  case " $with_case " in *" $before "*) cases=yes ;; esac
  case " $with_value " in *" $before "*) return ;; esac
  case "$word" in
    -*) COMPREPLY=($(compgen -W "$options" -- "$word")) ;;
    *) [ -z "$cases" ] || COMPREPLY=($(compgen -W "$({program} cases 2> /dev/null)sh"
                                R"sh( | sed -n '2,/^$/s/ .*//p')" -- "$word")) ;;
  esac
}}
complete -o default -F _{program} {program}
)sh";
  return fmt::format(whole, fmt::arg("program", program), fmt::arg("words", joined(commands.front().options)),
                     fmt::arg("names", names), fmt::arg("branches", branches));
}

}  // namespace

std::string completion_script(const std::string& program, const std::vector<CommandWords>& commands,
                              const std::string& shell) {
  if (shell == "bash") return function_of(program, commands);
  if (shell == "zsh")
    return fmt::format("#compdef {}\nautoload -U +X bashcompinit && bashcompinit\n{}", program,
                       function_of(program, commands));
  throw unknown_word_error("--completion", shell, completion_shells);
}

}  // namespace ehd::cli
