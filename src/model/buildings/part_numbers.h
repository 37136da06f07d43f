// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace jalon {

/// Which of the blocks, facades and strips stand above a part, numbered from 0 in the order of the
/// parts of that class; UINT32_MAX: none.
struct PartNumbers {
  uint32_t block, facade, strip;
};
/// Of each part.
std::vector<PartNumbers> part_numbers(const Model& model);

}  // namespace jalon
