// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Edges of walls and windows of known form: unbiased, and worth what their standard deviations say.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "unit/modelling/sampled_wall.h"

using namespace walls;

namespace {

size_t measured_edges_trials() {
  if (std::getenv("JALON_FULL") != nullptr) return 400;
  return std::getenv("JALON_SANITIZED") != nullptr ? 2 : 40;
}

// Distance of an upright edge's line from the truth, into the solid.
bool edge_error(const VectorPlane& plane, const VectorRing& ring, size_t i,
                const std::vector<Rectangle>& truths, double& error) {
  const Vec2 a = on_wall(plane, ring.corners[i]),
             b = on_wall(plane, ring.corners[(i + 1) % ring.corners.size()]);
  const Vec2 along = (b - a) * (1 / norm(b - a)), left{-along.v, along.u}, middle = (a + b) * 0.5;
  double best = INFINITY;
  for (const Rectangle& r : truths)
    for (const Vec2 side : {Vec2{r.left, middle.v}, Vec2{r.right, middle.v},
                            Vec2{middle.u, r.bottom}, Vec2{middle.u, r.top}}) {
      const Vec2 d = middle - side;
      if (std::fabs(dot(d, along)) > 1e-3 || norm(d) > 0.05) continue;
      if (norm(d) < std::fabs(best)) best = dot(d, left);
    }
  error = best;
  return std::isfinite(best);
}

}  // namespace

TEST_CASE("vectorise__edges_are_unbiased_and_their_sigmas_honest") {
  Errors gridded, random_points;
  for (const Sampling sampling : kSamplings) {
    Errors errors, scaled;
    Errors& family =
        sampling == Sampling::kJittered || sampling == Sampling::kPoisson ? random_points : gridded;
    for (size_t k = 0; k < measured_edges_trials(); ++k) {
      RandomStream random(k, 3);
      SampledWall wall;
      wall.seed = k + 1;
      wall.sampling = sampling;
      const Rectangle whole{0.01 * random.uniform(), 0.01 * random.uniform(),
                            2.9 + 0.1 * random.uniform(), 2.4 + 0.1 * random.uniform()};
      const Rectangle hole{0.5 + 0.3 * random.uniform(), 0.5 + 0.3 * random.uniform(),
                           1.4 + 0.8 * random.uniform(), 1.2 + 0.8 * random.uniform()};
      wall.solid = [&](double u, double v) { return whole.contains(u, v) && !hole.contains(u, v); };
      const VectorPlane plane = vectorised(segmentation_of({wall.points()}));
      REQUIRE(plane.faces.size() == 1);
      REQUIRE(plane.faces[0].openings.size() == 1);
      for (const VectorRing* ring : {&plane.faces[0].outline, &plane.faces[0].openings[0]}) {
        REQUIRE(ring->corners.size() == 4);
        for (size_t i = 0; i < 4; ++i) {
          double error = 0;
          REQUIRE(edge_error(plane, *ring, i, {whole, hole}, error));
          errors.add(error / wall.spacing);
          scaled.add(error / ring->edges[i].sigma_m);
          family.add(error / ring->edges[i].sigma_m);
          CHECK(ring->edges[i].source == EdgeSource::kDensity);
        }
      }
    }
    MESSAGE("FIGURE edges, " << std::string(name_of(sampling)) << ": bias " << errors.mean()
                             << " spacings, RMS " << errors.rms() << ", worst " << errors.worst
                             << "; error / sigma RMS " << scaled.rms());
    if (measured_edges_trials() < 20) continue;  // too few to say how far errors scatter
    CHECK(std::fabs(errors.mean()) <= 0.05);
    CHECK(errors.rms() <= 0.3);
  }
  if (measured_edges_trials() < 20) return;
  for (const Errors& scaled : {gridded, random_points}) {
    CHECK(scaled.rms() >= 0.8);
    CHECK(scaled.rms() <= 1.2);
  }
}
