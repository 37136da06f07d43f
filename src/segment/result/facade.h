// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/segmentation.h"

namespace jalon {

/// The rows of a segmentation while they are made; fits are in the local frame whose origin is given.
struct FacadeContext {
  const Cloud& cloud;
  Vec3 origin;
  double orientation_tolerance_rad;
  bool facade_frame;
  const FacadeAxes* axes = nullptr;  ///< known before the planes, or null
};

/// Index of the main facade: the vertical plane of the largest area; -1 when there is none.
int main_facade(const std::vector<Segment>& segments);

/// Turns normals toward the station that saw most of the segment's points, and says which share of them did. Without
/// stations: horizontal planes upward; walls and what belongs to them toward the likelier viewer, with the probability
/// (front/fronts.h); others toward the viewer of the wall nearest to them, or without any toward the middle of the
/// cloud.
void turn_normals(const FacadeContext& context, std::span<const uint32_t> labels,
                  std::vector<Segment>& segments, Task& task);

/// Orientation class of each segment relative to the main facade, within the tolerance (Boulaassal 2010, 3.22-3.25).
void classify(const FacadeContext& context, std::vector<Segment>& segments);

/// Rotation about Z that takes the main facade's normal to -Y, about a whole-metre point of the facade that becomes
/// the origin.
Transform facade_transform(const FacadeContext& context, const std::vector<Segment>& segments);

}  // namespace jalon
