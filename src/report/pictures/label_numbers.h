// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "report/pictures/label_raster.h"

namespace jalon {

/// A segment's number on the picture, centred on a pixel.
struct LabelNumber {
  uint32_t label = 0, column = 0, row = 0;
};

/// One number for each segment that has room for a text of this height (pixels): where it is farthest from the
/// segment's border.
std::vector<LabelNumber> place_numbers(const LabelRaster& raster, double text_height);

}  // namespace jalon
