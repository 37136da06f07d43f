// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "segment/segmentation.h"

namespace jalon {

/// A way to make a model of a segmentation, with its parameter table.
struct ModellingMethod {
  const char* name;
  const char* owner;  ///< of its parameters, in messages
  std::span<const ParamRow> (*rows)();
  Model (*run)(const Segmentation& segmentation, const ParamSet& params, Task& task);
};

/// All of them, the default first.
std::span<const ModellingMethod> modelling_methods();
std::span<const char* const> modelling_method_names();

}  // namespace jalon
