// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/voxel_flood.h"

#include <cmath>

namespace jalon {

namespace {

constexpr int kBitsOfSide = 3;

uint32_t within(int64_t x, int64_t y, int64_t z) {
  constexpr int64_t kMask = (1 << kBitsOfSide) - 1;
  return static_cast<uint32_t>((z & kMask) << 2 * kBitsOfSide | (y & kMask) << kBitsOfSide |
                               (x & kMask));
}

}  // namespace

size_t VoxelFlood::PlaceHash::operator()(const Place& place) const {
  // Odd factors of golden ratio and square roots, as of Fibonacci hashing (Knuth 1973, 6.4).
  uint64_t mixed = static_cast<uint64_t>(place.x) * 0x9e3779b97f4a7c15u ^
                   static_cast<uint64_t>(place.y) * 0xbf58476d1ce4e5b9u ^
                   static_cast<uint64_t>(place.z) * 0x94d049bb133111ebu;
  mixed ^= mixed >> 32;
  return mixed;
}

uint32_t VoxelFlood::add(const Vec3& place) {
  const auto number = [&](double coordinate) {
    return static_cast<int64_t>(std::floor(coordinate / cell_m_));
  };
  const int64_t x = number(place.x), y = number(place.y), z = number(place.z);
  const Place at{x >> kBitsOfSide, y >> kBitsOfSide, z >> kBitsOfSide};
  if (blocks_.empty() || !(blocks_[last_].place == at)) {
    const auto [found, is_added] = at_.try_emplace(at, static_cast<uint32_t>(blocks_.size()));
    if (is_added) blocks_.emplace_back(at);
    last_ = found->second;
  }
  const uint32_t voxel = last_ * kVoxels + within(x, y, z);
  set_bit(blocks_[last_].occupied, voxel);
  return voxel;
}

uint32_t VoxelFlood::neighbour(uint32_t block, int dx, int dy, int dz) {
  if (dx == 0 && dy == 0 && dz == 0) return block;
  uint32_t& known = blocks_[block].neighbours[static_cast<size_t>(9 * dz + 3 * dy + dx + 13)];
  if (known == kNotLookedFor) {
    const Place& here = blocks_[block].place;
    const auto found = at_.find(Place{here.x + dx, here.y + dy, here.z + dz});
    known = found == at_.end() ? kNone : found->second;
  }
  return known;
}

void VoxelFlood::reach(uint32_t voxel) {
  Block& block = blocks_[voxel / kVoxels];
  if (!bit(block.occupied, voxel) || bit(block.taken, voxel)) return;
  if (block.fresh == Bits{}) fresh_blocks_.push_back(voxel / kVoxels);
  set_bit(block.taken, voxel);
  set_bit(block.fresh, voxel);
  front_.push_back(voxel);
}

void VoxelFlood::take(uint32_t voxel) {
  reach(voxel);
  while (!front_.empty()) {
    const uint32_t here = front_.back();
    front_.pop_back();
    const uint32_t block = here / kVoxels, in = here % kVoxels;
    const int x = static_cast<int>(in % kSide), y = static_cast<int>(in / kSide % kSide),
              z = static_cast<int>(in / (kSide * kSide));
    constexpr int kEnd = static_cast<int>(kSide);
    const auto beyond = [](int at) { return at < 0 ? -1 : at == kEnd ? 1 : 0; };
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const uint32_t beside = neighbour(block, beyond(x + dx), beyond(y + dy), beyond(z + dz));
          if (beside < kNone) reach(beside * kVoxels + within(x + dx, y + dy, z + dz));
        }
  }
}

void VoxelFlood::settle() {
  for (const uint32_t block : fresh_blocks_) blocks_[block].fresh = {};
  fresh_blocks_.clear();
}

}  // namespace jalon
