// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/scene.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "segment/surface/cell_firsts.h"

namespace jalon {

namespace {

// Smallest cells for normals and draws: sides of a few tolerances, so that the spread of three points is well above
// the noise; the largest ones are 2^kLevels times as wide.
constexpr double kFineCellTolerances = 4;
constexpr int kLevels = 6;

// A cube that starts at the smallest coordinates, so that any shift of the cloud, not only one by whole metres,
// leaves the cells and with them all draws as they are; the cloud's own octree keeps to whole metres and would cut
// the surfaces elsewhere.
Cube anchored_cube(const Box3& box) {
  const Vec3 sides = box.max - box.min;
  const double extent = std::max({sides.x, sides.y, sides.z});
  Cube cube;
  cube.origin = box.min;
  cube.edge = std::ldexp(1.0, std::ilogb(extent) + 1);
  return cube;
}

}  // namespace

SegmentScene indexed_scene(const Cloud& cloud, const SurfaceSettings& settings, Task& task) {
  const Cube anchored = anchored_cube(bounds(cloud, task));
  SegmentScene scene{
      .cloud = cloud, .settings = settings, .tree = Octree::build(cloud.xyz(), anchored, task)};
  scene.order = scene.tree->order();
  const Octree& tree = *scene.tree;
  scene.grid = {tree.grid_x(), tree.grid_y(), tree.grid_z(), tree.grid_step()};
  scene.origin = tree.cube().origin;
  scene.owner.assign(scene.size(), 0);
  scene.rejections.assign(scene.size(), 0);
  if (scene.settings.curved()) scene.curved_rejections.assign(scene.size(), 0);
  scene.rejected_blocks.assign(scene.size() / kRejectionBlock + 1, 0);
  scene.normals = Buffer<float>(3 * scene.size());
  scene.spacing = Buffer<float>(scene.size());
  return scene;
}

void look_at_cells(SegmentScene& scene, Task& task) {
  const Cube& cube = scene.tree->cube();
  const double finest =
      std::log2(cube.edge / (kFineCellTolerances * scene.settings.distance_tolerance_m));
  scene.fine_level = std::clamp(static_cast<int>(std::floor(finest)), 0, kMaxLevel);
  scene.coarse_level = std::max(0, scene.fine_level - kLevels);
  scene.level = Buffer<uint8_t>(scene.size());
  if (scene.normals.empty()) scene.normals = Buffer<float>(3 * scene.size());
  if (scene.spacing.empty()) scene.spacing = Buffer<float>(scene.size());
  scene.cell_firsts =
      cell_firsts(*scene.tree, scene.coarse_level, scene.fine_level, scene.level, task);
  estimate_local_surface(scene, task);
}

SegmentScene scene_with_cells(const Cloud& cloud, const SurfaceSettings& settings, Task& task) {
  SegmentScene made = indexed_scene(cloud, settings, task);
  look_at_cells(made, task);
  return made;
}

void release_points(SegmentScene& scene) {
  scene.order = {};
  scene.tree.reset();
  scene.grid = {};
  scene.cell_firsts = {};
  scene.owner = {};
  scene.rejections = {};
  scene.curved_rejections = {};
  scene.rejected_blocks = {};
  scene.normals = {};
  scene.spacing = {};
  scene.level = {};
}

void SegmentScene::forget_rejections() {
  for (size_t b = 0; b < rejected_blocks.size(); ++b) {
    if (std::exchange(rejected_blocks[b], uint8_t{0}) == 0) continue;
    for (auto* counts : {&rejections, &curved_rejections}) {
      const size_t begin = std::min(counts->size(), b * kRejectionBlock);
      std::fill_n(counts->data() + begin, std::min(kRejectionBlock, counts->size() - begin),
                  uint8_t{0});
    }
  }
}

// Among the firsts of the level's cells: a tenth of the points and less, where the codes of all points would be
// searched for both ends of the cell.
Octree::Cell SegmentScene::cell_around(int at_level, uint32_t position) const {
  const auto& firsts = cell_firsts[static_cast<size_t>(at_level - coarse_level)];
  const auto behind = std::upper_bound(firsts.begin(), firsts.end(), position);
  const uint64_t code = tree->code(position) >> (3 * (kMaxLevel - at_level));
  return {code, behind[-1], *behind - behind[-1]};
}

SurfaceAxes plane_axes(const Vec3& normal) {
  constexpr double kHorizontal = 0.95;  // nz beyond which "up in the plane" is ill defined
  const Vec3 reference = std::fabs(normal.z) < kHorizontal ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(reference, normal));
  return {u, cross(normal, u)};
}

}  // namespace jalon
