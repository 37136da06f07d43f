// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/deviation_raster.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "cloud/statistics.h"

namespace jalon {

namespace {

constexpr uint32_t kHiddenLabel = DeviationScale::kSteps + 1, kQuietLabel = kHiddenLabel + 1;
constexpr const char* kAxisNames[3] = {"X (m)", "Y (m)", "Z (m)"};

Vec3 unit(int axis, double length = 1) {
  Vec3 out;
  out[axis] = length;
  return out;
}

}  // namespace

const char* DeviationAxes::right_name() const { return kAxisNames[right]; }
const char* DeviationAxes::up_name() const { return kAxisNames[up]; }

Projection DeviationAxes::projection(const Vec3& origin) const {
  return {
      origin, unit(right), unit(up), unit(into, into == 2 ? -1 : 1), {origin[right], origin[up]}};
}

DeviationAxes axes_of(const Comparison& comparison, DeviationView view, Task& task) {
  if (view == DeviationView::kPlan) return {0, 1, 2};
  if (view == DeviationView::kFront) return {0, 2, 1};
  if (view == DeviationView::kSide) return {1, 2, 0};
  // The two longest axes; heights stay upright.
  const Box3 box = bounds(*comparison.cloud, task);
  const Vec3 size = box.max - box.min;
  if (size.z <= std::min(size.x, size.y)) return {0, 1, 2};
  return size.x >= size.y ? DeviationAxes{0, 2, 1} : DeviationAxes{1, 2, 0};
}

LabelRaster deviation_raster(const Comparison& comparison, const DeviationScale& scale,
                             const Projection& projection, bool only_significant, Task& task) {
  const auto distance = comparison.points.require("distance").values<double>();
  const auto status = comparison.points.require("status").values<uint8_t>();
  std::span<const uint8_t> significant;
  if (only_significant) significant = comparison.points.require("significant").values<uint8_t>();
  std::vector<uint32_t> labels(distance.size());
  parallel_for(task, labels.size(), 1 << 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const bool is_told = std::isfinite(distance[i]);
      const bool is_quiet = is_told && !significant.empty() && significant[i] == 0;
      labels[i] = is_quiet  ? kQuietLabel
                  : is_told ? scale.step_of(distance[i]) + 1
                  : status[i] == static_cast<uint8_t>(CompareStatus::kHidden) ? kHiddenLabel
                                                                              : 0;
    }
  });
  return rasterise_points(*comparison.cloud, labels, projection, task);
}

IndexedImage deviation_image(const LabelRaster& raster, const DeviationScale& scale) {
  IndexedImage image{raster.columns, raster.rows, {}, {{0xff, 0xff, 0xff}, kNotComparedColour}};
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    image.palette.push_back(scale.colour(step));
  image.palette.push_back(kHiddenColour);
  image.palette.push_back(kNotComparedColour);  // not significant
  image.pixels.reserve(raster.labels.size());
  for (const uint32_t label : raster.labels)
    image.pixels.push_back(label == LabelRaster::kEmpty   ? uint8_t{0}
                           : label == LabelRaster::kNoise ? uint8_t{1}
                                                          : static_cast<uint8_t>(label + 1));
  return image;
}

}  // namespace jalon
