// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "base/table_columns.h"
#include "segment/evaluation/evaluation.h"

namespace jalon {

namespace {

// One row a segment of a side; other: what the other side is called.
FieldTable side_table(const std::vector<SegmentVerdict>& side, std::span<const int64_t> source) {
  struct Row {
    uint32_t label;
    int64_t source;
    const SegmentVerdict* verdict;
  };
  std::vector<Row> rows;
  for (size_t s = 0; s < side.size(); ++s)
    rows.push_back({static_cast<uint32_t>(s + 1), source[s], &side[s]});
  FieldTable t;
  add_column<uint32_t>(t, rows, "label", "", "label of the segment",
                       [](const Row& r) { return r.label; });
  add_column<int64_t>(t, rows, "source_label", "", "its value in the field it was made from",
                      [](const Row& r) { return r.source; });
  add_column<uint64_t>(t, rows, "points", "points", "number of its points",
                       [](const Row& r) { return r.verdict->points; });
  add_column<uint8_t>(t, rows, "kept", "", "1; 0 = left out, too small",
                      [](const Row& r) { return r.verdict->kept ? 1 : 0; });
  add_column<uint32_t>(t, rows, "partner", "", "label of its pair on the other side; 0 = unmatched",
                       [](const Row& r) { return r.verdict->partner; });
  add_column<uint32_t>(t, rows, "parts", "", "segments of the other side that lie mostly in it",
                       [](const Row& r) { return r.verdict->parts; });
  add_column<uint64_t>(t, rows, "covered", "points",
                       "its points that segments of the other side hold",
                       [](const Row& r) { return r.verdict->covered; });
  return t;
}

}  // namespace

FieldTable pair_table(const Evaluation& e) {
  using P = SegmentPair;
  FieldTable t;
  const auto& rows = e.pairs;
  add_column<uint32_t>(t, rows, "automatic", "", "label of the automatic segment A",
                       [](const P& p) { return p.automatic; });
  add_column<uint32_t>(t, rows, "reference", "", "label of the reference segment SR",
                       [](const P& p) { return p.reference; });
  add_column<uint64_t>(t, rows, "card_automatic", "points", "Card A",
                       [](const P& p) { return p.card_automatic; });
  add_column<uint64_t>(t, rows, "card_reference", "points", "Card SR",
                       [](const P& p) { return p.card_reference; });
  add_column<uint64_t>(t, rows, "intersection", "points", "I: points of both",
                       [](const P& p) { return p.intersection; });
  add_column<uint64_t>(t, rows, "commission", "points", "D+: points of A alone",
                       [](const P& p) { return p.commission(); });
  add_column<uint64_t>(t, rows, "omission", "points", "D-: points of SR alone",
                       [](const P& p) { return p.omission(); });
  add_column<double>(t, rows, "tdr", "1", "detection rate I / Card SR",
                     [](const P& p) { return p.tdr(); });
  add_column<double>(t, rows, "tda", "1", "detection accuracy I / Card A",
                     [](const P& p) { return p.tda(); });
  add_column<double>(t, rows, "iou", "1", "intersection over union",
                     [](const P& p) { return p.iou(); });
  add_column<double>(t, rows, "angle", "rad", "between the normals",
                     [](const P& p) { return p.angle_rad; });
  add_column<double>(t, rows, "distance", "m", "mean distance of A's points from SR's plane",
                     [](const P& p) { return p.distance_m; });
  add_column<double>(t, rows, "offset_difference", "m",
                     "A's centroid beyond SR's plane, along SR's normal",
                     [](const P& p) { return p.offset_m; });
  return t;
}

FieldTable automatic_table(const Evaluation& e) {
  return side_table(e.automatic, e.automatic_source);
}
FieldTable reference_table(const Evaluation& e) {
  return side_table(e.reference, e.reference_source);
}

FieldTable totals_table(const Evaluation& e) {
  FieldTable t;
  const std::span<const EvaluationTotals> row(&e.totals, 1);
  const auto count = [&](const char* name, const char* unit, const char* meaning, uint64_t value) {
    add_column<uint64_t>(t, row, name, unit, meaning,
                         [&](const EvaluationTotals&) { return value; });
  };
  const auto number = [&](const char* name, const char* unit, const char* meaning, double value) {
    add_column<double>(t, row, name, unit, meaning, [&](const EvaluationTotals&) { return value; });
  };
  const EvaluationTotals& v = e.totals;
  count("pairs", "", "segments matched one to one", v.pairs);
  count("unmatched_automatic", "", "kept automatic segments without a pair", v.unmatched_automatic);
  count("unmatched_reference", "", "kept reference segments without a pair", v.unmatched_reference);
  count("left_out_automatic", "", "automatic segments below the smallest size",
        v.left_out_automatic);
  count("left_out_reference", "", "reference segments below the smallest size",
        v.left_out_reference);
  count("over_segmented", "", "reference segments with two or more automatic parts",
        v.over_segmented);
  count("under_segmented", "", "automatic segments with two or more reference parts",
        v.under_segmented);
  count("non_segmented", "", "reference segments mostly in no automatic segment", v.non_segmented);
  count("card_automatic", "points", "sum of Card A over the pairs", v.card_automatic);
  count("card_reference", "points", "sum of Card SR over the pairs", v.card_reference);
  count("intersection", "points", "sum of I over the pairs", v.intersection);
  count("commission", "points", "sum of D+ over the pairs", v.card_automatic - v.intersection);
  count("omission", "points", "sum of D- over the pairs", v.card_reference - v.intersection);
  number("global_tdr", "1", "sum of I / sum of Card SR", v.global_tdr);
  number("global_tda", "1", "sum of I / sum of Card A", v.global_tda);
  number("global_iou", "1", "of the sums", v.global_iou);
  number("mean_tdr", "1", "mean over the pairs", v.mean_tdr);
  number("mean_tda", "1", "mean over the pairs", v.mean_tda);
  number("mean_iou", "1", "mean over the pairs", v.mean_iou);
  number("detection", "1", "mean TDR over all kept reference segments, unmatched as 0",
         v.detection);
  number("accuracy", "1", "mean TDA over all kept automatic segments, unmatched as 0", v.accuracy);
  number("mean_angle", "rad", "mean over the pairs", v.angle_rad.mean);
  number("std_angle", "rad", "standard deviation over the pairs", v.angle_rad.deviation);
  number("mean_distance", "m", "mean over the pairs", v.distance_m.mean);
  number("std_distance", "m", "standard deviation over the pairs", v.distance_m.deviation);
  number("mean_offset_difference", "m", "mean over the pairs", v.offset_m.mean);
  number("std_offset_difference", "m", "standard deviation over the pairs", v.offset_m.deviation);
  return t;
}

}  // namespace jalon
