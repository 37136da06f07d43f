// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "segment/evaluation/parts.h"

using namespace jalon;

namespace {

SegmentPair pair(uint64_t a, uint64_t r, uint64_t both, double angle_rad) {
  SegmentPair out;
  out.card_automatic = a;
  out.card_reference = r;
  out.intersection = both;
  out.angle_rad = angle_rad;
  return out;
}

SegmentVerdict verdict(uint64_t points, bool kept, uint32_t partner, uint32_t parts,
                       uint64_t covered) {
  return {points, kept, partner, parts, covered};
}

}  // namespace

TEST_CASE("total_up__sums_means_and_counts_of_a_case_done_by_hand") {
  Evaluation e;
  e.pairs = {pair(100, 80, 60, 0.1), pair(50, 100, 40, 0.3), pair(10, 10, 10, kNaN)};
  e.automatic = {verdict(100, true, 1, 2, 0), verdict(50, true, 2, 1, 0),
                 verdict(10, true, 3, 0, 0), verdict(30, true, 0, 3, 0),
                 verdict(2, false, 0, 5, 0)};
  e.reference = {verdict(80, true, 1, 1, 70), verdict(100, true, 2, 2, 49),
                 verdict(10, true, 3, 0, 10), verdict(40, true, 0, 0, 0),
                 verdict(20, true, 0, 0, 10), verdict(1, false, 0, 2, 0)};
  const EvaluationTotals t = total_up(e, 0.5);
  CHECK(t.pairs == 3);
  CHECK(t.unmatched_automatic == 1);
  CHECK(t.unmatched_reference == 2);
  CHECK(t.left_out_automatic == 1);
  CHECK(t.left_out_reference == 1);
  CHECK(t.under_segmented == 2);  // those left out do not count
  CHECK(t.over_segmented == 1);
  CHECK(t.non_segmented == 2);  // 49 of 100 and 0 of 40, not 10 of 20
  CHECK(t.card_automatic == 160);
  CHECK(t.card_reference == 190);
  CHECK(t.intersection == 110);
  CHECK(t.global_tdr == doctest::Approx(110.0 / 190));
  CHECK(t.global_tda == doctest::Approx(110.0 / 160));
  CHECK(t.global_iou == doctest::Approx(110.0 / 240));
  CHECK(t.mean_tdr == doctest::Approx((0.75 + 0.4 + 1) / 3));
  CHECK(t.mean_iou == doctest::Approx((60.0 / 120 + 40.0 / 110 + 1) / 3));
  CHECK(t.detection == doctest::Approx((0.75 + 0.4 + 1) / 5));
  CHECK(t.accuracy == doctest::Approx((0.6 + 0.8 + 1) / 4));
  CHECK(t.angle_rad.mean == doctest::Approx(0.2).scale(0));  // NaN left out
  CHECK(t.angle_rad.deviation == doctest::Approx(std::sqrt(0.02)).scale(0));
  CHECK(std::isnan(t.distance_m.mean));
}

TEST_CASE("total_up__nothing_found__rates_are_NaN_or_zero") {
  const EvaluationTotals none = total_up({}, 0.5);
  CHECK(none.pairs == 0);
  for (const double rate : {none.global_tdr, none.mean_iou, none.detection, none.accuracy})
    CHECK(std::isnan(rate));
  Evaluation missed;
  missed.reference = {verdict(10, true, 0, 0, 0)};
  const EvaluationTotals t = total_up(missed, 0.5);
  CHECK(t.detection == 0);
  CHECK(std::isnan(t.accuracy));
  missed.pairs = {pair(5, 5, 5, 0.1)};
  CHECK(std::isnan(total_up(missed, 0.5).angle_rad.deviation));  // of a single value
}
