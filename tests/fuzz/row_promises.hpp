// SPDX-License-Identifier: GPL-3.0-or-later
// What reading stored rows promises of ANY text behind a right checksum: a merge refuses it in one line and leaves no
// table, or its tables are whole.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/content_hash.hpp"
#include "io/output_file.hpp"
#include "io/sweep_shards.hpp"
#include "tests/files.hpp"
#include "tests/fuzz/refusal.hpp"

namespace ehd::verification::promises {

/// A sweep of one row with a finished shard, of which each input replaces the row.
class StoredRow {
 public:
  explicit StoredRow(const std::string& statement) : sweep_(read_sweep(folder_.write("s.toml", statement))) {
    (void)run_shard(sweep_, {}, out(), {1, 1});
    const std::string journal = test::read(file());
    header_ = journal.substr(0, journal.find('\n') + 1);
    hash_ = SweepHashes(sweep_, {}).of_row[0];
  }

  [[nodiscard]] std::string broken_by(std::string text) const {
    std::replace(text.begin(), text.end(), '\n', ' ');  // a row is a line
    // The row repeats its hash, which differs from build to build.
    constexpr std::string_view key = "\"hash\":\"";
    if (const auto at = text.find(key); at != std::string::npos)
      text.replace(at + key.size(), content_hash_digits, hash_);
    const std::string content = hash_ + " " + text;
    constexpr std::size_t check_digits = 16;
    std::ofstream(file(), std::ios::binary)
        << header_ << content_hash(content).substr(0, check_digits) << " " << content << "\n";
    for (const char* table : {"rows.csv", "rows.json"}) std::filesystem::remove(out() / table);
    try {
      (void)merge_shards(sweep_, {.threads = 1}, out());
    } catch (const OutputError& refusal) {
      if (one_line(refusal.what()) != refusal.what()) return "the refusal is not one line of printable text";
      for (const auto& entry : std::filesystem::directory_iterator(out()))
        if (entry.path().filename() != "shards") return entry.path().filename().string() + " is left of a refused row";
      return "";
    }
    const Json rows = Json::parse(test::read(out() / "rows.json"))["rows"];
    if (rows.size() != 1 || rows[0]["row"] != 0) return "rows.json has another row";
    const std::string csv = test::read(out() / "rows.csv");
    if (std::count(csv.begin(), csv.end(), '\n') < 2) return "rows.csv has no row";
    return "";
  }

 private:
  [[nodiscard]] std::filesystem::path out() const { return folder_.path() / "out"; }
  [[nodiscard]] std::filesystem::path file() const { return out() / "shards" / "1-of-1" / "journal"; }
  test::Folder folder_;
  Sweep sweep_;
  std::string header_, hash_;
};

inline std::string row_broken(std::string_view bytes) {
  static const StoredRow contact(
      "case = \"dry-steel\"\ncombine = \"zip\"\n[keys]\n\"conditions.load_N_per_m\" = [1e5]\n");
  static const StoredRow bearing(
      "case = \"na4908\"\nlaws = [\"hertz\"]\ncombine = \"zip\"\n[keys]\n\"bearing.rollers\" = [4]\n");
  const std::string text(bytes);
  if (auto broken = contact.broken_by(text); !broken.empty()) return "contact: " + broken;
  if (auto broken = bearing.broken_by(text); !broken.empty()) return "bearing: " + broken;
  return "";
}

}  // namespace ehd::verification::promises
