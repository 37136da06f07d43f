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

/// Parameter table of method "static".
std::span<const ParamRow> static_scanner_rows();
/// Fields "face" (uint32), "true_xyz" (float64 x 3), "range" (float32); one cloud station a scan station.
Cloud scan_static(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task);

/// Parameter table of the operation "scene" and its builder.
std::span<const ParamRow> scene_rows();
Model build_scene(const ParamSet& params, Task& task);

}  // namespace jalon
