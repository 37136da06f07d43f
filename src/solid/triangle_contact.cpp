// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/triangle_contact.h"

#include <algorithm>
#include <limits>

#include "solid/cut_envelope.h"
#include "solid/nearest_point.h"

namespace jalon {

namespace {

constexpr double kGap_m = 1e-9;
constexpr int kMostRounds = 200;  ///< a few dozen are usual for round pieces, ten for flat ones

Cut cut_at(const ConvexPiece& piece, const Vec3& point, std::span<const Vec3> corners) {
  const SignedDistance d = piece.distance(point);
  Cut cut{d.value, point, d.gradient, {}};
  for (size_t i = 0; i < 3; ++i) cut.corners[i] = cut.at(corners[i]);
  return cut;
}

Vec3 point_at(std::span<const Vec3> corners, const Weights& w) {
  return corners[0] + (corners[1] - corners[0]) * w[1] + (corners[2] - corners[0]) * w[2];
}

}  // namespace

Contact least_distance(const ConvexPiece& piece, std::span<const Vec3> corners) {
  if (corners.size() == 1) {
    const SignedDistance d = piece.distance(corners[0]);
    return {d.value, corners[0], d.gradient, d.value, d.gradient, 0};
  }
  Cut last = cut_at(piece, nearest_on_triangle(piece.centre(), corners[0], corners[1], corners[2]),
                    corners);
  Cut best = last;
  CutEnvelope envelope;
  Weights where{1.0 / 3, 1.0 / 3, 1.0 / 3};
  for (int round = 0; round < kMostRounds; ++round) {
    envelope.add(last, where);
    if (best.value - envelope.minimise(where) <= kGap_m) break;
    last = cut_at(piece, point_at(corners, where), corners);
    if (last.value < best.value) best = last;
  }
  Contact contact{best.value, best.point, best.gradient, 0, {}, 0};
  contact.gap =
      std::max(0.0, best.value - envelope.best_mixture(best.point, contact.floor, contact.slope));
  return contact;
}

}  // namespace jalon
