// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/surface_classes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>

#include "geometry/plane.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// A rectangle: corner, two sides at right angles, and whether another surface meets it there.
struct Sheet {
  Vec3 corner, u, v;
  bool joined[4];                     ///< at the sides v = 0, v = 1, u = 0, u = 1
  double hole_from = 0, hole_to = 0;  ///< of both sides
};

struct Sampled {
  std::vector<Vec3> points;
  std::vector<double> to_fold_m, to_end_m;  ///< of each point
};

// Evenly at random, with noise across; no point falls into the hole.
Sampled sampled(const std::vector<Sheet>& sheets, double per_m2, double sigma_m, uint64_t seed) {
  Sampled out;
  RandomStream random(seed, 0);
  for (const Sheet& s : sheets) {
    const double width = norm(s.u), height = norm(s.v);
    const Vec3 n = normalized(cross(s.u, s.v));
    const auto count = static_cast<size_t>(per_m2 * width * height);
    for (size_t i = 0; i < count; ++i) {
      const double u = random.uniform(), v = random.uniform(), noise = random.normal();
      const bool in_u = u > s.hole_from && u<s.hole_to, in_v = v> s.hole_from && v < s.hole_to;
      if (in_u && in_v) continue;
      const double to_side[4] = {v * height, (1 - v) * height, u * width, (1 - u) * width};
      double fold = 1e9, end = 1e9;
      for (size_t k = 0; k < 4; ++k) {
        double& nearest = s.joined[k] ? fold : end;
        nearest = std::min(nearest, to_side[k]);
      }
      if (s.hole_to > 0) {
        if (in_v)
          end =
              std::min(end, std::min(std::fabs(u - s.hole_from), std::fabs(u - s.hole_to)) * width);
        if (in_u)
          end = std::min(end,
                         std::min(std::fabs(v - s.hole_from), std::fabs(v - s.hole_to)) * height);
        if (!in_u && !in_v) {  // to a corner of the hole
          const double du = std::min(std::fabs(u - s.hole_from), std::fabs(u - s.hole_to)) * width;
          const double dv = std::min(std::fabs(v - s.hole_from), std::fabs(v - s.hole_to)) * height;
          end = std::min(end, std::hypot(du, dv));
        }
      }
      out.points.push_back(s.corner + u * s.u + v * s.v + sigma_m * noise * n);
      out.to_fold_m.push_back(fold);
      out.to_end_m.push_back(end);
    }
  }
  return out;
}

/// Three walls of a room, one with a window.
std::vector<Sheet> room() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {true, false, true, false}},
          {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {true, false, true, false}, 0.3, 0.7},
          {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}, {true, false, true, false}}};
}
/// Four steps of stairs with a gap in the upper riser.
std::vector<Sheet> stairs() {
  std::vector<Sheet> out;
  for (int i = 0; i < 4; ++i) {
    const double y = 0.4 * i, z = 0.4 * i;
    out.push_back({{0, y, z}, {2, 0, 0}, {0, 0, 0.4}, {i > 0, true, false, false}});
    out.push_back({{0, y, z + 0.4}, {2, 0, 0}, {0, 0.4, 0}, {true, i < 3, false, false}});
  }
  out[6].hole_from = 0.35, out[6].hole_to = 0.65;
  return out;
}
/// A pillar of six sides, which meet at 120 degrees, seen from all sides.
std::vector<Sheet> pillar() {
  std::vector<Sheet> out;
  const auto corner = [](int i) {
    const double angle = i * std::numbers::pi / 3;
    return Vec3{0.5 * std::cos(angle), 0.5 * std::sin(angle), 0};
  };
  for (int i = 0; i < 6; ++i)
    out.push_back({corner(i), corner(i + 1) - corner(i), {0, 0, 2}, {false, false, true, true}});
  return out;
}

std::vector<uint8_t> classes(const Cloud& cloud, uint32_t k = 16, double radius_m = 0,
                             unsigned with_threads = 2) {
  FeaturesSettings set;
  set.k = k;
  set.which = "surface_class";
  set.radius_m = radius_m;
  Task task(threads(with_threads));
  const Cloud out = with_features(cloud, set, task);
  const auto values = out.fields.require("surface_class").values<uint8_t>();
  return {values.begin(), values.end()};
}

/// Shares of the points that are what the truth says.
struct Shares {
  double folds = 0, ends = 0, surfaces = 0;
};
constexpr double kPerM2 = 2500;

Shares shares(const Sampled& truth, const std::vector<uint8_t>& found, uint32_t k) {
  const double reach = std::sqrt(k / (std::numbers::pi * kPerM2));  // of k points
  size_t of[3] = {0, 0, 0}, right[3] = {0, 0, 0};
  for (size_t i = 0; i < found.size(); ++i) {
    const double fold = truth.to_fold_m[i], end = truth.to_end_m[i];
    int kind = -1;
    if (fold < 0.25 * reach && end > 1.5 * reach) kind = 0;
    if (end < 0.25 * reach && fold > 1.5 * reach) kind = 1;
    if (end > 1.5 * reach && fold > 1.5 * reach) kind = 2;
    if (kind < 0) continue;
    constexpr SurfaceClass kWanted[3] = {SurfaceClass::kBoundary, SurfaceClass::kEdge,
                                         SurfaceClass::kSurface};
    ++of[kind];
    right[kind] += found[i] == static_cast<uint8_t>(kWanted[kind]);
  }
  const auto share = [&](size_t kind) {
    return static_cast<double>(right[kind]) / static_cast<double>(of[kind]);
  };
  return {share(0), share(1), share(2)};
}

// FIGURE lines: shares of folds, ends and surfaces that are told so.
Shares measured(const char* name, const std::vector<Sheet>& sheets, double sigma_m, uint64_t seed,
                uint32_t k) {
  const Sampled truth = sampled(sheets, kPerM2, sigma_m, seed);
  const Shares s = shares(truth, classes(cloud_of(truth.points), k), k);
  std::printf(
      "FIGURE surface_class %s sigma %.3f seed %u k %u: boundary %.3f edge %.3f surface %.3f\n",
      name, sigma_m, static_cast<unsigned>(seed), k, s.folds, s.ends, s.surfaces);
  return s;
}

TEST_CASE("surface_classes__a_room_with_a_window__has_boundaries_edges_and_surfaces") {
  for (const double sigma : {0.0, 0.003})
    for (const uint32_t k : {16u, 32u}) {
      const Shares s = measured("room", room(), sigma, 1, k);
      CHECK(s.folds > 0.9);
      CHECK(s.ends > (k == 16 ? 0.8 : 0.95));
      CHECK(s.surfaces > 0.97);
    }
}

TEST_CASE("surface_classes__scenes_and_seeds_that_nobody_had_looked_at__are_told_as_well") {
  for (uint64_t seed = 201; seed < 204; ++seed)
    for (const uint32_t k : {16u, 32u}) {
      for (const Shares& s : {measured("stairs", stairs(), 0.002, seed, k),
                              measured("pillar", pillar(), 0.002, seed, k)}) {
        CHECK(s.folds > 0.9);
        CHECK(s.ends > (k == 16 ? 0.8 : 0.95));
        CHECK(s.surfaces > 0.97);
      }
    }
}

size_t differing(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
  size_t n = 0;
  for (size_t i = 0; i < a.size(); ++i) n += a[i] != b[i];
  return n;
}

TEST_CASE("surface_classes__stay_where_the_cloud_is_jittered_rounded_turned_or_moved") {
  const std::vector<Vec3> points = sampled(room(), kPerM2, 0.003, 2).points;
  const std::vector<uint8_t> as_is = classes(cloud_of(points));
  const auto share = [&](auto&& change) {
    std::vector<Vec3> changed = points;
    for (Vec3& p : changed) p = change(p);
    return static_cast<double>(differing(as_is, classes(cloud_of(changed)))) /
           static_cast<double>(points.size());
  };
  RandomStream random(3, 0);
  const auto jitter = [&] { return 1e-4 * random.normal(); };
  CHECK(share([&](Vec3 p) { return p + Vec3{jitter(), jitter(), jitter()}; }) < 0.01);
  CHECK(share([](Vec3 p) {
          return Vec3{std::round(p.x * 1e3), std::round(p.y * 1e3), std::round(p.z * 1e3)} * 1e-3;
        }) < 0.02);
  const double c = std::cos(0.6), s = std::sin(0.6);
  CHECK(share([&](Vec3 p) { return Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z}; }) < 1e-3);
  CHECK(share([](Vec3 p) { return p + kFar; }) < 1e-3);
  const std::vector<Vec3> reversed(points.rbegin(), points.rend());
  std::vector<uint8_t> back = classes(cloud_of(reversed));
  std::reverse(back.begin(), back.end());
  CHECK(differing(as_is, back) <
        points.size() / 1000);  // only where neighbours are as far to the step of the index
}

TEST_CASE("surface_classes__half_of_the_points__tell_the_same_within_their_wider_reach") {
  const Sampled half = sampled(room(), kPerM2 / 2, 0.003, 4);
  const Shares s = shares(half, classes(cloud_of(half.points), 32), 64);
  CHECK(s.folds > 0.9);
  CHECK(s.ends > 0.9);
  CHECK(s.surfaces > 0.97);
}

TEST_CASE("surface_classes__within_a_radius__are_those_of_as_many_neighbours") {
  const Sampled truth = sampled(room(), kPerM2, 0.003, 5);
  const Shares s = shares(
      truth, classes(cloud_of(truth.points), 16, std::sqrt(32 / (std::numbers::pi * kPerM2))), 32);
  CHECK(s.folds > 0.9);
  CHECK(s.ends > 0.8);  // half of the ball is empty there: 16 neighbours
  CHECK(s.surfaces > 0.97);
}

TEST_CASE("surface_classes__threads__the_same_bits") {
  const Cloud cloud = cloud_of(sampled(room(), kPerM2, 0.003, 6).points);
  for (const double radius_m : {0.0, 0.07, 1.0}) {
    const std::vector<uint8_t> one = classes(cloud, 16, radius_m, 1);
    CHECK(one == classes(cloud, 16, radius_m, 2));
    CHECK(one == classes(cloud, 16, radius_m, 7));
  }
}

TEST_CASE("surface_classes__points_that_span_no_plane__are_unknown") {
  std::vector<Vec3> line;
  for (int i = 0; i < 30; ++i) line.push_back({0.1 * i, 0, 0});
  for (const auto& points :
       {std::vector<Vec3>{{1, 2, 3}}, std::vector<Vec3>(30, Vec3{1, 1, 1}), line})
    for (const uint8_t c : classes(cloud_of(points))) CHECK(c == 0);
}

}  // namespace
}  // namespace jalon
