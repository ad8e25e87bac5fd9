// SPDX-License-Identifier: GPL-3.0-or-later
// cases/references.bib, as much of BibTeX as that file uses: @type{key, field = {text}, …}, a field a line.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ehd {

struct BibliographyEntry {
  std::string key;
  std::map<std::string, std::string> fields;  ///< without braces
  std::string text;                           ///< the entry as it stands in the file
  /// "Kostreva (1984), Int. J. Num. Meth. Fluids 4, 377-397, doi …": what is known, in one line.
  [[nodiscard]] std::string citation() const;
};

using Bibliography = std::map<std::string, BibliographyEntry>;

/// Throws CaseError where the file cannot be read.
[[nodiscard]] Bibliography read_bibliography(const std::filesystem::path& file);

/// The key in a case's source: what stands before the first comma.
[[nodiscard]] std::string bibliography_key(const std::string& source);

}  // namespace ehd
