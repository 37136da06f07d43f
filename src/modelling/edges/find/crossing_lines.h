// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/edges/find/edge_line.h"
#include "modelling/plane/plane_frame.h"
#include "segment/labels/label_groups.h"
#include "segment/segmentation.h"

namespace jalon {

/// The lines, in the coordinates of one plane, in which the other planes of a segmentation meet or
/// cross it: those with points within reach_m of it or on both sides, and not parallel to it.
///
/// Before: segment is the index of the plane, frame its frame. After: in the order of the segments;
/// the direction says nothing about the solid. O(planes and the points of those that are near).
std::vector<EdgeLine> crossing_lines(const Segmentation& segmentation, const LabelGroups& groups,
                                     size_t segment, const PlaneFrame& frame, double reach_m);

}  // namespace jalon
