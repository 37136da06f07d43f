// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Candidates of a furnished room sampled twice, against the motion between the samples.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "registration/coarse/candidates.h"
#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kCell_m = 0.4;

struct Rooms {
  CoarseSurface reference, moving;
  Transform truth;  ///< between the surfaces' own frames
};

Rooms rooms_of(uint64_t draw, bool any_axis) {
  const Transform start = random_start(draw, any_axis);
  Rooms out{described_surface(furnished_room().sample(5000, 0.003, 2 * draw + 1), kCell_m),
            described_surface(
                moved_points(furnished_room().sample(5000, 0.003, 2 * draw + 2), start), kCell_m),
            {}};
  out.truth = between_surfaces(inverse(start), out.reference, out.moving);
  return out;
}

double nearest_of(const std::vector<PoseCandidate>& all, PoseSource source, const Rooms& rooms) {
  double nearest = 1e9;
  for (const PoseCandidate& c : all)
    if (c.source == source)
      nearest = std::min(nearest, farthest_apart(c.T_reference_moving, rooms.truth, rooms.moving));
  return nearest;
}

size_t count_of(const std::vector<PoseCandidate>& all, PoseSource source) {
  return static_cast<size_t>(std::count_if(
      all.begin(), all.end(), [&](const PoseCandidate& c) { return c.source == source; }));
}

}  // namespace

TEST_CASE("coarse_candidates__features_and_planes_each_bring_the_true_pose_among_rigid_ones") {
  const Rooms rooms = rooms_of(3, true);
  Task task;
  const auto all = coarse_candidates(rooms.reference, rooms.moving, false, task);
  // Iterations begin with a reach of four cells; planes are fitted to better than half a cell.
  CHECK(nearest_of(all, PoseSource::kFeatures, rooms) < 4 * kCell_m);
  CHECK(nearest_of(all, PoseSource::kPlanes, rooms) < 0.5 * kCell_m);
  for (const PoseCandidate& c : all) {
    const Transform& T = c.T_reference_moving;
    CHECK(T.determinant() == doctest::Approx(1).epsilon(1e-9));
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      CHECK(norm(T.direction(axis)) == doctest::Approx(1).epsilon(1e-9));
  }
  const size_t of_features = count_of(all, PoseSource::kFeatures),
               of_planes = count_of(all, PoseSource::kPlanes);
  CHECK(of_features + of_planes == all.size());
  CHECK(of_features <= 60);
  CHECK(of_planes <= 8 + 256);
}

TEST_CASE("coarse_candidates__of_level_clouds_stay_upright_but_for_the_largest_planes") {
  const Rooms rooms = rooms_of(5, false);
  Task task;
  const auto all = coarse_candidates(rooms.reference, rooms.moving, true, task);
  // Walls whose cosines with the vertical differ by 0.07 at the most: half of that is the tilt.
  const double least_upright = std::cos(0.036);
  size_t tilted = 0;
  for (const PoseCandidate& c : all)
    tilted += c.source == PoseSource::kPlanes && c.T_reference_moving.m[10] < least_upright;
  CHECK(tilted <= 8);
  CHECK(count_of(all, PoseSource::kPlanes) > 8);
  CHECK(nearest_of(all, PoseSource::kPlanes, rooms) < 0.5 * kCell_m);
}

TEST_CASE("coarse_candidates__without_distinct_places_planes_alone_speak") {
  Rooms rooms = rooms_of(6, true);
  rooms.moving.distinct.clear();
  Task task;
  const auto all = coarse_candidates(rooms.reference, rooms.moving, false, task);
  CHECK(count_of(all, PoseSource::kFeatures) == 0);
  CHECK(nearest_of(all, PoseSource::kPlanes, rooms) < 0.5 * kCell_m);
}
