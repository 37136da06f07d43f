// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_pipes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr int kFewestSides = 8, kMostSides = 64;
constexpr double kLeastMitreCosine = 0.2;  // a mitre five radii long: sharper bends are mistakes

int sides_of(double radius_m, double chord_m) {
  const double cosine = 1 - std::min(1.0, chord_m / radius_m);
  const double sides = std::ceil(std::numbers::pi / std::acos(cosine));
  return std::clamp(static_cast<int>(std::min(sides, 1e6)), kFewestSides, kMostSides);
}

// The ring moved along the pipe into a plane through the place.
Corners moved_into(const Corners& ring, const Vec3& along, const Vec3& place, const Vec3& normal) {
  Corners out;
  for (const Vec3& p : ring)
    out.push_back(p + along * (dot(place - p, normal) / dot(along, normal)));
  return out;
}

}  // namespace

void add_coded_pipe(SharedFaces& faces, uint32_t part, uint32_t id, const std::vector<Vec3>& axis,
                    double radius_m, double chord_m) {
  std::vector<Vec3> places;
  for (const Vec3& p : axis)
    if (places.empty() || p != places.back()) places.push_back(p);
  if (places.size() < 2 || !(radius_m > 0)) return;
  Vec3 along = normalized(places[1] - places[0]);
  const PlaneAxes axes = axes_of(along);
  const int sides = sides_of(radius_m, chord_m);
  Corners ring;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    ring.push_back(places[0] + axes.u * (radius_m * std::cos(angle)) +
                   axes.v * (radius_m * std::sin(angle)));
  }
  const size_t first = faces.size();
  faces.add(part, id, Corners(ring.rbegin(), ring.rend()));
  for (size_t i = 1; i < places.size(); ++i) {
    const bool is_last = i + 1 == places.size();
    const Vec3 next = is_last ? along : normalized(places[i + 1] - places[i]);
    const Vec3 mitre = normalized(along + next);
    const bool turns_back = dot(mitre, along) < kLeastMitreCosine;
    const Corners end = moved_into(ring, along, places[i], turns_back ? along : mitre);
    for (size_t k = 0; k < ring.size(); ++k) {
      const size_t l = (k + 1) % ring.size();
      faces.add(part, id, {ring[k], ring[l], end[l], end[k]});
    }
    ring = end;
    along = next;
    if (turns_back) break;
  }
  faces.add(part, id, ring);
  faces.close(part, first);
}

}  // namespace jalon
