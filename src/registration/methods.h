// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/registration.h"

namespace jalon {

struct Target;

/// A way to find a pose: of clouds, of targets, or of both.
struct RegistrationMethod {
  const char* name;
  const char* owner;  ///< of its parameters
  std::span<const ParamRow> (*rows)();
  /// Of clouds, or nullptr.
  Registration (*run)(const CloudPtr& reference, const CloudPtr& moving, const Transform& T_start,
                      const ParamSet&, Task&);
  /// Of targets, or nullptr.
  Registration (*run_targets)(std::span<const Target> reference, std::span<const Target> moving,
                              const ParamSet&, Task&);
};
/// All there are; the first is the default.
std::span<const RegistrationMethod> registration_methods();
std::span<const char* const> registration_method_names();

}  // namespace jalon
