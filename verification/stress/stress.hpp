// SPDX-License-Identifier: GPL-3.0-or-later
// ehd stress: the solvers under other arithmetic, starts, threads and extreme inputs. Each part is a table and a
// verdict.
#pragma once

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/json.hpp"
#include "verification/tolerance.hpp"

namespace ehd::verification::stress {

struct Column {
  std::string name, unit;
};
/// "contact | time [s]": names with or without a unit.
[[nodiscard]] std::vector<Column> columns_of(std::string_view header);
/// A text or a number. A number that is absent or not finite is not known: its cell is shown empty.
struct Cell : std::variant<std::string, double> {
  Cell(std::string_view text) : variant(std::string(text)) {}
  Cell(const std::string& text) : variant(text) {}
  Cell(const char* text) : variant(std::string(text)) {}
  template <class Number>
  requires std::is_arithmetic_v<Number> Cell(Number number) : variant(static_cast<double>(number)) {}
  Cell(const std::optional<double>& number) : variant(number.value_or(std::nan(""))) {}
  Cell(const std::optional<Tolerance>& bound) : variant(bound ? bound->value() : std::nan("")) {}
};
struct Table {
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};
};

/// One part as stress.json has it.
struct Part {
  std::string id = {};        ///< "a" … "k"
  std::string name = {};      ///< "box"
  std::string question = {};  ///< one sentence
  Verdict verdict = Verdict::inconclusive;
  std::string summary = {};  ///< one sentence, with the numbers
  std::optional<Tolerance> tolerance = {};
  Table table = {};
  std::optional<Table> points = {};  ///< every run, where the table adds runs up; not printed
  std::vector<std::string> failures = {};
  double wall_s = 0;
  Json settings = Json::object();
};

/// The verdict of a part from those of its rows: fail if a row fails, else inconclusive if a row is, or if there is
/// none.
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
  /// Writes the verdict and the failures into the part.
  void close(Part& part) const;

 private:
  long passed_ = 0, failed_ = 0, open_ = 0;
  std::vector<std::string> not_passed_;
};

/// The size of a run.
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
/// Runs and times a part. A part that throws fails with the message: the others still run, and the file is written.
[[nodiscard]] Part run_part(const PartEntry& entry, const Scope& scope);
/// A part that did not run to its end, because the program was interrupted: inconclusive.
[[nodiscard]] Part interrupted_part(const PartEntry& entry, const Scope& scope);
/// By id or name; nullptr where there is none.
[[nodiscard]] const PartEntry* find_part(const std::string& text);

/// A stress.json: schema, provenance, parts, wall_s, success (every part passed).
[[nodiscard]] Json to_json(const std::vector<Part>& parts, double wall_s);
[[nodiscard]] bool all_passed(const std::vector<Part>& parts);
[[nodiscard]] std::string human_text(const Part& part);
/// A line for each part.
[[nodiscard]] std::string human_summary(const std::vector<Part>& parts);

}  // namespace ehd::verification::stress
