// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What the segments put into a hole.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/walls/hole_content.h"

using namespace jalon;

namespace {

/// Planes with these normals, labels from 1 on.
Segmentation planes_with(const std::vector<Vec3>& normals) {
  Segmentation out;
  for (const Vec3& n : normals) {
    Segment segment;
    segment.label = static_cast<uint32_t>(out.segments.size() + 1);
    segment.fit.plane = {normalized(n), 0};
    out.segments.push_back(segment);
  }
  return out;
}

const Vec3 kOut{0, -1, 0};
const WallMap kMap{{0, 0}, 0.1, 40, 40, std::vector<WallCell>(1600, WallCell::kThrough)};

void add_patch(HoleSurvey& hole, uint32_t label, double u0, double v0, int columns, int rows,
               double w, int a_cell = 1) {
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      for (int k = 0; k < a_cell; ++k)
        hole.points.push_back({0, label, static_cast<float>(u0 + 0.1 * c + 0.05),
                               static_cast<float>(v0 + 0.1 * r + 0.05), static_cast<float>(w)});
}

}  // namespace

TEST_CASE("hole_content__tells_fillers_by_the_angle_of_their_planes_to_the_wall") {
  const Segmentation s = planes_with({kOut, {0.05, 1, 0}, {1, 0.05, 0}, {1, 1, 0}, kOut});
  HoleSurvey hole;
  for (uint32_t label = 0; label <= 5; ++label) add_patch(hole, label, 0, 0, 3, 3, -0.2);
  Task task;
  const HoleContent content = content_of(hole, kMap, s, kOut, 5, task);  // 5: the wall itself
  const auto labels = [](const std::vector<HoleFiller>& fillers) {
    std::vector<uint32_t> out;
    for (const HoleFiller& f : fillers) out.push_back(f.label);
    return out;
  };
  CHECK(labels(content.parallel) == std::vector<uint32_t>{1, 2});
  CHECK(labels(content.upright) == std::vector<uint32_t>{3});
  CHECK(labels(content.other) == std::vector<uint32_t>{0, 4});
}

TEST_CASE("hole_content__counts_cells_and_blocks_once_and_orders_by_cells") {
  const Segmentation s = planes_with({kOut, kOut, kOut});
  HoleSurvey hole;
  add_patch(hole, 1, 0, 0, 3, 3, -0.2, 5);   // many points in few cells
  add_patch(hole, 2, 0.8, 0.8, 8, 4, -0.1);  // two blocks of 4 x 4 cells
  add_patch(hole, 3, 2, 2, 3, 3, 0.1);
  Task task;
  const HoleContent content = content_of(hole, kMap, s, kOut, 9, task);
  REQUIRE(content.parallel.size() == 3);
  const HoleFiller &first = content.parallel[0], &second = content.parallel[1];
  CHECK(first.label == 2);
  CHECK(first.cells == 32);
  CHECK(first.blocks.size() == 2);
  CHECK(std::is_sorted(first.blocks.begin(), first.blocks.end()));
  CHECK(second.label == 1);  // as many cells as 3: by label
  CHECK(second.cells == 9);
  CHECK(second.points == 45);
  CHECK(second.blocks.size() == 1);
}

TEST_CASE("hole_content__a_fillers_depth_is_its_median_whatever_strays") {
  const Segmentation s = planes_with({kOut});
  HoleSurvey hole;
  add_patch(hole, 1, 0, 1, 10, 20, -0.25);
  hole.points.push_back({0, 1, 0.5f, 0.2f, -0.9f});
  hole.points.push_back({0, 1, 0.5f, 1.5f, -0.9f});
  Task task;
  const HoleContent content = content_of(hole, kMap, s, kOut, 9, task);
  REQUIRE(content.parallel.size() == 1);
  CHECK(content.parallel[0].depth_m == doctest::Approx(0.25));
  CHECK(content_of({}, kMap, s, kOut, 9, task).parallel.empty());
}
