// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Parts of sets of cells, and openings in walls painted by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "base/random.h"
#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/find_openings.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

using OpeningList = std::vector<OpeningCandidate>;

// A wall of 12 x 6 m in cells of 5 cm, its lower left corner at (100, 20).
struct PaintedWall {
  WallCells cells = painted::cells_of(240, 120);
  PaintedWall() { cells.origin = {100, 20}; }

  // In metres from its corner; share: of the cells that have this state, the others are empty.
  PaintedWall& with(double left, double foot, double width, double height, WallState state,
                    double share = 1) {
    RandomStream random(17, static_cast<uint64_t>(left * 100 + foot));
    const auto line = [](double at) { return static_cast<uint32_t>(std::lround(at * 20)); };
    for (uint32_t r = line(foot); r < line(foot + height); ++r)
      for (uint32_t c = line(left); c < line(left + width); ++c)
        cells.states[size_t{r} * cells.columns + c] =
            random.uniform() < share ? state : WallState::kEmpty;
    return *this;
  }
  OpeningList candidates() const {
    Task task;
    return find_openings(cells, {}, task);
  }
  OpeningList openings() const {
    OpeningList out = candidates();
    std::erase_if(out, [](const OpeningCandidate& c) { return !c.is_opening; });
    return out;
  }
};

void check_box(const OpeningCandidate& candidate, double left, double foot, double width,
               double height) {
  const RingBox box = candidate.shape.box();
  CHECK(norm(box.low - Vec2{100 + left, 20 + foot}) < 0.05);
  CHECK(norm(box.high - Vec2{100 + left + width, 20 + foot + height}) < 0.05);
}

}  // namespace

TEST_CASE("cell_regions__are_joined_by_sides_and_neither_by_corners_nor_round_the_end_of_a_row") {
  // Columns 0 to 4:   . . . . #
  //                   # # . # .
  //                   . # . # #
  const std::vector<uint32_t> cells{1, 3, 4, 5, 6, 8, 14};
  CellRegions regions(5, 3);
  auto parts = regions.of(cells);
  REQUIRE(parts.size() == 3);
  for (auto& part : parts) std::sort(part.begin(), part.end());
  CHECK(parts[0] == std::vector<uint32_t>{1, 5, 6});
  CHECK(parts[1] == std::vector<uint32_t>{3, 4, 8});
  CHECK(parts[2] == std::vector<uint32_t>{14});
  CHECK(regions.of(std::vector<uint32_t>{6}).size() == 1);  // it forgets the ones before
  CHECK(regions.of({}).empty());
}

TEST_CASE("state_counts__share_is_of_all_cells_and_none_of_none") {
  StateCounts counts;
  CHECK(counts.all() == 0);
  CHECK(counts.share(WallState::kOn) == 0);
  counts.cells[static_cast<size_t>(WallState::kThrough)] = 3;
  counts.cells[static_cast<size_t>(WallState::kEmpty)] = 9;
  CHECK(counts.all() == 12);
  CHECK(counts.share(WallState::kThrough) == 0.25);
}

TEST_CASE("find_openings__windows_and_a_door_at_the_foot_from_left_to_right") {
  const OpeningList found = PaintedWall()
                                .with(8, 1, 1.2, 1.6, WallState::kThrough, 0.3)
                                .with(1, 1, 1.2, 1.6, WallState::kThrough, 0.3)
                                .with(4, 0, 1, 2.2, WallState::kThrough, 0.5)
                                .with(1, 4, 1.2, 1.2, WallState::kThrough)
                                .candidates();
  REQUIRE(found.size() == 4);
  CHECK(std::all_of(found.begin(), found.end(), [](const auto& c) { return c.is_opening; }));
  CHECK(std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.shape.box().low.u < b.shape.box().low.u;
  }));
  check_box(found[2], 4, 0, 1, 2.2);
  check_box(found[3], 8, 1, 1.2, 1.6);
  CHECK(found[3].bordered == doctest::Approx(1));
  CHECK(found[3].relief == 0);
  CHECK(found[3].inside.share(WallState::kThrough) == doctest::Approx(0.3).epsilon(0.15).scale(0));
}

TEST_CASE("find_openings__in_a_wall_without_gaps_there_are_none") {
  CHECK(PaintedWall().candidates().empty());
  Task task;
  CHECK(find_openings({}, {}, task).empty());
}

TEST_CASE("find_openings__an_empty_place_that_wall_surrounds_is_one_and_an_empty_band_is_not") {
  const PaintedWall wall = PaintedWall()
                               .with(2, 2, 1, 1.2, WallState::kEmpty)
                               .with(5, 3, 5, 0.5, WallState::kEmpty);  // a gutter's shadow
  const OpeningList found = wall.openings();
  REQUIRE(found.size() == 1);
  check_box(found[0], 2, 2, 1, 1.2);
  CHECK(wall.candidates().size() == 2);
}

TEST_CASE("find_openings__a_gateway_without_a_point_is_not_known_and_one_that_is_deep_is") {
  CHECK(PaintedWall().with(4, 0, 3, 3, WallState::kEmpty).openings().empty());
  CHECK(PaintedWall().with(4, 0, 3, 3, WallState::kHidden).openings().empty());
  const OpeningList found = PaintedWall().with(4, 0, 3, 3, WallState::kDeep, 0.5).openings();
  REQUIRE(found.size() == 1);
  check_box(found[0], 4, 0, 3, 3);
}

TEST_CASE("find_openings__what_lies_deep_behind_a_strip_was_seen_beside_it") {
  // Over a balcony along the wall, and over a canopy: rooms were seen from below, past what hides the wall.
  CHECK(PaintedWall().with(0, 3, 12, 0.5, WallState::kDeep).openings().empty());
  CHECK(PaintedWall().with(3, 3, 4, 0.5, WallState::kDeep).openings().empty());
  // Beside a pier of which only the upper half was seen.
  CHECK(PaintedWall()
            .with(4, 0, 0.6, 5, WallState::kDeep)
            .with(1, 0, 3, 2.5, WallState::kHidden)
            .openings()
            .empty());
  // A loggia is as deep, and is no strip.
  const OpeningList found = PaintedWall().with(4, 2, 2.4, 2.4, WallState::kDeep).openings();
  REQUIRE(found.size() == 1);
  check_box(found[0], 4, 2, 2.4, 2.4);
}

TEST_CASE("find_openings__an_empty_place_at_the_side_of_a_wall_is_where_that_ends") {
  PaintedWall wall;
  wall.with(11, 3, 1, 1.5, WallState::kEmpty);
  CHECK(wall.openings().empty());
  // Seen through it is one, and so is an empty one within the wall, beside a pier of 15 cm.
  wall.with(11, 3, 1, 1.5, WallState::kThrough);
  CHECK(wall.openings().size() == 1);
  PaintedWall pier;
  pier.with(10.85, 3, 1, 1.5, WallState::kEmpty);
  CHECK(pier.openings().size() == 1);
}

TEST_CASE("find_openings__what_wall_does_not_surround_needs_to_be_seen_through") {
  // Empty, with something before the wall to its left.
  CHECK(PaintedWall()
            .with(2, 2, 1, 1.2, WallState::kEmpty)
            .with(1.2, 2, 0.8, 1.2, WallState::kHidden)
            .openings()
            .empty());
  CHECK(PaintedWall()
            .with(2, 2, 1, 1.2, WallState::kThrough, 0.3)
            .with(1.2, 2, 0.8, 1.2, WallState::kHidden)
            .openings()
            .size() == 1);
}

TEST_CASE("find_openings__what_was_seen_through_one_corner_only_is_not_an_opening") {
  // A neighbour's floor behind a gateway: all of it in the lowest fifth.
  CHECK(PaintedWall()
            .with(4, 0, 3, 3, WallState::kEmpty)
            .with(4, 0, 3, 0.6, WallState::kThrough)
            .openings()
            .empty());
  // And stray points all over it.
  PaintedWall wall;
  wall.with(4, 0, 3, 3, WallState::kEmpty).with(4, 0, 3, 0.6, WallState::kThrough);
  for (uint32_t r = 5; r < 60; r += 12)
    for (uint32_t c = 85; c < 140; c += 12)
      wall.cells.states[size_t{r} * wall.cells.columns + c] = WallState::kThrough;
  CHECK(wall.openings().empty());
}

TEST_CASE("find_openings__a_window_over_a_hidden_band_is_found_although_the_band_is_larger") {
  // A parapet hides the wall over all its width, and the foot of the window with it.
  const OpeningList found = PaintedWall()
                                .with(2, 1, 8, 2, WallState::kEmpty)
                                .with(5, 1, 1.2, 2, WallState::kEmpty)
                                .with(5, 3, 1.2, 0.9, WallState::kThrough, 0.5)
                                .openings();
  REQUIRE(found.size() == 1);
  CHECK(found[0].shape.box().low.u == doctest::Approx(105).epsilon(0.001));
  CHECK(found[0].shape.box().high.v == doctest::Approx(23.9).epsilon(0.003));
}

TEST_CASE("find_openings__a_window_of_two_lights_is_one_and_windows_at_a_pier_are_two") {
  const auto two = [](double bar_m) {
    return PaintedWall()
        .with(3, 1, 0.6, 1.4, WallState::kThrough, 0.4)
        .with(3.6 + bar_m, 1, 0.6, 1.4, WallState::kThrough, 0.4)
        .openings();
  };
  const OpeningList lights = two(0.1);
  REQUIRE(lights.size() == 1);
  check_box(lights[0], 3, 1, 1.3, 1.4);
  CHECK(two(0.5).size() == 2);
}

TEST_CASE("find_openings__broad_windows_at_a_pier_that_is_hardly_seen_are_two") {
  const auto two = [](double light_m) {
    return PaintedWall()
        .with(1, 1, light_m, 1.4, WallState::kThrough, 0.4)
        .with(1.1 + light_m, 1, light_m, 1.4, WallState::kThrough, 0.4)
        .openings();
  };
  const OpeningList windows = two(4);
  REQUIRE(windows.size() == 2);
  check_box(windows[0], 1, 1, 4, 1.4);
  check_box(windows[1], 5.1, 1, 4, 1.4);
  CHECK(two(0.8).size() == 1);
}

TEST_CASE("find_openings__what_something_hides_is_none_though_more_was_seen_past_it") {
  // A buttress, and what marks of cells make of it: hidden; without it a gateway.
  CHECK(PaintedWall().with(4, 0, 0.6, 5, WallState::kHidden).openings().empty());
  CHECK(PaintedWall().with(4, 0, 0.6, 5, WallState::kDeep).openings().size() == 1);
}

TEST_CASE("find_openings__a_parapet_before_a_window_says_nothing_of_what_is_seen_over_it") {
  // A window over a broader parapet, seen through in a third of what that leaves of it.
  PaintedWall wall;
  wall.with(3.5, 1.8, 2.5, 1.2, WallState::kHidden).with(4, 3, 1.5, 1.4, WallState::kEmpty);
  wall.with(4, 3.45, 1.5, 0.35, WallState::kThrough, 0.5);
  const OpeningList windows = wall.openings();
  REQUIRE(windows.size() == 1);
  CHECK(norm(windows[0].shape.box().high - Vec2{105.5, 24.4}) < 0.05);
}

TEST_CASE("find_openings__relief_about_an_opening_is_told") {
  const OpeningList found = PaintedWall()
                                .with(2.85, 0.85, 1.3, 1.7, WallState::kRelief)
                                .with(3, 1, 1, 1.4, WallState::kThrough, 0.4)
                                .openings();
  REQUIRE(found.size() == 1);
  check_box(found[0], 3, 1, 1, 1.4);
  CHECK(found[0].relief == doctest::Approx(1));
}

TEST_CASE("find_openings__shapes_lie_over_each_other_by_no_more_than_a_fifth") {
  // L-shaped and T-shaped gaps and a heap of random ones.
  PaintedWall wall;
  wall.with(1, 1, 2, 0.8, WallState::kThrough).with(1, 1, 0.8, 3, WallState::kThrough);
  wall.with(5, 3, 3, 0.8, WallState::kThrough).with(6, 1, 0.8, 2.5, WallState::kThrough);
  RandomStream random(8, 8);
  for (int k = 0; k < 30; ++k)
    wall.with(9 + 2.5 * random.uniform(), 5 * random.uniform(), 0.4, 0.4, WallState::kThrough);
  const OpeningList found = wall.candidates();
  CHECK(found.size() >= 4);
  for (size_t i = 0; i < found.size(); ++i)
    for (size_t j = i + 1; j < found.size(); ++j) {
      const RingBox a = found[i].shape.box(), b = found[j].shape.box();
      const double width = std::min(a.high.u, b.high.u) - std::max(a.low.u, b.low.u),
                   height = std::min(a.high.v, b.high.v) - std::max(a.low.v, b.low.v);
      if (width <= 0 || height <= 0) continue;
      CHECK(width * height <= 0.2 * std::max(a.width() * a.height(), b.width() * b.height()));
    }
}

TEST_CASE("find_openings__two_cells_high_it_is_one_where_seen_through_and_none_where_empty") {
  Task task;
  const auto vents = [&](WallState state) {
    WallCells cells = painted::cells_of(120, 60, WallState::kOn, 0.1);
    painted::paint(cells, {40, 30, 46, 32}, state);
    return find_openings(cells, {}, task);
  };
  const OpeningList seen = vents(WallState::kThrough);
  REQUIRE(seen.size() == 1);
  CHECK(seen[0].is_opening);
  CHECK(seen[0].is_narrow);
  CHECK(overlap(seen[0].shape.box(), {{4, 3}, {4.6, 3.2}}) > 0.9);
  CHECK(vents(WallState::kEmpty).empty());
}

TEST_CASE("find_openings__the_gap_between_two_parapets_has_no_jambs_and_a_window_has") {
  // Parapets of balconies, one over the other, and nothing beside them.
  PaintedWall parapets;
  parapets.with(0, 0, 4, 6, WallState::kOutside).with(7, 0, 5, 6, WallState::kOutside);
  const OpeningList gaps = parapets.with(4, 1.2, 3, 1.6, WallState::kDeep).candidates();
  REQUIRE(gaps.size() == 1);
  CHECK(gaps[0].jambs < 0.1);
  const OpeningList window = PaintedWall().with(4, 1.2, 3, 1.6, WallState::kDeep).candidates();
  REQUIRE(window.size() == 1);
  CHECK(window[0].jambs > 0.9);
}

TEST_CASE("find_openings__a_level_strip_under_the_end_of_a_wall_is_none_without_jambs") {
  // An oriel ends 2 m above the ground; a post in its plane reaches lower, and so the strip counts as inside.
  const auto over_strip = [](double left, double width) {
    return PaintedWall()
        .with(0, 0, 12, 2, WallState::kOutside)
        .with(left, 2, width, 0.2, WallState::kThrough)
        .openings();
  };
  CHECK(over_strip(0, 12).empty());
  CHECK(over_strip(4, 2).size() == 1);
}
