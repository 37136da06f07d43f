// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "geometry/symmetric_eigen.h"
#include "segment/surface/scene.h"

namespace jalon {

namespace {

constexpr uint8_t kUndecided = 0xff;
constexpr size_t kMinCellPoints =
    12;  // fewer say little: the angle error passes 5 degrees at 3 mm noise
constexpr size_t kMaxCellSample =
    48;  // more do not better a normal that is only compared with 25 degrees
constexpr double kMaxThickness = 0.5;  // rms of a planar cell, in tolerances
constexpr double kMaxFlatness = 0.05;  // smallest against middle eigenvalue of a planar cell
constexpr size_t kCellsPerChunk = 256;

struct PointRange {
  size_t begin, end;
};

// Free points of a cell: how many, whether one of them has no level yet.
struct Census {
  size_t free = 0;
  bool undecided = false;
};

Census census_of(const SegmentScene& scene, const PointRange& cell) {
  Census census;
  if (std::memchr(&scene.level[cell.begin], kUndecided, cell.end - cell.begin) == nullptr)
    return census;
  for (size_t i = cell.begin; i < cell.end; ++i) {
    if (scene.owner[i] != 0) continue;
    ++census.free;
    census.undecided |= scene.level[i] == kUndecided;
  }
  return census;
}

// Normal of the cell's points when they are flat, else NaN.
Vec3 cell_normal(const SegmentScene& scene, const PointRange& cell, size_t free_points) {
  Moments moments;
  moments.reference = scene.local(cell.begin);
  const size_t step = (free_points + kMaxCellSample - 1) / kMaxCellSample;
  size_t turn = 0;
  for (size_t i = cell.begin; i < cell.end; ++i)
    if (scene.owner[i] == 0 && turn++ % step == 0) moments.add(scene.local(i));
  const Vec3 none{kFloatNaN, kFloatNaN, kFloatNaN};
  if (moments.n < 3) return none;
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  const double thickness = kMaxThickness * scene.settings.distance_tolerance_m;
  const bool flat =
      eigen.values[0] <= thickness * thickness && eigen.values[0] <= kMaxFlatness * eigen.values[1];
  return flat && eigen.values[1] > 0 ? eigen.vectors[0] : none;
}

void decide_cell(SegmentScene& scene, const PointRange& cell, int level, bool keep_normals) {
  const Census census = census_of(scene, cell);
  const bool enough = census.free >= kMinCellPoints;
  if (!census.undecided || (!enough && level > scene.coarse_level)) return;
  Vec3 normal{kFloatNaN, kFloatNaN, kFloatNaN};
  if (enough && !keep_normals) normal = cell_normal(scene, cell, census.free);
  const double edge = std::ldexp(scene.tree->cube().edge, -level);
  const double spacing = edge / std::sqrt(static_cast<double>(std::max<size_t>(1, census.free)));
  for (size_t i = cell.begin; i < cell.end; ++i) {
    if (scene.owner[i] != 0 || scene.level[i] != kUndecided) continue;
    scene.level[i] = static_cast<uint8_t>(level);
    scene.spacing[i] = static_cast<float>(spacing);
    if (keep_normals) continue;
    for (int k = 0; k < 3; ++k)
      scene.normals[3 * i + static_cast<size_t>(k)] = static_cast<float>(normal[k]);
  }
}

}  // namespace

void take_field_normals(SegmentScene& scene, Task& task) {
  const Column& column = scene.cloud.fields.require("normal");
  if (column.info().components != 3 || !is_floating(column.info().type))
    fail(Status::kInvalidArgument, "field \"normal\" must have three floating-point components");
  parallel_for(task, scene.size(), 1 << 15, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t p = scene.order[i];
      const Vec3 m = normalized({column.number(p, 0), column.number(p, 1), column.number(p, 2)});
      const bool known = is_finite(m) && squared_norm(m) > 0;
      for (int k = 0; k < 3; ++k)
        scene.normals[3 * i + static_cast<size_t>(k)] =
            known ? static_cast<float>(m[k]) : kFloatNaN;
    }
  });
}

void estimate_local_surface(SegmentScene& scene, Task& task) {
  const bool keep_normals = scene.settings.normals == NormalSource::kField;
  if (keep_normals) take_field_normals(scene, task);
  parallel_for(task, scene.size(), 1 << 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (scene.owner[i] == 0) scene.level[i] = kUndecided;
  });
  for (int level = scene.fine_level; level >= scene.coarse_level; --level) {
    const auto& firsts = scene.cell_firsts[static_cast<size_t>(level - scene.coarse_level)];
    parallel_for(task, firsts.size() - 1, kCellsPerChunk, [&](size_t begin, size_t end) {
      for (size_t c = begin; c < end; ++c)
        decide_cell(scene, {firsts[c], firsts[c + 1]}, level, keep_normals);
    });
  }
}

}  // namespace jalon
