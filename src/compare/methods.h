// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"
#include "compare/comparison.h"
#include "model/model.h"

namespace jalon {

/// A way to compare, with its parameter table. Functions are nullptr where a method cannot do that.
struct CompareMethod {
  const char* name = nullptr;
  const char* owner = nullptr;  ///< of its parameters, in messages
  std::span<const ParamRow> (*rows)() = nullptr;
  Comparison (*run)(const CloudPtr& reference, const CloudPtr& compared, const ParamSet& params,
                    Task& task) = nullptr;
  Comparison (*run_model)(const ModelPtr& reference, const CloudPtr& compared,
                          const ParamSet& params, Task& task) = nullptr;
  /// At given core points.
  Comparison (*run_core)(const CloudPtr& reference, const CloudPtr& compared, const CloudPtr& core,
                         const ParamSet& params, Task& task) = nullptr;
  /// Sets the parameters from the text of another program's parameter file, all or nothing; gives
  /// back a line for every key that is not known.
  std::vector<std::string> (*read_file)(std::string_view text, ParamSet& params) = nullptr;
  /// Sets what the level of detection is to know of the alignment of the clouds.
  void (*use_registration)(std::span<const double> covariance36, const Vec3& centre,
                           ParamSet& params) = nullptr;
};

/// The default first.
std::span<const CompareMethod> compare_methods();
std::span<const char* const> compare_method_names();

}  // namespace jalon
