// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/scene.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Scene wall() {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {652000.5, 6861000.25, 30}, {3, 0, 0}, {0, 0, 2}, 3000, 0.003, random);
  return out;
}

}  // namespace

TEST_CASE("segment_scene__local_and_exact_coordinates_are_those_of_the_caller") {
  const Scene scene = wall();
  const MadeScene made(scene.points);
  REQUIRE(made.scene.size() == 3000);
  std::vector<uint8_t> seen(3000, 0);
  for (size_t p = 0; p < made.scene.size(); ++p) {
    const Vec3 world = scene.points[made.point(p)];
    CHECK(norm(made.scene.exact(p) + made.scene.origin - world) < 1e-8);
    CHECK(norm(made.scene.local(p) - made.scene.exact(p)) < 1e-6);
    ++seen[made.point(p)];
    CHECK(made.scene.owner[p] == 0);
    CHECK(made.scene.may_seed(p));
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == 3000);
}

TEST_CASE("segment_scene__an_arbitrary_shift_leaves_the_order_of_the_points") {
  std::vector<Vec3> points, shifted;
  RandomStream random(2, 7);
  for (int i = 0; i < 500; ++i) {  // coordinates that a shift leaves exact
    points.push_back({0x1p-10 * static_cast<double>(random.below(4096)),
                      0x1p-10 * static_cast<double>(random.below(4096)), 0});
    shifted.push_back(points.back() + Vec3{17.375, -3.125, 0.0625});
  }
  const MadeScene a(points), b(shifted);
  CHECK(norm(b.scene.origin - a.scene.origin - Vec3{17.375, -3.125, 0.0625}) == 0);
  for (size_t p = 0; p < points.size(); ++p) CHECK(a.point(p) == b.point(p));
}

TEST_CASE("segment_scene__cells_around_points_are_those_of_the_octree") {
  const Scene scene = wall();
  const MadeScene made(scene.points);
  const Octree& tree = *made.scene.tree;
  for (uint32_t p = 0; p < made.scene.size(); p += 7)
    for (int level = made.scene.coarse_level; level <= made.scene.fine_level; ++level) {
      const Octree::Cell found = made.scene.cell_around(level, p),
                         wanted = tree.cell(level, tree.code(p) >> (3 * (kMaxLevel - level)));
      CHECK(found.code == wanted.code);
      CHECK(found.first == wanted.first);
      CHECK(found.count == wanted.count);
    }
}

TEST_CASE("segment_scene__rejections_are_counted_up_to_a_limit_and_forgotten_together") {
  Scene scene;
  RandomStream random(4, 7);
  scene.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 2}, 9001, 0.003, random);
  SurfaceSettings settings;
  settings.primitives = Primitives::kAll;
  MadeScene made(scene.points, settings);
  RansacScene& s = made.scene;
  for (int time = 0; time < 5; ++time)
    for (const size_t p : {0, 4095, 4096, 9000}) {
      s.note_rejection(s.rejections, p, 4);
      s.note_rejection(s.curved_rejections, p, kMostRejections);
    }
  CHECK(s.rejections[9000] == 4);
  CHECK(s.curved_rejections[4096] == kMostRejections);
  CHECK_FALSE(s.may_seed(0));
  s.forget_rejections();
  for (const auto* counts : {&s.rejections, &s.curved_rejections})
    CHECK(std::count(counts->begin(), counts->end(), 0) == 9001);
  s.note_rejection(s.rejections, 4095, 4);
  CHECK(s.rejections[4095] == 1);
}

TEST_CASE("plane_axes__u_horizontal_v_upward_in_a_right_handed_frame") {
  RandomStream random(3, 7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 n = normalized(Vec3{random.normal(), random.normal(), 0.5 * random.normal()});
    const SurfaceAxes axes = plane_axes(n);
    CHECK(norm(cross(axes.u, axes.v) - n) < 1e-12);
    if (std::fabs(n.z) > 0.94) continue;
    CHECK(std::fabs(axes.u.z) < 1e-12);
    CHECK(axes.v.z > 0);
  }
  CHECK(norm(plane_axes({0, 0, 1}).u - Vec3{1, 0, 0}) < 1e-12);
}
