// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Pieces of one wall told from what fills the openings of another in the same plane.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/evidence/pieces_apart.h"
#include "modelling/evidence/plane_roles.h"
#include "modelling/plane/coplanar.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::kStep_m;

namespace {

constexpr double kLeaves_m = 0.22;  // of dormers, and of the leaves of the doors
constexpr double kRelief_m = 0.1;

void set_areas(Segmentation& out, const std::vector<std::vector<Vec3>>& parts) {
  for (size_t s = 0; s < parts.size(); ++s)
    out.segments[s].area_m2 = kStep_m * kStep_m * static_cast<double>(parts[s].size());
}

// Two houses, the second this far behind the first. Each has two windows; those of the second have surrounds, `proud`
// before it, those of the first frames, `deep` behind it.
Segmentation two_houses(double step_m, double proud_m, double deep_m) {
  std::vector<std::vector<Vec3>> parts(2);
  add_layer(parts[0], 0, 0, 6, 6, 0);
  add_layer(parts[1], 6, 0, 6, 6, step_m);
  for (const double u : {1.0, 3.5}) {
    cut(parts[0], u, 2, 1.2, 1.6);
    auto& frame = parts.emplace_back();
    add_layer(frame, u, 2, 1.2, 1.6, deep_m);
    cut(frame, u + 0.1, 2.1, 1.0, 1.4);
  }
  for (const double u : {7.0, 9.5}) {
    cut(parts[1], u - 0.15, 1.85, 1.5, 1.9);
    auto& surround = parts.emplace_back();
    add_layer(surround, u - 0.15, 1.85, 1.5, 1.9, step_m - proud_m);
    cut(surround, u, 2, 1.2, 1.6);
  }
  // Panes, of no segment's plane.
  for (const double u : {1.0, 3.5, 7.0, 9.5}) {
    auto& pane = parts.emplace_back();
    add_layer(pane, u + 0.1, 2.1, 1.0, 1.4, 0.45);
  }
  Segmentation out = walls::segmentation_of(parts);
  set_areas(out, parts);
  return out;
}

// A wall with two doors, their leaves, and two dormers over it in the plane of the leaves.
Segmentation mansard(bool has_dormers) {
  std::vector<Vec3> wall, first, second, left, right;
  add_layer(wall, 0, 0, 8, 6, 0);
  for (const double u : {1.0, 5.0}) {
    cut(wall, u, 0, 1.6, 2.6);
    add_layer(u < 2 ? first : second, u, 0, 1.6, 2.6, kLeaves_m);
  }
  add_layer(left, 1, 6, 1.6, 2.2, kLeaves_m);
  add_layer(right, 5, 6, 1.6, 2.2, kLeaves_m);
  std::vector<std::vector<Vec3>> parts{wall, first, second};
  if (has_dormers) parts.insert(parts.end(), {left, right});
  Segmentation out = walls::segmentation_of(parts);
  set_areas(out, parts);
  return out;
}

// The same wall with two shop fronts under a canopy that hides how their openings end: a panel in each, and a dormer in
// the plane of the panels.
Segmentation canopied() {
  constexpr double kCanopy_m = -1.2;
  std::vector<std::vector<Vec3>> parts(4);
  auto &wall = parts[0], &first = parts[1], &second = parts[2], &dormer = parts[3];
  add_layer(wall, 0, 0, 8, 6, 0);
  cut(wall, 0.5, 1, 7, 2.4);
  for (const double u : {1.0, 4.6}) {
    cut(wall, u, 0, 2.4, 1.2);
    add_layer(u < 2 ? first : second, u + 0.6, 0.1, 1.2, 0.8, kLeaves_m);
  }
  add_layer(dormer, 2, 6, 3, 2.2, kLeaves_m);
  add_layer(parts.emplace_back(), 0.5, 1, 7, 2.4, kCanopy_m);
  Segmentation out = walls::segmentation_of(parts);
  set_areas(out, parts);
  return out;
}

// A half-timbered storey that stands out over the one below as far as its panes stand back: between posts that touch
// the windows, strips of its wall are narrow.
Segmentation jettied() {
  constexpr double kJetty_m = 0.1, kPost_m = 0.2, kProud_m = 0.03;
  std::vector<std::vector<Vec3>> parts(3);
  auto &lower = parts[0], &upper = parts[1], &posts = parts[2];
  add_layer(lower, 0, 0, 6, 2.5, kJetty_m);
  add_layer(upper, 0, 2.5, 6, 2.5, 0);
  for (const double u : {0.0, 1.5, 3.0, 4.5, 5.8}) {
    cut(upper, u, 2.5, kPost_m, 2.5);
    add_layer(posts, u, 2.5, kPost_m, 2.5, -kProud_m);
  }
  for (const double u : {0.3, 1.8, 3.3}) {
    cut(upper, u, 3.4, 1.1, 1);
    add_layer(parts.emplace_back(), u, 3.4, 1.1, 1, kJetty_m);
  }
  Segmentation out = walls::segmentation_of(parts);
  set_areas(out, parts);
  return out;
}

// A wall in two pieces; before the larger one, with or without windows, a narrow band runs all about most of it, in the
// plane of the house farther along, which has large windows. The band is of two cells: what one of 1.2 cells encloses
// is an opening or none by where the cells fall.
Segmentation banded(bool has_windows) {
  constexpr double kProud_m = 0.06, kBand_m = 0.2;
  std::vector<std::vector<Vec3>> parts(3);
  add_layer(parts[0], 0, 0, 4, 8, 0);
  if (has_windows)
    for (const double v : {1.5, 4.5}) cut(parts[0], 1.4, v, 1.2, 1.6);
  add_layer(parts[1], 6, 0, 2, 8, 0);
  add_layer(parts[2], 0.2, 0.2, 3.6, 7.6, -kProud_m);
  cut(parts[2], 0.2 + kBand_m, 0.2 + kBand_m, 3.6 - 2 * kBand_m, 7.6 - 2 * kBand_m);
  add_layer(parts[2], 12, 0, 6, 6, -kProud_m);
  for (const double u : {12.7, 15.3})
    for (const double v : {0.7, 3.3}) cut(parts[2], u, v, 2, 2);
  Segmentation out = walls::segmentation_of(parts);
  set_areas(out, parts);
  return out;
}

// Of each label from 0, for none.
std::vector<size_t> points_by_label(const Segmentation& segmentation) {
  std::vector<size_t> points(segmentation.segments.size() + 1);
  for (const uint32_t label : segmentation.labels->values<uint32_t>()) ++points[label];
  return points;
}

}  // namespace

TEST_CASE("pieces_apart__surrounds_in_the_plane_of_the_house_next_door_stay_with_their_own") {
  const Segmentation given = two_houses(0.06, 0.06, 0.3);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  CHECK(whole[4] == whole[0]);  // on one plane
  CHECK(whole[5] == whole[0]);
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  const std::vector<size_t> points = points_by_label(segmentation);
  CHECK(points[1] == given.segments[0].point_count());
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(evidence[points[5] > 0 ? 4 : 5].role == PlaneRole::kRelief);
}

TEST_CASE("pieces_apart__frames_in_the_plane_of_the_house_next_door_stay_with_their_own") {
  const Segmentation given = two_houses(0.08, 0.05, 0.08);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  CHECK(whole[2] == whole[1]);  // on one plane
  CHECK(whole[3] == whole[1]);
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  const std::vector<size_t> points = points_by_label(segmentation);
  CHECK(points[2] == given.segments[1].point_count());
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
}

TEST_CASE("pieces_apart__leaves_of_doors_leave_the_dormers_in_their_plane") {
  const Segmentation given = mansard(true);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  for (size_t s = 2; s <= 4; ++s) CHECK(whole[s] == whole[1]);  // all on one plane
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  std::vector<size_t> points(5);
  for (const uint32_t label : segmentation.labels->values<uint32_t>()) ++points[label - 1];
  CHECK(points[1] + points[2] == given.segments[1].point_count() + given.segments[2].point_count());
  CHECK(points[3] + points[4] == given.segments[3].point_count() + given.segments[4].point_count());
  for (size_t s = 1; s < 5; ++s) {
    if (points[s] == 0) continue;
    CHECK(evidence[s].role == (s < 3 ? PlaneRole::kFilling : PlaneRole::kWall));
  }
  CHECK(evidence[0].role == PlaneRole::kWall);
}

TEST_CASE("pieces_apart__leaves_that_are_one_segment_with_the_dormers_in_their_plane_leave_it") {
  const Segmentation four = mansard(true);
  // One segment of leaves and dormers.
  std::vector<std::vector<Vec3>> parts(2);
  const auto labels = four.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i) parts[labels[i] > 1].push_back(four.cloud->point(i));
  Segmentation given = walls::segmentation_of(parts);
  set_areas(given, parts);
  Segmentation segmentation = given;
  Task task;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  REQUIRE(segmentation.segments.size() == 3);
  REQUIRE(evidence.size() == 3);
  const std::vector<size_t> points = points_by_label(segmentation);
  CHECK(points[2] == four.segments[3].point_count() + four.segments[4].point_count());
  CHECK(points[3] == four.segments[1].point_count() + four.segments[2].point_count());
  for (size_t s = 0; s < 3; ++s) CHECK(segmentation.segments[s].point_count() == points[s + 1]);
  CHECK(segmentation.segments[1].area_m2 + segmentation.segments[2].area_m2 ==
        doctest::Approx(given.segments[1].area_m2));
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(evidence[2].role == PlaneRole::kFilling);
  CHECK(given.labels->values<uint32_t>()[0] == 1);  // as it was
  // The wall alone is not parted.
  Segmentation alone = walls::segmentation_of({parts[0]});
  set_areas(alone, {parts[0]});
  CHECK(gather_whole_walls(alone, 0.03, {}, task).size() == 1);
}

TEST_CASE("pieces_apart__leaves_leave_the_dormers_in_their_plane_whichever_way_that_looks") {
  Segmentation given = mansard(true);
  for (size_t s = 1; s < 5; ++s) {
    Plane& plane = given.segments[s].fit.plane;
    plane = {plane.normal * -1.0, -plane.offset};
  }
  Task task;
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  std::vector<size_t> points(5);
  for (const uint32_t label : segmentation.labels->values<uint32_t>()) ++points[label - 1];
  CHECK(points[1] + points[2] == given.segments[1].point_count() + given.segments[2].point_count());
  CHECK(points[3] + points[4] == given.segments[3].point_count() + given.segments[4].point_count());
  CHECK(evidence[points[1] > 0 ? 1 : 2].role == PlaneRole::kFilling);
}

TEST_CASE("pieces_apart__what_measured_wall_encloses_leaves_the_dormer_in_its_plane") {
  const Segmentation given = canopied();
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  CHECK(whole[1] == whole[3]);  // all on one plane
  CHECK(whole[2] == whole[3]);
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  // Each alone, as each may lie in an opening of its own.
  for (size_t s = 1; s <= 3; ++s)
    CHECK(segmentation.segments[s].point_count() == given.segments[s].point_count());
  CHECK(evidence[3].role == PlaneRole::kWall);
}

TEST_CASE("pieces_apart__leaves_alone_stay_together") {
  const Segmentation given = mansard(false);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  const Segmentation joined = joined_pieces(given, whole, task);
  const auto evidence = gather_evidence(joined, {}, task);
  CHECK(pieces_apart(given, whole, evidence, kRelief_m, task) == whole);
}

TEST_CASE("pieces_apart__panes_between_posts_leave_the_storey_below_in_their_plane") {
  const Segmentation given = jettied();
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  for (size_t s = 3; s < 6; ++s) CHECK(whole[s] == whole[0]);  // all on one plane
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  const std::vector<size_t> points = points_by_label(segmentation);
  CHECK(points[1] == given.segments[0].point_count());
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
  for (size_t s = 3; s < 6; ++s)
    if (points[s + 1] > 0) CHECK(evidence[s].role == PlaneRole::kFilling);
}

TEST_CASE("pieces_apart__within_a_band_a_wall_with_windows_is_no_pane_of_it_as_one_without_is") {
  for (const bool has_windows : {false, true}) {
    const Segmentation given = banded(has_windows);
    Task task;
    const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
    CHECK(whole[1] == whole[0]);
    auto evidence = gather_evidence(joined_pieces(given, whole, task), {}, task);
    CHECK(explained_m2(evidence[2]) > explained_m2(evidence[0]) / 2);
    // What the band runs about passes for an opening, as where more of it was seen through.
    const auto within = std::ranges::max_element(evidence[2].openings, {}, [](const auto& o) {
      return o.shape.box().width() * o.shape.box().height();
    });
    within->is_opening = true;
    const bool is_apart = pieces_apart(given, whole, evidence, kRelief_m, task) != whole;
    CHECK(is_apart == !has_windows);
  }
}
