// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Volumes between two models. Closed surfaces: the difference of what they enclose. Others: square prisms along the
// direction, from the topmost surface of one model to that of the other, a ray through the centre of each cell.

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "compare/distance/model_surface.h"
#include "compare/volumes/mesh_closure.h"
#include "compare/volumes/volume.h"
#include "spatial/triangles/tree.h"

namespace jalon {

namespace {

constexpr double kChordError_m = 1e-4;
constexpr double kCellsAcross = 500;
constexpr size_t kModelVolumeCellGrain = 2048;

struct State {
  ModelSurface surface;
  Box3 box;
  MeshClosure closure;
  double enclosed_m3 = kNaN;  ///< NaN unless closed

  State(const Model& model, Task& task) : surface(model, kChordError_m, task) {
    for (const auto& t : surface.triangles())
      for (const uint32_t v : t) box.add(surface.vertices()[v]);
    closure = closure_of(surface.vertices(), surface.triangles(), task);
    if (closure.is_closed())
      enclosed_m3 = enclosed_volume(surface.vertices(), surface.triangles(), task);
  }
};

Box3 projected_box(const State& state, const VolumeGrid& grid) {
  Box3 box;
  for (const auto& t : state.surface.triangles())
    for (const uint32_t v : t) box.add(grid.project(state.surface.vertices()[v]));
  return box;
}

/// Height of the topmost surface above the centre of each cell. Rays come from above.
CellHeights surface_heights(const State& state, const VolumeGrid& grid, double top, Task& task) {
  const auto tree = TriangleTree::build(state.surface.vertices(), state.surface.triangles(), task);
  CellHeights out(grid.cells());
  parallel_for(task, grid.cells(), kModelVolumeCellGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      RayHit hit;
      const bool found = tree->nearest({grid.place(c, top), -grid.up}, hit);
      out.height[c] = found ? top - hit.t : kNaN;
      out.variance[c] = 0;
      out.points[c] = found ? 1 : 0;
    }
  });
  return out;
}

/// Both closed: nothing to cut or fill cell by cell.
Volume enclosed_difference(const State& reference, const State& compared) {
  Volume out;
  add_value<double>(out.summary, "net", "m3",
                    "what the compared model encloses less what the reference encloses",
                    compared.enclosed_m3 - reference.enclosed_m3);
  return out;
}

Volume prisms(const State& reference, const State& compared, const VolumeSettings& settings,
              Task& task) {
  const VolumeGrid axes = volume_axes(reference.box, compared.box, settings.direction);
  Box3 both = projected_box(reference, axes);
  both += projected_box(compared, axes);
  const double extent = std::max(both.max.x - both.min.x, both.max.y - both.min.y);
  const double wanted = settings.cell_m;
  const double cell_m = wanted > 0 ? wanted : extent > 0 ? extent / kCellsAcross : 1;
  const VolumeGrid grid = grid_over(axes, both, cell_m);
  const double top = both.max.z + 1;
  const CellHeights before = surface_heights(reference, grid, top, task);
  const CellHeights after = surface_heights(compared, grid, top, task);
  return sum_up_volume(grid, before, after, settings.dead_band_m, task);
}

}  // namespace

Volume volume_between(const Model& reference, const Model& compared, const VolumeSettings& settings,
                      Task& task) {
  const State before(reference, task), after(compared, task);
  using Surfaces = VolumeSettings::Surfaces;
  const Surfaces surfaces = settings.surfaces;
  const bool both_closed = before.closure.is_closed() && after.closure.is_closed();
  if (surfaces == Surfaces::kClosed && !both_closed) {
    const State& open = before.closure.is_closed() ? after : before;
    fail(Status::kDegenerate,
         "the %s model is not closed: %llu sides at a border, %llu where triangles run opposite "
         "ways",
         &open == &before ? "reference" : "compared",
         static_cast<unsigned long long>(open.closure.border_sides),
         static_cast<unsigned long long>(open.closure.inconsistent_sides));
  }
  const bool closed =
      surfaces == Surfaces::kClosed || (surfaces == Surfaces::kAutomatic && both_closed);
  Volume out = closed ? enclosed_difference(before, after) : prisms(before, after, settings, task);
  add_value<double>(out.summary, "reference_volume", "m3",
                    "that the reference encloses; NaN unless closed", before.enclosed_m3);
  add_value<double>(out.summary, "compared_volume", "m3",
                    "that the compared model encloses; NaN unless closed", after.enclosed_m3);
  return out;
}

}  // namespace jalon
