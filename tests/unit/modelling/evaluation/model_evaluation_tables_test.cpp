// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The tables of an evaluation that was written down by hand, its sums worked out beside it.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/evaluation/model_evaluation.h"

using namespace jalon;

namespace {

double told(const FieldTable& table, const char* name, size_t row = 0, uint32_t component = 0) {
  return table.require(name).number(row, component);
}

/// Two pairs, an invented face, two missing ones and one too small on either side.
ModelEvaluation written() {
  ModelEvaluation e;
  e.automatic = {{7, ~0u, 0, 1, 10, true, 1},
                 {8, ~0u, 1, 2, 4, true, 0},
                 {9, ~0u, 2, 1, 3, true},
                 {10, 5, 2, 1, 0.01, false}};
  e.reference = {{1, ~0u, 0, 1, 5, true, 1},
                 {2, ~0u, 1, 1, 8, true, 0},
                 {3, ~0u, 2, 1, 1, true},
                 {4, ~0u, 2, 1, 2, true},
                 {5, ~0u, 2, 1, 0.02, false}};
  FacePair first, second;
  first.automatic = 1;
  first.areas = {4, 5, 3};
  first.angle_rad = 0.01;
  first.distance_m = -0.02;
  first.same_class = true;
  first.borders.f1 = 0.8;
  second.reference = 1;
  second.areas = {10, 8, 8};
  second.angle_rad = 0.03;
  second.distance_m = 0.04;
  e.pairs = {first, second};
  e.unpaired = {3, 3, 0};
  e.shift = {0.5, -0.25, 0.125};
  VertexPair near, far;
  near.deviation = {0, 0, 0.1};
  far.deviation = {0.3, 0, -0.4};
  e.vertices = {near, far};
  return e;
}

}  // namespace

TEST_CASE("evaluation_tables__of_a_side_tell_every_face_and_its_partner") {
  const ModelEvaluation e = written();
  for (const auto& [table, side] : {std::pair{automatic_face_table(e), &e.automatic},
                                    {reference_face_table(e), &e.reference}}) {
    REQUIRE(table.require("face").count() == side->size());
    for (size_t i = 0; i < side->size(); ++i) {
      const FaceVerdict& v = (*side)[i];
      CHECK(told(table, "face", i) == v.face);
      CHECK(told(table, "ring", i) == v.ring);
      CHECK(told(table, "part", i) == v.part);
      CHECK(told(table, "merged", i) == v.merged);
      CHECK(told(table, "area", i) == v.area_m2);
      CHECK(told(table, "kept", i) == (v.kept ? 1 : 0));
      CHECK(told(table, "partner", i) == v.partner);
    }
  }
  // Partners point at each other.
  const FieldTable a = automatic_face_table(e), r = reference_face_table(e);
  for (size_t i = 0; i < 2; ++i)
    CHECK(told(r, "partner", static_cast<size_t>(told(a, "partner", i))) == static_cast<double>(i));
}

TEST_CASE("evaluation_tables__of_the_pairs_have_their_indices_and_what_is_not_known_as_nan") {
  const FieldTable t = face_pair_table(written());
  REQUIRE(t.require("automatic").count() == 2);
  CHECK(told(t, "automatic", 0) == 1);
  CHECK(told(t, "reference", 1) == 1);
  CHECK(told(t, "completeness", 0) == doctest::Approx(3.0 / 5));
  CHECK(told(t, "correctness", 0) == doctest::Approx(3.0 / 4));
  CHECK(told(t, "quality", 0) == doctest::Approx(3.0 / 6));
  CHECK(told(t, "correctness", 1) == doctest::Approx(0.8));
  CHECK(told(t, "distance", 0) == -0.02);
  CHECK(told(t, "same_class", 0) == 1);
  CHECK(told(t, "same_class", 1) == 0);
  CHECK(told(t, "contour_f1", 0) == 0.8);
  CHECK(std::isnan(told(t, "contour_f1", 1)));
  CHECK(std::isnan(told(t, "hausdorff", 0)));
}

TEST_CASE("evaluation_tables__totals_count_each_face_once_and_sum_what_is_known") {
  const FieldTable t = model_totals_table(written());
  CHECK(told(t, "pairs") == 2);
  CHECK(told(t, "unmatched_automatic") == 1);
  CHECK(told(t, "unmatched_reference") == 2);
  CHECK(told(t, "left_out_automatic") == 1);
  CHECK(told(t, "left_out_reference") == 1);
  CHECK(told(t, "same_class") == 1);
  // 11 m2 shared of 14 + 3 found and 13 + 3 true ones.
  CHECK(told(t, "total_completeness") == doctest::Approx(11.0 / 16));
  CHECK(told(t, "total_correctness") == doctest::Approx(11.0 / 17));
  CHECK(told(t, "mean_completeness") == doctest::Approx((0.6 + 1) / 2));
  CHECK(told(t, "mean_angle") == doctest::Approx(0.02));
  CHECK(told(t, "mean_plane_distance") == doctest::Approx(0.01));
  CHECK(told(t, "std_plane_distance") == doctest::Approx(0.06 / std::sqrt(2.0)));
  CHECK(told(t, "mean_contour_f1") == doctest::Approx(0.8));
  CHECK(std::isnan(told(t, "mean_hausdorff")));
  CHECK(told(t, "shift", 0, 1) == -0.25);
  CHECK(told(t, "vertices") == 2);
  CHECK(told(t, "max_distance") == doctest::Approx(0.5));
  CHECK(told(t, "mean_dz") == doctest::Approx(-0.15));
  // Of nothing there are no means, and no row less.
  const FieldTable none = model_totals_table({});
  CHECK(told(none, "pairs") == 0);
  CHECK(std::isnan(told(none, "mean_angle")));
  CHECK(std::isnan(told(none, "total_completeness")));
}
