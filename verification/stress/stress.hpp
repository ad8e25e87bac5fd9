// SPDX-License-Identifier: GPL-3.0-or-later
// ehd stress: what arithmetic, starts, threads and extreme inputs do to the solvers. Each part is a table and a
// verdict.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/json.hpp"
#include "verification/tolerance.hpp"

namespace ehd::verification::stress {

struct Column {
  std::string name, unit;
};
/// A number that is not finite is unknown, and shown as an empty cell.
using Cell = std::variant<std::string, double>;
struct Table {
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};
};

/// One part as stress.json has it.
struct Part {
  std::string id = {};        ///< "a" … "i"
  std::string name = {};      ///< "box"
  std::string question = {};  ///< one sentence
  Verdict verdict = Verdict::inconclusive;
  std::string summary = {};  ///< one sentence, with the numbers
  std::optional<Tolerance> tolerance = {};
  Table table = {};
  std::optional<Table> points = {};  ///< every single run, where the table sums them up; not printed
  std::vector<std::string> failures = {};
  double wall_s = 0;
  Json settings = Json::object();
};

/// Verdicts of single rows, added up: one failure fails the whole, else one inconclusive row leaves it open. Nothing
/// judged: inconclusive.
class Tally {
 public:
  /// error + uncertainty against the tolerance; NaN is inconclusive and never passes. `what` names a row that does not
  /// pass.
  Verdict add(double error, double uncertainty, const Tolerance& tolerance, const std::string& what);
  Verdict add(Verdict verdict, const std::string& what);
  /// A yes or a no.
  Verdict require(bool holds, const std::string& what);
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] long judged() const { return passed_ + failed_ + open_; }
  [[nodiscard]] long passed() const { return passed_; }
  /// At most twenty sentences, and how many more there are.
  [[nodiscard]] std::vector<std::string> failures() const;

 private:
  long passed_ = 0, failed_ = 0, open_ = 0;
  std::vector<std::string> not_passed_;
};

/// How large a run is made.
struct Scope {
  bool quick = false;
  unsigned threads = 0;  ///< 0: as many as there are cores
  std::function<void(const std::string&)> progress = {};
  void show(const std::string& what) const {
    if (progress) progress(what);
  }
};

/// THE list of parts.
struct PartEntry {
  std::string id, name;
  std::function<Part(const Scope&)> run;
};
[[nodiscard]] const std::vector<PartEntry>& parts();
/// The part, timed. One that throws is a part that fails with the message: the others still run, and the file is
/// written.
[[nodiscard]] Part run_part(const PartEntry& entry, const Scope& scope);
/// By id or name; nullptr where there is none.
[[nodiscard]] const PartEntry* find_part(const std::string& text);

/// A stress.json: schema, provenance, parts, wall_s, success (every part passed).
[[nodiscard]] Json to_json(const std::vector<Part>& parts, double wall_s);
[[nodiscard]] bool all_passed(const std::vector<Part>& parts);
[[nodiscard]] std::string human_text(const Part& part);
/// A line a part.
[[nodiscard]] std::string human_summary(const std::vector<Part>& parts);

}  // namespace ehd::verification::stress
