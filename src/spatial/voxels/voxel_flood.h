// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Occupied voxels about the origin, and what hangs together with some of them over faces, edges and corners: the
/// pieces of connected_components with 26 neighbours, of which only those that are asked for are gone through. A point
/// costs the finding of its voxel, which is quick where the last point lies near; voxels are bits, in blocks of 512.
class VoxelFlood {
 public:
  explicit VoxelFlood(double cell_m) : cell_m_(cell_m) {}

  /// The number of the voxel at a place, which is occupied from then on. Not after the first take().
  uint32_t add(const Vec3& place);

  /// Takes the piece that holds a voxel, unless it was.
  void take(uint32_t voxel);
  /// Is it of a piece that was taken since the last settle()?
  bool is_new(uint32_t voxel) const { return bit(blocks_[voxel / kVoxels].fresh, voxel); }
  bool has_new() const { return !fresh_blocks_.empty(); }
  /// What was taken is new no more.
  void settle();
  /// Is it of a piece that was taken before the last settle()?
  bool is_settled(uint32_t voxel) const {
    return bit(blocks_[voxel / kVoxels].taken, voxel) && !is_new(voxel);
  }

 private:
  static constexpr uint32_t kSide = 8, kVoxels = kSide * kSide * kSide, kNeighbours = 27;
  static constexpr uint32_t kNotLookedFor = 0xffffffffu, kNone = 0xfffffffeu;
  using Bits = std::array<uint64_t, kVoxels / 64>;

  struct Place {
    int64_t x, y, z;
    bool operator==(const Place&) const = default;
  };
  struct PlaceHash {
    size_t operator()(const Place& place) const;
  };
  struct Block {
    explicit Block(const Place& at) : place(at) { neighbours.fill(kNotLookedFor); }
    Place place;
    Bits occupied{}, taken{}, fresh{};
    std::array<uint32_t, kNeighbours> neighbours;
  };

  static bool bit(const Bits& bits, uint32_t voxel) {
    return (bits[voxel % kVoxels / 64] >> voxel % 64 & 1) != 0;
  }
  static void set_bit(Bits& bits, uint32_t voxel) {
    bits[voxel % kVoxels / 64] |= uint64_t{1} << voxel % 64;
  }
  uint32_t neighbour(uint32_t block, int dx, int dy, int dz);
  void reach(uint32_t voxel);

  double cell_m_;
  std::vector<Block> blocks_;
  std::unordered_map<Place, uint32_t, PlaceHash> at_;
  uint32_t last_ = 0;                   ///< the block that add() found last
  std::vector<uint32_t> fresh_blocks_;  ///< that may have new voxels
  std::vector<uint32_t> front_;         ///< voxels taken whose neighbours are to be looked at
};

}  // namespace jalon
