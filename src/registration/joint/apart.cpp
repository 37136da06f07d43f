// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/apart.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "geometry/vec.h"

namespace jalon {

namespace {

double width_m(const Box3& box) { return std::hypot(box.max.x - box.min.x, box.max.y - box.min.y); }
double gap_m(const Box3& a, const Box3& b) {
  return std::hypot(std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
                    std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y}));
}

}  // namespace

std::string apart_hint(const std::vector<Vec3>& points, const StripScene& scene) {
  // A city beside a street is larger by less, and a street beside a city.
  constexpr double kOtherUnit = 20;
  Box3 seen, walls;
  for (const Vec3& p : points) seen.add(p);
  for (size_t t = 0; t < scene.face_of.size(); ++t)
    if (scene.strip_of_face[scene.face_of[t]] != kNoStrip)
      for (size_t k = 0; k < 3; ++k) walls.add(scene.corners[3 * t + k]);
  const double ratio = width_m(walls) / width_m(seen);
  if (std::isnormal(ratio) && (ratio > kOtherUnit || ratio < 1 / kOtherUnit))
    return "; the model's walls reach " + text_of(ratio, ratio > 1 ? 0 : 3) +
           " times as far as the points: are both in one unit?";
  if (const double gap = gap_m(seen, walls); gap > 0)
    return "; the model's walls stand " + text_of(gap, 0) +
           " m from the points: are both in one coordinate system?";
  return "";
}

}  // namespace jalon
