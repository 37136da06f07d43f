// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/task.h"
#include "scan/builder/builder.h"
#include "scan/scene.h"

namespace jalon {

/// Where the scene "yard" stands (Lambert 2008 of its survey), before the caller's turn and shift.
constexpr double kYardShift_m[] = {734500, 642100, 0};

/// The scene "yard": buildings of corrugated sheet with doors, windows and gutters, targets, ground, bushes, eaves.
void build_yard(const SceneSettings& settings, SceneBuilder& out);

/// What a surveyor would bring along, and what is true of the scene.
struct YardTruth {
  std::vector<std::string> survey, targets;  ///< lines of code lists, in the world's coordinates
  std::vector<uint8_t> face_classes;         ///< 0 rest ... 4 gutters; of face ids from 1 on
};
YardTruth yard_truth(const SceneSettings& settings);
/// As text; docs of the shape: jalon_scene_write_truth.
std::string json_of(const YardTruth& truth, const SceneSettings& settings);

}  // namespace jalon
