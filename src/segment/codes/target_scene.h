// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "cloud/cloud.h"
#include "geometry/plane.h"
#include "segment/codes/coded_object.h"
#include "segment/codes/opening_front.h"
#include "segment/codes/plan_tiles.h"
#include "segment/codes_settings.h"

namespace jalon {

/// The plane of a target's wall, upright or not, and up to which height its points reach.
struct TargetWall {
  uint32_t object = 0;
  Plane plane;
  double high_m = -std::numeric_limits<double>::infinity();
};

/// A frame or leaf that form "improved" found, in the upright plane of its target: what lies around it and before its
/// front, up to the wall, is the wall's reveal.
struct FoundOpening {
  Plane plane;
  Vec3 along;          ///< level, in the plane
  double outside = 1;  ///< 1: the wall lies on the side of the plane's normal, else -1
  OpeningFront front;
  bool has_sill = false;                                  ///< a window
  double left_m = 0, right_m = 0, low_m = 0, high_m = 0;  ///< along the plane, and heights
};

/// A cloud while targets take their points out of it: a point that has an object is set aside for those that follow.
struct TargetScene {
  TargetScene(const Cloud& all, CodedObjects& listed, const TargetCodeSettings& given, Task& task)
      : cloud(all),
        objects(listed),
        settings(given),
        owner(all.size(), 0),
        tiles(all, listed.origin, task) {}

  const Cloud& cloud;
  CodedObjects& objects;
  const TargetCodeSettings& settings;
  std::vector<uint32_t> owner;  ///< object of each point, 0: none yet
  PlanTiles tiles;
  std::vector<TargetWall> walls;  ///< form "improved" looks for openings behind them
  std::vector<FoundOpening> openings;

  bool is_improved() const { return settings.input.form == CodeForm::kImproved; }
  Vec3 local(size_t i) const { return cloud.point(i) - objects.origin; }
  Vec3 place(const CodedPoint& target) const { return target.position - objects.origin; }
};

/// Indices, ascending, of the points about a target's centre; in_whole: also those that have an object already.
std::vector<uint32_t> patch_of(const TargetScene& scene, const CodedPoint& target, bool in_whole);
/// Least-squares plane of points, relative to the objects' origin; nothing for fewer than three or collinear ones.
std::optional<Plane> plane_of(const TargetScene& scene, const std::vector<uint32_t>& points);
/// Indices, ascending, of the points without an object that keep(local point) takes.
template <class Keep>
std::vector<uint32_t> free_points(const TargetScene& scene, Keep&& keep, Task& task);
/// The same in the tiles that a circle in plan meets.
template <class Keep>
std::vector<uint32_t> free_about(const TargetScene& scene, const Vec2& place, double radius_m,
                                 Keep&& keep);
/// Whether two targets' patches lie in one plane, as panes of a facade do; true where one has no patch.
bool are_on_one_facade(const TargetScene& scene, const CodedPoint& a, const CodedPoint& b);
void warn_of_target(TargetScene& scene, const CodedObject& object, std::string text);

/// Walls from one target each: draws of planes through the target, then what is above the first gap in height and in
/// columns lower than a wall goes back.
void take_walls(TargetScene& scene, Task& task);
/// Doors from one target each, the windows of a facade from two.
void take_doors(TargetScene& scene, Task& task);
void take_windows(TargetScene& scene, Task& task);
/// Form "improved": the reveals and sills of the openings found go to their walls, and what of a wall over
/// them is too low for a wall.
void take_reveals(TargetScene& scene, Task& task);
/// Gutters grown from one target each over points with nearly level normals.
void take_gutters(TargetScene& scene, Task& task);

}  // namespace jalon

#include "base/parallel.h"

namespace jalon {

template <class Keep>
std::vector<uint32_t> free_points(const TargetScene& scene, Keep&& keep, Task& task) {
  constexpr size_t kFreePointsPerChunk = 1 << 15;
  const size_t n = scene.owner.size();
  std::vector<std::vector<uint32_t>> parts((n + kFreePointsPerChunk - 1) / kFreePointsPerChunk);
  parallel_for(task, n, kFreePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (scene.owner[i] == 0 && keep(scene.local(i)))
        parts[begin / kFreePointsPerChunk].push_back(static_cast<uint32_t>(i));
  });
  std::vector<uint32_t> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

template <class Keep>
std::vector<uint32_t> free_about(const TargetScene& scene, const Vec2& place, double radius_m,
                                 Keep&& keep) {
  return scene.tiles.points_about(
      place, radius_m, [&](uint32_t i) { return scene.owner[i] == 0 && keep(scene.local(i)); });
}

}  // namespace jalon
