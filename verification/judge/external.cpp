// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/external.hpp"

#include <fmt/format.h>
#include <stdlib.h>  // mkdtemp

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <variant>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/near_miss.hpp"
#include "io/output_file.hpp"
#include "io/problem_json.hpp"
#include "io/temporary_files.hpp"
#include "verification/judge/hints.hpp"
#include "verification/judge/score.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

namespace {

/// mkdtemp replaces the six letters.
constexpr std::size_t unique_letters = 6;
constexpr std::string_view case_word = "{case}", out_word = "{out}", tolerance_word = "{tolerance}";

/// A folder that goes with its files, also by a signal.
class Exchange {
 public:
  Exchange() {
    std::error_code error;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
    std::string name = (temporary / ("ehd-external-" + std::string(unique_letters, 'X'))).string();
    if (!error && !::mkdtemp(name.data())) error = {errno, std::generic_category()};
    if (error)
      throw OutputError(fmt::format("TMPDIR: no folder can be made there ({}); allowed is a folder that may be written",
                                    error.message()));
    folder_ = name;
    folder_note_ = TemporaryNote(name);
    case_note_ = TemporaryNote(problem().string());
    out_note_ = TemporaryNote(submission().string());
  }
  ~Exchange() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  [[nodiscard]] std::filesystem::path problem() const { return folder_ / "case.json"; }
  [[nodiscard]] std::filesystem::path submission() const { return folder_ / "submission.json"; }

 private:
  std::filesystem::path folder_;
  TemporaryNote folder_note_, case_note_, out_note_;
};

void replace(std::string& text, std::string_view word, const std::string& by) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

/// The submission's result for this case.
const SubmittedResult& result_in(const Submission& submission, const Case& contact_case) {
  for (const SubmittedResult& result : submission.results) {
    if (result.case_id != contact_case.id) continue;
    if (result.version != contact_case.version)
      throw refusal(result.place, fmt::format("version = {}: is not the one asked for; allowed is {}", result.version,
                                              contact_case.version));
    const auto is_judged = [](const SubmittedNumber& number) {
      return std::ranges::find(judged_films, number.quantity) != judged_films.end();
    };
    if (std::ranges::none_of(result.numbers, is_judged))
      throw refusal(result.place, "has neither film.minimum nor film.central; required is one of them");
    return result;
  }
  throw refusal(submission.file.string(), "has no result for " + contact_case.id + "; required is one");
}

/// Its numbers as observables.
Observables observed_in(const SubmittedResult& result, const CaseScales& scales) {
  Observables observed;
  for (const SubmittedNumber& number : result.numbers) {
    const auto unit = scales.unit(number.quantity, number.scaling);
    if (!unit) throw refusal(result.place, "has a scaling that the case leaves open; allowed is hertz");
    observed[number.quantity] = {.value = number.value / *unit, .error = number.stated_error};
  }
  return observed;
}

std::vector<std::string> hints_of(const SubmittedResult& result, const Observables& observed, const Case& contact_case,
                                  const CaseScales& scales) {
  std::vector<Compared> numbers;
  for (const Certified& certified : certified_numbers(contact_case, scales))
    for (const SubmittedNumber& number : result.numbers)
      if (number.quantity == certified.quantity)
        numbers.push_back({.number = number, .value = observed.at(number.quantity).value, .certified = certified});
  return hints_for(contact_case, scales, numbers, false);
}

/// What is wrong with the words in braces: "has no {case}, has no {out}, {tol} is unknown, did you mean {tolerance}?".
/// A word that resembles none of them is the shell's or another program's: awk '{print}'.
std::string faults_of(const std::string& command) {
  std::string faults;
  const auto add = [&faults](const std::string& fault) { faults += (faults.empty() ? "" : ", ") + fault; };
  const std::vector<std::string> words{std::string(case_word), std::string(out_word), std::string(tolerance_word)};
  for (const std::string& word : {words[0], words[1]})
    if (command.find(word) == std::string::npos) add("has no " + word);
  for (auto begin = command.find('{'); begin != std::string::npos; begin = command.find('{', begin + 1)) {
    const auto end = command.find('}', begin);
    if (end == std::string::npos) break;
    const std::string word = command.substr(begin, end + 1 - begin);
    constexpr std::size_t shortest = 5;  // {tol}, {cas}
    if (word.size() < shortest || std::ranges::find(words, word) != words.end()) continue;
    const std::string meant = near_miss(word.substr(0, word.size() - 1), words);  // "{tol" begins "{tolerance}"
    if (!meant.empty()) add(fmt::format("{} is unknown, did you mean {}?", word, meant));
  }
  return faults;
}

}  // namespace

ExternalSolver external_from(const std::string& text) {
  const auto equals = text.find('=');
  const ExternalSolver made{.name = text.substr(0, equals),
                            .command = equals == std::string::npos ? "" : text.substr(equals + 1)};
  constexpr const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
  const std::string allowed = "; allowed is NAME='command {case} {out} {tolerance}'";
  if (equals == std::string::npos || made.name.empty()) throw std::invalid_argument("has no name" + allowed);
  if (made.name.find_first_not_of(letters) != std::string::npos)
    throw std::invalid_argument("has a name with other characters than letters, digits, \".\", \"-\" and \"_\"" +
                                allowed);
  if (const std::string faults = faults_of(made.command); !faults.empty())
    throw std::invalid_argument(faults + allowed);
  return made;
}

ExternalRun run_external(const ExternalSolver& solver, const Case& contact_case, double tolerance,
                         double time_limit_s) {
  const Exchange exchange;
  OutputFile(exchange.problem()).commit(json_text(problem_json(contact_case)));
  std::string command = solver.command;
  replace(command, case_word, shell_quoted(exchange.problem().string()));
  replace(command, out_word, shell_quoted(exchange.submission().string()));
  replace(command, tolerance_word, plain(tolerance));

  ExternalRun external{.judged = {}, .end = run_command(command, time_limit_s)};
  ContactRun& run = external.judged.run;
  external.judged.tolerance = tolerance;
  run.case_id = contact_case.id;
  run.version = contact_case.version;
  run.solver = solver.name;
  const auto& contact = std::get<ContactCase>(contact_case.body);
  if (!contact.dry()) {
    const Nondimensional stated = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
    run.groups = stated.problem.groups;
    run.scales = stated.scales;
  }
  SolveRecord& record = run.solution.record;
  record.cost.wall_s = external.end.wall_s;
  // The files are gone when somebody reads a message about them.
  const auto without_paths = [&](std::string text) {
    replace(text, exchange.problem().string(), std::string(case_word));
    replace(text, exchange.submission().string(), std::string(out_word));
    return text;
  };
  external.end.last_line = without_paths(external.end.last_line);
  const CommandEnd& end = external.end;
  const std::string ended = end.words + (end.last_line.empty() ? "" : ": " + end.last_line);
  record.reason = ended;
  if (!end.exit_code) {
    const bool by_limit = end.wall_s >= time_limit_s;
    record.status = by_limit ? StopReason::limit_reached : StopReason::diverged;
    return external;
  }
  try {
    const Submission submission = read_submission(exchange.submission());
    const SubmittedResult& result = result_in(submission, contact_case);
    const CaseScales scales(contact);
    run.solution.observables = observed_in(result, scales);
    external.hints = hints_of(result, run.solution.observables, contact_case, scales);
    record.status = *end.exit_code == 0 ? StopReason::converged : StopReason::tolerance_not_met;
    if (*end.exit_code == 0) record.reason.clear();
  } catch (const CaseError& fault) {
    record.status = StopReason::diverged;
    std::error_code ignored;
    record.reason = std::filesystem::exists(exchange.submission(), ignored)
                        ? fmt::format("its submission is refused: {}; {}", without_paths(fault.what()), ended)
                        : "it left no submission; " + ended;
  }
  for (std::size_t film = 0; film < 2; ++film) {
    const auto at = run.solution.observables.find(judged_films[film]);
    if (at != run.solution.observables.end()) external.judged.films[film].reported = at->second.error;
  }
  return external;
}

}  // namespace ehd::judging
