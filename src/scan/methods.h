// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "model/trajectory/trajectory.h"
#include "scan/scanner.h"

namespace jalon {

/// A way to make a cloud of a model, with its parameter table; functions that it does not have are
/// nullptr. The only list of them: what the
/// library offers by name comes from here.
struct ScannerMethod {
  const char* name;
  const char* owner;  ///< of its parameters, in messages
  std::span<const ParamRow> (*rows)();
  Cloud (*scan)(const Model& model, std::span<const ScanStation> stations, const ParamSet& params,
                Task& task);
  FieldTable (*truth)(const Model& model, const Cloud* cloud, const ParamSet& params, Task& task);
  Cloud (*drive)(const Model& model, const Trajectory& trajectory, const ParamSet& params,
                 Task& task);
};
std::span<const ScannerMethod> scanner_methods();
std::span<const char* const> scanner_method_names();

}  // namespace jalon
