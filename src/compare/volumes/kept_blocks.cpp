// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/kept_blocks.h"

namespace jalon {

KeptBlocks::KeptBlocks(std::span<const uint8_t> has_points) {
  const size_t blocks = has_points.size();
  const auto has = [&](size_t block) { return block < blocks && has_points[block] != 0; };
  place_.resize(blocks);
  for (size_t block = 0; block < blocks; ++block) {
    place_[block] = static_cast<uint32_t>(block_.size());
    const bool is_end = block == 0 || block + 1 == blocks;
    if (is_end || has(block - 1) || has(block) || has(block + 1))
      block_.push_back(static_cast<uint32_t>(block));
  }
  left_out_ = static_cast<uint32_t>(blocks - block_.size()) * kBlock;
  if (left_out_ == 0) *this = {};
}

}  // namespace jalon
