// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A gauge along a trajectory: the tables of solid/sweep.h.

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/error.h"
#include "base/numbers.h"
#include "base/table_columns.h"
#include "compare/clearance/clearance.h"
#include "geometry/rigid_motion.h"
#include "solid/sweep.h"

namespace jalon {

namespace {

void put(const Vec3& v, bool known, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = known ? v[i] : kNaN;
}

double parameter_of(const SweepPlace& place) { return place.interval + place.time; }

FieldTable table_of(const std::vector<SweepPlace>& rows, const PartTriangles* triangles) {
  FieldTable t;
  const auto known = [](const SweepPlace& r) { return r.kind != ObstacleKind::kNone; };
  const auto source = [&](const SweepPlace& r) {
    return r.kind == ObstacleKind::kFace ? triangles->sources[r.index] : TriangleSource{};
  };
  add_column<double>(t, rows, "parameter", "1", "pose number and share of the way to the next",
                     [&](const SweepPlace& r) { return known(r) ? parameter_of(r) : kNaN; });
  add_column<double>(t, rows, "clearance", "m",
                     "from gauge to obstacle; negative: this deep inside",
                     [&](const SweepPlace& r) { return known(r) ? r.clearance_m : kNaN; });
  add_column<uint32_t>(t, rows, "interval", "", "from this pose to the next",
                       [](const SweepPlace& r) { return r.interval; });
  add_column<uint32_t>(t, rows, "piece", "", "of the gauge, or 2^32 - 1",
                       [&](const SweepPlace& r) { return known(r) ? r.piece : ~uint32_t{0}; });
  add_column<uint8_t>(t, rows, "kind", "", "0 nothing within reach, 1 point, 2 face",
                      [](const SweepPlace& r) { return static_cast<uint8_t>(r.kind); });
  add_column<uint64_t>(
      t, rows, "point", "", "point of the cloud, or 2^64 - 1",
      [](const SweepPlace& r) { return r.kind == ObstacleKind::kPoint ? r.index : kNoRow; });
  add_column<uint64_t>(t, rows, "part", "", "part, or 2^64 - 1",
                       [&](const SweepPlace& r) { return source(r).part; });
  add_column<uint64_t>(t, rows, "face", "", "row of the faces, or 2^64 - 1",
                       [&](const SweepPlace& r) { return source(r).face; });
  add_column<uint64_t>(t, rows, "triangle", "", "row of the triangles, or 2^64 - 1",
                       [&](const SweepPlace& r) { return source(r).triangle; });
  add_columns<double, 3>(t, rows, "xyz", "m", "the place, on the obstacle",
                         [&](const SweepPlace& r, double* o) { put(r.obstacle, known(r), o); });
  add_columns<double, 3>(t, rows, "gauge_xyz", "m",
                         "nearest point of the gauge's surface at that time",
                         [&](const SweepPlace& r, double* o) { put(r.gauge, known(r), o); });
  return t;
}

}  // namespace

SweepTables sweep_tables(std::span<const ConvexPiece> pieces, std::span<const Transform> poses,
                         const Cloud* cloud, const Model* model, const ClearanceSettings& settings,
                         Task& task) {
  for (size_t i = 0; i < poses.size(); ++i)
    require_rigid(poses[i], ("pose " + std::to_string(i)).c_str());
  if (cloud != nullptr && model != nullptr) require_one_crs(cloud->crs, model->crs);
  Obstacles obstacles;
  std::shared_ptr<const Octree> octree;
  if (cloud != nullptr && cloud->size() > 0) {
    const ProgressSpan span(task, 0, 0.3, "index");
    octree = cloud->octree(task);
    obstacles.octree = octree.get();
    obstacles.xyz = cloud->xyz();
  }
  std::optional<PartTriangles> triangles;
  std::optional<TriangleBoxes> boxes;
  if (model != nullptr) {
    triangles = triangles_of_part(*model, kWholeModel, settings.chord_m);
    boxes.emplace(triangles->vertices, triangles->triangles, task);
    obstacles.triangles = &*boxes;
  }
  const ProgressSpan span(task, 0.3, 1, "sweeping");
  SweepResult result =
      sweep_gauge(pieces, poses, obstacles, {settings.margin_m, settings.reach_m}, task);
  std::sort(result.places.begin(), result.places.end(),
            [](const SweepPlace& a, const SweepPlace& b) {
              return std::tuple(parameter_of(a), a.kind, a.index) <
                     std::tuple(parameter_of(b), b.kind, b.index);
            });

  const PartTriangles* sources = triangles ? &*triangles : nullptr;
  SweepTables tables{table_of(result.places, sources), table_of(result.intervals, sources)};
  add_column<uint64_t>(tables.intervals, result.near_counts, "near", "",
                       "points and triangles within the margin", [](uint64_t n) { return n; });
  return tables;
}

}  // namespace jalon
