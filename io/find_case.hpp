// SPDX-License-Identifier: GPL-3.0-or-later
// Where cases are found: the folder of benchmark cases, and the CASE argument of the command line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/substitution.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// The file of a CASE argument. With a '/' or the ending .toml the argument is a path. Otherwise it is the id of a case
/// in cases/ or in a folder of cases/; if there is none, it is a path too. Throws CaseError.
[[nodiscard]] std::filesystem::path find_case(const std::string& path_or_id);

/// The end of a message about an unknown id: what is allowed.
inline constexpr std::string_view allowed_id = "an id that `ehd cases` or `ehd cases --atlas` lists";
/// "did you mean ID? " of the cases in cases/, folders in it left out; or nothing.
[[nodiscard]] std::string did_you_mean_case(const std::string& id);

/// The folder of the benchmark cases: environment EHD_CASES, else the one the program was built from. An installed
/// program takes PREFIX/share/ehd/cases, which it finds from its own place, PREFIX/bin.
[[nodiscard]] std::filesystem::path cases_folder();

/// All cases in cases/, by id, folders in it left out. Throws CaseError at the first that cannot be read.
[[nodiscard]] std::vector<Case> all_cases();

/// The case that a CASE argument names, with other values for some of its keys; "-" is standard input, where the id may
/// be any. Throws CaseError.
[[nodiscard]] Case read_named_case(const std::string& path_id_or_dash,
                                   const std::vector<Substitution>& substitutions = {});

}  // namespace ehd
