// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"

namespace jalon {

/// Parameter table of operation "model_sample".
std::span<const ParamRow> model_sample_rows();
/// Points on all surfaces of a model, uniform by area (octree-and-applications 2.23), with fields "normal", "face",
/// "triangle", "part".
Cloud sample_model(const Model& model, const ParamSet& params, Task& task);

}  // namespace jalon
