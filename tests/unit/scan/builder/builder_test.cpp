// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// Faces with openings against unit cells that are counted one by one; boxes against their volume.

namespace {

constexpr int kCellsWide = 12, kCellsHigh = 9;
const Frame kTiltedFrame{{3, -2, 1}, {0.6, 0.8, 0}, {-0.48, 0.36, 0.8}};

/// On whole metres, a metre or more apart, each at one side at most: what is left is one piece.
std::vector<Rect> scattered_openings(uint64_t seed) {
  RandomStream random(seed, 0);
  const auto draw = [&](int n) {
    return static_cast<double>(random.below(static_cast<uint64_t>(n)));
  };
  std::vector<Rect> out;
  for (int k = 0; k < 40; ++k) {
    const double u = draw(kCellsWide), v = draw(kCellsHigh);
    const Rect r{u, u + 1 + draw(3), v, v + 1 + draw(3)};
    if (r.u1 > kCellsWide || r.v1 > kCellsHigh) continue;
    const int sides = (r.u0 == 0) + (r.u1 == kCellsWide) + (r.v0 == 0) + (r.v1 == kCellsHigh);
    const bool is_near = std::any_of(out.begin(), out.end(), [&](const Rect& o) {
      return r.u0 <= o.u1 && o.u0 <= r.u1 && r.v0 <= o.v1 && o.v0 <= r.v1;
    });
    if (sides < 2 && !is_near) out.push_back(r);
  }
  return out;
}

/// Is the unit cell with this lower left corner part of the face?
bool is_filled(const std::vector<Rect>& openings, int i, int j) {
  if (i < 0 || j < 0 || i >= kCellsWide || j >= kCellsHigh) return false;
  return std::none_of(openings.begin(), openings.end(), [&](const Rect& o) {
    return i >= o.u0 && i < o.u1 && j >= o.v0 && j < o.v1;
  });
}

}  // namespace

TEST_CASE("scene_builder__a_face_is_its_rectangle_without_the_openings") {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const std::vector<Rect> openings = scattered_openings(seed);
    SceneBuilder out{Transform{}};
    const uint32_t part = out.part("wall", "wall");
    out.face(part, kTiltedFrame, {0, kCellsWide, 0, kCellsHigh}, openings);
    const Model model = out.take();
    REQUIRE(model.faces.size() == 1);
    const Face& face = model.faces.front();

    // Cell by cell: rings and triangles hold the same, and the border is where a filled cell ends.
    double cells = 0, border = 0;
    for (int j = -1; j <= kCellsHigh; ++j)
      for (int i = -1; i <= kCellsWide; ++i) {
        const bool filled = is_filled(openings, i, j);
        const Vec3 p = kTiltedFrame.point(i + 0.37, j + 0.61);
        const Hit hit = first_hit(model, p + kTiltedFrame.normal(), -kTiltedFrame.normal());
        REQUIRE(std::isfinite(hit.distance) == filled);
        REQUIRE((!filled || hit.is_front));
        REQUIRE(is_inside(model, face, p, 0) == filled);
        cells += filled;
        border += filled != is_filled(openings, i + 1, j);
        border += filled != is_filled(openings, i, j + 1);
      }
    for (size_t r = 0; r < face.ring_count; ++r) {
      const std::vector<Vec2> ring = flat_ring(model, face, r);
      CHECK((signed_area(ring) > 0) == (r == 0));
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
        CHECK(std::abs(cross(b - a, c - b)) > 0.9);  // it turns between sides of a metre or more
      }
    }
    CHECK(std::abs(face.area_m2 - cells) < kRounding_m);
    CHECK(std::abs(shell_of(model, {}).area_m2 - cells) < kRounding_m);  // none lies on another
    CHECK(std::abs(open_edge_m(model) - border) < kRounding_m);          // whole edges are shared
  }
}

TEST_CASE("scene_builder__ids_count_from_1_and_a_given_id_is_shared") {
  SceneBuilder out{Transform{}};
  const uint32_t house = out.part("house", "building"), wall = out.part("wall", "wall", house);
  CHECK(out.face(wall, kTiltedFrame, {0, 1, 0, 1}) == 1);
  CHECK(out.face(house, kTiltedFrame, {2, 3, 0, 1}, {}, 1) == 1);
  CHECK(out.new_id() == 2);
  CHECK(out.face(wall, kTiltedFrame, {4, 5, 0, 1}) == 3);
  const Model model = out.take();
  CHECK(model.parts[wall].parent == house);
  CHECK(model.parts[house].parent == kNoParent);
  CHECK(model.faces[1].part == house);
  CHECK(model.triangle_faces == std::vector<uint32_t>{1, 1, 1, 1, 3, 3});
}

TEST_CASE("scene_builder__places_faces_by_the_transform_at_map_coordinates") {
  Transform T_world_scene;
  T_world_scene.m = {0.8, -0.6, 0, 652000, 0.6, 0.8, 0, 6861000, 0, 0, 1, 35};
  SceneBuilder out(T_world_scene);
  out.face(out.part("wall", "wall"), kTiltedFrame, {0, 5, 0, 2});
  const Model model = out.take();
  const Face& face = model.faces.front();
  constexpr double kTolerance_m = 4e-9;  // four ulps of seven digits
  CHECK(std::abs(norm(face.plane.normal) - 1) < 1e-15);
  // The frame's normal is (0.64, -0.48, 0.6); the turn has the cosine 0.8.
  CHECK(norm(face.plane.normal - Vec3{0.8, 0, 0.6}) < 1e-15);
  for (const Vec3& v : model.vertices) CHECK(std::abs(face.plane.distance(v)) < kTolerance_m);
  const Vec3 corner{652000 + 0.8 * 3 + 0.6 * 2, 6861000 + 0.6 * 3 - 0.8 * 2, 36};
  CHECK(std::abs(norm(model.vertices[model.corners[2]] - model.vertices[model.corners[0]]) -
                 std::sqrt(29)) < kTolerance_m);  // the diagonal
  double nearest = 1;
  for (const Vec3& v : model.vertices) nearest = std::min(nearest, norm(v - corner));
  CHECK(nearest < kTolerance_m);
}

TEST_CASE("scene_builder__a_box_is_closed_but_for_the_bottom_that_it_stands_on") {
  const Vec3 corner{1, -2, 0.5}, size{4, 3, 2};
  for (const bool has_bottom : {true, false}) {
    SceneBuilder out{Transform{}};
    out.box(out.part("box", "box"), corner, size, has_bottom);
    const Model model = out.take();
    CHECK(model.faces.size() == (has_bottom ? 6 : 5));
    const Shell shell = shell_of(model, {}, corner);
    CHECK(std::abs(shell.volume_m3 - 24) < kRounding_m);  // positive: all faces look outward
    CHECK(norm(shell.vector_area - Vec3{0, 0, has_bottom ? 0.0 : 12.0}) < kRounding_m);
    CHECK(std::abs(open_edge_m(model) - (has_bottom ? 0 : 14)) < kRounding_m);
  }
}
