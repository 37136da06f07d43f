// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "base/task.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// Gives the surface features of its points, from their neighbours within radius_m; none where
/// there is no normal or too few neighbours. Distinct ones are at most `most` that lie farthest
/// from the mean (Rusu et al. 2009: what is not the same all over the scene, as planes are);
/// salient ones are a seventh of all points, at the most.
///
/// Normals come with either sign, so each point turns its own to the side where its neighbours lie,
/// and theirs to face a place above it on that side; a surface seen from behind has the same
/// features.
///
/// Before: points, normals and tree are set. After: features, distinct, salient and mean_feature
/// are.
void describe_features(CoarseSurface& surface, double radius_m, size_t most, Task& task);

/// Of two features, in feature space.
float squared_distance(const Feature& a, const Feature& b);

}  // namespace jalon
