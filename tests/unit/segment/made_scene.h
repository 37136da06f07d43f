// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "segment/ransac/extraction.h"
#include "unit/segment/scenes.h"

namespace jalon::test {

/// A cloud with all that the steps of a run share, its cells looked at.
struct MadeScene {
  CloudPtr cloud;
  Task task;
  RansacScene scene;

  explicit MadeScene(const std::vector<Vec3>& points, const SurfaceSettings& settings = {})
      : cloud(cloud_of(points)), scene{indexed_scene(*cloud, settings, task), {}, {}} {
    look_at_cells(scene, task);
  }

  /// Index in the cloud of the point at a position.
  uint32_t point(size_t position) const { return scene.tree->order()[position]; }
  /// A surface that owns the points of a face, with their least-squares plane.
  Surface surface(const std::vector<int>& faces, int face, uint32_t owner) {
    Surface out;
    out.pixel_m = 0.1;
    Moments moments;
    for (uint32_t p = 0; p < scene.size(); ++p) {
      if (faces[point(p)] != face) continue;
      out.positions.push_back(p);
      scene.owner[p] = owner;
      moments.add(scene.local(p));
    }
    PlaneFit fit;
    fit_plane(moments, fit);
    out.plane = fit.plane;
    out.sigma_m = fit.sigma;
    out.area_m2 = occupied_area_m2(bounded_raster(flat_points(scene, out, task), out.pixel_m, 0));
    return out;
  }
  /// The surfaces of faces 1 ... count.
  std::vector<Surface> surfaces(const std::vector<int>& faces, int count) {
    std::vector<Surface> out;
    for (int face = 1; face <= count; ++face)
      out.push_back(surface(faces, face, static_cast<uint32_t>(face)));
    return out;
  }
  /// Points of the face among those of the surface.
  size_t shared(const std::vector<int>& faces, int face, const Surface& surface) const {
    size_t count = 0;
    for (const uint32_t p : surface.positions) count += faces[point(p)] == face;
    return count;
  }
};

}  // namespace jalon::test
