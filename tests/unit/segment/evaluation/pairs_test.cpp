// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numeric>

#include "base/random.h"
#include "segment/evaluation/parts.h"
#include "unit/segment/scenes.h"

using namespace jalon;

namespace {

Segmentation labelled(const std::vector<uint32_t>& labels, size_t segments) {
  Segmentation s;
  s.labels = make_column<uint32_t>({"label"}, labels);
  s.segments.resize(segments);
  return s;
}

}  // namespace

TEST_CASE("count_overlaps__counts_points_of_both_sides_in_kept_segments") {
  const auto a = labelled({1, 1, 2, 2, 0, 3, 1}, 3), r = labelled({1, 1, 1, 2, 2, 2, 0}, 2);
  Evaluation verdicts;
  verdicts.automatic.resize(3);
  verdicts.reference.resize(2);
  verdicts.automatic[2].kept = false;
  Task task;
  const auto overlaps = count_overlaps(a, r, verdicts, task);
  REQUIRE(overlaps.size() == 3);  // by reference, then automatic label
  const uint32_t expected[3][3] = {{1, 1, 2}, {1, 2, 1}, {2, 2, 1}};
  for (size_t i = 0; i < 3; ++i) {
    CHECK(overlaps[i].reference == expected[i][0]);
    CHECK(overlaps[i].automatic == expected[i][1]);
    CHECK(overlaps[i].points == expected[i][2]);
  }
}

TEST_CASE("pair_segments__reaches_the_largest_total_of_all_pairings_of_enough_iou") {
  constexpr uint32_t kCount = 5;
  RandomStream random(2, 1);
  Task task;
  for (int draw = 0; draw < 40; ++draw) {
    Evaluation e;
    e.automatic.resize(kCount);
    e.reference.resize(kCount);
    std::vector<Overlap> overlaps;
    for (uint32_t r = 1; r <= kCount; ++r)
      for (uint32_t a = 1; a <= kCount; ++a) {
        const uint64_t times = random.below(3), n = times * random.below(40);
        if (n > 0) overlaps.push_back({a, r, n});
      }
    for (const Overlap& o : overlaps) {
      e.automatic[o.automatic - 1].points += o.points;
      e.reference[o.reference - 1].points += o.points;
    }
    uint64_t allowed[kCount][kCount] = {};  // points of the pairs of iou >= 0.2
    for (const Overlap& o : overlaps) {
      const uint64_t all =
          e.automatic[o.automatic - 1].points + e.reference[o.reference - 1].points;
      if (static_cast<double>(o.points) >= 0.2 * static_cast<double>(all - o.points))
        allowed[o.reference - 1][o.automatic - 1] = o.points;
    }
    uint64_t best = 0;
    std::array<uint32_t, kCount> order;
    std::iota(order.begin(), order.end(), 0u);
    do {
      uint64_t sum = 0;
      for (uint32_t r = 0; r < kCount; ++r) sum += allowed[r][order[r]];
      best = std::max(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    pair_segments(overlaps, 0.2, e, task);
    uint64_t sum = 0;
    for (const SegmentPair& pair : e.pairs) {
      CHECK(pair.iou() >= 0.2);
      CHECK(e.automatic[pair.automatic - 1].partner == pair.reference);
      CHECK(e.reference[pair.reference - 1].partner == pair.automatic);
      sum += pair.intersection;
    }
    CHECK(sum == best);
  }
}

TEST_CASE("compare_planes__angle_mean_distance_and_offset_of_known_planes") {
  // Points at z = 0.1 and 0.3 against the plane z = 0.05; normals 0.2 rad apart, one turned over.
  const Vec3 far{652000, 6861000, 0};
  auto a = labelled({1, 1, 2}, 2), r = labelled({1, 1, 2}, 2);
  a.cloud = test::cloud_of({{0, 0, 0.1}, {1, 0, 0.3}, {0, 0, 9}}, far);
  a.segments[0].fit.plane = {{std::sin(0.2), 0, -std::cos(0.2)}, 0};
  a.segments[0].fit.centroid = far + Vec3{0.5, 0, 0.2};
  r.segments[0].fit.plane = {{0, 0, 1}, 0.05};
  r.segments[0].fit.centroid = far + Vec3{0, 0, 0.05};
  r.segments[1].fit.plane.offset = kNaN;  // no plane
  std::vector<SegmentPair> pairs(2);
  pairs[0].automatic = pairs[0].reference = 1;
  pairs[1].automatic = pairs[1].reference = 2;
  Task task;
  compare_planes(a, r, pairs, task);
  CHECK(pairs[0].angle_rad == doctest::Approx(0.2).scale(0));
  CHECK(pairs[0].distance_m == doctest::Approx(0.15).scale(0));
  CHECK(pairs[0].offset_m == doctest::Approx(0.15).scale(0));
  CHECK(std::isnan(pairs[1].angle_rad));
  CHECK(std::isnan(pairs[1].distance_m));
}
