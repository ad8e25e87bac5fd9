// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of cases/references.bib. It knows the part of BibTeX that the file uses: @type{key, field = {text}, …},
// one field a line.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ehd {

struct BibliographyEntry {
  std::string key;
  std::map<std::string, std::string> fields;  ///< without braces
  std::string text;                           ///< the entry as it stands in the file
  /// One line: "Kostreva (1984), Int. J. Num. Meth. Fluids 4, 377-397, doi …". Unknown parts are left out.
  [[nodiscard]] std::string citation() const;
};

using Bibliography = std::map<std::string, BibliographyEntry>;

/// Throws CaseError where the file cannot be read.
[[nodiscard]] Bibliography read_bibliography(const std::filesystem::path& file);

/// The key in a case's source: the text before the first comma.
[[nodiscard]] std::string bibliography_key(const std::string& source);

}  // namespace ehd
