// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"

namespace jalon {

struct ModelSampleSettings {
  uint64_t points = 0;      ///< 0: by the spacing
  double spacing_m = 0.05;  ///< one point a square of this side on the average
  double chord_error_m = 1e-4;
  uint64_t seed = 1;
};
/// Parameter table of operation "model_sample".
std::span<const ParamRow> model_sample_rows();
/// Points on all surfaces of a model, uniform by area (Girardeau-Montaut 2006, C.2), with fields "normal", "face",
/// "triangle", "part".
Cloud sample_model(const Model& model, const ModelSampleSettings& settings, Task& task);

}  // namespace jalon
