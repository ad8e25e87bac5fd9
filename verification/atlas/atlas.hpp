// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas: line contacts over a grid of M and L, solved to the digits that the reference solver vouches for, as
// atlas.csv, digits.txt and one case file a point. cases/atlas/README.md explains the columns.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/solution.hpp"
#include "io/output_file.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

// -- points -----------------------------------------------------------------------------------------------------

enum class AtlasLaws {
  isoviscous,  ///< L = 0: isoviscous, incompressible
  barus,       ///< Barus, incompressible
  roelands,    ///< Roelands z = 0.68, p_0 = 1.96e8 Pa, Dowson and Higginson's density
};
[[nodiscard]] std::string_view to_string(AtlasLaws laws);

inline constexpr double atlas_alpha_per_Pa = 2.2e-8;      ///< of both sets: it makes p_H of M and L
inline constexpr double atlas_highest_pressure_Pa = 4e9;  ///< above, a point is a numerical test
inline constexpr double atlas_worst_error = 1e-4;         ///< relative, of H_min and H_cen: above, no digits

struct AtlasPoint {
  AtlasLaws laws = AtlasLaws::isoviscous;
  double M = 0;
  double L = 0;
  Inlet inlet = Flooded{};

  [[nodiscard]] std::string id() const;  ///< "atlas-roelands-m20-l10-flooded", "…-cut4"
  [[nodiscard]] std::string title() const;
  [[nodiscard]] double hertz_pressure_Pa() const;  ///< L sqrt(M/2pi)/alpha; 0 at L = 0
  [[nodiscard]] bool numerical_test() const;
  [[nodiscard]] ContactCase contact() const;
  /// 1e-10; Barus 1e-7.
  [[nodiscard]] double usual_tolerance() const;
};

/// All points, by law set, inlet (flooded; cut at X = -4 for M >= 2), M and L. L = 0 is there once: isoviscous.
[[nodiscard]] std::vector<AtlasPoint> atlas_points();

// -- digits -----------------------------------------------------------------------------------------------------

/// A number with the digits that are known, and the uncertainty of just this text: its error and its rounding.
struct KnownDigits {
  std::string text;
  std::string relative;  ///< uncertainty over |text|, rounded up to two digits
  std::string absolute;
};

/// As many digits as leave `error` (absolute) below half a unit of the last one, at most 15; absent where not even the
/// first one is known, the value is 0, either is not finite, or the error is not positive.
[[nodiscard]] std::optional<KnownDigits> known_digits(double value, double error);

/// Significant digits in a decimal text.
[[nodiscard]] int count_digits(std::string_view text);

// -- one point solved -------------------------------------------------------------------------------------------

/// A quantity of a point, with its absolute error.
struct AtlasReading {
  double value = 0;
  double error = 0;
};

/// What is left of a solve, kept on disk until the atlas is complete. Names of readings are columns of the CSV.
struct AtlasRecord {
  std::string id;
  std::string solver;       ///< name, version and how it solved the probes: atlas_solver_version()
  double tolerance = 0;     ///< asked for
  double time_limit_s = 0;  ///< of each solve
  StopReason status = StopReason::diverged;
  std::string reason;
  std::map<std::string, AtlasReading> readings;
  long nodes = 0;
  double wall_s = 0;

  /// H_min and H_cen are known to 1e-4: only then are digits printed.
  [[nodiscard]] bool has_digits() const;
};

[[nodiscard]] std::string json_of(const AtlasRecord& record);
/// Absent for what is no record (a file of another program, or one that was damaged).
[[nodiscard]] std::optional<AtlasRecord> record_from(const std::string& json);

/// Solves a point. Where that leaves H_min or H_cen unknown to 1e-4, looser tolerances follow: 1000 times each, up to
/// 1e-4, that one at once where time ran out. Tolerance, status and reason stay those of the first solve, except that
/// one without a film, where a looser one has found digits, is called tolerance-not-met.
[[nodiscard]] AtlasRecord solve_point(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                                      double time_limit_s);

/// Changes when the solver does: version, and a digest of three short solves to the last bit.
[[nodiscard]] std::string atlas_solver_version(const RegisteredSolver& solver);

// -- files ------------------------------------------------------------------------------------------------------

/// The case file of a point. A point without digits waits for them.
[[nodiscard]] std::string case_text_of(const AtlasPoint& point, const AtlasRecord& record, int version = 1);

[[nodiscard]] const std::vector<std::string>& atlas_columns();
/// Cells in the order of atlas_columns(), empty where nothing is known.
[[nodiscard]] std::vector<std::string> atlas_row(const AtlasPoint& point, const AtlasRecord& record);

/// atlas.csv read back: rows by column name.
struct AtlasTable {
  std::vector<std::map<std::string, std::string>> rows;
};
/// Throws CaseError, "FILE:LINE: column = value: what is wrong; what is allowed", where the file is none that `ehd
/// atlas` wrote: every number is finite and in its range, every law known.
[[nodiscard]] AtlasTable read_atlas_table(const std::filesystem::path& csv);

/// Digits of H_min and H_cen over M and L, a table for each law set and inlet.
[[nodiscard]] std::string digits_text(const AtlasTable& table);

/// cases/atlas
[[nodiscard]] std::filesystem::path atlas_folder();
/// atlas-*.toml of a folder, by name; none where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> atlas_files(const std::filesystem::path& folder);

/// What differs between atlas.csv and the case files beside it, a sentence each: problem, values, uncertainties; points
/// that only one of them has.
[[nodiscard]] std::vector<std::string> atlas_disagreements(const std::filesystem::path& folder);

// -- the run ----------------------------------------------------------------------------------------------------

struct AtlasRequest {
  std::filesystem::path folder;
  std::vector<AtlasPoint> points;
  std::string only;  ///< solve points with this in their id; rows and files of the others stay as they are
  std::optional<double> tolerance = {};  ///< instead of each point's usual one
  double time_limit_s = 30;
  unsigned threads = 0;  ///< 0: as many as there are cores
  bool fresh = false;    ///< do not believe records of an earlier run
  /// After each point, one thread at a time; reused ones come first, save for what the threads overlap.
  std::function<void(std::size_t done, std::size_t all, const AtlasRecord& record, bool reused)> progress = {};
};

struct AtlasResult {
  struct Entry {
    AtlasPoint point;
    AtlasRecord record;
    bool reused = false;  ///< from a record of an earlier run
  };
  std::vector<Entry> entries;          ///< selected points, in the order of the request
  std::vector<std::string> left_over;  ///< case files in the folder that belong to no row
  double wall_s = 0;
};

[[nodiscard]] std::vector<AtlasPoint> selected_points(const AtlasRequest& request);

/// Solves what no record answers, the heaviest first; a record is written as soon as its point is solved. Then
/// atlas.csv, digits.txt and the case files are written, each whole or not at all. A case in which a number changes
/// gets the next version. Throws OutputError where the folder cannot be written, CaseError where `only` should keep
/// rows of an atlas.csv that is none.
[[nodiscard]] AtlasResult run_atlas(const AtlasRequest& request, const RegisteredSolver& solver);

/// Points, digits, the slowest, and what is not known, for a terminal.
[[nodiscard]] std::string human_summary(const AtlasResult& result);

}  // namespace ehd::verification
