// SPDX-License-Identifier: GPL-3.0-or-later
// A benchmark case as a user writes it, and the strict reader. SI and text live here; solvers never see a Case.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contact/conditions.hpp"

namespace ehd {

/// Their input is wrong: what() is the ONE line "FILE:LINE: key = value: what is wrong; what is allowed".
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class ExpectationKind { exact, published, computed, fit };
[[nodiscard]] std::string_view to_string(ExpectationKind kind);  ///< "exact", …
enum class Scaling { hertz, moes, SI, kostreva };

/// One [[expect]]: a number that somebody vouches for, or one that the case waits for.
struct Expectation {
  std::string quantity;  ///< "film.minimum", "roller.3.inner.force", …
  std::string law;       ///< bearing cases only
  bool waiting = false;  ///< status = "waiting": no value
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
  [[nodiscard]] bool dry() const { return !lubricant; }
};

struct BearingGeometry {
  int rollers = 0;
  double pitch_diameter_m = 0;
  double roller_diameter_m = 0;
  double length_m = 0;     ///< effective contact length
  double clearance_m = 0;  ///< diametral; negative: preload
  double density_kg_per_m3 = 0;
  double first_azimuth_deg = 0;
  std::optional<double> ring_thickness_m = {};
  std::optional<double> roughness_m = {};
};

struct BearingOperation {
  double inner_speed_rpm = 0;
  double outer_speed_rpm = 0;
  double radial_load_N = 0;
};

struct PalmgrenDatum {
  std::optional<double> load_N = {};  ///< default: the largest roller load of the dry solution
};
struct LundbergDatum {};
struct LengthDatum {
  double x0_m = 0;
};
using Datum = std::variant<PalmgrenDatum, LundbergDatum, LengthDatum>;

struct FitRange {
  std::optional<std::pair<double, double>> load_N = {};  ///< absent: follows the dry balance (bearing_run, default_fit_from)
  int points = 6;
};

struct BearingLubricant {
  Lubricant lubricant;
  double viscosity_Pa_s = 0;
};

struct BearingCase {
  BearingGeometry geometry;
  BearingOperation operation;
  double modulus_Pa = 0;
  double poisson = 0;
  std::optional<BearingLubricant> lubricant = {};
  Datum datum = PalmgrenDatum{};
  FitRange fit = {};
};

struct Case {
  std::string id;
  int version = 0;
  std::string title;
  std::string source;
  std::variant<ContactCase, BearingCase> body;
  std::vector<Expectation> expectations;
  std::filesystem::path file;                ///< as named by the user
  std::map<std::string, int> lines;          ///< dotted key ("bearing.length_m") or table ("bearing") -> line
  std::map<std::string, std::string> texts;  ///< dotted key -> its value as written, for error messages
};

/// Reads and checks a case; throws CaseError. Everything that can be refused without solving is refused here, the
/// groups' range included (nondimensionalise is tried).
[[nodiscard]] Case read_case(const std::filesystem::path& file);

/// The same of a text that is at hand, as if it stood in `file`: its name is the id, and stands in messages.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file);

/// A value as TOML has it.
using TomlValue = std::variant<std::int64_t, double, std::string>;
/// As TOML would write it, a number with as many digits as tell it from every other.
[[nodiscard]] std::string toml_text(const TomlValue& value);

/// A value for a key of a case, "operation.radial_load_N", in the place of the one in the file or beside those there.
struct Substitution {
  std::string key;
  TomlValue value;
};

/// The same with other values, which pass every check that the file's own would; messages name the line of the value
/// that was replaced, or of its table. The file's expectations are left out, since they speak of its own numbers.
[[nodiscard]] Case read_case(std::string text, const std::filesystem::path& file,
                             const std::vector<Substitution>& substitutions);

/// A CASE argument: a path to a TOML file (it holds a '/' or ends in .toml), or the id of one in cases/ or a folder in
/// it (cases/atlas); a file of another name only where no case has it for an id. Throws CaseError.
[[nodiscard]] std::filesystem::path find_case(const std::string& path_or_id);

/// The folder of the benchmark cases: environment EHD_CASES, else the one the program was built from.
[[nodiscard]] std::filesystem::path cases_folder();

/// All cases in cases/, by id, folders in it left out. Throws CaseError at the first that cannot be read.
[[nodiscard]] std::vector<Case> all_cases();

/// FILE:LINE: message, with the line of `key` or of its table; the way every CaseError is worded.
[[nodiscard]] CaseError case_error(const Case& where, const std::string& key, const std::string& message);

}  // namespace ehd
