// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "formats/drawings/pixels.h"
#include "report/pictures/label_raster.h"

namespace jalon {

/// Colours of segments: far apart from each other (Kelly 1965, without greys), the calm ones first.
std::span<const Rgb> segment_palette();
constexpr Rgb kNoiseColour{0xb4, 0xb4, 0xb4}, kPaperColour{0xff, 0xff, 0xff};

/// Palette index of each label (by label - 1), so that segments that meet in the picture differ: greedy colouring by
/// label, then the colour that covers least so far, so that a wall has its colour for itself. The same picture gives
/// the same colours.
std::vector<uint8_t> colour_labels(const LabelRaster& raster, size_t segments);

/// The raster as a picture: palette entries 0 = paper, 1 = noise, 2 ... = segment_palette().
IndexedImage image_of(const LabelRaster& raster, std::span<const uint8_t> colours);

}  // namespace jalon
