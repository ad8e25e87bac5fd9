// SPDX-License-Identifier: GPL-3.0-or-later
// A result as programs read it (JSON, CSV) and as people read it (tables). Files are written whole or not at all.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "workflow/contact_run.hpp"

namespace ehd {

using Json = nlohmann::ordered_json;

/// The result object of `ehd solve`. Numbers are finite; what is unknown or not asked for is absent, never null.
[[nodiscard]] Json to_json(const ContactRun& run);
[[nodiscard]] Json to_json(const Plan& plan);
/// Indented by two spaces, with a line feed at the end; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& json);

/// object[key] = value, where value is finite.
void put(Json& object, const std::string& key, double value);
void put(Json& object, const std::string& key, const std::optional<double>& value);

/// Columns X, P, H, rho, eta (and x_m, p_Pa, h_m where SI is known), a header line with units. rho and eta are
/// relative to rho_0 and eta_0, and absent for a dry contact; where eta/eta_0 overflows, eta is left empty.
[[nodiscard]] std::string profile_csv(const ContactRun& run);

/// The result, its status, the plausibility table and the cost, for a terminal. `styled`: with bold and colour.
[[nodiscard]] std::string human_table(const ContactRun& run, const std::string& title, bool styled);
[[nodiscard]] std::string human_plan(const Plan& plan);

/// Rows of cells as aligned columns, two spaces between; the first `left` columns flush left, the others right.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left,
                                  const std::string& indent = "");

/// Where a file cannot be written: what() names it and says why.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that appears whole, at commit, or not at all. The constructor already opens a temporary file beside it, so
/// that a path that cannot be written is refused before anything is computed (OutputError). Devices and pipes
/// (/dev/stdout) are written directly.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// Throws OutputError; the old file is then still there.
  void commit(const std::string& text);

  /// The same in pieces, of what would not fit into memory: what is appended shows at commit().
  void append(const std::string& text);
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty when done, or for a device
};

}  // namespace ehd
