// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/buffer.h"
#include "base/task.h"

namespace jalon {

/// Queries by the reference point that is nearest to them: those of position p in ascending order.
class NearestGroups {
 public:
  /// nearest: for each query the sorted position of its reference point (below references) or kNoPoint.
  NearestGroups(std::span<const uint32_t> nearest, size_t references, Task& task);
  std::span<const uint32_t> operator[](size_t position) const {
    return {queries_.data() + begins_[position], begins_[position + 1] - begins_[position]};
  }

 private:
  Buffer<uint32_t> queries_, begins_;
};

}  // namespace jalon
