// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of the atlas says on the terminal.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "io/tables.hpp"
#include "verification/atlas/atlas.hpp"

namespace ehd::verification {

namespace {

using Entry = AtlasResult::Entry;

std::string slowest_list(const AtlasResult& result) {
  constexpr std::size_t most = 8;
  std::vector<const Entry*> by_time;
  for (const Entry& entry : result.entries) by_time.push_back(&entry);
  std::stable_sort(by_time.begin(), by_time.end(),
                   [](const Entry* a, const Entry* b) { return a->record.wall_s > b->record.wall_s; });
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(most, by_time.size()); ++i)
    rows.push_back({by_time[i]->record.id, std::string(to_string(by_time[i]->record.status)),
                    plain(by_time[i]->record.wall_s, 3) + " s"});
  return "slowest\n" + aligned(rows, 2, "  ");
}

std::string without_digits_list(const AtlasResult& result) {
  constexpr std::size_t most = 40;
  std::string text;
  std::size_t named = 0;
  for (const Entry& entry : result.entries) {
    const AtlasRecord& record = entry.record;
    if (record.has_digits() || ++named > most) continue;
    text += fmt::format("  {}: {}{}\n", record.id, to_string(record.status),
                        record.reason.empty() ? "" : ", " + record.reason);
  }
  if (named == 0) return "";
  return "without digits\n" + text + (named > most ? fmt::format("  and {} more\n", named - most) : "");
}

}  // namespace

std::string human_summary(const AtlasResult& result) {
  constexpr int many = 9, several = 6;
  std::size_t reused = 0, with_many = 0, with_several = 0, without = 0, tests = 0;
  AtlasTable table;
  for (const Entry& entry : result.entries) {
    const AtlasRow& row = table.rows.emplace_back(row_of(atlas_row(entry.point, entry.record)));
    const int digits = std::min(count_digits(row.at("H_min")), count_digits(row.at("H_cen")));
    reused += entry.reused ? 1 : 0;
    with_many += digits >= many ? 1 : 0;
    with_several += digits >= several ? 1 : 0;
    without += entry.record.has_digits() ? 0 : 1;
    tests += entry.point.numerical_test() ? 1 : 0;
  }
  const std::size_t all = result.entries.size();
  std::string text = digits_text(table) + "\n";
  text += fmt::format("{} points, {} solved now, {} from records of an earlier run, {} s\n", all, all - reused, reused,
                      plain(result.wall_s, 3));
  text += fmt::format(
      "{} with {} digits or more of H_min and H_cen, {} with {} or more, {} without; {} are numerical tests\n",
      with_many, many, with_several, several, without, tests);
  text += slowest_list(result) + without_digits_list(result);
  for (const auto& file : result.left_over) text += "left over: " + file + " belongs to no point of the list\n";
  return text;
}

}  // namespace ehd::verification
