// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/plane/vector_plane.h"
#include "segment/segmentation.h"

namespace jalon {

struct JointSetting {
  bool enabled = true;
  double gap_m =
      0;  ///< edges this near to another plane are drawn to it; 0: two spacings of its points
};

/// A vertex that several planes share, by its place in each.
struct SharedCorner {
  struct Use {
    size_t plane = 0;
    Vec2 place;
  };
  Vec3 position;
  std::vector<Use> uses;
};

/// Closes the gaps where planes meet (Boulaassal 2010, 5.6.3.3): corners of facades, walls on the
/// ground, sills and cornices on walls. A straight edge of an outline within the gap of a plane
/// that is there moves onto the line in which both planes intersect (EdgeSource::kPlanes); where
/// both planes have such an edge, ends nearer than the gap become one vertex. Faces stay exactly
/// plane: corners move in their plane only, and a vertex of three planes is their common point.
/// segments: planes[i] is that of segments[i]; their covariances give the joints' sigma_m.
///
/// After: faces are as sound as they were (one that would meet itself or its openings keeps its
/// edges); edges that moved have source and sigma of their joint; a shared corner has its place in
/// each plane. O(faces^2) box tests + the edges of neighbours.
std::vector<SharedCorner> join_planes(std::vector<VectorPlane>& planes,
                                      std::span<const Segment> segments,
                                      const JointSetting& setting, Task& task);

}  // namespace jalon
