// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/mosaic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "verification/report/heading.hpp"

namespace ehd::report {

namespace {

constexpr std::string_view picture_begins = "<svg ", size_begins = "viewBox=\"0 0 ";
constexpr double tile_gap = 16, heading_height = 24;  // pixels

struct MosaicTile {
  std::string svg;
  double width = 0, height = 0;
};

/// The size that picture() wrote.
MosaicTile tile_of(const std::string& svg) {
  MosaicTile tile{.svg = svg};
  const std::size_t at = svg.find(size_begins);
  if (!svg.starts_with(picture_begins) || at == std::string::npos ||
      std::sscanf(svg.c_str() + at + size_begins.size(), "%lf %lf", &tile.width, &tile.height) != 2)
    throw std::invalid_argument("a tile is no picture of a page");
  return tile;
}

/// A picture within a picture stands where its x and y say.
std::string placed(const MosaicTile& tile, double x, double y) {
  return fmt::format("{}x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}", picture_begins, pixels(x), pixels(y),
                     pixels(tile.width), pixels(tile.height), tile.svg.substr(picture_begins.size()));
}

}  // namespace

std::string mosaic(const Picture& frame, const std::string& heading, const std::vector<std::string>& tiles,
                   std::size_t columns) {
  if (tiles.empty() || columns == 0) throw std::invalid_argument("a mosaic has tiles and columns");
  std::string content;
  double y = 0, width = 0;
  if (!heading.empty()) {
    content += "<text class=\"head\" x=\"8\" y=\"16\">" + markup_to_svg(heading) + "</text>\n";
    y = heading_height;
  }
  for (std::size_t first = 0; first < tiles.size(); first += columns) {
    double x = 0, highest = 0;
    for (std::size_t k = first; k < std::min(first + columns, tiles.size()); ++k) {
      const MosaicTile tile = tile_of(tiles[k]);
      content += placed(tile, x, y);
      x += tile.width + tile_gap;
      highest = std::max(highest, tile.height);
    }
    width = std::max(width, x - tile_gap);
    y += highest + tile_gap;
  }
  Picture whole = frame;
  whole.width = std::max(width, heading_width(heading) + 16);
  whole.height = y - tile_gap;
  return picture(whole, content, Place::file);
}

}  // namespace ehd::report
