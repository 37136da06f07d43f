// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/truth.h"

#include <algorithm>

#include "base/error.h"
#include "scan/flat_triangles.h"
#include "scan/shared_edges.h"
#include "scan/touching.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr size_t kTruthPerCheck = 1 << 16;

/// Numbers the groups that are large enough by their first triangle, which is their root.
Truth numbered(const Model& model, const FlatTriangles& flats, UnionFind& groups,
               double min_area_m2, Task& task) {
  // 1. Area, and the largest triangle, of each group.
  std::vector<double> area(flats.size(), 0), largest_area(flats.size(), 0);
  std::vector<uint32_t> largest(flats.size());
  for (uint32_t t = 0; t < flats.size(); ++t) {
    if (t % kTruthPerCheck == 0) task.checkpoint(0.5 * t / flats.size());
    if (!flats.is_flat(t)) continue;
    const uint32_t root = groups.find(t);
    const double own = flats.area(t);
    area[root] += own;
    if (own > largest_area[root]) largest_area[root] = own, largest[root] = t;
  }
  // 2. Numbers.
  Truth truth;
  truth.triangle_segments.assign(flats.size(), kNoSegment);
  for (uint32_t t = 0; t < flats.size(); ++t) {
    if (t % kTruthPerCheck == 0) task.checkpoint(0.5 + 0.5 * t / flats.size());
    if (!flats.is_flat(t)) continue;
    const uint32_t root = groups.find(t);
    if (root == t && area[t] >= min_area_m2) {
      const uint32_t main = largest[t];
      TruePlane plane{flats.plane(main), area[t], model.triangle_faces[main], 0};
      plane.plane.offset += dot(plane.plane.normal, flats.origin());
      if (const Face* face = flats.face(main); face != nullptr) plane.part = face->part;
      truth.planes.push_back(plane);
      truth.triangle_segments[t] = static_cast<uint32_t>(truth.planes.size());
    }
    truth.triangle_segments[t] = truth.triangle_segments[root];
  }
  return truth;
}

}  // namespace

Truth find_truth(const Model& model, double min_area_m2, Task& task) {
  const FlatTriangles flats(model, task);
  UnionFind groups(flats.size());
  std::vector<uint8_t> inner_edges;
  {
    const ProgressSpan span(task, 0, 0.5);
    inner_edges = join_by_edges(flats, groups, task);
  }
  {
    const ProgressSpan span(task, 0.5, 0.9);
    join_touching(flats, inner_edges, groups, task);
  }
  const ProgressSpan span(task, 0.9, 1);
  return numbered(model, flats, groups, min_area_m2, task);
}

FieldTable truth_table(const Truth& truth, const Vec3& shift, std::span<const uint32_t> labels,
                       Task& task) {
  constexpr size_t kLabelGrain = 1 << 16;
  const size_t n = truth.planes.size();
  std::vector<uint32_t> segment, face, part;
  std::vector<double> normal, offset, area;
  std::vector<uint64_t> count(n, 0);
  for (size_t begin = 0; begin < labels.size(); begin += kLabelGrain) {
    task.checkpoint(static_cast<double>(begin) / static_cast<double>(labels.size()));
    for (size_t i = begin; i < std::min(labels.size(), begin + kLabelGrain); ++i)
      if (labels[i] != kNoSegment && labels[i] <= n) ++count[labels[i] - 1];
  }
  for (const TruePlane& p : truth.planes) {
    segment.push_back(static_cast<uint32_t>(segment.size() + 1));
    face.push_back(p.face);
    part.push_back(p.part);
    normal.insert(normal.end(), {p.plane.normal.x, p.plane.normal.y, p.plane.normal.z});
    offset.push_back(p.plane.offset + dot(p.plane.normal, shift));
    area.push_back(p.area_m2);
  }
  FieldTable table;
  const auto set = [&]<class T>(const char* name, uint32_t components, const char* unit,
                                const char* meaning, const std::vector<T>& values) {
    table.set(make_column<T>({name, element_type_of<T>(), components, unit, meaning}, values));
  };
  set("segment", 1, "", "number in the field segment of the points", segment);
  set("face", 1, "", "id of its largest face", face);
  set("part", 1, "", "part of that face", part);
  set("normal", 3, "1", "unit normal", normal);
  set("offset", 1, "m", "normal . p = offset", offset);
  set("area", 1, "m2", "openings taken off", area);
  set("count", 1, "", "points of the cloud", count);
  return table;
}

}  // namespace jalon
