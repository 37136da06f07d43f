// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "report/elevation/drawn_ring.h"
#include "report/elevation/opening_list.h"
#include "report/settings.h"

namespace jalon {

/// A face as the drawing shows it, in view coordinates: x to the right along the facade, z up, depth away from the eye.
struct DrawnFace {
  enum class Kind : uint8_t { kFront, kEdgeOn, kSlanted };
  enum class Role : uint8_t {
    kWall,
    kElement,
    kInside,
    kGround,
    kNoData
  };  ///< kInside: seen in an opening
  Kind kind = Kind::kFront;
  Role role = Role::kElement;
  bool is_copy = false;
  uint32_t label = 0;
  double depth_m = 0;            ///< behind the main plane; negative = in front of it
  std::vector<DrawnRing> rings;  ///< outline, then holes
  Vec2 edge[2];                  ///< of an edge-on face
  size_t group = 0;              ///< of the depth legend; front faces only
  size_t face = 0;               ///< of the model
};

/// An opening as the drawing shows it.
struct DrawnOpening {
  size_t row = 0;      ///< of the list
  double depth_m = 0;  ///< of the wall around it
  std::vector<DrawnRing> contour;
  Vec2 low, high;
  bool is_empty = false;  ///< nothing was seen in it: drawn with the cross of an open hole
};

/// Front faces of about one depth: one colour.
struct DepthGroup {
  double from_m = 0, to_m = 0;
  size_t faces = 0;
  int side = 0;     ///< -1 in front of the main plane, 0 in it, 1 behind
  size_t rank = 0;  ///< from the main plane outward on its side, 0 the nearest
};

struct ElevationFaces {
  std::vector<DrawnFace> faces;    ///< farthest first
  std::vector<DepthGroup> groups;  ///< nearest to the eye first
  OpeningList list;                ///< of the whole model
  bool has_named_openings = false;
  std::vector<DrawnOpening> openings;  ///< of the faces shown, farthest first
  std::vector<DrawnRing> unknown;      ///< holes of walls without knowledge of what is there
  Vec2 low, high;                      ///< box of the front faces (of all when there are none)
  Vec2 wall_low, wall_high;            ///< box of the walls, where they are named; else the same
  double ground_m = 0;                 ///< as ground_level
  double main_sigma_m = 0;             ///< of the main plane
  bool empty = true;
  Vec3 corner_world;  ///< of the main plane: left end of the walls, lowest height of the box
};

constexpr size_t kMaxDepthGroups = 8;

/// The model's faces and openings within these limits.
ElevationFaces elevation_faces(const Model& model, const ElevationView& view,
                               const ViewLimits& limits, Task& task);

/// Adds what is shown of the openings; the faces must be there.
void add_openings(ElevationFaces& out, const Model& model, const ElevationView& view);

}  // namespace jalon
