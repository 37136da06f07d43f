// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/evaluation/evaluation.h"

namespace jalon {

// Steps of evaluate_segmentation.

/// Points that both segments hold.
struct Overlap {
  uint32_t automatic = 0, reference = 0;  ///< labels of kept segments
  uint64_t points = 0;
};

/// Non-empty overlaps of the kept segments, ascending by reference, then automatic label.
std::vector<Overlap> count_overlaps(const Segmentation& automatic, const Segmentation& reference,
                                    const Evaluation& verdicts, Task& task);
/// Pairs of the largest total overlap among those of at least min_iou; fills pairs and partners.
void pair_segments(std::span<const Overlap> overlaps, double min_iou, Evaluation& out, Task& task);
/// Angle, mean distance and offset of each pair; NaN where a side has no plane.
void compare_planes(const Segmentation& automatic, const Segmentation& reference,
                    std::vector<SegmentPair>& pairs, Task& task);
/// Sums, means and counts over everything found.
EvaluationTotals total_up(const Evaluation& evaluation, double covered_share);

}  // namespace jalon
