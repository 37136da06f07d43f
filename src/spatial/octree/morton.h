// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jalon {

/// Morton codes: groups of 3 bits x y z, one group a level, level 1 in the most significant place (Girardeau-Montaut
/// 2006, 4.2).

/// Bit i of v (21 bits) to bit 3 i.
constexpr uint64_t spread_bits(uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffffull;
  v = (v | v << 16) & 0x001f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  v = (v | v << 2) & 0x1249249249249249ull;
  return v;
}
/// The reverse.
constexpr uint32_t gather_bits(uint64_t v) {
  v &= 0x1249249249249249ull;
  v = (v | v >> 2) & 0x10c30c30c30c30c3ull;
  v = (v | v >> 4) & 0x100f00f00f00f00full;
  v = (v | v >> 8) & 0x001f0000ff0000ffull;
  v = (v | v >> 16) & 0x001f00000000ffffull;
  v = (v | v >> 32) & 0x1fffff;
  return static_cast<uint32_t>(v);
}

/// Cell numbers p, q, r < 2^level to the code of 3 * level bits.
constexpr uint64_t morton_code(uint32_t p, uint32_t q, uint32_t r) {
  return spread_bits(p) << 2 | spread_bits(q) << 1 | spread_bits(r);
}

struct CellNumbers {
  uint32_t p, q, r;
};
constexpr CellNumbers cell_numbers(uint64_t code) {
  return {gather_bits(code >> 2), gather_bits(code >> 1), gather_bits(code)};
}

/// Bits of one axis (0 = x, 1 = y, 2 = z) in a code of this level.
constexpr uint64_t axis_mask(int level, int axis) {
  const uint64_t all = (uint64_t{1} << 3 * level) - 1;
  return (0x1249249249249249ull << (2 - axis)) & all;
}
/// The next cell along an axis, without taking the code apart (2.2, method A); false at the border of the cube.
constexpr bool increment_cell(uint64_t& code, int level, int axis) {
  const uint64_t mask = axis_mask(level, axis);
  if ((code & mask) == mask) return false;
  code = (((code | ~mask) + 1) & mask) | (code & ~mask);
  return true;
}
constexpr bool decrement_cell(uint64_t& code, int level, int axis) {
  const uint64_t mask = axis_mask(level, axis);
  if ((code & mask) == 0) return false;
  code = (((code & mask) - (mask & (~mask + 1))) & mask) | (code & ~mask);
  return true;
}

}  // namespace jalon
