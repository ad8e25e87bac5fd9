// SPDX-License-Identifier: GPL-3.0-or-later
// A case as a user states it: a contact or a bearing in SI, with the numbers that somebody expects of it. Types only;
// io/case_reader.hpp reads them from a file. Solvers never see a Case.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bearing/fit_of.hpp"
#include "bearing/geometry.hpp"
#include "contact/conditions.hpp"
#include "contact/enum_words.hpp"
#include "contact/oil_grade.hpp"

namespace ehd {

/// The user's input is wrong: what() is one line, "FILE:LINE: key = value: what is wrong; what is allowed".
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// Several errors of one case, a line each: what() is the first of them. `lines` has at least one.
  explicit CaseError(const std::vector<std::string>& lines)
      : std::runtime_error(lines.at(0)), more_(lines.begin() + 1, lines.end()) {}
  /// The lines after what(); most often none.
  [[nodiscard]] const std::vector<std::string>& more() const { return more_; }

 private:
  std::vector<std::string> more_;
};

enum class ExpectationKind { exact, published, computed, fit };
inline constexpr auto all_expectation_kinds = all_words<ExpectationKind>;
[[nodiscard]] std::string_view to_string(ExpectationKind kind);  ///< "exact", …
[[nodiscard]] std::optional<ExpectationKind> expectation_kind_from(std::string_view text);

enum class Scaling { hertz, moes, SI, kostreva };
inline constexpr auto all_scalings = all_words<Scaling>;
[[nodiscard]] std::string_view to_string(Scaling scaling);  ///< "hertz", …
[[nodiscard]] std::optional<Scaling> scaling_from(std::string_view text);

/// One [[expect]]: a number that a source gives, or one whose source could not be obtained.
struct Expectation {
  std::string quantity;  ///< "film.minimum", "roller.3.inner.force", …
  std::string law;       ///< bearing cases only
  bool waiting = false;  ///< status = "waiting": there is no value
  double value = 0;
  std::string digits;  ///< the text of the value
  Scaling scaling = Scaling::hertz;
  double uncertainty = 0;  ///< relative; default half of the last digit
  ExpectationKind kind = ExpectationKind::computed;
  int line = 0;
};

/// A contact case: lubricated (lubricant and inlet present) or dry ([conditions] alone).
struct ContactCase {
  Statement statement;
  std::optional<Lubricant> lubricant = {};
  std::optional<Inlet> inlet = {};
  std::optional<GradedOil> oil = {};  ///< where the oil is stated by its grade; statement and lubricant follow from it
  [[nodiscard]] bool dry() const { return !lubricant; }
};

struct BearingOperation {
  double inner_speed_rpm = 0;
  double outer_speed_rpm = 0;
  double radial_load_N = 0;
};

/// Where the approach is 0: the words of `datum.law`.
struct PalmgrenDatum {
  static constexpr std::string_view name = "palmgren";
  std::optional<double> load_N = {};  ///< default: the largest roller load of the dry solution
};
struct LundbergDatum {
  static constexpr std::string_view name = "lundberg";
};
struct LengthDatum {
  static constexpr std::string_view name = "x0";
  double x0_m = 0;
};
using Datum = std::variant<PalmgrenDatum, LundbergDatum, LengthDatum>;

struct FitRange {
  /// Absent: the range follows from the dry balance (default_fit_from in bearing_fit).
  std::optional<std::pair<double, double>> load_N = {};
  int points = 6;
  bearing::FitOf of = bearing::FitOf::force;  ///< no case file states it; the paper's statements are judged with both
};

struct BearingLubricant {
  Lubricant lubricant;
  double viscosity_Pa_s = 0;
  std::optional<GradedOil> oil = {};  ///< where the oil is stated by its grade; the two above follow from it
};

struct BearingCase {
  bearing::Geometry geometry;
  std::optional<double> ring_thickness_m = {};  ///< of the outer ring
  std::optional<double> roughness_m = {};       ///< composite
  BearingOperation operation;
  double modulus_Pa = 0;
  double poisson = 0;
  std::optional<BearingLubricant> lubricant = {};
  Datum datum = PalmgrenDatum{};
  FitRange fit = {};
};

/// Where a key or a table stands, for error messages.
struct CasePlace {
  int line = 0;
  std::string text = {};  ///< the value as written; empty for a table
  bool operator==(const CasePlace&) const = default;
};

struct Case {
  std::string id;
  int version = 0;
  std::string title;
  std::string source;
  std::variant<ContactCase, BearingCase> body;
  std::vector<Expectation> expectations;
  std::filesystem::path file;               ///< as named by the user
  std::map<std::string, CasePlace> places;  ///< of dotted keys ("bearing.length_m") and tables ("bearing")
  /// Keys, and tables, that the command line gave: dotted key -> "--set KEY=VALUE".
  std::map<std::string, std::string> given = {};
};

/// "FILE:LINE: message", with the line of `key` or of its table; "ehd: --set KEY=VALUE: message" where the command line
/// gave the key. Every message about a key is made here.
[[nodiscard]] CaseError case_error(const Case& where, const std::string& key, const std::string& message);

}  // namespace ehd
