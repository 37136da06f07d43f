// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "segment/evaluation/evaluation.h"

using namespace jalon;

namespace {

double tables_value(const FieldTable& table, const char* name, size_t row = 0) {
  return table.require(name).number(row);
}

}  // namespace

TEST_CASE("pair_table__a_row_a_pair_with_its_rates") {
  Evaluation e;
  e.pairs.resize(2);
  SegmentPair& p = e.pairs[1];
  p = {4, 7, 50, 80, 40, 0.01, 0.002, -0.003};
  const FieldTable t = pair_table(e);
  const std::pair<const char*, double> expected[] = {{"automatic", 4},
                                                     {"reference", 7},
                                                     {"card_automatic", 50},
                                                     {"card_reference", 80},
                                                     {"intersection", 40},
                                                     {"commission", 10},
                                                     {"omission", 40},
                                                     {"tdr", 0.5},
                                                     {"tda", 0.8},
                                                     {"iou", 40.0 / 90},
                                                     {"angle", 0.01},
                                                     {"distance", 0.002},
                                                     {"offset_difference", -0.003}};
  for (const auto& column : expected) {
    const char* const name = column.first;
    CAPTURE(name);
    CHECK(t.require(name).count() == 2);
    CHECK(tables_value(t, name, 1) == doctest::Approx(column.second));
  }
  CHECK(std::isnan(tables_value(t, "angle", 0)));
}

TEST_CASE("side_tables__each_side_has_its_own_verdicts_and_source_labels") {
  Evaluation e;
  e.automatic = {{100, true, 2, 1, 90}, {3, false, 0, 0, 1}};
  e.automatic_source = {17, -4};
  e.reference = {{60, true, 0, 3, 50}};
  e.reference_source = {99};
  const FieldTable a = automatic_table(e), r = reference_table(e);
  CHECK(a.require("label").count() == 2);
  CHECK(tables_value(a, "label", 1) == 2);
  CHECK(tables_value(a, "source_label", 1) == -4);
  CHECK(tables_value(a, "points", 0) == 100);
  CHECK(tables_value(a, "kept", 0) == 1);
  CHECK(tables_value(a, "kept", 1) == 0);
  CHECK(tables_value(a, "partner", 0) == 2);
  CHECK(tables_value(a, "covered", 0) == 90);
  CHECK(r.require("label").count() == 1);
  CHECK(tables_value(r, "source_label") == 99);
  CHECK(tables_value(r, "parts") == 3);
}

TEST_CASE("totals_table__one_row_whose_commission_and_omission_follow_from_the_sums") {
  Evaluation e;
  e.totals.pairs = 3;
  e.totals.non_segmented = 2;
  e.totals.card_automatic = 160;
  e.totals.card_reference = 190;
  e.totals.intersection = 110;
  e.totals.global_tdr = 0.25;
  e.totals.offset_m = {0.5, 0.125};
  const FieldTable t = totals_table(e);
  CHECK(t.require("pairs").count() == 1);
  CHECK(tables_value(t, "pairs") == 3);
  CHECK(tables_value(t, "non_segmented") == 2);
  CHECK(tables_value(t, "commission") == 50);
  CHECK(tables_value(t, "omission") == 80);
  CHECK(tables_value(t, "global_tdr") == 0.25);
  CHECK(tables_value(t, "mean_offset_difference") == 0.5);
  CHECK(tables_value(t, "std_offset_difference") == 0.125);
  CHECK(std::isnan(tables_value(t, "mean_angle")));
}
