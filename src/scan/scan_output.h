// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "base/buffer.h"
#include "base/field.h"
#include "cloud/cloud.h"

namespace jalon {

/// Columns of a cloud to be, of every scanner: the points and their truth.
struct ScanOutput {
  explicit ScanOutput(size_t n);
  void set_point(size_t i, const Vec3& measured, const Vec3& exact, uint32_t face_id,
                 uint32_t true_segment);
  /// Moves everything out.
  Cloud take();

  Buffer<double> xyz;
  std::shared_ptr<Column> face, segment, true_xyz;
};

/// To whole metres and multiples of the step, relative to an origin of whole metres; a step of 0 changes nothing.
Vec3 stepped(Vec3 p, double step_m);

/// What is added to all coordinates at the end; throws kInvalidArgument unless there are three
/// numbers.
Vec3 offset_of(std::span<const double> offset_m);

}  // namespace jalon
