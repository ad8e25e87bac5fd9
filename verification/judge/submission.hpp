// SPDX-License-Identifier: GPL-3.0-or-later
// A submission: what somebody's solver found for some cases, as a file. docs/judge.md explains the two forms:
//   JSON  {"schema": "ehd-submission-1", "solver": {"name": ...}, "results": [{"case": ..., "film.minimum": ...}]}
//   CSV   columns case, version, quantity, value, scaling, and stated_error where one is stated
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "contact/quantities.hpp"
#include "workflow/case.hpp"

namespace ehd {
struct FileKind;
}  // namespace ehd

namespace ehd::judging {

inline constexpr const char* submission_schema = "ehd-submission-1";

/// One number of a result, in the scaling that the submission names.
struct SubmittedNumber {
  Quantity quantity = Quantity::film_minimum;
  double value = 0;  ///< finite; positive for a film
  Scaling scaling = Scaling::hertz;
  std::optional<double> stated_error = {};  ///< relative; in JSON one for all films of a result
};

struct SubmittedResult {
  std::string case_id;
  int version = 0;
  std::vector<SubmittedNumber> numbers;
  std::optional<double> wall_s = {};
  std::optional<std::filesystem::path> profile = {};  ///< CSV with columns X, P, H
  std::string place;                                  ///< in messages: "mine.json: results[3]", "mine.csv:4"
};

struct Submission {
  std::filesystem::path file;
  std::string name, version, url, hardware;  ///< one line each; empty where not stated
  std::vector<SubmittedResult> results;      ///< each case once
};

[[nodiscard]] bool is_csv(const std::filesystem::path& file);  ///< by its ending, .csv or .CSV

/// By the file's ending: CSV, else JSON. As strict as the reader of case files: throws CaseError, one line
/// with the place, what is wrong and what is allowed, for an unknown key or quantity, a number that is not finite, a
/// case twice.
[[nodiscard]] Submission read_submission(const std::filesystem::path& file);

// The two readers, and what both refuse.

[[nodiscard]] Submission read_submission_json(const std::filesystem::path& file);
[[nodiscard]] Submission read_submission_csv(const std::filesystem::path& file);

inline constexpr std::size_t most_results = 10000;  ///< the atlas has some hundred cases
/// The text of a file that somebody handed in, without a byte-order mark. Throws CaseError: text_of_file, and a null
/// byte.
[[nodiscard]] std::string submitted_text(const std::filesystem::path& file, const FileKind& kind);
/// "PLACE: what", on one line, shortened.
[[nodiscard]] CaseError refusal(const std::string& place, const std::string& what);
/// A quantity by its name. Throws CaseError for an unknown one, and for a self-check.
[[nodiscard]] Quantity submitted_quantity(const std::string& place, const std::string& name);
[[nodiscard]] Scaling submitted_scaling(const std::string& place, const std::string& name);
/// An id of a case, so that it is no path. Throws CaseError.
void require_case_id(const std::string& place, const std::string& id);
/// Of a size up to 1e100, positive for a film, a stated error in (0, 1]. Throws CaseError.
void require_number(const std::string& place, const SubmittedNumber& number);

}  // namespace ehd::judging
