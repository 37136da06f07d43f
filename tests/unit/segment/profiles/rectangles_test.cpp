// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/profiles/rectangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace jalon;

namespace {

// A line of slice k at height 0.25 k, from (u0, v) to (u1, v) in its slice, with points every 5 cm.
ProfileLine line_of(uint32_t slice, double u0, double u1, double v) {
  ProfileLine line;
  line.slice = slice;
  line.from = {u0, v};
  line.to = {u1, v};
  for (double u = u0; u <= u1 + 1e-9; u += 0.05) line.moments.add({u, v, 0.25 * slice});
  return line;
}

const RectangleRule kRule{0.25, 0.17, 0.025};

}  // namespace

TEST_CASE("rectangles__of_a_wall_with_a_set_back_upper_part_are_two_planes") {
  std::vector<ProfileLine> lines;
  for (uint32_t k = 0; k < 4; ++k) lines.push_back(line_of(k, 0, 2, 0));
  for (uint32_t k = 4; k < 8; ++k) lines.push_back(line_of(k, 0, 2, 0.2));
  Task task;
  const auto rectangles = match_lines(lines, kRule, task);
  CHECK(rectangles.size() == 7);  // one of them joins the two parts
  const auto planes = join_rectangles(lines, rectangles, kRule, task);
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].lines == std::vector<uint32_t>{0, 1, 2, 3});
  CHECK(planes[1].lines == std::vector<uint32_t>{4, 5, 6, 7});
}

TEST_CASE("rectangles__of_a_wall_beside_windows_take_the_nearest_line") {
  std::vector<ProfileLine> lines{line_of(0, 0, 6, 0)};
  for (uint32_t k = 1; k < 4; ++k)
    for (double u = 0; u < 6; u += 2) {
      lines.push_back(line_of(k, u, u + 1, 0));
      lines.push_back(line_of(k, u + 1.05, u + 1.95, 0.2));
    }
  Task task;
  const auto planes = join_rectangles(lines, match_lines(lines, kRule, task), kRule, task);
  REQUIRE(planes.size() == 4);
  CHECK(planes[0].lines.size() == 10);  // the wall, whole below and in three columns
  for (size_t k = 1; k < 4; ++k) CHECK(planes[k].lines.size() == 3);
}

// A wall and a surround 6 cm before it, and lines that were cut where both lie in a slice: one slope after the other
// leads from plane to plane, each within the angle of the last.
TEST_CASE("rectangles__lead_over_no_chain_of_slopes_from_plane_to_plane") {
  std::vector<ProfileLine> lines;
  const double depths[] = {0, 0, 0, 0.01, 0.03, 0.05, 0.06, 0.06, 0.06};
  for (uint32_t k = 0; k < 9; ++k) {
    lines.push_back(line_of(k, 0, 4, 0));
    lines.push_back(line_of(k, 4.1, 5, depths[k]));
  }
  Task task;
  const auto sets = join_rectangles(lines, match_lines(lines, kRule, task), kRule, task);
  for (const ProfileSet& set : sets) {
    PlaneFit fit;
    REQUIRE(fit_plane(set.moments, fit));
    CHECK(fit.sigma < 0.5 * kRule.tolerance_m);
    double low = INFINITY, high = -INFINITY;
    for (const uint32_t line : set.lines) {
      low = std::min(low, lines[line].from.v);
      high = std::max(high, lines[line].from.v);
    }
    CHECK(high - low < 0.05);
  }
  CHECK(std::ranges::count_if(sets, [](const ProfileSet& s) { return s.lines.size() >= 9; }) == 1);
}

TEST_CASE("rectangles__need_neighbouring_slices_one_direction_and_overlap") {
  Task task;
  const auto count = [&](const std::vector<ProfileLine>& lines) {
    return match_lines(lines, kRule, task).size();
  };
  CHECK(count({line_of(0, 0, 2, 0), line_of(1, 0, 2, 0)}) == 1);
  CHECK(count({line_of(0, 0, 2, 0), line_of(2, 0, 2, 0)}) == 0);
  CHECK(count({line_of(0, 0, 2, 0), line_of(1, 1.9, 3, 0)}) == 0);
  CHECK(count({line_of(0, 0, 2, 0), line_of(1, 0, 2, 0.5)}) == 0);
  ProfileLine turned = line_of(1, 0, 2, 0);
  turned.to = {1.9, 0.6};
  CHECK(count({line_of(0, 0, 2, 0), turned}) == 0);
  CHECK(count({}) == 0);
}

// Groups of lines that cannot run beside one another: asked of all at once, each has the rectangles it has by itself.
TEST_CASE("rectangles__of_groups_far_apart_are_those_of_each_alone") {
  std::mt19937 draw(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  Task task;
  std::vector<std::vector<ProfileLine>> slices(2);
  size_t alone = 0;
  for (int group = 0; group < 200; ++group) {
    const Vec2 middle{6.0 * (group % 20), 6.0 * (group / 20)};
    std::vector<ProfileLine> own;
    for (uint32_t k = 0; k < 8; ++k) {
      const double turn = between(0, 0.3), half = between(0.1, 2), v = between(-0.5, 0.5);
      const Vec2 reach{half * std::cos(turn), half * std::sin(turn)};
      const Vec2 at = middle + Vec2{between(-0.5, 0.5), v};
      ProfileLine line;
      line.slice = k / 4;
      line.from = at - reach;
      line.to = at + reach;
      for (double t = -1; t <= 1; t += 0.1)
        line.moments.add({at.u + t * reach.u, at.v + t * reach.v, 0.25 * line.slice});
      own.push_back(line);
      slices[line.slice].push_back(line);
    }
    alone += match_lines(own, kRule, task).size();
  }
  std::vector<ProfileLine> all;
  for (auto& slice : slices) {
    std::shuffle(slice.begin(), slice.end(), draw);
    all.insert(all.end(), slice.begin(), slice.end());
  }
  CHECK(alone > 400);
  CHECK(match_lines(all, kRule, task).size() == alone);
}
