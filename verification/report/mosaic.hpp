// SPDX-License-Identifier: GPL-3.0-or-later
// Several pictures side by side in one file.
#pragma once

#include <string>
#include <vector>

#include "verification/report/svg.hpp"

namespace ehd::report {

/// `tiles`: pictures drawn for Place::page, each with an id of its own, in rows of `columns`. A row is as high as its
/// highest tile. `frame`: its size is not read; `heading`: markup above the tiles. Throws std::invalid_argument where
/// there is no tile, no column, or a tile that is no picture.
[[nodiscard]] std::string mosaic(const Picture& frame, const std::string& heading,
                                 const std::vector<std::string>& tiles, std::size_t columns);

}  // namespace ehd::report
