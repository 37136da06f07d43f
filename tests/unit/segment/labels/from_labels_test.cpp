// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/from_labels.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "unit/segment/labelled.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CloudPtr with_faces(const Scene& scene, const Vec3& shift = {}) {
  Cloud cloud = *cloud_of(scene.points, shift);
  cloud.fields.set(make_column<int32_t>({"face"}, scene.faces));
  return std::make_shared<const Cloud>(std::move(cloud));
}

// Columns in a plane each, one above the other: cheap points for a million segments' worth of labels.
CloudPtr many_labels(size_t n, uint32_t labels, uint64_t seed) {
  Buffer<double> xyz(3 * n);
  std::vector<uint32_t> field(n), shifted(n);
  RandomStream random(seed, 5);
  for (size_t i = 0; i < n; ++i) {
    const auto label = static_cast<uint32_t>(i * labels / n);
    const double noise = 0.006 * (random.uniform() - 0.5);
    xyz[3 * i] = static_cast<double>(label % 100) + 0.9 * random.uniform();
    xyz[3 * i + 1] = noise;
    xyz[3 * i + 2] = static_cast<double>(label / 100) + 0.9 * random.uniform();
    field[i] = label + 1;
    shifted[i] =
        random.uniform() < 0.05 ? static_cast<uint32_t>(random.below(labels + 1)) : label + 1;
  }
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields.set(make_column<uint32_t>({"reference"}, field));
  cloud.fields.set(make_column<uint32_t>({"automatic"}, shifted));
  return std::make_shared<const Cloud>(std::move(cloud));
}

}  // namespace

TEST_CASE("labels of true faces give the true planes, on the national grid too") {
  const Scene scene = facade_scene(800, 1);
  const Vec3 shift{652000, 6861000, 120};
  const Segmentation local = from_labels(with_faces(scene), "face"),
                     national = from_labels(with_faces(scene, shift), "face");
  REQUIRE(local.segments.size() == 18);
  REQUIRE(national.segments.size() == 18);
  for (size_t s = 0; s < 18; ++s) {
    const Segment &a = local.segments[s], &b = national.segments[s];
    CHECK(a.source_label == b.source_label);
    CHECK(a.fit.n == b.fit.n);
    CHECK(std::fabs(a.fit.sigma - 0.003) < 0.0006);
    CHECK(norm(b.fit.centroid - shift - a.fit.centroid) < 1e-8);
    CHECK(norm(cross(a.fit.plane.normal, b.fit.plane.normal)) < 1e-8);
  }
  const Segment& wall = *std::find_if(local.segments.begin(), local.segments.end(),
                                      [](const Segment& s) { return s.source_label == 1; });
  CHECK(wall.orientation == Orientation::kParallel);
  CHECK(std::fabs(wall.area_m2 - 54) < 3);  // 10 x 6 m less two windows of 3 m2
  CHECK(std::fabs(std::fabs(wall.fit.plane.normal.y) - 1) < 1e-5);
}

TEST_CASE("labels agree with what the segmenter made of them") {
  const Scene scene = facade_scene(800, 2);
  const CloudPtr cloud = cloud_of(scene.points);
  const Segmentation found = run(cloud, ransac_params());
  Cloud labelled = *cloud;
  labelled.fields.set(found.labels);
  const Segmentation back =
      from_labels(std::make_shared<const Cloud>(std::move(labelled)), "label");
  REQUIRE(back.segments.size() == found.segments.size());
  for (size_t s = 0; s < found.segments.size(); ++s) {
    CHECK(back.segments[s].fit.n == found.segments[s].fit.n);
    CHECK(back.segments[s].orientation == found.segments[s].orientation);
    CHECK(std::fabs(back.segments[s].area_m2 / found.segments[s].area_m2 - 1) < 0.5);
  }
  Task task;
  const Evaluation e = evaluate_segmentation(found, back, evaluation_params(), task);
  CHECK(e.totals.detection == 1);
  CHECK(e.totals.angle_rad.mean < 1e-3);
}

TEST_CASE("labels without three points off a line keep their row with NaN") {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {5, 0, 0},
                                 {6, 0, 0}, {7, 1, 0}, {9, 9, 9}, {9, 9, 9}};
  const std::vector<int64_t> labels{2, 2, 2, 2, 7, 7, 7, 9, 9};
  Cloud cloud = *cloud_of(points);
  cloud.fields.set(make_column<int64_t>({"label"}, labels));
  const Segmentation s = from_labels(std::make_shared<const Cloud>(std::move(cloud)), "label");
  REQUIRE(s.segments.size() == 3);
  CHECK(s.segments[0].source_label == 2);
  CHECK_FALSE(s.segments[0].has_plane());
  CHECK(s.segments[0].orientation == Orientation::kNone);
  CHECK(s.segments[1].has_plane());
  CHECK_FALSE(s.segments[2].has_plane());
  CHECK(std::isnan(s.residuals->values<float>()[0]));
  CHECK(std::fabs(s.residuals->values<float>()[4]) < 1e-9f);
}

TEST_CASE("labels that mean noise are the caller's choice") {
  Scene scene = facade_scene(200, 1);
  for (int& face : scene.faces)
    if (face == 0) face = -1;
  const CloudPtr cloud = with_faces(scene);
  CHECK(from_labels(cloud, "face").segments.size() == 19);
  CHECK(from_labels(cloud, "face", "{\"noise_labels\": [-1]}").segments.size() == 18);
  CHECK(from_labels(cloud, "face", "{\"noise_labels\": [-1, 1, 2]}").segments.size() == 16);
  CHECK_THROWS_AS(from_labels(cloud, "face", "{\"noise_labels\": [0.5]}"), Error);
  CHECK_THROWS_AS(from_labels(cloud, "no such field"), Error);
}

TEST_CASE("labels and their evaluation hold for millions of points and thousands of segments") {
  const size_t n = std::getenv("JALON_FULL") != nullptr        ? 10000000
                   : std::getenv("JALON_SANITIZED") != nullptr ? 100000
                                                               : 1000000;
  const CloudPtr cloud = many_labels(n, 5000, 1);
  const auto before = std::chrono::steady_clock::now();
  const Segmentation automatic = from_labels(cloud, "automatic"),
                     reference = from_labels(cloud, "reference");
  const double made =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  Task task;
  const Evaluation e = evaluate_segmentation(automatic, reference, evaluation_params(), task);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() - made;
  MESSAGE("FIGURE " << n << " points, 5000 x 5000 segments: " << made << " s for both from labels, "
                    << seconds << " s to evaluate");
  CHECK(e.totals.pairs == 5000);
  for (const SegmentPair& pair : e.pairs)
    CHECK(automatic.segments[pair.automatic - 1].source_label ==
          reference.segments[pair.reference - 1].source_label);
  CHECK(std::fabs(e.totals.mean_tdr - 0.95) < 0.01);
  CHECK(std::fabs(e.totals.mean_tda - 0.95) < 0.01);
}

TEST_CASE("labels give the same bits for any number of threads") {
  const CloudPtr cloud = many_labels(300000, 3, 4);
  const Segmentation one = from_labels(cloud, "automatic", "{}", 1);
  for (const unsigned threads : {2u, 7u}) {
    const Segmentation other = from_labels(cloud, "automatic", "{}", threads);
    REQUIRE(other.segments.size() == one.segments.size());
    for (size_t s = 0; s < one.segments.size(); ++s) {
      CHECK(other.segments[s].fit.covariance == one.segments[s].fit.covariance);
      CHECK(other.segments[s].fit.plane.offset == one.segments[s].fit.plane.offset);
      CHECK(other.segments[s].area_m2 == one.segments[s].area_m2);
    }
  }
}
