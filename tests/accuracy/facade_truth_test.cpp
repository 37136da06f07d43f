// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The measures of facade_truth.h on results made up for them.
#include "facade_truth.h"

#include <doctest/doctest.h>

namespace jalon::facade_truth_test {

using namespace jalon::test;

namespace {

TruthContour rectangle(double u0, double u1, double v0, double v1) {
  return {{{u0, v0}}, {{u1, v0}}, {{u1, v1}}, {{u0, v1}}};
}

TruthOpening true_opening(TruthContour contour, OpeningClass opening_class) {
  TruthOpening o;
  o.opening_class = opening_class;
  o.contour = std::move(contour);
  o.outline_seen_share = o.area_seen_share = 1;
  o.spacing_m = 0.02;
  o.width_spacings = 50;
  return o;
}

/// A wall of 10 x 5 m, wholly seen, with a window, an arched door on the ground and a small vent.
FacadeTruth made_up_truth() {
  FacadeTruth truth;
  TruthWall wall;
  wall.along = {1, 0, 0}, wall.up = {0, 0, 1}, wall.normal = {0, -1, 0};
  TruthContour door = rectangle(5, 6, 0, 2);
  door[2].sagitta_m = 0.5;
  wall.outline = {{{0, 0}}, {{5, 0}},  {{5, 2}, -0.5}, {{6, 2}},
                  {{6, 0}}, {{10, 0}}, {{10, 5}},      {{0, 5}}};
  wall.raster.cell_m = 0.1;
  wall.raster.columns = 100, wall.raster.rows = 50;
  wall.raster.cells.assign(5000, Sight::kSeen);
  truth.walls.push_back(wall);
  truth.openings = {true_opening(rectangle(1, 2, 1, 2.5), OpeningClass::kWindow),
                    true_opening(door, OpeningClass::kDoor),
                    true_opening(rectangle(8, 8.2, 0.2, 0.4), OpeningClass::kVent)};
  truth.openings[1].touches_ground = truth.openings[1].touches_border = true;
  truth.openings[2].width_spacings = 4;
  return truth;
}

FoundOpening found_opening(const TruthContour& contour, const char* part_class, double out_m = 0) {
  return {part_class, drawn(contour), out_m};
}

/// What a perfect model has.
FoundFacade perfect(const FacadeTruth& truth) {
  FoundFacade out;
  for (const TruthOpening& o : truth.openings)
    out.openings.push_back(found_opening(o.contour, name_of(o.opening_class)));
  Shape shape = drawn(truth.walls[0].outline).region[0];
  for (const size_t i : {0, 2}) shape.rings.push_back(out.openings[i].drawn.region[0].rings[0]);
  out.walls.push_back({shape, 0});
  return out;
}

}  // namespace

TEST_CASE("facade_truth__a_perfect_model_has_perfect_figures") {
  const FacadeTruth truth = made_up_truth();
  const FacadeFigures f = compare_facade(perfect(truth), truth);
  CHECK(f.wanted == 2);  // the vent is less than five spacings wide
  CHECK(f.found == 2);
  CHECK(f.judged == 2);
  CHECK(f.right == 2);
  CHECK(f.median_iou() > 0.9999);
  CHECK(f.certain == 2);
  CHECK(f.class_right == 2);
  CHECK(f.wall_m2 == doctest::Approx(50 - 1.5 - 2 - 0.3927 - 0.04).epsilon(1e-3));
  CHECK(f.invented_m2 == 0);
  CHECK(f.lost_m2 == 0);
  // Four of the window; of the door none: it stands on the ground and its arc goes on from its sides.
  CHECK(f.corners == 4);
  CHECK(f.paired == 4);
  CHECK(f.corner_rms() < 1e-9);
  CHECK(f.straight == 1);
  CHECK(f.false_arcs == 0);
  CHECK(f.notes.empty());
}

TEST_CASE("facade_truth__missed_displaced_and_invented_openings_count") {
  const FacadeTruth truth = made_up_truth();
  FoundFacade found = perfect(truth);
  // 1. The window moved by 2 cm both ways: one spacing and root two of it.
  found.openings[0] = found_opening(rectangle(1.02, 2.02, 1.02, 2.52), "door");
  FacadeFigures f = compare_facade(found, truth);
  CHECK(f.found == 2);
  CHECK(f.class_right == 1);
  CHECK(f.corner_rms() == doctest::Approx(std::sqrt(2.0)));
  // 2. By half its width: IoU 1/3, missed and wrong.
  found.openings[0] = found_opening(rectangle(1.5, 2.5, 1, 2.5), "window");
  f = compare_facade(found, truth);
  CHECK(f.recall() == doctest::Approx(0.5));
  CHECK(f.precision() == doctest::Approx(0.5));
  CHECK(f.notes.find("missed window") != std::string::npos);
  // 3. Of another wall's plane: neither.
  found.openings[0] = found_opening(truth.openings[0].contour, "window", 1);
  f = compare_facade(found, truth);
  CHECK(f.found == 1);
  CHECK(f.right == 1);
  // 4. One too many, without a class; an opening that nobody wanted is no mistake.
  found = perfect(truth);
  found.openings.push_back(found_opening(rectangle(3, 4, 1, 2), "opening"));
  f = compare_facade(found, truth);
  CHECK(f.judged == 3);
  CHECK(f.right == 2);
  CHECK(f.certain == 2);
}

TEST_CASE("facade_truth__two_halves_of_an_opening_do_not_count_as_found_twice") {
  const FacadeTruth truth = made_up_truth();
  FoundFacade found = perfect(truth);
  found.openings[0] = found_opening(rectangle(1, 1.8, 1, 2.5), "window");
  found.openings.push_back(found_opening(rectangle(1.8, 2, 1, 2.5), "window"));
  found.openings.push_back(found_opening(rectangle(1, 2, 1, 2.4), "window"));
  const FacadeFigures f = compare_facade(found, truth);
  CHECK(f.found == 2);
  CHECK(f.judged == 4);
  CHECK(f.right == 2);
  CHECK(*std::min_element(f.ious.begin(), f.ious.end()) ==
        doctest::Approx(14.0 / 15).epsilon(0.01).scale(0));
}

TEST_CASE("facade_truth__walls_invented_and_lost_are_areas") {
  FacadeTruth truth = made_up_truth();
  FoundFacade found = perfect(truth);
  // 1. The window is filled: 1.5 m2 invented. The vent is filled too, but may be.
  found.walls[0].shape.rings.resize(1);
  FacadeFigures f = compare_facade(found, truth);
  CHECK(f.invented_m2 == doctest::Approx(1.5).epsilon(0.01));
  CHECK(f.lost_m2 == 0);
  // 2. A metre is missing at the right, half of it unseen.
  for (size_t c = 0; c < 5000; ++c)
    if (c % 100 >= 90 && c / 100 < 25) truth.walls[0].raster.cells[c] = Sight::kHidden;
  found = perfect(truth);
  for (Vec2& p : found.walls[0].shape.rings[0]) p.u = std::min(p.u, 9.0);
  f = compare_facade(found, truth);
  CHECK(f.lost_m2 == doctest::Approx(2.5).epsilon(0.01));
  CHECK(f.wall_seen_m2 == doctest::Approx(f.wall_m2 - 2.5).epsilon(0.01).scale(0));
  CHECK(f.invented_m2 == 0);
  // 3. A face 20 cm before the wall is none of it; what covers the wall is neither.
  found = perfect(truth);
  found.walls[0].out_m = 0.2;
  f = compare_facade(found, truth);
  CHECK(f.lost_share() == doctest::Approx(1));
  CHECK(f.invented_share() == doctest::Approx(1).epsilon(0.01));
  found.walls[0].out_m = -2;
  f = compare_facade(found, truth);
  CHECK(f.invented_m2 == 0);
  CHECK(f.elsewhere_share() == doctest::Approx(1).epsilon(0.01));
  found.walls[0].out_m = 0.2;
  truth.walls[0].covers.push_back({rectangle(0, 10, 0, 5), {rectangle(3, 4, 3, 4)}});
  f = compare_facade(found, truth);
  CHECK(f.wall_m2 == doctest::Approx(1).epsilon(0.01));
  CHECK(f.invented_m2 == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("facade_truth__arcs_of_straight_openings_are_false") {
  const FacadeTruth truth = made_up_truth();
  FoundFacade found = perfect(truth);
  TruthContour bent = truth.openings[0].contour;
  bent[2].sagitta_m = 0.05;
  found.openings[0] = found_opening(bent, "window");
  const FacadeFigures f = compare_facade(found, truth);
  CHECK(f.straight == 1);
  CHECK(f.false_arcs == 1);
}

TEST_CASE("facade_truth__unseen_and_narrow_openings_are_not_wanted") {
  TruthOpening o = true_opening(rectangle(0, 1, 0, 1), OpeningClass::kWindow);
  CHECK(is_wanted(o));
  o.area_seen_share = 0.59;
  CHECK_FALSE(is_wanted(o));
  o.area_seen_share = 1, o.outline_seen_share = 0.59;
  CHECK_FALSE(is_wanted(o));
  o.outline_seen_share = 1, o.width_spacings = 5;
  CHECK_FALSE(is_wanted(o));
}

TEST_CASE("facade_truth__figures_add_up") {
  const FacadeTruth truth = made_up_truth();
  const FacadeFigures one = compare_facade(perfect(truth), truth);
  FacadeFigures sum = one;
  sum += one;
  CHECK(sum.facades == 2);
  CHECK(sum.wanted == 4);
  CHECK(sum.ious.size() == 4);
  CHECK(sum.recall() == 1);
  CHECK(row_of("both", sum).find("both") == 0);
}

TEST_CASE("facade_truth__reads_walls_and_openings_from_a_model") {
  Model model;
  model.parts = {{"facade", "facade", kNoParent},
                 {"wall", "wall", 0},
                 {"window 1", "window", 1},
                 {"door 1", "door", 1},
                 {"leaf", "joinery", 3}};
  const auto face = [&](uint32_t part, double y, std::vector<std::vector<Vec3>> rings) {
    Face f;
    f.part = part;
    f.plane = {{0, -1, 0}, -y};
    model.add_face(f, rings);
  };
  face(
      1, 0,
      {{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}}, {{1, 0, 1}, {1, 0, 2}, {2, 0, 2}, {2, 0, 1}}});
  model.rings[1].part = 2;
  face(4, 0.2, {{{3, 0.2, 0}, {3.8, 0.2, 0}, {3.8, 0.2, 2}, {3, 0.2, 2}}});
  const FoundFacade found = found_facade(model, made_up_truth());
  REQUIRE(found.walls.size() == 1);
  CHECK(found.walls[0].shape.rings.size() == 2);
  REQUIRE(found.openings.size() == 2);
  CHECK(found.openings[0].part_class == "window");
  CHECK(found.openings[1].part_class == "door");
  CHECK(found.openings[1].out_m == doctest::Approx(0));  // of its wall
  CHECK(areas(found.openings[1].drawn.region, found.openings[1].drawn.region, 0.001).a_m2 ==
        doctest::Approx(1.6));
}

}  // namespace jalon::facade_truth_test
