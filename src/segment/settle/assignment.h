// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"
#include "segment/settle/surface_patch.h"

namespace jalon {

/// Gives every point to its likeliest surface, by distance, sigma and density, among those within the tolerance whose
/// raster reaches the point: once all planes are known, no surface keeps what it took from later ones (Boulaassal
/// 2010, 3.4.5: robbery by order). Updates positions and scene.owner; surfaces keep their order.
void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// The same round after round, between which surfaces are refitted, dropped, split or joined: looked at are the points
/// that a surface may reach which is not what it was, the others stay as they are.
class Assignment {
 public:
  void next_round(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

 private:
  /// Owners of the last round as owners of this one, 0 for those that are gone.
  std::vector<uint32_t> renew_patches(const SegmentScene& scene,
                                      const std::vector<Surface>& surfaces,
                                      std::vector<SurfacePatch>& changed, Task& task);
  void box_blocks(const SegmentScene& scene, Task& task);

  std::vector<SurfacePatch> patches_;  ///< by owner
  std::vector<Box3> boxes_;            ///< of short runs of points
};

}  // namespace jalon
