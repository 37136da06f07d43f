// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "formats/files/byte_source.h"
#include "formats/settings.h"
#include "geometry/vec.h"

namespace jalon::png {

/// Keyword of the text chunk that tells a depth image's grid: the twelve numbers of DepthGrid, in metres.
inline constexpr char kGridKeyword[] = "Depth image grid";

/// Where the pixels of a depth image lie: origin + column * right + row * down + grey * toward, rows from the top.
struct DepthGrid {
  Vec3 origin;  ///< of the middle of the first pixel, at grey value 0
  Vec3 right, down;
  Vec3 toward;  ///< from a grey value to the next
  Vec3 point(uint32_t column, uint32_t row, uint32_t grey) const {
    return origin + static_cast<double>(column) * right + static_cast<double>(row) * down +
           static_cast<double>(grey) * toward;
  }
};

std::string text_of_grid(const DepthGrid& grid);
/// False when the text is none.
bool parse_grid(std::string_view text, DepthGrid& out);

/// Of a file of so many rows: by its own text, where there is one; else by the world file beside it, where there is
/// one, and the options; else by these. Error(kFormat) where they do not tell.
DepthGrid grid_of_file(const ByteSource& source, const std::string& text, uint32_t rows,
                       const ReadSettings& settings);

}  // namespace jalon::png
