// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "segment/segmentation.h"

namespace jalon {

/// A way to find segments.
struct SegmentMethod {
  const char* name;
  const char* owner;  ///< of its parameters
  std::span<const ParamRow> (*rows)();
  Segmentation (*run)(const CloudPtr&, const ParamSet&, Task&);
};
/// All there are; the first is the default.
std::span<const SegmentMethod> segment_methods();
std::span<const char* const> segment_method_names();

}  // namespace jalon
