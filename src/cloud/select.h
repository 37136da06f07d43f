// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// select() of indices that are known to be good.
Cloud select_unchecked(const Cloud& cloud, std::span<const uint64_t> indices, Task& task);
/// The same of ascending indices without repeats: when all are kept, the result shares the points and their index.
Cloud select_kept(const Cloud& cloud, std::span<const uint64_t> ascending, Task& task);
/// Where the mask has this value, ascending.
std::vector<uint64_t> indices_of(std::span<const uint8_t> mask, uint8_t value, Task& task);

}  // namespace jalon
