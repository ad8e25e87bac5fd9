// SPDX-License-Identifier: GPL-3.0-or-later
// A kept row of a sweep, read back. It may come from another machine: a right checksum does not make a right row. For
// source files only: the header of JSON is large.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "io/json.hpp"
#include "io/sweep_file.hpp"

namespace ehd {

/// A kept row does not have the form that io/sweep_row writes for this sweep. what() says why.
class StoredRowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct StoredRow {
  std::string text;  ///< the row's object in rows.json
  Json json;         ///< the text, parsed
};

/// `kept`: the text of a ComputedRow; `hash`: the row_hash of row number `row`. Checks everything that the tables
/// and messages read: the keys with their values, the hash, a result for each law with its status, and the type of
/// every entry that rows.csv shows. Throws StoredRowError.
[[nodiscard]] StoredRow read_stored_row(const Sweep& sweep, std::size_t row, const std::string& hash,
                                        const std::string& kept);

}  // namespace ehd
