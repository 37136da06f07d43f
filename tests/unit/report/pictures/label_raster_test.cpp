// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Rasters of labelled points: every point where it lies, whatever the order, and never too many pixels.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/pictures/label_raster.h"
#include "unit/modelling/walls.h"
#include "unit/report/pictures/picture_pixels.h"

using namespace jalon;
using picture_pixels::cloud_of_points;

namespace {

const Projection kFromAbove{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};

LabelRaster seen_from_above(const std::vector<Vec3>& points, const std::vector<uint32_t>& labels,
                            const Projection& projection = kFromAbove) {
  Task task;
  return rasterise_points(cloud_of_points(points), labels, projection, task);
}

uint32_t label_seen(const LabelRaster& raster, const Vec2& at) {
  const auto column = static_cast<size_t>((at.u - raster.low.u) / raster.pixel_m);
  const auto up = static_cast<size_t>((at.v - raster.low.v) / raster.pixel_m);
  return raster.labels.at((raster.rows - 1 - up) * raster.columns + column);
}

// Two layers of points of 5 x 3 m: the upper one only over the left half, with labels 1 and 2; and noise above both.
void two_layers(std::vector<Vec3>& points, std::vector<uint32_t>& labels) {
  RandomStream random(3, 9);
  const auto put = [&](double from, double to, double z, uint32_t label, int n) {
    for (int i = 0; i < n; ++i) {
      points.push_back({from + (to - from) * random.uniform(), 3 * random.uniform(), z});
      labels.push_back(label);
    }
  };
  put(0, 5, 0, 1, 6000);
  put(0, 2.5, 1, 2, 3000);
  put(0, 5, 2, 0, 400);
}

}  // namespace

TEST_CASE("label_raster__shows_the_nearest_segment_and_never_noise_before_it") {
  std::vector<Vec3> points;
  std::vector<uint32_t> labels;
  two_layers(points, labels);
  const LabelRaster above = seen_from_above(points, labels);
  Projection from_below = kFromAbove;
  from_below.into = {0, 0, 1};
  const LabelRaster below = seen_from_above(points, labels, from_below);
  size_t wrong = 0, seen = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 at{points[i].x, points[i].y};
    if (labels[i] == 0) continue;
    // From below the lower layer is nearest everywhere; from above where the upper one, with its rim, is not.
    seen += labels[i] == 1;
    wrong += labels[i] == 1 && label_seen(below, at) != 1;
    if (labels[i] != 2 && at.u < 2.7) continue;
    ++seen;
    wrong += label_seen(above, at) != labels[i];
  }
  CHECK(seen > 11000);
  CHECK(wrong == 0);
}

TEST_CASE("label_raster__does_not_depend_on_the_order_of_the_points") {
  std::vector<Vec3> points;
  std::vector<uint32_t> labels;
  two_layers(points, labels);
  const LabelRaster raster = seen_from_above(points, labels);
  RandomStream random(4, 9);
  for (size_t i = points.size(); i-- > 1;) {
    const size_t other = random.below(i + 1);
    std::swap(points[i], points[other]);
    std::swap(labels[i], labels[other]);
  }
  const LabelRaster shuffled = seen_from_above(points, labels);
  CHECK(shuffled.columns == raster.columns);
  CHECK(shuffled.labels == raster.labels);
  CHECK(shuffled.low == raster.low);
}

TEST_CASE("label_raster__spans_the_segments_with_a_rim_and_few_enough_pixels") {
  RandomStream random(5, 9);
  struct Extents {
    double width, height;
    bool has_dense_corner;
  };
  const std::vector<Extents> scenes{
      {10, 5, false}, {1000, 1000, true}, {1e5, 0.2, true}, {0, 7, false}};
  for (const Extents& e : scenes) {
    std::vector<Vec3> points{{0, 0, 0}, {e.width, e.height, 0}};
    const double share = e.has_dense_corner ? 1e-4 : 1;
    for (int i = 0; i < 5000; ++i)
      points.push_back(
          {share * e.width * random.uniform(), share * e.height * random.uniform(), 0});
    std::vector<uint32_t> labels(points.size(), 1);
    points.push_back({-1e6, 1e6, 0});  // noise does not widen the picture
    labels.push_back(0);
    const LabelRaster raster = seen_from_above(points, labels);
    CAPTURE(e.width);
    const double pixels = static_cast<double>(raster.labels.size());
    CHECK(raster.labels.size() == size_t{raster.columns} * raster.rows);
    // A row and a column of rounding, and a side of at most 16 000 pixels.
    CHECK(pixels <= kMaxPicturePixels + 20000);
    CHECK(raster.low.u <= 0);
    CHECK(raster.low.v <= 0);
    CHECK(raster.low.u + raster.width_m() >= e.width);
    CHECK(raster.low.v + raster.height_m() >= e.height);
    CHECK(label_seen(raster, {e.width, e.height}) == 1);
  }
}

TEST_CASE("label_raster__of_points_at_no_place_on_earth_is_empty") {
  for (const double far_m : {1e10, 1e160, 1e252}) {
    CAPTURE(far_m);
    const LabelRaster raster = seen_from_above({{0, 0, 0}, {far_m, far_m, 0}}, {1, 1});
    CHECK(raster.labels.empty());
    CHECK((raster.rows == 0 && raster.columns == 0));
  }
  CHECK(!seen_from_above({{0, 0, 0}, {1e8, 1e8, 0}}, {1, 1}).labels.empty());
}

TEST_CASE("label_raster__of_one_point_or_none_or_noise_alone") {
  CHECK(seen_from_above({}, {}).labels.empty());
  const LabelRaster one = seen_from_above({{7, 8, 9}}, {3});
  CHECK(std::count(one.labels.begin(), one.labels.end(), 3u) > 0);
  CHECK(std::abs(one.low.u + one.width_m() / 2 - 7) < 0.02);  // the least extent is 1 cm
  const LabelRaster noise = seen_from_above({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}, {0, 0, 0});
  CHECK(label_seen(noise, {1, 1}) == LabelRaster::kNoise);
  // In the frame of a facade that runs north: what lies along it is right, heights are up.
  std::vector<Vec3> wall;
  for (int i = 0; i < 400; ++i) wall.push_back({5, 0.1 * (i % 40), 0.1 * (i / 40)});
  Segmentation s = walls::segmentation_of({wall});
  s.T_facade_world.m = {0, 1, 0, 0, -1, 0, 0, 5, 0, 0, 1, 0};
  Task task;
  const LabelRaster front = rasterise_labels(s, PictureView::kFront, task);
  CHECK(front.width_m() > 3.8);
  CHECK(front.height_m() > 0.8);
  CHECK(front.height_m() < 1.4);
  const LabelRaster plan = rasterise_labels(s, PictureView::kPlan, task);
  CHECK(plan.width_m() < 0.5);  // a line in plan
  CHECK(plan.height_m() > 3.8);
  CHECK(label_seen(plan, {5, 2}) == 1);
}
