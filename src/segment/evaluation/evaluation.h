// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "base/numbers.h"
#include "segment/segmentation.h"

namespace jalon {

/// An automatic segment A and the reference segment SR it stands for (2010 thesis, 5.5.3.2).
struct SegmentPair {
  uint32_t automatic = 0, reference = 0;  ///< labels
  uint64_t card_automatic = 0, card_reference = 0, intersection = 0;
  double angle_rad = kNaN;   ///< between the normals, 0 ... pi / 2 (5.11)
  double distance_m = kNaN;  ///< mean distance of A's points from SR's plane
  double offset_m = kNaN;    ///< A's plane beyond SR's along SR's normal, at A's centroid

  uint64_t commission() const { return card_automatic - intersection; }  ///< D+
  uint64_t omission() const { return card_reference - intersection; }    ///< D-
  double tdr() const {
    return static_cast<double>(intersection) / static_cast<double>(card_reference);
  }  ///< (5.10)
  double tda() const {
    return static_cast<double>(intersection) / static_cast<double>(card_automatic);
  }  ///< (5.9)
  double iou() const {
    return static_cast<double>(intersection) /
           static_cast<double>(card_automatic + card_reference - intersection);
  }
};

/// A segment of one side as the other side sees it.
struct SegmentVerdict {
  uint64_t points = 0;
  bool kept = true;      ///< not below min_points or min_area_m2
  uint32_t partner = 0;  ///< label on the other side; 0 = unmatched
  uint32_t parts = 0;    ///< segments of the other side that lie mostly in it
  uint64_t covered = 0;  ///< its points that any kept segment of the other side holds
};

struct MeanAndDeviation {
  double mean = kNaN, deviation = kNaN;  ///< of the values that are numbers; deviation with n - 1
};

struct EvaluationTotals {
  uint64_t pairs = 0, unmatched_automatic = 0, unmatched_reference = 0;
  uint64_t left_out_automatic = 0, left_out_reference = 0;
  uint64_t over_segmented = 0, under_segmented = 0, non_segmented = 0;
  uint64_t card_automatic = 0, card_reference = 0, intersection = 0;  ///< sums over the pairs
  double global_tdr = kNaN, global_tda = kNaN, global_iou = kNaN;     ///< of those sums
  double mean_tdr = kNaN, mean_tda = kNaN, mean_iou = kNaN;           ///< over the pairs
  double detection = kNaN;  ///< mean TDR over all kept reference segments, unmatched ones as 0
  double accuracy = kNaN;   ///< mean TDA over all kept automatic segments, unmatched ones as 0
  MeanAndDeviation angle_rad, distance_m, offset_m;
};

/// What evaluate_segmentation finds; immutable.
struct Evaluation {
  std::vector<SegmentPair> pairs;                    ///< ascending by reference label
  std::vector<SegmentVerdict> automatic, reference;  ///< row s is label s + 1
  std::vector<int64_t> automatic_source,
      reference_source;  ///< their labels in the fields they were made from
  EvaluationTotals totals;
};

/// The parameters of operation "evaluation".
struct EvaluationSettings {
  uint64_t min_points = 0;  ///< of a segment that counts
  double min_area_m2 = 0;
  double min_iou = 0.1;        ///< of a pair
  double part_share = 0.5;     ///< of the points of a segment that is a part of another
  double covered_share = 0.5;  ///< of the points of a reference that is found at all
  double coordinate_tolerance_m = 0.001;
};
std::span<const ParamRow> evaluation_rows();

/// Two segmentations of one cloud (points equal by index): overlaps, one-to-one pairs of the largest total overlap,
/// geometry of the pairs, counts of over-, under- and non-segmentation.
Evaluation evaluate_segmentation(const Segmentation& automatic, const Segmentation& reference,
                                 const EvaluationSettings& settings, Task& task);

/// The tables of jalon/evaluate.h.
FieldTable pair_table(const Evaluation& evaluation);
FieldTable automatic_table(const Evaluation& evaluation);
FieldTable reference_table(const Evaluation& evaluation);
FieldTable totals_table(const Evaluation& evaluation);

}  // namespace jalon
