// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/label_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace jalon {

namespace {

constexpr double kDigitWidth = 0.6;  // of the text's height
constexpr double kLeastRoom = 0.5;   // half the text's height free on each side

// Pixels to the nearest pixel of another label, counted as a king moves, in two passes (Rosenfeld & Pfaltz 1966).
std::vector<uint16_t> distances_to_border(const LabelRaster& raster) {
  const size_t columns = raster.columns, rows = raster.rows;
  const auto& labels = raster.labels;
  std::vector<uint16_t> out(labels.size(), 0);
  const auto step = [&](size_t at, size_t other, uint16_t& least) {
    least = std::min<uint16_t>(least, labels[other] == labels[at] ? out[other] : 0);
  };
  for (size_t y = 1; y + 1 < rows; ++y)
    for (size_t x = 1; x + 1 < columns; ++x) {
      const size_t at = y * columns + x;
      uint16_t least = UINT16_MAX - 1;
      for (const size_t other : {at - columns - 1, at - columns, at - columns + 1, at - 1})
        step(at, other, least);
      out[at] = static_cast<uint16_t>(least + 1);
    }
  for (size_t y = rows - 1; y-- > 1;)
    for (size_t x = columns - 1; x-- > 1;) {
      const size_t at = y * columns + x;
      uint16_t least = static_cast<uint16_t>(out[at] - 1);
      for (const size_t other : {at + columns + 1, at + columns, at + columns - 1, at + 1})
        step(at, other, least);
      out[at] = static_cast<uint16_t>(least + 1);
    }
  return out;
}

}  // namespace

std::vector<LabelNumber> place_numbers(const LabelRaster& raster, double text_height) {
  if (raster.columns < 3 || raster.rows < 3) return {};
  const std::vector<uint16_t> room = distances_to_border(raster);
  uint32_t last = 0;
  for (const uint32_t label : raster.labels)
    if (label != LabelRaster::kNoise) last = std::max(last, label);
  std::vector<size_t> best(last + size_t{1}, raster.labels.size());
  for (size_t i = 0; i < raster.labels.size(); ++i) {
    const uint32_t label = raster.labels[i];
    if (label == LabelRaster::kEmpty || label == LabelRaster::kNoise) continue;
    if (best[label] == raster.labels.size() || room[i] > room[best[label]]) best[label] = i;
  }
  std::vector<LabelNumber> out;
  for (uint32_t label = 1; label <= last; ++label) {
    if (best[label] == raster.labels.size()) continue;
    const double digits = static_cast<double>(std::to_string(label).size());
    const double needed = text_height * std::max(kLeastRoom, kDigitWidth * digits / 2);
    if (room[best[label]] < needed) continue;
    out.push_back({label, static_cast<uint32_t>(best[label] % raster.columns),
                   static_cast<uint32_t>(best[label] / raster.columns)});
  }
  return out;
}

}  // namespace jalon
