// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/evaluation/evaluation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "segment/evaluation/parts.h"

namespace jalon {

namespace {

constexpr size_t kEvaluationPointsPerChunk = 1 << 15;
constexpr size_t kNone = ~size_t{0};

struct FirstIndex {
  size_t index = kNone;
  FirstIndex& operator+=(const FirstIndex& b) {
    index = std::min(index, b.index);
    return *this;
  }
};

// The same points in the same order, up to what file formats round.
void require_same_points(const Cloud& a, const Cloud& b, double tolerance_m, Task& task) {
  if (a.xyz_buffer == b.xyz_buffer) return;
  if (a.size() != b.size())
    fail(Status::kInvalidArgument,
         "the automatic segmentation has %zu points, the reference %zu: both must be of one cloud",
         a.size(), b.size());
  const FirstIndex none;
  const FirstIndex first = parallel_reduce(task, a.size(), kEvaluationPointsPerChunk, none,
                                           [&](size_t begin, size_t end) {
                                             for (size_t i = begin; i < end; ++i)
                                               if (!(norm(a.point(i) - b.point(i)) <= tolerance_m))
                                                 return FirstIndex{i};
                                             return none;
                                           });
  if (first.index != kNone)
    fail(Status::kInvalidArgument,
         "point %zu of the automatic segmentation is not point %zu of the reference: both must be "
         "of one cloud",
         first.index, first.index);
}

// The same threshold for both sides (5.5.3.2: details that are too small to matter are left out of the reference).
std::vector<SegmentVerdict> judge_sizes(const Segmentation& s, const EvaluationSettings& settings) {
  std::vector<SegmentVerdict> out;
  out.reserve(s.segments.size());
  for (const Segment& segment : s.segments) {
    SegmentVerdict verdict;
    verdict.points = segment.point_count();
    verdict.kept = segment.point_count() >= std::max<uint64_t>(1, settings.min_points) &&
                   (settings.min_area_m2 <= 0 || segment.area_m2 >= settings.min_area_m2);
    out.push_back(verdict);
  }
  return out;
}

// Which points are found on the other side at all, and which segments are parts of which.
void judge_overlaps(std::span<const Overlap> overlaps, double part_share, Evaluation& out) {
  for (const Overlap& overlap : overlaps) {
    SegmentVerdict &a = out.automatic[overlap.automatic - 1],
                   &r = out.reference[overlap.reference - 1];
    a.covered += overlap.points;
    r.covered += overlap.points;
    const double points = static_cast<double>(overlap.points);
    if (points >= part_share * static_cast<double>(a.points)) ++r.parts;
    if (points >= part_share * static_cast<double>(r.points)) ++a.parts;
  }
}

std::vector<int64_t> source_labels(const Segmentation& s) {
  std::vector<int64_t> out;
  for (const Segment& segment : s.segments)
    out.push_back(segment.source_label != 0 ? segment.source_label : segment.label);
  return out;
}

constexpr auto kEvaluationRows = setting_rows(
    integer_row<&EvaluationSettings::min_points>(
        "min_points", 0, 4e9, "points", "",
        "Segments of fewer points are left out, on both sides; give the segmenter's own."),
    number_row<&EvaluationSettings::min_area_m2>(
        "min_area_m2", 0, 1e9, "m2", "",
        "Segments of a smaller area are left out, on both sides; give the segmenter's own."),
    number_row<&EvaluationSettings::min_iou>(
        "min_iou", 0, 1, "1", "",
        "Segments that overlap less (intersection over union) are no pair: chance contacts "
        "stay unmatched."),
    number_row<&EvaluationSettings::part_share>(
        "part_share", 0.5, 1, "1", "",
        "A segment is a part of another when this share of its points lies in it: a reference "
        "with 2 parts is over-segmented, an automatic segment with 2 is under-segmented."),
    number_row<&EvaluationSettings::covered_share>(
        "covered_share", 0, 1, "1", "",
        "A reference is non-segmented when automatic segments hold less than this share of "
        "its points."),
    number_row<&EvaluationSettings::coordinate_tolerance_m>(
        "coordinate_tolerance_m", 0, 1, "m", "",
        "Largest distance between the two clouds' points of one index: a radius, what file "
        "formats round."));

}  // namespace

std::span<const ParamRow> evaluation_rows() { return kEvaluationRows; }

// 1. same points; 2. same size threshold; 3. overlaps; 4. pairs; 5. geometry; 6. totals.
Evaluation evaluate_segmentation(const Segmentation& automatic, const Segmentation& reference,
                                 const EvaluationSettings& settings, Task& task) {
  Evaluation out;
  {
    ProgressSpan span(task, 0, 0.1, "comparing points");
    require_same_points(*automatic.cloud, *reference.cloud, settings.coordinate_tolerance_m, task);
  }
  out.automatic = judge_sizes(automatic, settings);
  out.reference = judge_sizes(reference, settings);
  out.automatic_source = source_labels(automatic);
  out.reference_source = source_labels(reference);
  const std::vector<Overlap> overlaps = [&] {
    ProgressSpan span(task, 0.1, 0.4, "counting overlaps");
    return count_overlaps(automatic, reference, out, task);
  }();
  judge_overlaps(overlaps, settings.part_share, out);
  {
    ProgressSpan span(task, 0.4, 0.6, "pairing segments");
    pair_segments(overlaps, settings.min_iou, out, task);
  }
  ProgressSpan span(task, 0.6, 1, "comparing planes");
  compare_planes(automatic, reference, out.pairs, task);
  out.totals = total_up(out, settings.covered_share);
  return out;
}

}  // namespace jalon
