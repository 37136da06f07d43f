// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "formats/drawings/pixels.h"
#include "geometry/vec.h"
#include "model/model.h"

namespace jalon {

/// What a page shows in three dimensions: clouds, outlines, and what a click on them tells.
struct ViewChannel {
  enum class Kind : uint8_t {
    kLabel,   ///< a number from 0 on, each with a colour
    kScale,   ///< a value on a scale of colours; NaN: none[0], -infinity: none[1]
    kColour,  ///< 0xRRGGBB
  };
  Kind kind = Kind::kScale;
  std::string name, unit;
  double low = 0, high = 1;  ///< ends of the scale
  std::vector<Rgb> colours;  ///< of the labels; of the scale, evenly
  struct None {
    Rgb colour;
    std::string name;  ///< "" is not told in the legend
  };
  std::vector<None> none;
  std::function<double(size_t point)> value;
};

struct ViewCloud {
  std::string name;
  CloudPtr cloud;
  Transform pose;  ///< where it is shown: T_world_cloud
  Rgb colour{0x80, 0x80, 0x80};
  bool is_hidden = false;  ///< until the reader asks for it
  std::vector<ViewChannel> channels;
};

/// Outlines that belong together and have a name.
struct ViewPart {
  std::string tag;   ///< written on the picture, "" = nothing
  std::string text;  ///< what a click tells
  Rgb colour{0x33, 0x33, 0x33};
  bool is_opening = false;
  std::vector<std::vector<Vec3>> rings;  ///< the outer one first, in one plane
};

struct ViewScene {
  std::vector<ViewCloud> clouds;
  std::vector<ViewPart> parts;
  std::vector<std::string> labels;         ///< what a click tells of a point with label i
  Vec3 along{1, 0, 0}, towards{0, -1, 0};  ///< to the right for an eye in front, and to that eye
  Box3 focus;                              ///< what the first view shows; empty: all
};

}  // namespace jalon
