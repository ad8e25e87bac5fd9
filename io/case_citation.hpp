// SPDX-License-Identifier: GPL-3.0-or-later
// A case as somebody else uses it: its BibTeX entry, and its problem and digits as JSON.
#pragma once

#include <string>
#include <vector>

#include "io/bibliography.hpp"
#include "io/json.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// An entry for each case (id, version, digits, this software), and the entries of their sources, each once.
[[nodiscard]] std::string bibtex_of_cases(const std::vector<Case>& cases, const Bibliography& bibliography);
/// Whether the file of the case stands in the folder of the benchmark cases, or in a folder of it such as cases/atlas.
/// Only such a case may be cited: another file may have the same id and other values.
[[nodiscard]] bool is_benchmark_case(const Case& any);
/// All entries of the bibliography, unchanged.
[[nodiscard]] std::string bibtex_of_sources(const Bibliography& bibliography);

/// {"schema": "ehd-cases-1", "cases": [{"case", "version", "title", "source", "problem", "expect"}]}; a bearing has no
/// "problem".
[[nodiscard]] Json cases_json(const std::vector<Case>& cases);

}  // namespace ehd
