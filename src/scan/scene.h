// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "scan/grammar_settings.h"
#include "scan/yard_settings.h"

namespace jalon {

enum class SceneName {
  kFacade,
  kStreet,
  kRoom,
  kBox,
  kSurrounds,
  kStrips,
  kInsa,
  kInsaSurveyed,
  kUnwanted,
  kStd,
  kNormal,
  kPatches,
  kSills,
  kRobbery,
  kLycee,
  kArches,
  kResidence,
  kEarthworks,
  kGrammar,
  kBow,
  kYard
};

/// Of the operation "scene"; the table of the rows says what each member means.
struct SceneSettings {
  SceneName name = SceneName::kFacade;
  double rotation_rad = 0;
  std::vector<double> shift_m{0, 0, 0};
  double width_m = 22, height_m = 10;
  int64_t storeys = 3, bays = 7, doors = 2;
  double reveal_m = 0.20, frame_m = 0, cornice_m = 0.35, ground_m = 6;
  int epoch = 1;  ///< of the street: 1 or 2
  int day = 1;    ///< of the earthworks: 1 to 4
  double glass_m = 0, gap_m = 0;
  double depth_m = 0.25;
  bool crossing = false;
  uint64_t seed = 1;
  GrammarSettings grammar{};
  YardSettings yard{};
};
std::span<const ParamRow> scene_rows();
Model build_scene(const SceneSettings& settings, Task& task);

}  // namespace jalon
