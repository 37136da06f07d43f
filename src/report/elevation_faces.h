// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "model/model.h"
#include "segment/segmentation.h"

namespace jalon {

/// A face as the drawing shows it: seen from the street, x to the right along the facade, z up, depth away from the
/// eye.
struct DrawnFace {
  enum class Kind : uint8_t { kFront, kEdgeOn, kSlanted };
  Kind kind = Kind::kFront;
  uint32_t label = 0;
  double depth_m = 0;  ///< behind the main plane; negative = in front of it
  std::vector<std::vector<Vec2>> rings;  ///< (x, z); an edge-on face has one ring of its two end points
  size_t group = 0;                      ///< of the depth legend; front faces only
};

/// Front faces of about one depth: one colour.
struct DepthGroup {
  double from_m = 0, to_m = 0;
  size_t faces = 0;
};

struct ElevationFaces {
  std::vector<DrawnFace> faces;    ///< farthest first
  std::vector<DepthGroup> groups;  ///< nearest first
  Vec2 low, high;                  ///< box of the front faces (of all when there are none)
  bool empty = true;
  Vec3 corner_world;               ///< the point of the main plane at low
};

constexpr size_t kMaxDepthGroups = 8;

struct ViewLimits {
  double in_front_m = 10, behind_m = 10;  ///< of the main plane: the front face of the largest area
  double front_angle_rad = 0.26;          ///< largest turn of a front face from the facade
};

/// The model's faces within these limits.
ElevationFaces elevation_faces(const Segmentation& segmentation, const Model& model, const ViewLimits& limits,
                               Task& task);

}  // namespace jalon
