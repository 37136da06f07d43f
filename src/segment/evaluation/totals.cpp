// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/numbers.h"
#include "segment/evaluation/parts.h"

namespace jalon {

namespace {

double ratio_of_totals(double a, double b) { return b > 0 ? a / b : kNaN; }
double ratio_of_totals(uint64_t a, uint64_t b) {
  return ratio_of_totals(static_cast<double>(a), static_cast<double>(b));
}

// Mean and deviation of what value(pair) gives, NaN left out.
template <class F>
MeanAndDeviation spread(const std::vector<SegmentPair>& pairs, F&& value) {
  double sum = 0, squares = 0;
  size_t n = 0;
  for (const SegmentPair& pair : pairs)
    if (const double v = value(pair); std::isfinite(v)) sum += v, ++n;
  MeanAndDeviation out;
  if (n == 0) return out;
  out.mean = sum / static_cast<double>(n);
  for (const SegmentPair& pair : pairs)
    if (const double v = value(pair); std::isfinite(v)) squares += (v - out.mean) * (v - out.mean);
  if (n > 1) out.deviation = std::sqrt(squares / static_cast<double>(n - 1));
  return out;
}

void count_verdicts(const std::vector<SegmentVerdict>& side, uint64_t& left_out,
                    uint64_t& unmatched, uint64_t& in_parts) {
  for (const SegmentVerdict& verdict : side) {
    if (!verdict.kept) {
      ++left_out;
      continue;
    }
    if (verdict.partner == 0) ++unmatched;
    if (verdict.parts >= 2) ++in_parts;
  }
}

}  // namespace

EvaluationTotals total_up(const Evaluation& e, double covered_share) {
  EvaluationTotals t;
  t.pairs = e.pairs.size();
  count_verdicts(e.automatic, t.left_out_automatic, t.unmatched_automatic, t.under_segmented);
  count_verdicts(e.reference, t.left_out_reference, t.unmatched_reference, t.over_segmented);
  for (const SegmentVerdict& r : e.reference)
    if (r.kept && static_cast<double>(r.covered) < covered_share * static_cast<double>(r.points))
      ++t.non_segmented;
  double tdr = 0, tda = 0, iou = 0;
  for (const SegmentPair& pair : e.pairs) {
    t.card_automatic += pair.card_automatic;
    t.card_reference += pair.card_reference;
    t.intersection += pair.intersection;
    tdr += pair.tdr();
    tda += pair.tda();
    iou += pair.iou();
  }
  t.global_tdr = ratio_of_totals(t.intersection, t.card_reference);
  t.global_tda = ratio_of_totals(t.intersection, t.card_automatic);
  t.global_iou =
      ratio_of_totals(t.intersection, t.card_automatic + t.card_reference - t.intersection);
  const double pairs = static_cast<double>(t.pairs);
  t.mean_tdr = ratio_of_totals(tdr, pairs);
  t.mean_tda = ratio_of_totals(tda, pairs);
  t.mean_iou = ratio_of_totals(iou, pairs);
  t.detection = ratio_of_totals(tdr, static_cast<double>(t.pairs + t.unmatched_reference));
  t.accuracy = ratio_of_totals(tda, static_cast<double>(t.pairs + t.unmatched_automatic));
  t.angle_rad = spread(e.pairs, [](const SegmentPair& p) { return p.angle_rad; });
  t.distance_m = spread(e.pairs, [](const SegmentPair& p) { return p.distance_m; });
  t.offset_m = spread(e.pairs, [](const SegmentPair& p) { return p.offset_m; });
  return t;
}

}  // namespace jalon
