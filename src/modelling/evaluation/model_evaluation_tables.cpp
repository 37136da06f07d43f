// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/table_columns.h"
#include "modelling/evaluation/model_evaluation.h"

namespace jalon {

namespace {

std::vector<ComparedAreas> areas_of(const ModelEvaluation& e) {
  std::vector<ComparedAreas> out;
  for (const FacePair& pair : e.pairs) out.push_back(pair.areas);
  return out;
}

FieldTable side_table(const std::vector<FaceVerdict>& rows) {
  using V = FaceVerdict;
  FieldTable t;
  add_column<uint32_t>(t, rows, "face", "", "row of the model's faces",
                       [](const V& v) { return v.face; });
  add_column<uint32_t>(t, rows, "ring", "", "row of its rings, of an opening; else 2^32 - 1",
                       [](const V& v) { return v.ring; });
  add_column<uint32_t>(t, rows, "part", "", "part of the model", [](const V& v) { return v.part; });
  add_column<uint32_t>(t, rows, "merged", "", "faces of one plane that it stands for",
                       [](const V& v) { return v.merged; });
  add_column<double>(t, rows, "area", "m2", "openings taken off",
                     [](const V& v) { return v.area_m2; });
  add_column<uint8_t>(t, rows, "kept", "", "1; 0 = left out, too small",
                      [](const V& v) { return v.kept ? 1 : 0; });
  add_column<uint32_t>(t, rows, "partner", "",
                       "row of its pair on the other side; 2^32 - 1 = unmatched",
                       [](const V& v) { return v.partner; });
  return t;
}

struct BorderColumn {
  const char* name;
  const char* unit;
  const char* meaning;
  double (*value)(const BorderComparison&);
};
constexpr BorderColumn kBorderColumns[] = {
    {"contour_precision", "1",
     "share of the automatic border within the tolerance of the reference",
     [](const BorderComparison& b) { return b.automatic.within; }},
    {"contour_recall", "1",
     "share of the reference border within the tolerance of the automatic one",
     [](const BorderComparison& b) { return b.reference.within; }},
    {"contour_f1", "1", "of these two", [](const BorderComparison& b) { return b.f1; }},
    {"contour_mean", "m", "mean distance of the automatic border from the reference",
     [](const BorderComparison& b) { return b.automatic.mean_m; }},
    {"contour_rms", "m", "root mean square of it",
     [](const BorderComparison& b) { return b.automatic.rms_m; }},
    {"contour_mean_back", "m", "mean distance of the reference border from the automatic one",
     [](const BorderComparison& b) { return b.reference.mean_m; }},
    {"contour_rms_back", "m", "root mean square of it",
     [](const BorderComparison& b) { return b.reference.rms_m; }},
    {"hausdorff95", "m", "95 % of both borders are nearer",
     [](const BorderComparison& b) { return b.hausdorff95_m; }},
    {"hausdorff", "m", "largest distance", [](const BorderComparison& b) { return b.hausdorff_m; }},
};

uint64_t unmatched(const std::vector<FaceVerdict>& side) {
  uint64_t n = 0;
  for (const FaceVerdict& v : side) n += v.kept && v.partner == FaceVerdict::kNoPartner;
  return n;
}

uint64_t left_out(const std::vector<FaceVerdict>& side) {
  uint64_t n = 0;
  for (const FaceVerdict& v : side) n += !v.kept;
  return n;
}

void add_spread(FieldTable& t, const ModelEvaluation& e, const char* name, const char* unit,
                double (*value)(const FacePair&)) {
  std::vector<double> values;
  for (const FacePair& pair : e.pairs) values.push_back(value(pair));
  const MeanAndStd spread = mean_and_std(values);
  add_value<double>(t, std::string("mean_") + name, unit, "over the pairs", spread.mean);
  add_value<double>(t, std::string("std_") + name, unit, "over the pairs, divided by n - 1",
                    spread.std);
}

}  // namespace

FieldTable face_pair_table(const ModelEvaluation& e) {
  using P = FacePair;
  FieldTable t;
  add_column<uint32_t>(t, e.pairs, "automatic", "", "row of the automatic side",
                       [](const P& p) { return p.automatic; });
  add_column<uint32_t>(t, e.pairs, "reference", "", "row of the reference side",
                       [](const P& p) { return p.reference; });
  for (const ColumnPtr& column : index_table(areas_of(e), e.formulas)) t.set(column);
  add_column<double>(t, e.pairs, "angle", "rad", "between the planes",
                     [](const P& p) { return p.angle_rad; });
  add_column<double>(t, e.pairs, "distance", "m",
                     "of the automatic face's middle beyond the reference's plane",
                     [](const P& p) { return p.distance_m; });
  add_column<uint8_t>(t, e.pairs, "same_class", "", "1: their parts have one class",
                      [](const P& p) { return p.same_class ? 1 : 0; });
  for (const BorderColumn& c : kBorderColumns)
    add_column<double>(t, e.pairs, c.name, c.unit, c.meaning,
                       [&](const P& p) { return c.value(p.borders); });
  return t;
}

FieldTable automatic_face_table(const ModelEvaluation& e) { return side_table(e.automatic); }
FieldTable reference_face_table(const ModelEvaluation& e) { return side_table(e.reference); }

FieldTable model_totals_table(const ModelEvaluation& e) {
  FieldTable t;
  add_value<uint64_t>(t, "pairs", "", "faces matched one to one", e.pairs.size());
  add_value<uint64_t>(t, "unmatched_automatic", "", "kept automatic faces without a pair",
                      unmatched(e.automatic));
  add_value<uint64_t>(t, "unmatched_reference", "", "kept reference faces without a pair",
                      unmatched(e.reference));
  add_value<uint64_t>(t, "left_out_automatic", "", "automatic faces below the smallest size",
                      left_out(e.automatic));
  add_value<uint64_t>(t, "left_out_reference", "", "reference faces below the smallest size",
                      left_out(e.reference));
  uint64_t same_class = 0;
  for (const FacePair& pair : e.pairs) same_class += pair.same_class;
  add_value<uint64_t>(t, "same_class", "", "pairs whose parts have one class", same_class);
  for (const ColumnPtr& column : index_totals_table(areas_of(e), e.unpaired, e.formulas))
    t.set(column);
  add_spread(t, e, "angle", "rad", [](const FacePair& p) { return p.angle_rad; });
  add_spread(t, e, "plane_distance", "m", [](const FacePair& p) { return p.distance_m; });
  for (const BorderColumn& c : kBorderColumns) {
    std::vector<double> values;
    for (const FacePair& pair : e.pairs) values.push_back(c.value(pair.borders));
    add_value<double>(t, std::string("mean_") + c.name, c.unit, "over the pairs",
                      mean_and_std(values).mean);
  }
  const double shift[] = {e.shift.x, e.shift.y, e.shift.z};
  t.set(make_column<double>(
      {"shift", ElementType::kFloat64, 3, "m", "of the automatic model, before comparing"}, shift));
  add_vertex_totals(t, e.vertices);
  return t;
}

}  // namespace jalon
