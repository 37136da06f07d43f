// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/evaluations.h"

#include <algorithm>
#include <cstdint>

namespace jalon {

template <Maybe<SegmentPair> T>
auto members(T& p) {
  return std::tie(p.automatic, p.reference, p.card_automatic, p.card_reference, p.intersection,
                  p.angle_rad, p.distance_m, p.offset_m);
}
template <Maybe<SegmentVerdict> T>
auto members(T& v) {
  return std::tie(v.points, v.kept, v.partner, v.parts, v.covered);
}
template <Maybe<EvaluationTotals> T>
auto members(T& t) {
  return std::tie(t.pairs, t.unmatched_automatic, t.unmatched_reference, t.left_out_automatic,
                  t.left_out_reference, t.over_segmented, t.under_segmented, t.non_segmented,
                  t.card_automatic, t.card_reference, t.intersection, t.global_tdr, t.global_tda,
                  t.global_iou, t.mean_tdr, t.mean_tda, t.mean_iou, t.detection, t.accuracy,
                  t.angle_rad.mean, t.angle_rad.deviation, t.distance_m.mean,
                  t.distance_m.deviation, t.offset_m.mean, t.offset_m.deviation);
}
template <Maybe<FaceVerdict> T>
auto members(T& v) {
  return std::tie(v.face, v.ring, v.part, v.merged, v.area_m2, v.kept, v.partner);
}
template <Maybe<ComparedAreas> T>
auto members(T& a) {
  return std::tie(a.automatic_m2, a.reference_m2, a.intersection_m2);
}
template <Maybe<BorderSpread> T>
auto members(T& s) {
  return std::tie(s.mean_m, s.rms_m, s.q95_m, s.max_m, s.within);
}
template <Maybe<FacePair> T>
auto members(T& p) {
  return std::tie(p.automatic, p.reference, p.areas, p.angle_rad, p.distance_m, p.same_class,
                  p.borders.automatic, p.borders.reference, p.borders.f1, p.borders.hausdorff_m,
                  p.borders.hausdorff95_m);
}
template <Maybe<VertexPair> T>
auto members(T& p) {
  return std::tie(p.automatic, p.reference, p.deviation, p.in_facade, p.normalised);
}

namespace {

// What two segments share is of both, so that neither what is left of one nor what both have together wraps.
template <class T>
bool shares_what_it_has(const T& t) {
  return t.intersection <= t.card_automatic && t.intersection <= t.card_reference &&
         t.card_automatic <= UINT64_MAX - t.card_reference;
}

}  // namespace

void write_evaluation(ByteWriter& writer, const Evaluation& evaluation) {
  writer.list(evaluation.pairs);
  writer.list(evaluation.automatic);
  writer.list(evaluation.reference);
  writer.list(evaluation.automatic_source);
  writer.list(evaluation.reference_source);
  writer.item(evaluation.totals);
}

Evaluation read_evaluation(ByteReader& reader) {
  Evaluation out;
  reader.list(out.pairs);
  reader.list(out.automatic);
  reader.list(out.reference);
  reader.list(out.automatic_source);
  reader.list(out.reference_source);
  reader.item(out.totals);
  if (out.automatic_source.size() != out.automatic.size() ||
      out.reference_source.size() != out.reference.size())
    reader.refuse("the segments and their labels differ in number");
  if (!std::all_of(out.pairs.begin(), out.pairs.end(), shares_what_it_has<SegmentPair>) ||
      !shares_what_it_has(out.totals))
    reader.refuse("a pair shares more points than its segments have");
  return out;
}

void write_model_evaluation(ByteWriter& writer, const ModelEvaluation& evaluation) {
  writer.list(evaluation.automatic);
  writer.list(evaluation.reference);
  writer.list(evaluation.pairs);
  writer.list(evaluation.vertices);
  writer.item(evaluation.unpaired);
  writer.item(evaluation.shift);
  writer.item(evaluation.formulas);
}

ModelEvaluation read_model_evaluation(ByteReader& reader) {
  ModelEvaluation out;
  reader.list(out.automatic);
  reader.list(out.reference);
  reader.list(out.pairs);
  reader.list(out.vertices);
  reader.item(out.unpaired);
  reader.item(out.shift);
  reader.item(out.formulas);
  if (out.formulas != IndexFormulas::kCanonical && out.formulas != IndexFormulas::kThesis)
    reader.refuse("the formulas are unknown");
  for (const FacePair& pair : out.pairs)
    if (pair.automatic >= out.automatic.size() || pair.reference >= out.reference.size())
      reader.refuse("a pair has a face that is not there");
  return out;
}

void write_noise_law(ByteWriter& writer, const NoiseLaw& law) { writer.text(to_json(law)); }

NoiseLaw read_noise_law(ByteReader& reader) {
  const std::string json = reader.text();
  try {
    return noise_law_from_json(json);
  } catch (const Error& error) {
    reader.refuse("%s", error.what());
  }
}

}  // namespace jalon
