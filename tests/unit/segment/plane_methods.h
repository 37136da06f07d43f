// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "segment/methods.h"
#include "unit/segment/scenes.h"

namespace jalon::test {

/// By the table of methods, with parameters as JSON.
inline Segmentation segment_by(std::string_view method, const CloudPtr& cloud,
                               const char* json = "{}", unsigned threads = 2) {
  for (const SegmentMethod& m : segment_methods()) {
    if (method != m.name) continue;
    ParamSet params(m.owner, m.rows());
    params.from_json(json);
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    return m.run(cloud, params, task);
  }
  fail(Status::kNotFound, "no such method");
}

/// The segment with most points of the face, and their share of the face.
struct BestMatch {
  uint32_t label = 0;
  double share = 0;
};
inline BestMatch best_match(const Scene& scene, const Segmentation& s, int face) {
  std::vector<size_t> counts(s.segments.size() + 1, 0);
  const auto labels = s.labels->values<uint32_t>();
  size_t all = 0;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (scene.faces[i] != face) continue;
    ++all;
    if (labels[i] != 0) ++counts[labels[i]];
  }
  const auto best = std::max_element(counts.begin(), counts.end());
  return {static_cast<uint32_t>(best - counts.begin()),
          static_cast<double>(*best) / static_cast<double>(std::max<size_t>(1, all))};
}

/// The facade of the comparison of 2006: a wall of 10 x 6 m (faces 1 and, beyond the bay, 11), six windows set
/// back by 0.2 m (faces 2 to 7), a bay that stands out by 1 m (front 8, sides 9 and 10); 3 mm of noise.
inline Scene spec_facade(double spacing_m, uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 21);
  const auto add = [&](int face, Vec3 corner, Vec3 u, Vec3 v) {
    const auto count = static_cast<size_t>(norm(cross(u, v)) / (spacing_m * spacing_m));
    scene.rectangle(face, corner, u, v, count, 0.003, random);
  };
  // Columns of wall between x = 0, windows 1.0 ... 2.2, 2.9 ... 4.1, bay 5 ... 7, window 7.8 ... 9.0.
  const double windows[] = {1.0, 2.9, 7.8};
  double from = 0;
  for (const double x : windows) {
    const double to = x == 7.8 ? 5.0 : x;
    add(1, {from, 0, 0}, {to - from, 0, 0}, {0, 0, 6});
    if (x == 7.8) add(11, {7, 0, 0}, {x - 7, 0, 0}, {0, 0, 6});
    for (const double z : {0.0, 2.4, 5.4})
      add(x == 7.8 ? 11 : 1, {x, 0, z}, {1.2, 0, 0}, {0, 0, z == 0 ? 0.9 : z == 2.4 ? 1.5 : 0.6});
    from = x + 1.2;
  }
  add(11, {from, 0, 0}, {10 - from, 0, 0}, {0, 0, 6});
  int face = 2;
  for (const double x : windows)
    for (const double z : {0.9, 3.9}) add(face++, {x, 0.2, z}, {1.2, 0, 0}, {0, 0, 1.5});
  add(8, {5, -1, 0}, {2, 0, 0}, {0, 0, 6});
  add(9, {5, -1, 0}, {0, 1, 0}, {0, 0, 6});
  add(10, {7, -1, 0}, {0, 1, 0}, {0, 0, 6});
  return scene;
}

/// Largest distance of a face's corners, without their noise, from the segment's plane: of the points' box.
inline double largest_miss_m(const Scene& scene, int face, const Segment& segment, double y) {
  Box3 box;
  for (size_t i = 0; i < scene.points.size(); ++i)
    if (scene.faces[i] == face) box.add(scene.points[i]);
  double most = 0;
  for (const double x : {box.min.x, box.max.x})
    for (const double z : {box.min.z, box.max.z})
      most = std::max(most, std::fabs(segment.fit.plane.distance({x, y, z})));
  return most;
}

}  // namespace jalon::test
