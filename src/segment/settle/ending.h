// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"
#include "segment/segmentation.h"
#include "segment/settle/assignment.h"

namespace jalon {

// What the methods that find planes share: the check before them and the steps after them.

/// kInsufficientData below 3 points, kDegenerate when all are equal or on one line: nothing that a plane could be
/// fitted to.
void require_area(const Cloud& cloud, Task& task);

/// All points shared out anew among all planes, which are refitted after each round.
void share_out_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);
/// The same once more, when surfaces were joined meanwhile.
void share_out_points(SegmentScene& scene, std::vector<Surface>& surfaces, Assignment& assignment,
                      Task& task);

/// Refinement by global planarity where it is asked for, last fit, normals turned, orientation classes, facade frame,
/// tables of points and segments; all but parameters_json. Sorts the surfaces, largest first. After: neither they nor
/// the scene hold points any more.
Segmentation finish_segmentation(const CloudPtr& cloud, SegmentScene& scene,
                                 std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon
