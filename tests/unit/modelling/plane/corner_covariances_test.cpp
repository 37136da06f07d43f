// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Covariances of a ring's vertices, where those of its edges and of its plane are known.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/corner_covariances.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

constexpr double kPlaneSigma = 0.003;

/// The vertices of a ring in the plane y = 0 whose offset alone is uncertain.
struct Scene {
  Model model;
  VectorRing ring;
  Face plane;
  RingVertices vertices;

  explicit Scene(VectorRing r) : ring(std::move(r)) {
    plane.plane = {{0, -1, 0}, 0};
    plane.covariance[15] = kPlaneSigma * kPlaneSigma;
    vertices.ring = &ring;
    for (const Vec2& p : ring.corners) {
      vertices.vertices.push_back(static_cast<uint32_t>(model.vertices.size()));
      model.vertices.push_back(street_frame().lift(p));
    }
  }
  void set() { set_covariances(model, street_frame(), plane, vertices); }
};

}  // namespace

TEST_CASE("corner_covariances__of_a_rectangle_are_those_of_its_two_edges_and_its_plane") {
  Scene scene(rectangle({0, 0}, {4, 3}));
  const double sigma_m[] = {0.001, 0.002, 0.004, 0.008};  // bottom, right, top, left
  for (size_t e = 0; e < 4; ++e) scene.ring.edges[e].sigma_m = sigma_m[e];
  scene.vertices.extra_sigma_m = 0.004;
  scene.set();
  REQUIRE(scene.model.vertex_covariances.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    const auto& c = scene.model.vertex_covariances[i];
    const size_t before = (i + 3) % 4, level = i % 2 == 0 ? i : before,
                 upright = i % 2 == 0 ? before : i;
    const double truth[] = {sigma_m[upright] * sigma_m[upright],
                            kPlaneSigma * kPlaneSigma + 0.004 * 0.004,
                            sigma_m[level] * sigma_m[level]};
    for (size_t a = 0; a < 3; ++a)
      for (size_t b = 0; b < 3; ++b)
        CHECK(c[3 * a + b] == doctest::Approx(a == b ? truth[a] : 0).epsilon(1e-9));
  }
}

TEST_CASE("corner_covariances__are_unknown_beside_an_edge_without_sigma_and_what_was_known_stays") {
  Scene scene(rectangle({0, 0}, {4, 3}));
  for (size_t e = 0; e < 3; ++e) scene.ring.edges[e].sigma_m = 0.001;
  scene.model.vertices.push_back({9, 9, 9});  // of no ring
  scene.model.vertex_covariances.resize(2);
  scene.model.vertex_covariances[0].fill(kNaN);
  scene.model.vertex_covariances[1].fill(7);
  scene.set();
  const auto& all = scene.model.vertex_covariances;
  REQUIRE(all.size() == 5);
  CHECK(std::isnan(all[0][0]));  // between the left edge and the lower one
  CHECK(all[1][0] == 7);
  CHECK(all[2][0] == doctest::Approx(1e-6).scale(0));
  CHECK(std::isnan(all[3][0]));
  CHECK(std::isnan(all[4][0]));
}

TEST_CASE("corner_covariances__an_arc_that_runs_on_from_its_jamb_counts_by_its_chord") {
  // A round head on a door: tangent to both jambs, so that edges alone meet nowhere.
  Scene scene(rectangle({0, 0}, {2, 3}));
  for (VectorEdge& edge : scene.ring.edges) edge.sigma_m = 0.001;
  scene.ring.edges[2].sagitta_m = 1;
  scene.set();
  for (size_t i = 2; i < 4; ++i) {
    const auto& c = scene.model.vertex_covariances[i];
    CHECK(c[0] == doctest::Approx(1e-6).scale(0));  // across the jamb
    CHECK(c[8] == doctest::Approx(1e-6).scale(0));  // across the chord, level here
  }
  // A flat arch meets its jambs at an angle: by its tangent, so that height and width correlate.
  Scene flat(rectangle({0, 0}, {2, 3}));
  for (VectorEdge& edge : flat.ring.edges) edge.sigma_m = 0.001;
  flat.ring.edges[2].sagitta_m = 0.4;
  flat.set();
  CHECK(flat.model.vertex_covariances[2][8] > 1.5e-6);
  CHECK(flat.model.vertex_covariances[2][2] == -flat.model.vertex_covariances[3][2]);
  CHECK(flat.model.vertex_covariances[2][2] < 0);  // the jamb outward, the corner down
}
