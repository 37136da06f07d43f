// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "base/task.h"
#include "model/buildings/building_offsets.h"
#include "model/model.h"
#include "registration/joint/strip_conditions.h"
#include "spatial/triangles/tree.h"

namespace jalon {

constexpr uint32_t kNoStrip = std::numeric_limits<uint32_t>::max();

/// The strips of a model where they are given, and what else of it stops a ray.
struct StripScene {
  std::vector<GivenStrip> strips;
  uint32_t blocks = 0, facades = 0;
  /// Corners, three a triangle, and the face that each triangle is of.
  std::vector<Vec3> corners;
  std::vector<uint32_t> face_of;
  /// Of each face: its strip (kNoStrip: it only hides what is behind) and block.
  std::vector<uint32_t> strip_of_face, block_of_face;
};
/// model: of strips (building_tree.h). Error(kInvalidArgument) for one without, or with a strip of no facade or
/// block, or whose faces do not stand in one upright plane.
StripScene strip_scene(const Model& model, bool occluders);

/// The triangles with blocks, facades and strips moved by these offsets. Triangle t is of face scene.face_of[t].
std::shared_ptr<const TriangleTree> tree_of(const StripScene& scene, const BuildingOffsets& offsets,
                                            Task& task);

/// How far a strip's plane moves along its normal.
inline double shift_of(const GivenStrip& strip, uint32_t number, const BuildingOffsets& by) {
  return dot(strip.normal, by.blocks[strip.block]) + by.facades[strip.facade] + by.strips[number];
}

}  // namespace jalon
