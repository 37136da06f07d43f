// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Points of pipes and balls whose truth is known, and the surfaces that own them.
#pragma once

#include <numbers>

#include "unit/segment/made_scene.h"

namespace jalon::test {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;

/// A piece of a cylinder: heights within length_m about the point of its axis, angles from 0 to turn_rad.
struct PipePiece {
  Cylinder cylinder;
  double length_m = 1, turn_rad = kFullTurn_rad;
};

/// Points of the piece at random with noise of sigma_m along the normal.
inline void add_pipe(Scene& scene, int face, const PipePiece& piece, size_t count, double sigma_m,
                     RandomStream& random) {
  const auto [right, ahead] = across(piece.cylinder.direction);
  for (size_t i = 0; i < count; ++i) {
    const double angle = piece.turn_rad * random.uniform();
    const Vec3 foot =
        piece.cylinder.point + piece.length_m * (random.uniform() - 0.5) * piece.cylinder.direction;
    const double radius = piece.cylinder.radius + sigma_m * random.normal();
    scene.points.push_back(foot + radius * (std::cos(angle) * right + std::sin(angle) * ahead));
  }
  scene.faces.resize(scene.points.size(), face);
}

/// Points of the cap of a sphere that has at least this cosine to the vertical (-1: all of it).
inline void add_ball(Scene& scene, int face, const Sphere& ball, double least_cosine, size_t count,
                     double sigma_m, RandomStream& random) {
  for (size_t i = 0; i < count; ++i) {
    const double up = least_cosine + (1 - least_cosine) * random.uniform();
    const double angle = kFullTurn_rad * random.uniform(), out = std::sqrt(1 - up * up);
    const double radius = ball.radius + sigma_m * random.normal();
    scene.points.push_back(ball.centre +
                           radius * Vec3{out * std::cos(angle), out * std::sin(angle), up});
  }
  scene.faces.resize(scene.points.size(), face);
}

/// The same surface in the frame of a made scene.
inline Curved to_local(const MadeScene& made, Curved world) {
  world.centre -= made.scene.origin;
  return world;
}

/// Settings that look for spheres and cylinders too.
constexpr double kWidest_m = 10;  ///< as the recipe sets it: of a cloud's width

inline SurfaceSettings all_primitives() {
  SurfaceSettings settings;
  settings.primitives = Primitives::kAll;
  settings.max_radius_m = kWidest_m;
  return settings;
}

/// A surface that owns the points of a face and has this shape (of the world) and the rms about it as sigma.
inline Surface curved_surface(MadeScene& made, const std::vector<int>& faces, int face,
                              const Curved& world) {
  Surface out;
  out.curved = to_local(made, world);
  out.pixel_m = 0.05;
  double squares = 0;
  for (uint32_t p = 0; p < made.scene.size(); ++p) {
    if (faces[made.point(p)] != face) continue;
    out.positions.push_back(p);
    made.scene.owner[p] = static_cast<uint32_t>(face);
    squares += std::pow(out.curved.distance(made.scene.local(p)), 2);
  }
  out.sigma_m = std::sqrt(squares / static_cast<double>(out.positions.size()));
  return out;
}

/// The points of a surface in its frame.
inline std::vector<Vec3> local_points(const MadeScene& made, const Surface& surface) {
  std::vector<Vec3> out;
  for (const uint32_t p : surface.positions) out.push_back(made.scene.local(p));
  return out;
}

}  // namespace jalon::test
