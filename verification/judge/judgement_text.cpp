// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/judgement_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/text.hpp"
#include "io/tables.hpp"

namespace ehd::judging {

namespace {

using Cells = std::vector<std::vector<std::string>>;

std::string regime_words(const Regime& regime) {
  return fmt::format("{}, L {}", to_string(regime.load), to_string(regime.material));
}

/// The quantities that some case certifies: the columns.
std::vector<Quantity> columns_of(const Judgement& judgement) {
  std::vector<Quantity> columns;
  for (const Quantity quantity : all_quantities) {
    const auto has = [&](const JudgedCase& one) {
      return std::any_of(one.scores.begin(), one.scores.end(),
                         [&](const Score& score) { return score.certified.quantity == quantity; });
    };
    if (std::any_of(judgement.cases.begin(), judgement.cases.end(), has)) columns.push_back(quantity);
  }
  return columns;
}

std::string digits_cell(const JudgedCase& one, Quantity quantity) {
  for (const Score& score : one.scores) {
    if (score.certified.quantity != quantity) continue;
    if (score.missing()) return "missing";
    // The digits of the certified number bound the score: then it says "at least".
    const bool bounded = *score.error < score.certified.uncertainty;
    return fmt::format("{}{:.1f}{}", bounded ? ">" : "", score.digits, score.honesty == Honesty::missed ? "!" : "");
  }
  return "-";
}

std::string digits_table(const Judgement& judgement) {
  const auto columns = columns_of(judgement);
  Cells rows{{"case", "regime"}};
  for (const Quantity quantity : columns) rows[0].emplace_back(to_string(quantity));
  bool pressure = false, times = false;
  for (const JudgedCase& one : judgement.cases) {
    pressure = pressure || (one.profile && one.profile->pressure_error);
    times = times || one.wall_s;
  }
  if (pressure) rows[0].emplace_back("P (L2)");
  if (times) rows[0].emplace_back("stated time [s]");
  for (const JudgedCase& one : judgement.cases) {
    std::vector<std::string> row{one.id, one.groups ? regime_words(regime_of(*one.groups)) : "dry"};
    for (const Quantity quantity : columns) row.push_back(digits_cell(one, quantity));
    if (pressure)
      row.push_back(one.profile && one.profile->pressure_error ? plain(*one.profile->pressure_error, 2) : "-");
    if (times) row.push_back(one.wall_s ? plain(*one.wall_s, 3) : "-");
    rows.push_back(std::move(row));
  }
  return aligned_in_parts(rows, 2);
}

std::string regime_table(const Judgement& judgement) {
  Cells rows{{"regime", "numbers", "missing", "median", "worst", "median of the given"}};
  for (const RegimeDigits& row : judgement.regimes)
    rows.push_back({regime_words(row.regime), std::to_string(row.numbers), std::to_string(row.missing),
                    fixed(row.median, 1), fixed(row.worst, 1), row.median_given ? fixed(*row.median_given, 1) : "-"});
  return aligned_in_parts(rows, 1);
}

std::string gate_lines(const Judgement& judgement) {
  std::string text;
  for (const JudgedCase& one : judgement.cases) {
    if (!one.profile) continue;
    for (const Gate& gate : one.profile->gates) {
      const std::string found = gate.judged ? fmt::format("{}, allowed {} ({})", plain(gate.error, 2),
                                                          plain(gate.tolerance.value(), 2), gate.quadrature)
                                            : gate.quadrature;
      text += fmt::format("  {:<12}  {}: {}{} {}\n", to_string(gate.verdict), one.id, gate.name, gate.judged ? "" : ":",
                          found);
    }
  }
  return text;
}

std::string honesty_lines(const Judgement& judgement) {
  if (judgement.met + judgement.missed + judgement.undecided == 0) return "";
  std::string text = fmt::format("\nstated errors: {} met, {} missed, {} undecided\n", judgement.met, judgement.missed,
                                 judgement.undecided);
  for (const JudgedCase& one : judgement.cases)
    for (const Score& score : one.scores)
      if (score.honesty == Honesty::missed)
        text += fmt::format("  missed  {}: {}: stated {}, actual {}\n", one.id, to_string(score.certified.quantity),
                            plain(*score.stated_error, 2), plain(*score.error, 2));
  return text;
}

std::string hint_lines(const Judgement& judgement) {
  std::string text;
  for (const JudgedCase& one : judgement.cases) {
    for (const std::string& hint : one.hints) text += fmt::format("  {}: {}\n", one.id, hint);
    for (const std::string& quantity : one.not_certified)
      text += fmt::format("  {}: {} is not scored: the case certifies no digits of it\n", one.id, quantity);
  }
  return text;
}

}  // namespace

std::string human_text(const Judgement& judgement) {
  const Submission& from = judgement.submission;
  std::string text =
      fmt::format("{}{}{}, {}\n\ndigits (> bounded by the certified digits; ! above the stated error)\n{}", from.name,
                  from.version.empty() ? "" : " ", from.version, one_line(from.file.string()), digits_table(judgement));
  text += "what each of the first ten cases tests: ehd judge --help\n";
  text += "\ndigits by regime (a missing number counts as 0)\n" + regime_table(judgement);
  text += honesty_lines(judgement);
  if (const std::string gates = gate_lines(judgement); !gates.empty()) text += "\ngates\n" + gates;
  if (const std::string hints = hint_lines(judgement); !hints.empty()) text += "\nhints\n" + hints;
  return text;
}

}  // namespace ehd::judging
