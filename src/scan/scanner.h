// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"

namespace jalon {

struct ScanStation {
  std::string name;
  Transform pose;  ///< T_world_scanner, a rigid motion
};

/// Field "face" of points that no face gave.
constexpr uint32_t kNoFace = 0xffffffffu;

/// Throws kInvalidArgument unless the transform is a rotation and a shift (to 1e-6) of finite numbers.
void require_rigid(const Transform& pose);

/// Two or four tripods 1.7 m above the lowest point of the model, by the way its upright triangles face: in front of
/// a facade at 0.6 x its width; inside a street or a room, on its long axis; at the corners around a building. None
/// without upright triangles.
std::vector<ScanStation> automatic_stations(const Model& model);

/// Parameter table of method "static".
std::span<const ParamRow> static_scanner_rows();
/// Fields "face" (uint32), "true_xyz" (float64 x 3), "range" (float32), on demand "incidence_angle" (float32); one
/// cloud station a scan station. Without stations the automatic ones are taken.
Cloud scan_static(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task);

/// Parameter table of the operation "scene" and its builder.
std::span<const ParamRow> scene_rows();
Model build_scene(const ParamSet& params, Task& task);

}  // namespace jalon
