// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "geometry/plane.h"

namespace jalon {

/// Orientation classes relative to the main facade (Boulaassal 2010, 3.4.5.2); the numbers of jalon/segmenter.h.
enum class Orientation : uint8_t { kNone = 0, kParallel = 1, kVertical = 2, kHorizontal = 3, kInclined = 4 };

/// A planar segment: one architectural surface.
struct PlaneSegment {
  uint32_t label = 0;  ///< 1-based; points carry it
  Orientation orientation = Orientation::kNone;
  PlaneFit fit;        ///< normal toward the station where known
  double area_m2 = 0;  ///< occupied raster cells
  double length_u_m = 0, length_v_m = 0;  ///< extents along axis_u, axis_v
};

/// Result of a segmenter: immutable, keeps its cloud.
struct Segmentation {
  CloudPtr cloud;
  ColumnPtr labels;        ///< "label" uint32: 0 = noise set, s = segments[s - 1]
  ColumnPtr residuals;     ///< "residual" float32, m, signed distance to the own plane; NaN for noise
  ColumnPtr orientations;  ///< "orientation" uint8
  std::vector<PlaneSegment> segments;  ///< largest first
  Transform T_facade_world;
  std::string parameters_json;  ///< what it was made with
};

using SegmentationPtr = std::shared_ptr<const Segmentation>;

/// Parameter table of method "ransac".
std::span<const ParamRow> ransac_rows();
/// Sequential planes by seeded adaptive RANSAC (see segment/ransac.h for the steps).
Segmentation segment_ransac(const CloudPtr& cloud, const ParamSet& params, Task& task);

}  // namespace jalon
