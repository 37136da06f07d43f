// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::map<uint32_t, size_t> samples_of_faces(const Cloud& cloud) {
  std::map<uint32_t, size_t> out;
  for (const uint32_t id : values<uint32_t>(cloud, "face")) ++out[id];
  return out;
}

}  // namespace

TEST_CASE("sample__gives_every_face_its_share_of_the_points_on_it") {
  for (const char* name : {"surrounds", "std", "sills", "lycee", "facade"}) {
    CAPTURE(name);
    const Model model = scene(name);
    const auto faces = faces_by_id(model);
    const Cloud cloud = sampled(model, {.points = 60000, .noise_m = 0});
    REQUIRE(cloud.size() == 60000);
    CHECK(cloud.stations.empty());
    double area = 0;
    for (size_t t = 0; t < model.triangles.size(); ++t) {
      const auto& [a, b, c] = model.triangles[t];
      area += norm(cross(model.vertices[b] - model.vertices[a],
                         model.vertices[c] - model.vertices[a])) /
              2;
    }
    for (const auto& [id, n] : samples_of_faces(cloud)) {
      const auto found = faces.find(id);
      if (found == faces.end()) continue;
      double of_face = 0;
      for (const Face* face : found->second) of_face += face->area_m2;
      CHECK(std::abs(static_cast<double>(n) - 60000 * of_face / area) < 3);
    }
    const auto ids = values<uint32_t>(cloud, "face");
    for (size_t i = 0; i < cloud.size(); i += 7) {
      const auto found = faces.find(ids[i]);
      if (found == faces.end()) continue;
      const Vec3 p = cloud.point(i);
      REQUIRE(std::abs(found->second.front()->plane.distance(p)) < 1e-10);
      REQUIRE(std::any_of(found->second.begin(), found->second.end(),
                          [&](const Face* face) { return is_inside(model, *face, p, 1e-9); }));
    }
  }
}

TEST_CASE("sample__spreads_evenly_over_a_face") {
  const Model model = scene("normal");
  const Cloud cloud = sampled(model, {.spacing_m = 0.02, .noise_m = 0});
  REQUIRE(cloud.size() == 250000);
  std::vector<double> cells(400);
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.point(i);
    cells[static_cast<size_t>(p.x * 2) + 20 * static_cast<size_t>(p.z * 2)] += 1;
  }
  double chi2 = 0;
  for (const double n : cells) chi2 += (n - 625) * (n - 625) / 625;
  CHECK(is_chi_squared(chi2, 399));
}

TEST_CASE("sample__noise_goes_along_the_normal_with_the_deviation_asked_for") {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Model model = scene("std", {{"rotation_rad", 0.7}});
    const auto faces = faces_by_id(model);
    const Cloud cloud = sampled(model, {.points = 50000, .noise_m = 0.0075, .seed = seed});
    double squares = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Plane& plane = faces.at(values<uint32_t>(cloud, "face")[i]).front()->plane;
      const Vec3 off = cloud.point(i) - true_point(cloud, i);
      const double d = dot(off, plane.normal);
      REQUIRE(norm(off - plane.normal * d) < 1e-12);
      squares += d * d / (0.0075 * 0.0075);
    }
    CHECK(is_chi_squared(squares, 50000));
  }
}

TEST_CASE("sample__gives_equal_counts_glass_and_outliers_their_shares") {
  SampleSettings equal = {.points = 3000};
  equal.equal_counts = true;
  Task task;
  const auto strips = samples_of_faces(scan_sample(scene("std"), {}, equal, task));
  CHECK(strips.size() == 10);
  for (const auto& [id, n] : strips) CHECK(std::abs(static_cast<double>(n) - 300) <= 2);

  const Model model = scene("surrounds", {{"glass_m", 0.02}});
  const Cloud cloud =
      sampled(model, {.points = 60000,
                      .surfaces = {.glass_return_min = 0.05, .glass_return_max = 0.05},
                      .outliers = 0.02});
  CHECK(cloud.size() == 60000);
  double glass = 0, area = 0;
  for (const Face& face : model.faces) {
    const bool is_glass = model.parts[face.part].part_class == "glass";
    area += face.area_m2 * (is_glass ? 0.05 : 1);
    if (is_glass) glass += face.area_m2 * 0.05;
  }
  const auto faces = faces_by_id(model);
  size_t on_glass = 0, outliers = 0;
  for (const uint32_t id : values<uint32_t>(cloud, "face")) {
    outliers += id == kNoFace;
    on_glass += id != kNoFace && model.parts[faces.at(id).front()->part].part_class == "glass";
  }
  CHECK(is_binomial(on_glass, 60000, 0.98 * glass / area));
  CHECK(is_binomial(outliers, 60000, 0.02));
  const auto ids = values<uint32_t>(cloud, "face"), segments = values<uint32_t>(cloud, "segment");
  for (size_t i = 0; i < cloud.size(); ++i) REQUIRE((ids[i] == kNoFace) == (segments[i] == 0));
}

TEST_CASE("sample__has_the_same_bits_on_any_number_of_threads_and_others_for_another_seed") {
  const Model model = scene("insa");
  const SampleSettings options{.points = 100000,
                               .point_noise_m = 0.001,
                               .surfaces = {.glass_return_min = 0.05, .glass_return_max = 0.3},
                               .outliers = 0.02};
  const Cloud one = sampled(model, options, 1);
  CHECK(same_clouds(one, sampled(model, options, 2)));
  CHECK(same_clouds(one, sampled(model, options, 7)));
  SampleSettings other = options;
  other.seed = 2;
  CHECK_FALSE(same_clouds(one, sampled(model, other)));
}

TEST_CASE("sample__of_a_scene_on_the_national_grid_loses_nothing") {
  const std::vector<double> shift{652000, 6861000, 35};
  Task task;
  const Model far = build_scene({.name = SceneName::kPatches, .shift_m = shift}, task),
              here = scene("patches");
  const Cloud a = sampled(here, {.points = 5000}), b = sampled(far, {.points = 5000});
  for (size_t i = 0; i < a.size(); ++i)
    REQUIRE(norm(b.point(i) - Vec3{652000, 6861000, 35} - a.point(i)) < 2e-9);
}

TEST_CASE("sample__of_poor_models_ends_in_a_cloud_or_a_clear_error") {
  CHECK(sampled(Model{}).size() == 0);
  CHECK(sampled(Model{}, {.points = 100}).size() == 0);
  Model point;
  point.vertices = {{1, 2, 3}};
  point.triangles = {{0, 0, 0}};
  point.triangle_faces = {1};
  CHECK(sampled(point, {.points = 100}).size() == 0);
  Model broken = scene("normal");
  broken.vertices[0].x = std::nan("");
  CHECK_THROWS_AS(sampled(broken), Error);
  CHECK_THROWS_AS(sampled(scene("street"), {.spacing_m = 1e-4}), Error);
  const ScanStation station = station_at({0, 0, 0});
  Task task;
  CHECK_THROWS_AS(scan_sample(scene("normal"), {&station, 1}, SampleSettings{}, task), Error);
}
