// SPDX-License-Identifier: GPL-3.0-or-later
// What the program and the library say of themselves, from io/provenance.
#pragma once

#include <cstddef>
#include <string>

namespace ehd {

/// "0.1.0 (1a2b3c4d, FFTW 3.3.10, Eigen 3.4.0)"; "changed since" behind the commit of a changed tree.
[[nodiscard]] std::string version_text();

/// "commit 1a2b3c4d5e6f, changed since", of that many letters; "no commit" outside git. For citations and headers.
[[nodiscard]] std::string commit_words(std::size_t letters);

/// The same as version_text(), then commit, compiler, flags and libraries, a line each; without a line feed at the end.
[[nodiscard]] std::string build_text();

}  // namespace ehd
