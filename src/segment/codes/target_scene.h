// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "cloud/cloud.h"
#include "geometry/plane.h"
#include "segment/codes/coded_object.h"
#include "segment/codes_settings.h"

namespace jalon {

/// A cloud while targets take their points out of it: a point that has an object is set aside for those that follow.
struct TargetScene {
  const Cloud& cloud;
  CodedObjects& objects;
  const TargetCodeSettings& settings;
  std::vector<uint32_t> owner;  ///< object of each point, 0: none yet

  Vec3 local(size_t i) const { return cloud.point(i) - objects.origin; }
  Vec3 place(const CodedPoint& target) const { return target.position - objects.origin; }
};

/// Indices of the points about a target's centre; in_whole: also those that have an object already.
std::vector<uint32_t> patch_of(const TargetScene& scene, const CodedPoint& target, bool in_whole,
                               Task& task);
/// Least-squares plane of points, relative to the objects' origin; nothing for fewer than three or collinear ones.
std::optional<Plane> plane_of(const TargetScene& scene, const std::vector<uint32_t>& points);
/// Indices, ascending, of the points without an object that keep(local point) takes.
template <class Keep>
std::vector<uint32_t> free_points(const TargetScene& scene, Keep&& keep, Task& task);
void warn_of_target(TargetScene& scene, const CodedObject& object, std::string text);

/// Walls from one target each: draws of planes through the target, then what is above the first gap in height and in
/// columns lower than a wall goes back.
void take_walls(TargetScene& scene, Task& task);
/// Doors from one target each, the windows of a facade from two.
void take_doors(TargetScene& scene, Task& task);
void take_windows(TargetScene& scene, Task& task);
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

}  // namespace jalon
