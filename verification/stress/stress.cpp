// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/provenance.hpp"
#include "io/tables.hpp"
#include "verification/bench/child.hpp"
#include "verification/bench/timing.hpp"
#include "verification/report/schemas.hpp"
#include "verification/stress/parts.hpp"

namespace ehd::verification::stress {

namespace {

constexpr std::size_t most_failures = 20;

std::string shown(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? plain(number, 3) : "";
}

Json to_json(const Table& table) {
  Json json = {{"columns", Json::array()}, {"rows", Json::array()}};
  for (const auto& [name, unit] : table.columns) json["columns"].push_back({{"name", name}, {"unit", unit}});
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const Cell& cell : row) {
      if (const auto* text = std::get_if<std::string>(&cell)) {
        cells.push_back(*text);
      } else {
        const double number = std::get<double>(cell);
        cells.push_back(std::isfinite(number) ? Json(number) : Json(""));
      }
    }
    json["rows"].push_back(cells);
  }
  return json;
}

}  // namespace

std::vector<Column> columns_of(std::string_view header) {
  constexpr std::string_view bar = " | ";
  std::vector<Column> columns;
  for (std::size_t from = 0, to = 0; to < header.size(); from = to + bar.size()) {
    to = std::min(header.find(bar, from), header.size());
    const std::string_view text = header.substr(from, to - from);
    const std::size_t bracket = std::min(text.find(" ["), text.size());
    const std::string_view unit = bracket < text.size() ? text.substr(bracket + 2, text.size() - bracket - 3) : "";
    columns.push_back({std::string(text.substr(0, bracket)), std::string(unit)});
  }
  return columns;
}

Verdict Tally::add(Verdict verdict, const std::string& what) {
  if (verdict == Verdict::pass) {
    ++passed_;
  } else {
    (verdict == Verdict::fail ? failed_ : open_) += 1;
    not_passed_.push_back(fmt::format("{}: {}", to_string(verdict), what));
  }
  return verdict;
}

Verdict Tally::add(double error, double uncertainty, const Tolerance& tolerance, const std::string& what) {
  return add(judge(error, uncertainty, tolerance),
             fmt::format("{}: {}{} against {} ({}: {})", what, plain(error, 3),
                         uncertainty > 0 ? " +- " + plain(uncertainty, 3) : "", plain(tolerance.value(), 3),
                         tolerance.basis(), tolerance.reason()));
}

Verdict Tally::require(bool holds, const std::string& what) { return add(holds ? Verdict::pass : Verdict::fail, what); }

Verdict Tally::verdict() const {
  if (failed_ > 0) return Verdict::fail;
  return open_ > 0 || passed_ == 0 ? Verdict::inconclusive : Verdict::pass;
}

std::vector<std::string> Tally::failures() const {
  std::vector<std::string> some(not_passed_.begin(), not_passed_.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                               not_passed_.size(), most_failures)));
  if (not_passed_.size() > most_failures)
    some.push_back(fmt::format("and {} more", not_passed_.size() - most_failures));
  return some;
}

void Tally::close(Part& part) const {
  part.verdict = verdict();
  part.failures = failures();
}

const std::vector<PartEntry>& parts() {
  static const std::vector<PartEntry> list{
      {"a", "box", [](const Scope& scope) { return judge_box(run_box(scope)); }},
      {"b", "starts", [](const Scope& scope) { return judge_starts(run_starts(scope)); }},
      {"c", "precision", [](const Scope& scope) { return judge_precision(run_precision(scope)); }},
      {"d", "rounding", [](const Scope& scope) { return judge_rounding(run_rounding(scope)); }},
      {"e", "condition", [](const Scope& scope) { return judge_condition(run_condition(scope)); }},
      {"f", "grids", [](const Scope& scope) { return judge_grids(run_grids(scope)); }},
      {"g", "extremes", [](const Scope& scope) { return judge_extremes(run_extremes(scope)); }},
      {"h", "repeatability", [](const Scope& scope) { return judge_repeats(run_repeats(scope)); }},
      {"i", "bearings", [](const Scope& scope) { return judge_bearings(run_bearings(scope)); }},
      {"j", "motion", [](const Scope& scope) { return judge_motion(run_motion(scope)); }},
      {"k", "films", [](const Scope& scope) { return judge_films(run_films(scope)); }},
  };
  return list;
}

namespace {

Part ended_early(const PartEntry& entry, Verdict verdict, const std::string& message) {
  Part part{.id = entry.id, .name = entry.name, .question = "Does this part run to its end?"};
  part.verdict = verdict;
  part.summary = "ended early: " + one_line(message);
  part.failures = {fmt::format("{}: {}", to_string(verdict), part.summary)};
  return part;
}

}  // namespace

Part interrupted_part(const PartEntry& entry, const Scope& scope) {
  Part part = ended_early(entry, Verdict::inconclusive, "the program was interrupted");
  part.settings["quick"] = scope.quick;
  return part;
}

Part run_part(const PartEntry& entry, const Scope& scope) {
  const Stopwatch watch;
  const auto ended = [&](Verdict verdict, const std::string& message) { return ended_early(entry, verdict, message); };
  Part part = [&] {
    try {
      return entry.run(scope);
    } catch (const Refused& refused) {  // the system's fault: nothing is known of the solvers
      return ended(Verdict::inconclusive, refused.what());
    } catch (const std::bad_alloc&) {
      return ended(Verdict::inconclusive, memory_is_exhausted);
    } catch (const std::exception& thrown) {
      return ended(Verdict::fail, std::string("by an exception: ") + thrown.what());
    } catch (...) {
      return ended(Verdict::fail, "by an exception of unknown kind");
    }
  }();
  part.wall_s = watch.seconds();
  part.settings["quick"] = scope.quick;
  return part;
}

const PartEntry* find_part(const std::string& text) {
  const auto& list = parts();
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const auto& part) { return part.id == text || part.name == text; });
  return at == list.end() ? nullptr : &*at;
}

bool all_passed(const std::vector<Part>& parts) {
  return !parts.empty() &&
         std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.verdict == Verdict::pass; });
}

Json to_json(const std::vector<Part>& parts, double wall_s) {
  Json json = {{"schema", report::stress_schema.name}, {"provenance", provenance()}, {"parts", Json::array()}};
  for (const Part& part : parts) {
    Json one = {{"id", part.id}, {"name", part.name}, {"question", part.question}};
    one["verdict"] = to_string(part.verdict);
    one["summary"] = part.summary;
    if (part.tolerance) {
      one["tolerance"] = Json::object();
      put(one["tolerance"], "value", part.tolerance->value());
      one["tolerance"]["basis"] = part.tolerance->basis();
      one["tolerance"]["reason"] = part.tolerance->reason();
    }
    one.update(to_json(part.table));
    if (part.points) one["points"] = to_json(*part.points);
    one["failures"] = part.failures;
    put(one, "wall_s", part.wall_s);
    one["settings"] = part.settings;
    json["parts"].push_back(one);
  }
  put(json, "wall_s", wall_s);
  json["success"] = all_passed(parts);
  return json;
}

std::string human_text(const Part& part) {
  std::vector<std::vector<std::string>> rows(1);
  for (const auto& [name, unit] : part.table.columns)
    rows[0].push_back(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
  std::size_t left = part.table.columns.size();  // columns of text
  for (const auto& row : part.table.rows) {
    rows.emplace_back();
    for (const Cell& cell : row) rows.back().push_back(shown(cell));
    const auto number =
        std::find_if(row.begin(), row.end(), [](const Cell& cell) { return std::holds_alternative<double>(cell); });
    left = std::min(left, static_cast<std::size_t>(number - row.begin()));
  }
  std::string text = wrapped(fmt::format("({}) {}: {}", part.id, part.name, part.question), "    ") +
                     aligned_in_parts(rows, left, "  ");
  for (const auto& failure : part.failures) text += "  " + one_line(failure) + "\n";
  const std::string end = fmt::format("{} in {} s: {}", to_string(part.verdict), plain(part.wall_s, 2), part.summary);
  return text + wrapped("  " + end, "    ") + "\n";
}

std::string human_summary(const std::vector<Part>& parts) {
  std::vector<std::vector<std::string>> rows{{"part", "", "verdict", "time [s]"}};
  for (const Part& part : parts)
    rows.push_back({part.id, part.name, std::string(to_string(part.verdict)), plain(part.wall_s, 2)});
  std::string text = aligned(rows, 3) + "\n";
  for (const Part& part : parts) text += wrapped(fmt::format("{}  {}", part.id, part.summary), "   ");
  return text;
}

}  // namespace ehd::verification::stress
