// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/chords.h"

using namespace jalon;

namespace {

constexpr Vec3 kCorner{652000.25, 6861000.5, 140};

// A wall seen from -y with a round-headed opening and a pane that fills it; both share vertices.
Model arched_wall() {
  Model model;
  Face wall;
  wall.plane.normal = {0, -1, 0};
  model.add_face(
      wall, {{kCorner, kCorner + Vec3{6, 0, 0}, kCorner + Vec3{6, 0, 5}, kCorner + Vec3{0, 0, 5}},
             {kCorner + Vec3{2, 0, 1}, kCorner + Vec3{2, 0, 3}, kCorner + Vec3{4, 0, 3},
              kCorner + Vec3{4, 0, 1}}});
  model.sagittas.assign(model.corners.size(), 0);
  model.sagittas[5] = -1;  // the head: clockwise along the hole, as all openings run
  Face pane;
  pane.plane.normal = {0, -1, 0};
  pane.first_ring = model.rings.size();
  pane.ring_count = 1;
  model.rings.push_back({model.corners.size(), 4});
  for (const uint32_t v : {4u, 7u, 6u, 5u}) model.corners.push_back(v);
  model.sagittas.insert(model.sagittas.end(), {0, 0, 1, 0});
  model.faces.push_back(pane);
  return model;
}

double area_of(const Model& model, const Face& face) {
  Vec3 twice;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
    for (uint64_t c = 1; c + 1 < model.rings[r].count; ++c) {
      const auto corner = [&](uint64_t i) {
        return model.vertices[model.corners[model.rings[r].first + i]] - kCorner;
      };
      twice += cross(corner(c) - corner(0), corner(c + 1) - corner(0));
    }
  return dot(twice, face.plane.normal) / 2;
}

}  // namespace

TEST_CASE("chords: an arc keeps its chord error and its area comes near that of the circle") {
  const Model model = arched_wall();
  const double pane = 4 + std::numbers::pi / 2;
  for (const double error_m : {0.01, 0.001, 0.0001}) {
    const Model chords = with_chords(model, error_m);
    CHECK(!has_arcs(chords));
    double worst = 0;
    for (size_t v = model.vertices.size(); v < chords.vertices.size(); ++v) {
      const Vec3 d = chords.vertices[v] - (kCorner + Vec3{3, 0, 3});
      CHECK(std::abs(norm(d) - 1) < 1e-8);
      CHECK(d.z > 0);
    }
    const Ring& ring = chords.rings[1];
    for (uint64_t c = 0; c < ring.count; ++c) {
      const Vec3 a = chords.vertices[chords.corners[ring.first + c]];
      const Vec3 b = chords.vertices[chords.corners[ring.first + (c + 1) % ring.count]];
      const Vec3 middle = 0.5 * (a - kCorner + (b - kCorner)) - Vec3{3, 0, 3};
      if (std::min(a.z, b.z) >= kCorner.z + 3) worst = std::max(worst, 1 - norm(middle));
    }
    CHECK(worst <= error_m);
    CHECK(worst > error_m / 4);
    CHECK(std::abs(area_of(chords, chords.faces[1]) - pane) < std::numbers::pi * error_m);
    CHECK(std::abs(area_of(chords, chords.faces[0]) - (30 - pane)) < std::numbers::pi * error_m);
  }
}

TEST_CASE("chords: faces that share an arc share its new vertices") {
  const Model chords = with_chords(arched_wall(), 0.001);
  const auto sorted = [&](const Ring& ring) {
    std::vector<uint32_t> out(chords.corners.begin() + static_cast<long>(ring.first),
                              chords.corners.begin() + static_cast<long>(ring.first + ring.count));
    std::ranges::sort(out);
    return out;
  };
  CHECK(sorted(chords.rings[1]) == sorted(chords.rings[2]));
  CHECK(chords.rings[0].count == 4);
}

TEST_CASE(
    "chords: a round window of two arcs becomes a polygon; arcs without a chord stay a corner") {
  Model model;
  Face face;
  face.plane.normal = {0, 0, 1};
  model.add_face(face, {{{-1, 0, 0}, {1, 0, 0}}});
  model.sagittas = {1, 1};
  const Model chords = with_chords(model, 0.001);
  CHECK(chords.rings[0].count > 40);
  Vec3 twice;
  for (uint64_t c = 0; c < chords.rings[0].count; ++c)
    twice += cross(chords.vertices[chords.corners[c]],
                   chords.vertices[chords.corners[(c + 1) % chords.rings[0].count]]);
  CHECK(twice.z / 2 == doctest::Approx(std::numbers::pi).epsilon(0.002).scale(0));
  model.vertices[1] = model.vertices[0];
  CHECK(with_chords(model, 0.001).rings[0].count == 2);
}
