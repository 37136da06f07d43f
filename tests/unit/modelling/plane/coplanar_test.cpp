// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The pieces of one wall become one segment.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/plane/coplanar.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

// A piece of the plane y = 0 of this width, moved by a shift.
std::vector<Vec3> piece(double width_m, const Vec3& shift, double azimuth = 0) {
  walls::WallScan scan;
  scan.width = width_m, scan.height = 3, scan.spacing = 0.05, scan.noise = 0.003;
  scan.azimuth = azimuth, scan.shift = shift;
  return scan.points();
}

Segmentation segmentation_with(const std::vector<std::vector<Vec3>>& parts) {
  Segmentation out = walls::segmentation_of(parts);
  for (size_t s = 0; s < parts.size(); ++s)
    out.segments[s].area_m2 = 0.0025 * static_cast<double>(parts[s].size());
  return out;
}

Segmentation whole(const Segmentation& segmentation, double tolerance_m = 0.02) {
  Task task;
  return joined_pieces(segmentation, whole_walls(segmentation, tolerance_m, task), task);
}

size_t label_count(const Segmentation& segmentation, uint32_t label) {
  const auto labels = segmentation.labels->values<uint32_t>();
  return static_cast<size_t>(std::count(labels.begin(), labels.end(), label));
}

}  // namespace

TEST_CASE("joined_pieces__piers_five_metres_apart_on_one_plane_become_one_segment") {
  const Segmentation before = segmentation_with({piece(3, {}), piece(1, {8, 0, 0})});
  const Segmentation after = whole(before);
  const size_t large = label_count(before, 1), small = label_count(before, 2);
  CHECK(label_count(after, 1) == large + small);
  CHECK(label_count(after, 2) == 0);
  // It keeps its fit; number and area are those of all.
  CHECK(after.segments[0].fit.plane.normal == before.segments[0].fit.plane.normal);
  CHECK(after.segments[0].fit.plane.offset == before.segments[0].fit.plane.offset);
  CHECK(after.segments[0].point_count() == large + small);
  CHECK(after.segments[0].area_m2 ==
        doctest::Approx(before.segments[0].area_m2 + before.segments[1].area_m2));
  // The piece stays as a segment of nothing, so that labels keep their meaning.
  REQUIRE(after.segments.size() == 2);
  CHECK(after.segments[1].label == 2);
  CHECK_FALSE(after.segments[1].has_plane());
  CHECK(after.segments[1].point_count() == 0);
  CHECK(after.segments[1].area_m2 == 0);
  CHECK(after.residuals == before.residuals);
  CHECK(after.orientations == before.orientations);
}

TEST_CASE("joined_pieces__a_panel_five_centimetres_proud_a_pane_and_a_turned_wall_stay") {
  const Segmentation before = segmentation_with(
      {piece(3, {}), piece(1, {4, -0.05, 0}), piece(1, {1, 0.2, 0}), piece(1, {6, 0, 0}, 0.5)});
  const Segmentation after = whole(before);
  for (uint32_t label = 1; label <= 4; ++label) {
    CHECK(label_count(after, label) == label_count(before, label));
    CHECK(after.segments[label - 1].has_plane());
  }
  // Within the tolerance the panel is the wall's.
  CHECK(label_count(whole(before, 0.07), 2) == 0);
}

TEST_CASE("joined_pieces__joins_all_pieces_to_the_largest_wherever_it_stands") {
  const Segmentation before = segmentation_with(
      {piece(1, {8, 0, 0}), piece(1, {20, 3, 0}), piece(3, {}), piece(0.5, {12, 0, 0})});
  const Segmentation after = whole(before);
  CHECK(label_count(after, 1) == 0);
  CHECK(label_count(after, 4) == 0);
  CHECK(label_count(after, 2) == label_count(before, 2));
  CHECK(label_count(after, 3) == before.cloud->size() - label_count(before, 2));
}

TEST_CASE("joined_pieces__floors_and_points_without_a_label_stay_as_they_are") {
  std::vector<Vec3> floor, other_floor;
  for (double x = 0; x < 3; x += 0.05)
    for (double y = 0; y < 3; y += 0.05) {
      floor.push_back({x, y, 0});
      if (x < 1) other_floor.push_back({x + 6, y, 0});
    }
  Segmentation before =
      segmentation_with({floor, other_floor, piece(3, {0, 9, 0}), piece(1, {6, 9, 0})});
  const auto given = before.labels->values<uint32_t>();
  auto labels = std::make_shared<Column>(before.labels->info(), given.size());
  std::copy(given.begin(), given.end(), labels->values<uint32_t>().begin());
  labels->values<uint32_t>().front() = labels->values<uint32_t>().back() = 0;
  before.labels = labels;
  const Segmentation after = whole(before);
  for (const uint32_t label : {0u, 1u, 2u})
    CHECK(label_count(after, label) == label_count(before, label));
  CHECK(label_count(after, 4) == 0);
}
