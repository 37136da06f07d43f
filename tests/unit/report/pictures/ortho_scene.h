// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "base/table_columns.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "model/part_classes.h"
#include "unit/report/pictures/picture_pixels.h"

/// A wall of 4 x 3 m at an angle, with a recessed window of 1 x 1 m whose left foot is at (2, 1) m, and points on both
/// every 20 mm, one in the middle of each square.
namespace ortho_scene {

using namespace jalon;

inline constexpr double kStep_m = 0.02, kDepth_m = 0.2;

struct Scene {
  double angle = 0;
  Vec3 foot{652000, 6861000, 100};
  Model model = {};
  std::vector<Vec3> points = {};
  std::vector<uint8_t> red = {}, green = {}, blue = {};

  /// s along the wall, z up, d in front of it.
  Vec3 at(double s, double z, double d = 0) const {
    const double c = std::cos(angle), n = std::sin(angle);
    return foot + Vec3{s * c + d * n, s * n - d * c, z};
  }
  void add_point(double s, double z, double d, std::array<uint8_t, 3> colour) {
    points.push_back(at(s, z, d));
    red.push_back(colour[0]);
    green.push_back(colour[1]);
    blue.push_back(colour[2]);
  }
  Cloud cloud(bool in_colour = true) const {
    Cloud out = picture_pixels::cloud_of_points(points);
    if (!in_colour) return out;
    out.fields.set(make_column<uint8_t>({"red"}, red));
    out.fields.set(make_column<uint8_t>({"green"}, green));
    out.fields.set(make_column<uint8_t>({"blue"}, blue));
    return out;
  }
};

inline bool is_window(double s, double z) { return s > 2 && s < 3 && z > 1 && z < 2; }

inline Scene scene(double angle) {
  Scene out;
  out.angle = angle;
  Part facade, wall;
  facade.name = facade.part_class = part_class::kFacade;
  wall.name = wall.part_class = part_class::kWall;
  wall.parent = 0;
  out.model.parts = {facade, wall};
  Face face;
  face.part = 1;
  face.area_m2 = 11;
  face.plane.normal = out.at(0, 0, 1) - out.at(0, 0, 0);
  out.model.add_face(face, {{out.at(0, 0), out.at(4, 0), out.at(4, 3), out.at(0, 3)},
                            {out.at(2, 1), out.at(2, 2), out.at(3, 2), out.at(3, 1)}});
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 150; ++k) {
      const double s = (i + 0.5) * kStep_m, z = (k + 0.5) * kStep_m;
      if (is_window(s, z)) out.add_point(s, z, -kDepth_m, {0, 0, 200});
      else out.add_point(s, z, 0, {200, static_cast<uint8_t>(i), static_cast<uint8_t>(k)});
    }
  return out;
}

}  // namespace ortho_scene
