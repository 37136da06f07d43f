// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Evaluation against a reference: rates of a printed table, pairs, counts of errors, geometry.
#include "segment/evaluation/evaluation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/segment/labelled.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Table 5.3 of the facade thesis: Card A, Card SR, I of ten segments, and the rates recomputed from them.
struct Row {
  uint64_t card_a, card_sr, i;
  double tdr, tda, iou;
};
constexpr Row kTable53[] = {
    {5422, 5436, 5229, 0.9619, 0.9644, 0.929},    {9203, 8720, 8717, 0.9997, 0.9472, 0.947},
    {8922, 8286, 7841, 0.9463, 0.8788, 0.837},    {158, 178, 153, 0.8596, 0.9684, 0.836},
    {3912, 3533, 3533, 1.0000, 0.9031, 0.903},    {286, 280, 280, 1.0000, 0.9790, 0.979},
    {19923, 18996, 18926, 0.9963, 0.9500, 0.947}, {4615, 4299, 4283, 0.9963, 0.9281, 0.925},
    {7949, 7553, 7436, 0.9845, 0.9355, 0.922},    {414, 388, 381, 0.9820, 0.9203, 0.905},
};

// Labels with these overlaps; what is not in both is noise on the other side.
Labelled labels_of_table() {
  Labelled out;
  int64_t label = 0;
  for (const Row& row : kTable53) {
    ++label;
    out.add(row.i, label, 100 + label);
    out.add(row.card_a - row.i, label, 0);
    out.add(row.card_sr - row.i, 0, 100 + label);
  }
  return out;
}

}  // namespace

TEST_CASE("evaluation gives the rates of table 5.3") {
  const Labelled labelled = labels_of_table();
  const Evaluation e = labelled.evaluate();
  REQUIRE(e.pairs.size() == 10);
  for (const SegmentPair& pair : e.pairs) {
    const auto number = e.reference_source[pair.reference - 1] - 100;
    CAPTURE(number);
    CHECK(e.automatic_source[pair.automatic - 1] == number);
    const Row& row = kTable53[number - 1];
    CHECK(pair.card_automatic == row.card_a);
    CHECK(pair.card_reference == row.card_sr);
    CHECK(pair.intersection == row.i);
    CHECK(pair.commission() == row.card_a - row.i);
    CHECK(pair.omission() == row.card_sr - row.i);
    CHECK(std::fabs(pair.tdr() - row.tdr) < 5.1e-5);
    CHECK(std::fabs(pair.tda() - row.tda) < 5.1e-5);
    CHECK(std::fabs(pair.iou() - row.iou) < 5.1e-4);
  }
  const EvaluationTotals& t = e.totals;
  CHECK(t.card_automatic == 60804);
  CHECK(t.card_reference == 57669);
  CHECK(t.intersection == 56779);
  CHECK(t.card_automatic - t.intersection == 4025);
  CHECK(t.card_reference - t.intersection == 890);
  CHECK(std::fabs(t.global_tdr - 0.9846) < 5.1e-5);
  CHECK(std::fabs(t.global_tda - 0.9338) < 5.1e-5);
  CHECK(std::fabs(t.mean_tdr - 0.9726) < 5.1e-5);
  CHECK(std::fabs(t.mean_tda - 0.9375) < 5.1e-5);
  CHECK(std::fabs(t.mean_iou - 0.913) < 5.1e-4);
  CHECK(t.over_segmented + t.under_segmented + t.non_segmented + t.unmatched_automatic +
            t.unmatched_reference ==
        0);
}

TEST_CASE("evaluation of a segmentation with itself is perfect") {
  Labelled same;
  for (int64_t label = 1; label <= 40; ++label)
    same.add(static_cast<uint64_t>(30 * label), label, label);
  const Evaluation e = same.evaluate();
  CHECK(e.totals.pairs == 40);
  CHECK(e.totals.mean_tdr == 1);
  CHECK(e.totals.mean_tda == 1);
  CHECK(e.totals.detection == 1);
  CHECK(e.totals.angle_rad.mean == 0);
  CHECK(std::fabs(e.totals.offset_m.mean) < 1e-12);
}

TEST_CASE("evaluation counts over-, under- and non-segmentation") {
  Labelled l;
  l.add(600, 1, 1);  // reference 1 in two parts
  l.add(400, 2, 1);
  l.add(500, 3, 2);  // references 2, 3 and 4 in one segment
  l.add(200, 3, 3);
  l.add(100, 3, 4);
  l.add(300, 0, 5);  // reference 5 not found but for a few points
  l.add(20, 4, 5);
  l.add(90, 5, 0);   // found where nothing is
  l.add(700, 6, 6);  // as it should be
  const Evaluation e = l.evaluate();
  CHECK(e.totals.over_segmented == 1);
  CHECK(e.totals.under_segmented == 1);
  CHECK(e.totals.non_segmented == 1);
  CHECK(e.totals.pairs == 3);
  CHECK(e.totals.unmatched_reference == 3);
  CHECK(e.totals.unmatched_automatic == 3);
  CHECK(e.totals.detection == doctest::Approx((0.6 + 1 + 1) / 6));
  CHECK(e.totals.accuracy == doctest::Approx((1 + 500.0 / 800 + 1) / 6));
  // Below the threshold on both sides: 4 (100 points), and the found ones of 20 and 90 points.
  const Evaluation large = l.evaluate("{\"min_points\": 150}");
  CHECK(large.totals.left_out_reference == 1);
  CHECK(large.totals.left_out_automatic == 2);
  CHECK(large.totals.unmatched_reference == 2);
  CHECK(large.totals.unmatched_automatic == 1);
  CHECK(large.totals.non_segmented == 1);
}

TEST_CASE("evaluation pairs for the largest total overlap, not the largest single one") {
  Labelled l;
  l.add(50, 1, 1);
  l.add(45, 1, 2);
  l.add(45, 2, 1);
  const Evaluation e = l.evaluate();
  REQUIRE(e.pairs.size() == 2);
  CHECK(e.totals.intersection == 90);
}

TEST_CASE("evaluation tells the angle and the distance between planes") {
  const double angle = 0.01 * kDegree, shift_m = 0.002;
  Buffer<double> xyz(3 * 2 * 900);
  std::vector<int64_t> automatic, reference;
  for (size_t i = 0; i < 1800; ++i) {
    const double x = 0.1 * static_cast<double>(i % 30), z = 0.1 * static_cast<double>(i / 30 % 30);
    const bool is_turned =
        i >= 900;  // the automatic segment: half the points on a turned and shifted plane
    xyz[3 * i] = 652000 + x;
    xyz[3 * i + 1] = 6861000 + (is_turned ? shift_m + std::tan(angle) * (x - 1.45) : 0);
    xyz[3 * i + 2] = z;
    automatic.push_back(is_turned ? 7 : 0);
    reference.push_back(is_turned ? 0 : 3);
  }
  // One point in common, in the middle where it turns nothing, so that they pair.
  automatic[15 * 30 + 15] = 7;
  const Evaluation e = evaluate_labels(make_labelled_cloud(std::move(xyz), automatic, reference),
                                       "{\"min_iou\": 0}");
  REQUIRE(e.pairs.size() == 1);
  CHECK(std::fabs(e.pairs[0].angle_rad - angle) < 1e-6);
  CHECK(std::fabs(e.pairs[0].distance_m - shift_m * 900 / 901) < 1e-5);
  CHECK(std::fabs(std::fabs(e.pairs[0].offset_m) - shift_m * 900 / 901) < 1e-6);
}

TEST_CASE("evaluation refuses other points") {
  Labelled l;
  l.add(100, 1, 1);
  const CloudPtr cloud = l.cloud(), other = l.cloud(0.01), near = l.cloud(0.0004);
  Task task;
  const Segmentation a = from_labels(cloud, "automatic");
  CHECK_THROWS_AS(
      evaluate_segmentation(a, from_labels(other, "reference"), evaluation_params(), task), Error);
  CHECK(evaluate_segmentation(a, from_labels(near, "reference"), evaluation_params(), task)
            .pairs.size() == 1);
  l.add(1, 1, 1);
  CHECK_THROWS_AS(
      evaluate_segmentation(a, from_labels(l.cloud(), "reference"), evaluation_params(), task),
      Error);
}

TEST_CASE("evaluation of nothing gives NaN rates and no pairs") {
  Labelled none;
  const Evaluation e = none.evaluate();
  CHECK(e.totals.pairs == 0);
  CHECK(std::isnan(e.totals.mean_tdr));
  Labelled noise;
  noise.add(50, 0, 0);
  CHECK(std::isnan(noise.evaluate().totals.detection));
}

TEST_CASE("evaluation gives the same bits for any number of threads") {
  const Labelled l = labels_of_table();
  const Evaluation one = l.evaluate("{}", 1);
  for (const unsigned threads : {2u, 7u}) {
    const Evaluation other = l.evaluate("{}", threads);
    REQUIRE(other.pairs.size() == one.pairs.size());
    for (size_t i = 0; i < one.pairs.size(); ++i) {
      CHECK(other.pairs[i].automatic == one.pairs[i].automatic);
      CHECK(other.pairs[i].angle_rad == one.pairs[i].angle_rad);
      CHECK(other.pairs[i].distance_m == one.pairs[i].distance_m);
      CHECK(other.pairs[i].offset_m == one.pairs[i].offset_m);
    }
  }
}
