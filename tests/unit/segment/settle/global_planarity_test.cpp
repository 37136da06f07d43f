// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/global_planarity.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <string>

#include "unit/segment/made_scene.h"
#include "unit/segment/plane_methods.h"
#include "unit/segment/same_bits.h"
#include "unit/segment/surrounds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A wall of 4 x 3 m with a panel of 1.5 x 1 m that stands back by depth_m, less than the tolerance of 25 mm.
Scene panel(double depth_m, double sigma_m, uint64_t seed) {
  Scene out;
  RandomStream random(seed, 40);
  const auto add = [&](int face, double x, double z, double w, double h, double y) {
    out.rectangle(face, {x, y, z}, {w, 0, 0}, {0, 0, h}, static_cast<size_t>(1500 * w * h), sigma_m,
                  random);
  };
  add(1, 0, 0, 1, 3, 0);
  add(1, 2.5, 0, 1.5, 3, 0);
  add(1, 1, 0, 1.5, 1, 0);
  add(1, 1, 2, 1.5, 1, 0);
  add(2, 1, 1, 1.5, 1, depth_m);
  return out;
}

// Two walls of 3 x 3 m that meet at a crease of a few degrees.
Scene fold(double angle_rad, double sigma_m, uint64_t seed) {
  Scene out;
  RandomStream random(seed, 41);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 3}, 13000, sigma_m, random);
  out.rectangle(2, {3, 0, 0}, {3 * std::cos(angle_rad), 3 * std::sin(angle_rad), 0}, {0, 0, 3},
                13000, sigma_m, random);
  return out;
}

// One flat wall.
Scene flat(double sigma_m, uint64_t seed) {
  Scene out;
  RandomStream random(seed, 42);
  out.rectangle(1, {0, 0, 0}, {6, 0, 0}, {0, 0, 3}, 27000, sigma_m, random);
  return out;
}

std::string with(const char* more, bool refine) {
  return std::string("{\"global_planarity\":") + (refine ? "true" : "false") + more + "}";
}

Segmentation refined(const char* method, const Scene& scene, const char* more = "",
                     bool refine = true, unsigned threads = 2) {
  return segment_by(method, cloud_of(scene.points), with(more, refine).c_str(), threads);
}

constexpr const char* kMethods[] = {"ransac",   "region_growing",   "raster_growing",
                                    "profiles", "triangle_growing", "split_merge",
                                    "hough"};

}  // namespace

TEST_CASE("global_planarity__a_panel_set_back_by_less_than_the_tolerance__is_a_plane_of_its_own") {
  const Scene scene = panel(0.015, 0.002, 1);
  for (const char* method : kMethods) {
    CAPTURE(method);
    CHECK(refined(method, scene, "", false).segments.size() == 1);
    const Segmentation s = refined(method, scene);
    REQUIRE(s.segments.size() == 2);
    CHECK(best_match(scene, s, 1).share > 0.98);
    CHECK(best_match(scene, s, 2).share > 0.98);
    const double depth = s.segments[1].fit.centroid.y - s.segments[0].fit.centroid.y;
    CHECK(std::fabs(depth - 0.015) < 5e-4);
  }
}

TEST_CASE("global_planarity__walls_at_a_few_degrees__are_two") {
  const Scene scene = fold(0.02, 0.002, 2);
  for (const char* method : {"ransac", "hough", "split_merge"}) {
    CAPTURE(method);
    const Segmentation before = refined(method, scene, "", false), s = refined(method, scene);
    CAPTURE(before.segments.size());
    CAPTURE(best_match(scene, before, 1).share);
    CAPTURE(best_match(scene, before, 2).share);
    CHECK(s.segments.size() == 2);
    CHECK(best_match(scene, s, 1).share > 0.95);
    CHECK(best_match(scene, s, 2).share > 0.95);
  }
}

TEST_CASE(
    "global_planarity__a_tolerance_over_all_layers__has_wall_surrounds_and_joinery_told_apart") {
  // Boulaassal 2010, fig. 3.11: half-thickness 0.15 m.
  const Scene scene = surrounds(1);
  const char* wide = ",\"distance_tolerance_m\":0.15,\"normals\":\"none\"";
  const Segmentation before = refined("ransac", scene, wide, false),
                     s = refined("ransac", scene, wide);
  const uint32_t wall = best_match(scene, before, 1).label;
  CHECK(best_match(scene, before, 2).label == wall);  // under-segmented
  CHECK(best_match(scene, s, 1).label != best_match(scene, s, 2).label);
  CHECK(best_match(scene, s, 1).share > 0.95);
}

TEST_CASE("global_planarity__a_flat_wall_and_its_noise__stay_one_plane_with_the_same_bits") {
  for (const double sigma : {0.0, 0.002, 0.008})
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      const Scene scene = flat(sigma, seed);
      const Segmentation before = refined("split_merge", scene, "", false);
      REQUIRE(before.segments.size() == 1);
      check_same(before, refined("split_merge", scene), false);
    }
}

TEST_CASE("global_planarity__other_depths_and_seeds_than_it_was_made_with") {
  size_t found = 0, whole = 0, all = 0;
  for (uint64_t seed = 301; seed <= 305; ++seed)
    for (const double depth : {0.010, 0.018, -0.012}) {
      const Scene scene = panel(depth, 0.003, seed);
      const Segmentation s = refined("region_growing", scene);
      ++all;
      found += s.segments.size() == 2 && best_match(scene, s, 2).share > 0.95;
      whole += refined("region_growing", flat(0.003, seed)).segments.size() == 1;
    }
  std::printf("FIGURE global_planarity: %zu of %zu panels found, %zu of %zu walls whole\n", found,
              all, whole, all);
  CHECK(found == all);
  CHECK(whole == all);
}

TEST_CASE("global_planarity__threads_and_shift__the_same_bits") {
  Scene scene = panel(0.015, 0.002, 3);
  scene.points = snapped(std::move(scene.points));
  const Segmentation one = refined("region_growing", scene, "", true, 1);
  check_same(one, refined("region_growing", scene, "", true, 2), false);
  check_same(one, refined("region_growing", scene, "", true, 7), false);
  for (Vec3& p : scene.points) p += Vec3{652000, 6861000, 120};
  check_same(one, refined("region_growing", scene), true);
}

TEST_CASE("global_planarity__jitter_rounding_order_half_of_the_points_and_a_turn__change_nothing") {
  const Scene scene = panel(0.012, 0.003, 306);  // kept for the report
  RandomStream random(7, 0);
  const auto jittered = [&](Vec3 p) {
    return p + Vec3{random.normal(), random.normal(), random.normal()} * 1e-4;
  };
  const auto rounded = [](Vec3 p) {
    return Vec3{std::round(p.x * 1e3), std::round(p.y * 1e3), std::round(p.z * 1e3)} * 1e-3;
  };
  const auto turned = [](Vec3 p) {
    return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
  };
  std::vector<Scene> variants(5, scene);
  for (Vec3& p : variants[0].points) p = jittered(p);
  for (Vec3& p : variants[1].points) p = rounded(p);
  for (Vec3& p : variants[2].points) p = turned(p);
  std::reverse(variants[3].points.begin(), variants[3].points.end());
  std::reverse(variants[3].faces.begin(), variants[3].faces.end());
  variants[4] = {};
  for (size_t i = 0; i < scene.points.size(); i += 2) {
    variants[4].points.push_back(scene.points[i]);
    variants[4].faces.push_back(scene.faces[i]);
  }
  for (size_t v = 0; v < variants.size(); ++v) {
    CAPTURE(v);
    const Segmentation s = refined("region_growing", variants[v]);
    REQUIRE(s.segments.size() == 2);
    CHECK(best_match(variants[v], s, 1).share > 0.95);
    CHECK(best_match(variants[v], s, 2).share > 0.95);
  }
}

TEST_CASE("global_planarity__a_panel_smaller_than_the_least_area__stays_in_its_wall") {
  const Scene scene = panel(0.015, 0.002, 4);
  const Segmentation s = refined("split_merge", scene, ",\"min_area_m2\":2");
  CHECK(s.segments.size() == 1);
}
