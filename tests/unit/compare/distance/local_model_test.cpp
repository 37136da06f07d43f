// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "compare/distance/local_surface.h"
#include "compare/distance/nearest_groups.h"
#include "spatial/octree/octree.h"
#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr LocalModelKind kModels[] = {LocalModelKind::kPlane, LocalModelKind::kDelaunay,
                                      LocalModelKind::kQuadric};

std::string name_of(LocalModelKind model) {
  return model == LocalModelKind::kPlane      ? "plane"
         : model == LocalModelKind::kDelaunay ? "delaunay"
                                              : "quadric";
}

DistanceSettings with_model(LocalModelKind model, uint32_t k = 0, double radius_m = 0) {
  DistanceSettings settings;
  settings.local_model = model;
  settings.k = k;
  settings.radius_m = radius_m;
  return settings;
}

std::span<const double> distances(const Comparison& made) {
  return made.points.require("distance").values<double>();
}

// Points of a square inside a margin, at a height.
std::vector<double> inner(size_t n, double side, double margin, double height, uint64_t seed) {
  auto xyz = random_square(n, side - 2 * margin, height, seed);
  for (size_t i = 0; i < xyz.size(); ++i)
    if (i % 3 != 2) xyz[i] += margin;
  return xyz;
}

// A sphere of radius 1 about the origin, or compared points at 1 + height.
std::vector<double> sphere(size_t n, double radius, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 p = normalized({random.normal(), random.normal(), random.normal()}) * radius;
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
  }
  return xyz;
}

}  // namespace

// Spec 9 (6): with local modelling the bias of the sampling vanishes on the plane.
TEST_CASE("local_model__makes_distances_on_an_unchanged_or_lifted_plane_true") {
  for (const double height : {0.0, 0.005}) {
    const auto reference = cloud_of(random_square(10000, 1, 0.0, 1));
    const auto other = cloud_of(inner(3000, 1, 0.05, height, 2));
    const double plain = summary(compared(reference, other), "rms");
    for (const LocalModelKind model : kModels) {
      for (const double radius : {0.0, 0.03}) {
        const Comparison made = compared(reference, other, with_model(model, 0, radius));
        size_t off = 0;
        for (const double d : distances(made)) off += std::fabs(d - height) > 1e-6;
        MESSAGE("FIGURE ", name_of(model), " radius ", radius, ": ", off, " of 3000 are not ",
                height, " m; rms ", summary(made, "rms"), ", plain ", plain);
        // A foot outside the few triangles, or farther than the neighbours reach, keeps its plain distance.
        CHECK(off < (radius == 0 && model == LocalModelKind::kDelaunay ? 120 : 30));
        CHECK(summary(made, "modelled") >= 2900);
      }
    }
  }
}

TEST_CASE("local_model__of_a_noisy_plane_is_four_times_better_than_the_nearest_point") {
  const auto reference = cloud_of(random_square(20000, 10, 0, 1, 0.003));
  const auto other = cloud_of(inner(5000, 10, 0.3, 0, 2));
  const double plain = summary(compared(reference, other), "rms");
  for (const LocalModelKind model : kModels) {
    const Comparison made = compared(reference, other, with_model(model));
    MESSAGE("FIGURE noisy plane, ", name_of(model), ": rms ", summary(made, "rms"), ", plain ",
            plain);
    CHECK(summary(made, "rms") < plain / 4);
  }
}

TEST_CASE("local_model__quadric_follows_a_sphere_where_the_plane_does_not") {
  const auto reference = cloud_of(sphere(4000, 1, 3)), other = cloud_of(sphere(2000, 1.01, 4));
  const auto mean_error = [&](LocalModelKind model, double radius) {
    const Comparison made = compared(reference, other, with_model(model, 0, radius));
    double sum = 0;
    for (const double d : distances(made)) sum += std::fabs(d - 0.01);
    return sum / 2000;
  };
  for (const double radius : {0.0, 0.15}) {
    const double plane = mean_error(LocalModelKind::kPlane, radius),
                 quadric = mean_error(LocalModelKind::kQuadric, radius);
    MESSAGE("FIGURE sphere, radius ", radius, ": plane ", plane, " m, quadric ", quadric, " m off");
    CHECK(quadric < plane / 5);
  }
}

TEST_CASE("local_model__is_never_worse_than_the_nearest_point_and_its_foot_is_consistent") {
  auto xyz = random_square(3000, 10, 0, 7, 0.2);  // a crumpled sheet
  const auto reference = cloud_of(xyz), other = cloud_of(random_square(2000, 12, 0.3, 8, 0.5));
  const Comparison plain = compared(reference, other);
  for (const LocalModelKind model : kModels)
    for (const auto where :
         {DistanceSettings::Neighbourhood::kNearest, DistanceSettings::Neighbourhood::kPoint})
      for (const double radius : {0.0, 0.4}) {
        DistanceSettings settings = with_model(model, 0, radius);
        settings.neighbourhood = where;
        settings.differences = true;
        const Comparison made = compared(reference, other, settings);
        for (size_t i = 0; i < other->size(); ++i) {
          REQUIRE(distances(made)[i] <= distances(plain)[i]);
          const Vec3 d{made.points.require("difference_x").number(i),
                       made.points.require("difference_y").number(i),
                       made.points.require("difference_z").number(i)};
          REQUIRE(norm(d) == doctest::Approx(distances(made)[i]).epsilon(1e-12));
        }
      }
}

// An object added in the plane of a wall but beyond its end is a change; a plane continued into the void would hide it.
TEST_CASE("local_model__does_not_continue_a_surface_beyond_its_points") {
  const auto reference = cloud_of(random_square(10000, 1, 0, 5));
  std::vector<double> beyond = random_square(500, 0.5, 0, 6);
  for (size_t i = 0; i < beyond.size(); i += 3) beyond[i] += 1.1;
  const auto other = cloud_of(beyond);
  const Comparison plain = compared(reference, other);
  for (const LocalModelKind model : kModels)
    for (const double radius : {0.0, 0.05, 0.2}) {
      const Comparison made = compared(reference, other, with_model(model, 0, radius));
      for (size_t i = 0; i < other->size(); ++i)
        REQUIRE(distances(made)[i] > 0.9 * distances(plain)[i]);
    }
}

TEST_CASE("local_model__falls_back_on_few_points_lines_and_duplicates") {
  std::vector<double> line, equal;
  for (int i = 0; i < 50; ++i) line.insert(line.end(), {0.1 * i, 0, 0});
  for (int i = 0; i < 300; ++i) equal.insert(equal.end(), {0.1, 0.2, 0.3});
  const auto other = cloud_of(random_square(200, 1, 0.2, 5));
  for (const auto& reference :
       {cloud_of({0, 0, 0}), cloud_of({0, 0, 0, 1, 0, 0}), cloud_of(line), cloud_of(equal)}) {
    const Comparison plain = compared(reference, other);
    for (const LocalModelKind model : kModels)
      for (const double radius : {0.0, 0.5}) {
        const Comparison made = compared(reference, other, with_model(model, 0, radius));
        CHECK(std::ranges::equal(distances(made), distances(plain)));
        CHECK(summary(made, "modelled") == 0);
      }
  }
}

TEST_CASE("local_model__does_not_depend_on_order_threads_or_a_shift_by_whole_metres") {
  const auto snapped = [](std::vector<double> xyz, const Vec3& by) {
    for (size_t i = 0; i < xyz.size(); ++i)
      xyz[i] = std::round(xyz[i] * 1024) / 1024 + by[static_cast<int>(i % 3)];
    return xyz;
  };
  const auto reversed = [](const std::vector<double>& xyz) {
    std::vector<double> out;
    for (size_t i = xyz.size(); i != 0; i -= 3)
      out.insert(out.end(), {xyz[i - 3], xyz[i - 2], xyz[i - 1]});
    return out;
  };
  const auto a = random_square(8000, 10, 0, 7, 0.1), b = random_square(6000, 10, 0.1, 8, 0.1);
  const auto reference = cloud_of(snapped(a, {})), other = cloud_of(snapped(b, {}));
  const Vec3 national{652000, 6861000, 130};
  for (const LocalModelKind model : kModels)
    for (const double radius : {0.0, 0.4}) {
      const DistanceSettings settings = with_model(model, 0, radius);
      const Comparison one = compared(reference, other, settings, 1);
      const auto expected = distances(one);
      CHECK(std::ranges::equal(expected, distances(compared(reference, other, settings, 7))));
      const Comparison far =
          compared(cloud_of(snapped(a, national)), cloud_of(snapped(b, national)), settings);
      CHECK(std::ranges::equal(expected, distances(far)));
      const Comparison back =
          compared(cloud_of(snapped(a, {})), cloud_of(reversed(snapped(b, {}))), settings);
      for (size_t i = 0; i < expected.size(); ++i)
        REQUIRE(distances(back)[expected.size() - 1 - i] == expected[i]);
    }
}

// More than eight reference points a compared one take another way to the neighbours.
TEST_CASE("local_model__finds_the_same_for_few_compared_points") {
  const auto reference = cloud_of(random_square(30000, 10, 0, 7, 0.01));
  const auto all = random_square(6000, 10, 0.05, 8, 0.01);
  const auto other = cloud_of(all), few = cloud_of({all.begin(), all.begin() + 3 * 1000});
  for (const LocalModelKind model : kModels)
    for (const double radius : {0.0, 0.2}) {
      const DistanceSettings settings = with_model(model, 0, radius);
      const Comparison many = compared(reference, other, settings),
                       some = compared(reference, few, settings);
      for (size_t i = 0; i < 1000; ++i)
        REQUIRE(std::fabs(distances(many)[i] - distances(some)[i]) < 1e-7);
    }
}

TEST_CASE("nearest_groups__hold_each_query_under_its_reference_point_in_order") {
  RandomStream random(1, 0);
  for (const size_t references : {size_t{1}, size_t{255}, size_t{5000}, size_t{2000000}}) {
    std::vector<uint32_t> nearest(20000);
    for (uint32_t& p : nearest)
      p = random.below(10) == 0 ? kNoPoint : static_cast<uint32_t>(random.below(references));
    Task task;
    const NearestGroups groups(nearest, references, task);
    size_t seen = 0;
    for (size_t p = 0; p < references; ++p) {
      const auto queries = groups[p];
      REQUIRE(std::ranges::is_sorted(queries));
      for (const uint32_t q : queries) REQUIRE(nearest[q] == p);
      seen += queries.size();
    }
    CHECK(seen == nearest.size() - static_cast<size_t>(std::ranges::count(nearest, kNoPoint)));
  }
}
