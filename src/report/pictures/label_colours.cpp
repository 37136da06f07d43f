// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/label_colours.h"

#include <algorithm>
#include <array>
#include <utility>

namespace jalon {

namespace {

constexpr std::array<Rgb, 18> kPalette = {{{0xa6, 0xbd, 0xd7},
                                           {0xce, 0xa2, 0x62},
                                           {0x00, 0x7d, 0x34},
                                           {0xff, 0xb3, 0x00},
                                           {0x80, 0x3e, 0x75},
                                           {0xf6, 0x76, 0x8e},
                                           {0x00, 0x53, 0x8a},
                                           {0xff, 0x68, 0x00},
                                           {0x93, 0xaa, 0x00},
                                           {0xc1, 0x00, 0x20},
                                           {0x53, 0x37, 0x7a},
                                           {0xf4, 0xc8, 0x00},
                                           {0xff, 0x7a, 0x5c},
                                           {0x7f, 0x18, 0x0d},
                                           {0x59, 0x33, 0x15},
                                           {0xb3, 0x28, 0x51},
                                           {0xf1, 0x3a, 0x13},
                                           {0x23, 0x2c, 0x16}}};
constexpr size_t kReach = 3;  // pixels: segments with a narrow gap between them count as neighbours

bool is_segment(uint32_t label) {
  return label != LabelRaster::kEmpty && label != LabelRaster::kNoise;
}

using Pair = std::pair<uint32_t, uint32_t>;

// Which segments meet, both ways round, each pair once.
std::vector<Pair> neighbours_of(const LabelRaster& raster) {
  std::vector<Pair> out;
  const auto add = [&](uint32_t a, uint32_t b) {
    if (a == b || !is_segment(a) || !is_segment(b)) return;
    const Pair pair = std::minmax(a, b);
    if (out.empty() || out.back() != pair) out.push_back(pair);
  };
  const auto unique = [&] {
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  };
  for (size_t y = 0; y < raster.rows; ++y) {
    for (size_t x = 0; x < raster.columns; ++x) {
      const size_t at = y * raster.columns + x;
      for (size_t d = 1; d <= kReach; ++d) {
        if (x + d < raster.columns) add(raster.labels[at], raster.labels[at + d]);
        if (y + d < raster.rows) add(raster.labels[at], raster.labels[at + d * raster.columns]);
      }
    }
    if (out.size() > size_t{1} << 20) unique();
  }
  const size_t half = out.size();
  for (size_t i = 0; i < half; ++i) out.emplace_back(out[i].second, out[i].first);
  unique();
  return out;
}

}  // namespace

std::span<const Rgb> segment_palette() { return kPalette; }

std::vector<uint8_t> colour_labels(const LabelRaster& raster, size_t segments) {
  const std::vector<Pair> pairs = neighbours_of(raster);
  std::vector<uint64_t> pixels(segments + 1, 0);
  for (const uint32_t label : raster.labels)
    if (is_segment(label)) ++pixels[label];
  std::vector<uint8_t> colours(segments, 0);
  std::array<uint64_t, kPalette.size()> used{};  // pixels
  auto pair = pairs.begin();
  for (uint32_t label = 1; label <= segments; ++label) {
    std::array<uint64_t, kPalette.size()> near{};
    for (; pair != pairs.end() && pair->first == label; ++pair)
      if (pair->second < label) ++near[colours[pair->second - 1]];
    size_t best = 0;
    for (size_t c = 1; c < kPalette.size(); ++c)
      if (std::pair(near[c], used[c]) < std::pair(near[best], used[best])) best = c;
    colours[label - 1] = static_cast<uint8_t>(best);
    used[best] += 1 + pixels[label];
  }
  return colours;
}

IndexedImage image_of(const LabelRaster& raster, std::span<const uint8_t> colours) {
  IndexedImage image{raster.columns, raster.rows, {}, {kPaperColour, kNoiseColour}};
  image.palette.insert(image.palette.end(), kPalette.begin(), kPalette.end());
  image.pixels.reserve(raster.labels.size());
  for (const uint32_t label : raster.labels)
    image.pixels.push_back(label == LabelRaster::kEmpty ? uint8_t{0}
                           : label == LabelRaster::kNoise
                               ? uint8_t{1}
                               : static_cast<uint8_t>(2 + colours[label - 1]));
  return image;
}

}  // namespace jalon
