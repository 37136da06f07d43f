// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/params.h"
#include "base/task.h"
#include "registration/registration.h"
#include "registration/targets/settings.h"

namespace jalon {

/// A point known in one frame: a measured target, or a control point.
struct Target {
  std::string name;  ///< empty: unnamed
  Vec3 xyz;
  std::array<double, 9> covariance{};  ///< m2; all 0: the parameter's
};

/// Parameter table of method "targets".
std::span<const ParamRow> targets_rows();
/// The rigid or similarity motion that lays the moving targets onto the reference targets. Legend:
/// adjustment.h.
/// 1. Pairs by name, the rest by distances.
/// 2. Closed form.
/// 3. Weighted adjustment.
/// 4. Data snooping, on demand with removal.
Registration register_targets(std::span<const Target> reference, std::span<const Target> moving,
                              const TargetSettings& settings, Task& task);

}  // namespace jalon
