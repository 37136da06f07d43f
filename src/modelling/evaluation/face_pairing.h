// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/evaluation/compared_faces.h"
#include "modelling/evaluation/model_evaluation.h"

namespace jalon {

/// Pairs faces one to one so that the sum of the shared areas is largest (optimal assignment, Kuhn 1955), among those
/// whose planes agree and whose intersection over union reaches min_iou. shift: added to the automatic faces. Gives
/// areas, angle and distance of the pairs, ascending by reference.
std::vector<FacePair> pair_faces(std::span<const ComparedFace> automatic,
                                 std::span<const ComparedFace> reference, const Vec3& shift,
                                 const FaceChoice& choice, double min_iou, Task& task);

}  // namespace jalon
