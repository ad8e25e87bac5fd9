// SPDX-License-Identifier: GPL-3.0-or-later
// Where a result comes from: commit, compiler, libraries, machine, date.
#pragma once

#include <string>

#include "io/json.hpp"

namespace ehd {

/// {"version", "commit", "dirty", "compiler", "flags", "libraries", "cpu", "cores", "date"}. Unknown entries are
/// absent (the commit in a source tree without git).
[[nodiscard]] Json provenance();

/// "0.1.0 (1a2b3c4d, FFTW 3.3.10, Eigen 3.4.0)"; "changed since" behind the commit of a changed tree.
[[nodiscard]] std::string version_text();

/// The same, then commit, compiler, flags and libraries, a line each; without a line feed at the end.
[[nodiscard]] std::string build_text();

}  // namespace ehd
