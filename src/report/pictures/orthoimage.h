// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/drawings/pixels.h"
#include "formats/facade_views.h"
#include "model/model.h"

namespace jalon {

/// What the pixels of an orthoimage tell. kAuto: the first of these that the cloud has.
enum class OrthoContent { kAuto, kColour, kIntensity, kDistance };

/// Operation "orthoimage".
struct OrthoimageSettings {
  int64_t facade = 0;  ///< 1 ... : the k-th part of class facade; 0: that with the largest front
  OrthoContent content = OrthoContent::kAuto;
  double pixel_m = 0;                       ///< 0 = from the spacing of the points
  double in_front_m = 1.0, behind_m = 1.0;  ///< of the front plane: what is shown
  int64_t fill = 2;                         ///< how often small holes are closed
};
std::span<const ParamRow> orthoimage_rows();

/// A facade seen along the horizontal of its front plane, in true scale. Rows run from the top.
struct Orthoimage {
  OrthoContent content = OrthoContent::kDistance;
  PlacedFacade facade;
  uint32_t columns = 0, rows = 0;
  double pixel_m = 0;
  double left_m = 0,
         top_m = 0;  ///< of the outer corner of the first pixel, on the sheet of the elevation
  std::vector<uint8_t> has_data;  ///< one a pixel
  std::vector<uint8_t> colours;   ///< kColour: red, green, blue of each pixel
  std::vector<float> values;      ///< else: intensity, or metres before the front plane

  size_t size() const { return size_t{columns} * rows; }
};

/// Each pixel has the mean of its points nearest to the viewer. most_pixels: above, the pixels become larger where
/// their size was left open; Error(kLimit) where it was told. Error(kDegenerate) without an upright face,
/// kInsufficientData without points near the plane. O(points + pixels).
Orthoimage make_orthoimage(const Cloud& cloud, const Model& model,
                           const OrthoimageSettings& settings, double most_pixels, Task& task);

/// The same; none where there is no upright face or no point near it.
std::optional<Orthoimage> find_orthoimage(const Cloud& cloud, const Model& model,
                                          const OrthoimageSettings& settings, double most_pixels,
                                          Task& task);

constexpr double kMostOrthoPixels = 64e6;  // of a file: two gigabytes while it is made
constexpr double kOrthoPagePixels = 5e5;   // in a page: some megabytes at most

/// What pixels of a value look like: intensity in greys, the darkest and lightest fiftieth cut; distances from blue
/// (behind) over white to red (before), to 20 mm at least.
struct OrthoColours {
  double low = 0, high = 1;
  bool is_distance = false;
  Rgb operator()(double value) const;
};
OrthoColours colours_of(const Orthoimage& image);
/// Pixels without data are transparent.
RgbaImage rgba_of(const Orthoimage& image);

}  // namespace jalon
