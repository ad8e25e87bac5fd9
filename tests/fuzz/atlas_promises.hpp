// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader of atlas.csv promises of ANY bytes: a refusal in one line, or a table that is the same when it is
// written and read again.
#pragma once

#include <string>
#include <string_view>

#include "io/case_reader.hpp"
#include "tests/files.hpp"
#include "tests/fuzz/refusal.hpp"
#include "verification/atlas/table.hpp"

namespace ehd::verification::promises {

inline std::string atlas_broken(std::string_view bytes) {
  static const test::Folder folder;
  const auto file = folder.write("atlas.csv", bytes);
  try {
    const AtlasTable table = read_atlas_table(file);
    (void)digits_text(table);
    const std::string written = csv_text(table);
    if (csv_text(read_atlas_table(folder.write("again.csv", written))) != written) return "another table is read back";
  } catch (const CaseError& refusal) {
    return broken_by_refusal(refusal.what(), file.string(), bytes);
  }
  return "";
}

}  // namespace ehd::verification::promises
