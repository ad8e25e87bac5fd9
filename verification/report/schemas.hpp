// SPDX-License-Identifier: GPL-3.0-or-later
// The schemas of the files that the report reads; docs/schema/ has them.
#pragma once

namespace ehd::report {

/// `name` stands in the file. Files of versions up to 0.2.0 have the number instead, and are read too.
struct FileSchema {
  const char* name;
  int number;
};
inline constexpr FileSchema results_schema{"ehd-verify-2", 2};  ///< results.json of ehd verify
inline constexpr FileSchema bench_schema{"ehd-bench-1", 1};     ///< bench.json
inline constexpr FileSchema stress_schema{"ehd-stress-1", 1};   ///< stress.json

}  // namespace ehd::report
