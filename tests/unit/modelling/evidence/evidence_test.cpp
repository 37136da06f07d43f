// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What planes before and behind a wall are to it.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>

#include "modelling/contour/contour.h"
#include "modelling/evidence/evidence.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::evidence_of;
using layers::in_box;

namespace {

constexpr double kWindows[] = {1, 3, 5};  // 1.2 x 1.6 m, 1 m above the ground

// A wall of 12 x 7 m with three windows and a loggia of 3 x 2.6 m.
struct House {
  std::vector<Vec3> wall, panes, surrounds, room, parapets, loggia;
  House() {
    add_layer(wall, 0, 0, 12, 7, 0);
    add_layer(loggia, 8, 3.5, 3, 2.6, 1.5);
    for (const double left : kWindows) {
      add_layer(panes, left, 1, 1.2, 1.6, 0.15);
      add_layer(surrounds, left - 0.3, 0.7, 1.8, 2.2, -0.05);
      add_layer(parapets, left - 0.3, 4, 1.8, 1, -1.2);
    }
    add_layer(room, 0.5, 0.3, 6.5, 2.8, 4);
    const auto cut = [](std::vector<Vec3>& points) {
      std::erase_if(points, [](const Vec3& p) {
        for (const double left : kWindows)
          if (in_box(p, left, 1, 1.2, 1.6)) return true;
        return in_box(p, 8, 3.5, 3, 2.6);
      });
    };
    cut(wall);
    cut(surrounds);
  }
};

}  // namespace

TEST_CASE("gather_evidence__tells_panes_surrounds_rooms_parapets_and_a_loggia") {
  const House house;
  const auto role = [&](const std::vector<Vec3>& other, bool has_panes = true) {
    std::vector<std::vector<Vec3>> parts{house.wall, other};
    if (has_panes) parts.push_back(house.panes);
    const auto evidence = evidence_of(parts);
    CHECK(evidence[0].role == PlaneRole::kWall);
    return evidence[1].role;
  };
  CHECK(role(house.panes, false) == PlaneRole::kFilling);
  CHECK(role(house.surrounds) == PlaneRole::kRelief);
  CHECK(role(house.room) == PlaneRole::kInside);
  CHECK(role(house.parapets) == PlaneRole::kRelief);
  CHECK(role(house.loggia) == PlaneRole::kWall);
}

TEST_CASE("gather_evidence__finds_the_openings_of_a_wall_and_its_areas") {
  const House house;
  const auto evidence = evidence_of({house.wall, house.panes, house.loggia});
  size_t openings = 0;
  for (const OpeningCandidate& c : evidence[0].openings) openings += c.is_opening;
  CHECK(openings == 4);
  CHECK(evidence[0].is_wall());
  CHECK(evidence[0].gross_m2 == doctest::Approx(12 * 7).epsilon(0.05).scale(0));
  CHECK(evidence[0].measured_m2 ==
        doctest::Approx(12 * 7 - 3 * 1.2 * 1.6 - 3 * 2.6).epsilon(0.05).scale(0));
}

TEST_CASE("gather_evidence__leaves_floors_and_small_planes_and_has_the_same_bits_for_any_threads") {
  const House house;
  std::vector<Vec3> floor, small;
  for (const Vec3& p : house.wall) floor.push_back({p.x, p.z, 0});
  add_layer(small, 0, 0, 0.9, 1, -3);
  const std::vector<std::vector<Vec3>> parts{house.wall, floor, small, house.panes};
  const auto one = evidence_of(parts, 1), four = evidence_of(parts, 4);
  CHECK(one[1].empty());
  CHECK(one[2].empty());
  CHECK_FALSE(one[2].is_wall());
  for (size_t s = 0; s < parts.size(); ++s) {
    CHECK(one[s].cells.states == four[s].cells.states);
    CHECK(one[s].role == four[s].role);
    REQUIRE(one[s].openings.size() == four[s].openings.size());
    for (size_t k = 0; k < one[s].openings.size(); ++k)
      CHECK(one[s].openings[k].shape.sizes == four[s].openings[k].shape.sizes);
  }
}

namespace {

// The contour of the first of these parts, by its evidence and by its points alone.
struct BothContours {
  std::vector<WallEvidence> evidence;
  Contour drawn, plain;

  explicit BothContours(const std::vector<std::vector<Vec3>>& parts)
      : evidence(evidence_of(parts)) {
    std::vector<Vec2> points;
    for (const Vec3& p : parts[0]) points.push_back(evidence[0].cells.frame.project(p));
    Task task;
    drawn = contours_by(evidence)(0, points, {}, {}, task);
    plain = extract_contour(points, {}, task, {});
  }
};

}  // namespace

TEST_CASE("end_behind_walls__a_house_is_no_relief_of_the_one_next_door_whatever_strays_behind_it") {
  // Two houses 6 m high, the second a finger's breadth behind the first, and a strip of its plane that strays along the
  // far end of that.
  constexpr double kBehind_m = 0.029;
  std::vector<Vec3> first, second, panes;
  add_layer(first, -4, 0, 10, 6, 0);
  add_layer(second, 6, 0, 6, 6, kBehind_m);
  for (const double left : {1.0, 3.5, 7.0, 9.5}) {
    layers::cut(left < 6 ? first : second, left, 2, 1.2, 1.6);
    add_layer(panes, left, 2, 1.2, 1.6, 0.25);
  }
  add_layer(second, -4.2, 0, 0.15, 6, kBehind_m);
  auto evidence = evidence_of({first, second, panes});
  const auto beside = [&](const WallEvidence& wall) {
    return std::count_if(wall.openings.begin(), wall.openings.end(), [&](const auto& opening) {
      return opening.is_opening && wall.cells.frame.lift(opening.shape.box().middle()).x < 6;
    });
  };
  const auto relief = [](const WallEvidence& wall) {
    const auto& states = wall.cells.states;
    return std::count(states.begin(), states.end(), WallState::kRelief);
  };
  REQUIRE(evidence[0].is_wall());
  REQUIRE(evidence[1].is_wall());
  CHECK(relief(evidence[1]) > 0);
  // A window of the first is seen through the second's plane, too, which does not frame it there.
  const auto own = std::find_if(evidence[0].openings.begin(), evidence[0].openings.end(),
                                [](const auto& opening) { return opening.is_opening; });
  REQUIRE(own != evidence[0].openings.end());
  const Vec2 there =
      evidence[1].cells.frame.project(evidence[0].cells.frame.lift(own->shape.box().middle()));
  OpeningCandidate ghost = *own;
  ghost.shape = own->shape.placed(1, there - own->shape.box().middle());
  ghost.framed = ghost.jambs = 0;
  evidence[1].openings.push_back(ghost);
  CHECK(beside(evidence[1]) == 1);
  Task task;
  end_behind_walls(evidence, CellSetting{}.relief_m, task);
  CHECK(beside(evidence[0]) == 2);
  CHECK(beside(evidence[1]) == 0);
  CHECK(relief(evidence[1]) == 0);
}

TEST_CASE("end_behind_walls__large_panels_stay_relief_of_the_wall_about_them") {
  std::vector<Vec3> wall, panels, panes;
  add_layer(wall, 0, 0, 12, 6, 0);
  for (const double left : {0.6, 4.4, 8.2}) {
    layers::cut(wall, left, 0.6, 3.2, 4.8);
    add_layer(panels, left, 0.6, 3.2, 4.8, -0.04);
    for (const double u : {left + 0.3, left + 1.7}) {
      layers::cut(panels, u, 2, 1.2, 1.6);
      add_layer(panes, u, 2, 1.2, 1.6, 0.25);
    }
  }
  auto evidence = evidence_of({wall, panels, panes});
  REQUIRE(evidence[0].is_wall());
  REQUIRE(evidence[1].is_wall());
  const std::vector<WallState> before = evidence[0].cells.states;
  CHECK(std::count(before.begin(), before.end(), WallState::kRelief) > 0);
  Task task;
  end_behind_walls(evidence, CellSetting{}.relief_m, task);
  CHECK(evidence[0].cells.states == before);
}

TEST_CASE("contours_by__draws_a_wall_by_its_points_where_these_show_its_openings_and_no_others") {
  House house;
  std::erase_if(house.wall, [](const Vec3& p) { return p.x > 7.5; });
  const BothContours both({house.wall, house.panes});
  CHECK(both.evidence[0].is_plain);
  CHECK_FALSE(both.evidence[0].is_drawn());
  REQUIRE(both.drawn.pieces.size() == 1);
  CHECK(both.drawn.pieces[0].outline == both.plain.pieces[0].outline);
  CHECK(both.drawn.pieces[0].openings == both.plain.pieces[0].openings);
  CHECK(both.drawn.pieces[0].openings.size() == 3);
}

TEST_CASE("contours_by__draws_a_wall_by_its_evidence_where_its_points_have_a_hole_that_is_none") {
  House house;
  std::erase_if(house.wall, [](const Vec3& p) { return p.x > 7.5 || in_box(p, 2.5, 4, 2.5, 1.2); });
  std::vector<Vec3> lorry;
  add_layer(lorry, 2.3, 3.5, 2.9, 1.9, -1.5);
  const BothContours both({house.wall, house.panes, lorry});
  CHECK(both.evidence[0].is_wall());
  CHECK_FALSE(both.evidence[0].is_plain);
  REQUIRE(both.plain.pieces.size() == 1);
  CHECK(both.plain.pieces[0].openings.size() == 4);
}

TEST_CASE("contours_by__pieces_of_a_wall_that_go_round_surrounds_do_not_show_its_openings") {
  // Cut by a string course and by surrounds that touch it: the points' contour has no hole at all.
  House house;
  std::erase_if(house.wall, [](const Vec3& p) { return p.x > 7.5; });
  std::vector<Vec3> relief;
  add_layer(relief, 0, 2.85, 7.5, 0.2, -0.05);
  add_layer(relief, 0, 0.4, 7.5, 0.4, -0.05);
  for (const double left : kWindows) {
    add_layer(relief, left - 0.25, 0.8, 0.25, 2.05, -0.05);
    add_layer(relief, left + 1.2, 0.8, 0.25, 2.05, -0.05);
  }
  std::erase_if(house.wall, [](const Vec3& p) {
    return (p.z > 2.85 && p.z < 3.05) || (p.z > 0.4 && p.z < 0.8) ||
           std::any_of(std::begin(kWindows), std::end(kWindows),
                       [&](double left) { return in_box(p, left - 0.25, 0.4, 1.7, 2.65); });
  });
  const BothContours both({house.wall, relief, house.panes});
  CHECK(both.evidence[0].has_framed_openings());
  CHECK_FALSE(both.evidence[0].is_plain);
  for (const ContourPiece& piece : both.plain.pieces) CHECK(piece.openings.empty());
  size_t openings = 0;
  for (const ContourPiece& piece : both.drawn.pieces) openings += piece.openings.size();
  CHECK(openings == 3);
}

TEST_CASE(
    "contours_by__the_place_of_a_house_that_stands_forward_is_not_drawn_as_the_walls_beside_it") {
  // A row of houses, 8 cm back, beside one with windows; a lorry before the row, so that its points do not show it.
  constexpr double kHouse_m = 6, kForward_m = 0.08;
  std::vector<Vec3> row, forward, lorry;
  for (const double left : {0.0, 2 * kHouse_m}) add_layer(row, left, 0, kHouse_m, 6, kForward_m);
  add_layer(forward, kHouse_m, 0, kHouse_m, 6, 0);
  add_layer(lorry, 1, 2, 2.9, 1.9, -1.5);
  const auto cut = [](std::vector<Vec3>& points, double left, double foot, double width,
                      double height) {
    std::erase_if(points, [&](const Vec3& p) { return in_box(p, left, foot, width, height); });
  };
  cut(row, 1.2, 2.2, 2.5, 1.2);
  for (const double window : {1.0, 3.5}) {
    cut(row, 2 * kHouse_m + window, 1, 1.2, 1.6);
    cut(forward, kHouse_m + window, 1, 1.2, 1.6);
  }
  const BothContours both({row, forward, lorry});
  CHECK(both.evidence[0].is_drawn());
  CHECK(both.evidence[1].is_wall());
  double area_m2 = 0;
  for (const ContourPiece& piece : both.drawn.pieces) area_m2 += piece.area_m2;
  CHECK(area_m2 < 2 * kHouse_m * 6 + 1);
}
