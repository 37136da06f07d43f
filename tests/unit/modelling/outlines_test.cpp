// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "geometry/polygon2.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

// 12 windows of 1.20 x 1.80 m in a wall of 12 x 9 m.
std::vector<Rectangle> twelve_windows() {
  std::vector<Rectangle> out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      out.push_back({1.003 + 2.7 * i, 1.007 + 2.6 * j, 2.203 + 2.7 * i, 2.807 + 2.6 * j});
  return out;
}

std::function<bool(double, double)> solid_but(const std::vector<Rectangle>& holes) {
  return [holes](double u, double v) {
    return std::none_of(holes.begin(), holes.end(),
                        [&](const Rectangle& r) { return r.contains(u, v); });
  };
}

// Largest distance of a true corner to the nearest corner of the polygon.
double corner_error(const std::vector<Vec2>& polygon, const Rectangle& r) {
  double worst = 0;
  const Vec2 corners[] = {
      {r.left, r.bottom}, {r.right, r.bottom}, {r.right, r.top}, {r.left, r.top}};
  for (const Vec2 corner : corners) {
    double nearest = INFINITY;
    for (const Vec2& p : polygon) nearest = std::min(nearest, norm(p - corner));
    worst = std::max(worst, nearest);
  }
  return worst;
}

const Rectangle* hole_around(const std::vector<Rectangle>& holes, const std::vector<Vec2>& ring) {
  Vec2 sum;
  for (const Vec2& p : ring) sum = sum + p;
  const Vec2 mean = sum * (1 / static_cast<double>(ring.size()));
  for (const Rectangle& r : holes)
    if (r.contains(mean.u, mean.v)) return &r;
  return nullptr;
}

bool same_bits(const Model& a, const Model& b) {
  const auto equal = [](const auto& x, const auto& y) {
    using T = typename std::decay_t<decltype(x)>::value_type;
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
  };
  if (!equal(a.vertices, b.vertices) || !equal(a.corners, b.corners) ||
      !equal(a.sagittas, b.sagittas))
    return false;
  if (a.rings.size() != b.rings.size()) return false;
  for (size_t i = 0; i < a.rings.size(); ++i)
    if (a.rings[i].first != b.rings[i].first || a.rings[i].count != b.rings[i].count) return false;
  if (a.faces.size() != b.faces.size()) return false;
  for (size_t i = 0; i < a.faces.size(); ++i)
    if (a.faces[i].id != b.faces[i].id || a.faces[i].area_m2 != b.faces[i].area_m2 ||
        a.faces[i].ring_count != b.faces[i].ring_count)
      return false;
  return true;
}

}  // namespace

TEST_CASE("outlines: a wall with twelve windows comes out with its true corners and area") {
  const auto windows = twelve_windows();
  double truth = 12 * 9;
  for (const Rectangle& r : windows) truth -= r.area();
  for (const double spacing : {0.01, 0.02})
    for (const double jitter : {0.0, 0.4, 1.0})
      for (const double dropout : {0.0, 0.3}) {
        WallScan wall;
        wall.spacing = spacing;
        wall.jitter = jitter;
        wall.dropout = dropout;
        wall.noise = 0.006;
        wall.solid = solid_but(windows);
        const Model model = outlines_of(segmentation_of({wall.points()}));
        CAPTURE(spacing);
        CAPTURE(jitter);
        CAPTURE(dropout);
        REQUIRE(model.faces.size() == 1);
        const Face& face = model.faces[0];
        REQUIRE(face.ring_count == 13);
        double worst = 0;
        for (size_t k = 0; k < 13; ++k) {
          const auto ring = ring_on_wall(model, face, k, wall);
          CHECK(ring.size() == 4);
          const Rectangle whole{0, 0, 12, 9};
          const Rectangle* expected = k == 0 ? &whole : hole_around(windows, ring);
          REQUIRE(expected != nullptr);
          worst = std::max(worst, corner_error(ring, *expected));
          // Outline anticlockwise, openings clockwise, for an eye in front of the wall (u to the right from -Y).
          CHECK((signed_area(ring) > 0) == (k == 0));
        }
        CHECK(worst <= 2 * spacing);
        CHECK(std::fabs(face.area_m2 / truth - 1) <= 0.02);
        MESSAGE("spacing " << spacing << " jitter " << jitter << " dropout " << dropout
                           << ": worst corner " << 1000 * worst << " mm, area "
                           << 100 * (face.area_m2 / truth - 1) << " %");
      }
}

TEST_CASE("outlines: points missing at random make no openings") {
  for (const double dropout : {0.5, 0.8}) {
    WallScan wall;
    wall.width = 6;
    wall.height = 4;
    wall.spacing = 0.02;
    wall.jitter = 1;
    wall.dropout = dropout;
    const Model model = outlines_of(segmentation_of({wall.points()}));
    REQUIRE(model.faces.size() == 1);
    CHECK(model.faces[0].ring_count == 1);
    CHECK(std::fabs(model.faces[0].area_m2 / 24 - 1) < 0.02);
  }
}

TEST_CASE("outlines: an L-shaped wall has six corners") {
  WallScan wall;
  wall.width = 6;
  wall.height = 5;
  wall.solid = [](double u, double v) { return u < 2.5 || v < 2; };
  const Model model = outlines_of(segmentation_of({wall.points()}));
  REQUIRE(model.faces.size() == 1);
  const auto ring = ring_on_wall(model, model.faces[0], 0, wall);
  REQUIRE(ring.size() == 6);
  for (const Vec2 corner :
       {Vec2{0, 0}, Vec2{6, 0}, Vec2{6, 2}, Vec2{2.5, 2}, Vec2{2.5, 5}, Vec2{0, 5}}) {
    double nearest = INFINITY;
    for (const Vec2& p : ring) nearest = std::min(nearest, norm(p - corner));
    CHECK(nearest <= 2 * wall.spacing);
  }
}

TEST_CASE("outlines: a gable keeps its slopes, an arch is no rectangle") {
  WallScan wall;
  wall.width = 6;
  wall.height = 6;
  wall.spacing = 0.02;
  const auto in_arch = [](double u, double v) {
    return (std::fabs(u - 3) < 0.6 && v > 0.8 && v < 2.4) || std::hypot(u - 3, v - 2.4) < 0.6;
  };
  wall.solid = [&](double u, double v) { return v < 6 - std::fabs(u - 3) && !in_arch(u, v); };
  const Model model = outlines_of(segmentation_of({wall.points()}));
  REQUIRE(model.faces.size() == 1);
  REQUIRE(model.faces[0].ring_count == 2);
  const auto gable = ring_on_wall(model, model.faces[0], 0, wall);
  CHECK(gable.size() == 5);
  double top = 0;
  for (const Vec2& p : gable) top = std::max(top, p.v);
  CHECK(std::fabs(top - 6) < 3 * wall.spacing);
  const auto arch = ring_on_wall(model, model.faces[0], 1, wall);
  CHECK(arch.size() == 4);
  const double truth = 36 - 9 - (1.2 * 1.6 + 0.5 * 3.14159265358979 * 0.36);
  CHECK(std::fabs(model.faces[0].area_m2 / truth - 1) < 0.005);
}

TEST_CASE("outlines: a pane inside an opening becomes a face of its own") {
  WallScan wall;
  wall.width = 4;
  wall.height = 4;
  const Rectangle hole{1, 1, 3, 3}, pane{1.5, 1.5, 2.5, 2.5};
  wall.solid = [&](double u, double v) { return !hole.contains(u, v) || pane.contains(u, v); };
  const Model model = outlines_of(segmentation_of({wall.points()}));
  REQUIRE(model.faces.size() == 2);
  CHECK(model.faces[0].ring_count == 2);
  CHECK(model.faces[1].ring_count == 1);
  CHECK(model.faces[0].id == model.faces[1].id);
  CHECK(model.faces[0].part == model.faces[1].part);
  CHECK(std::fabs(model.faces[0].area_m2 / 12 - 1) < 0.02);
  CHECK(std::fabs(model.faces[1].area_m2 - 1) < 0.05);
}

TEST_CASE("outlines: vertices lie on the plane and the model is valid") {
  WallScan wall;
  wall.shift = {652000, 6861000, 100};
  wall.solid = solid_but({{1, 1, 2, 2}});
  const Model model = outlines_of(segmentation_of({wall.points()}));
  validate(model);
  REQUIRE(!model.vertices.empty());
  double worst = 0;
  for (const Vec3& p : model.vertices)
    worst = std::max(worst, std::fabs(model.faces[0].plane.distance(p)));
  CHECK(worst < 1e-8);
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].part_class == "facade");
  CHECK(model.parts[0].parent == kNoParent);
  CHECK(model.parts[1].parent == 0);
  CHECK(model.faces[0].sigma_m > 0.003);
  CHECK(model.faces[0].covariance[0] > 0);
}

TEST_CASE("outlines: the same bits for any number of threads") {
  WallScan wall;
  wall.spacing = 0.03;
  wall.jitter = 1;
  std::vector<std::vector<Vec3>> parts;
  for (uint64_t s = 0; s < 9; ++s) {
    wall.seed = s + 1;
    wall.width = 2 + static_cast<double>(s);
    wall.azimuth = 0.7 * static_cast<double>(s);
    wall.solid = solid_but({{0.5, 0.5, 1.5, 1.7}});
    parts.push_back(wall.points());
  }
  const Segmentation segmentation = segmentation_of(parts);
  const Model one = outlines_of(segmentation, "{}", 1);
  CHECK(one.faces.size() >= 9);
  CHECK(same_bits(one, outlines_of(segmentation, "{}", 2)));
  CHECK(same_bits(one, outlines_of(segmentation, "{}", 7)));
}

TEST_CASE("outlines: a national grid changes no corner") {
  WallScan wall;
  wall.spacing = 0.02;
  wall.jitter = 1;
  wall.solid = solid_but(twelve_windows());
  const Model here = outlines_of(segmentation_of({wall.points()}));
  wall.shift = {652000, 6861000, 128};
  const Model there = outlines_of(segmentation_of({wall.points()}));
  REQUIRE(here.vertices.size() == there.vertices.size());
  CHECK(here.corners == there.corners);
  CHECK(here.faces[0].area_m2 == there.faces[0].area_m2);
  double worst = 0;
  for (size_t i = 0; i < here.vertices.size(); ++i)
    worst = std::max(worst, norm(there.vertices[i] - wall.shift - here.vertices[i]));
  CHECK(worst < 1e-8);  // the step of doubles at 6 861 000 m is 1e-9 m
}

TEST_CASE("outlines: few points, slivers and equal points are dropped or drawn, never a crash") {
  for (size_t n = 0; n < 12; ++n) {
    std::vector<Vec3> few, line, equal;
    RandomStream random(n, 1);
    for (size_t i = 0; i < n; ++i) {
      few.push_back({random.uniform(), 0.001 * random.uniform(), random.uniform()});
      line.push_back({static_cast<double>(i), 0, 0});
      equal.push_back({1, 2, 3});
    }
    for (const auto& part : {few, line, equal}) {
      Model model = outlines_of(segmentation_of({part}));
      validate(model);
      model = outlines_of(segmentation_of({part}), R"({"max_edge_m": 2, "min_area_m2": 0})");
      validate(model);
    }
  }
  WallScan sliver;
  sliver.width = 5;
  sliver.height = 0.05;
  const Model model = outlines_of(segmentation_of({sliver.points()}));
  validate(model);
  REQUIRE(model.faces.size() == 1);
  CHECK(std::fabs(model.faces[0].area_m2 - 0.25) < sliver.width * 2 * sliver.spacing);
}

TEST_CASE("outlines: no segments give a model without faces") {
  const Model model = outlines_of(segmentation_of({}));
  CHECK(model.faces.empty());
  CHECK(model.parts.empty());
}

TEST_CASE("outlines: raw contours keep points of the cloud and enclose the straight area") {
  WallScan wall;
  wall.width = 3;
  wall.height = 2;
  wall.spacing = 0.02;
  const Segmentation segmentation = segmentation_of({wall.points()});
  const Model raw = outlines_of(segmentation, R"({"straighten": false})");
  const Model straight = outlines_of(segmentation);
  REQUIRE(raw.faces.size() == 1);
  CHECK(raw.rings[0].count > 100);
  CHECK(raw.faces[0].area_m2 < 6);
  CHECK(std::fabs(raw.faces[0].area_m2 / straight.faces[0].area_m2 - 1) < 0.05);
}

TEST_CASE("outlines: a cancel stops them and says so") {
  WallScan wall;
  wall.spacing = 0.008;
  const Segmentation segmentation = segmentation_of({wall.points()});
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  bool cancelled = false;
  try {
    model_outlines(segmentation, {}, task);
  } catch (const Error& error) {
    cancelled = error.status() == Status::kCancelled;
  }
  CHECK(cancelled);
}
