// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_pieces.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/told_epochs.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("change_pieces__of_a_box_that_went_are_one_piece_seen_through") {
  const BoxOnFloor gone{{-1.4, -1.4, 0}, {0.6, 0.5, 0.5}};
  const ToldEpochs epochs(floor_with({gone}, 1), floor_with({}, 2));
  Task task;
  const std::vector<ChangePiece> pieces = change_pieces(epochs.before, epochs.after, task);
  const auto large = std::find_if(pieces.begin(), pieces.end(),
                                  [](const ChangePiece& one) { return one.points >= 64; });
  REQUIRE(large != pieces.end());
  CHECK_FALSE(large->is_after);
  CHECK(large->moved_share < 0.2);
  CHECK(large->size_m == doctest::Approx(norm(Vec3{0.6, 0.5, 0.5})).epsilon(0.1).scale(0));
  CHECK_FALSE(large->sample.empty());
}

TEST_CASE("change_pieces__group_as_they_belong_and_each_in_one_group") {
  const BoxOnFloor one{{-1.4, -1.4, 0}, {0.6, 0.5, 0.5}}, other{{0.8, 0.7, 0}, {0.5, 0.6, 0.7}};
  const ToldEpochs epochs(floor_with({one, other}, 1), floor_with({}, 2));
  Task task;
  const std::vector<ChangePiece> pieces = change_pieces(epochs.before, epochs.after, task);
  const auto groups = group_pieces(epochs.before, epochs.after, pieces, 0.1, task);
  size_t all = 0, large = 0;
  for (const std::vector<size_t>& group : groups) {
    all += group.size();
    size_t points = 0;
    for (const size_t k : group) points += pieces[k].points;
    large += points >= 64 ? 1 : 0;
    CHECK(std::is_sorted(group.begin(), group.end()));
  }
  CHECK(all == pieces.size());
  CHECK(large == 2);  // two metres apart: two things
}

TEST_CASE("change_pieces__what_lies_on_the_way_of_a_surface_that_moved_is_a_part_of_its_change") {
  const BoxOnFloor foot{{-0.2, 0, 0}, {0.4, 0.2, 0.2}}, wall{{-1, -0.35, 0}, {2, 0.1, 0.25}};
  const ToldEpochs epochs(floor_with({foot}, 1), floor_with({wall}, 2));
  Task task;
  for (const double way_m : {0.01, 0.4}) {
    std::vector<ChangePiece> pieces = change_pieces(epochs.before, epochs.after, task);
    for (ChangePiece& piece : pieces) {
      piece.moved_share = 1;
      piece.offset_m = piece.is_after ? way_m : 0.0;
      piece.normal = piece.is_after ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    }
    const auto groups = group_pieces(epochs.before, epochs.after, pieces, 0.01, task);
    const bool is_one = std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
      const auto points_of = [&](bool is_after) {
        size_t points = 0;
        for (const size_t k : group)
          points += pieces[k].is_after == is_after ? pieces[k].points : 0;
        return points;
      };
      return points_of(false) >= 64 && points_of(true) >= 64;
    });
    CHECK(is_one == (way_m > 0.1));
  }
}

TEST_CASE("change_pieces__gap_of_boxes_is_that_of_their_nearest_places") {
  const auto box = [](const Vec3& low, const Vec3& high) {
    Box3 out;
    out.add(low);
    out.add(high);
    return out;
  };
  const Box3 a = box({0, 0, 0}, {1, 1, 1});
  CHECK(box_gap(a, box({4, 5, 0}, {6, 7, 1})) == doctest::Approx(5));
  CHECK(box_gap(a, box({0.5, 0.5, 0.5}, {2, 2, 2})) == 0);
  CHECK(box_gap(box({3, 0, 0}, {4, 1, 1}), a) == doctest::Approx(2));
}
