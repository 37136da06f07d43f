// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>

#include "model/model.h"

namespace jalon {

/// Vertices of files that name places by their bare coordinates: equal ones become one.
class EqualVertices {
 public:
  explicit EqualVertices(Model& model) : model_(model) {}

  uint32_t add(const Vec3& p) {
    const Vec3 q{p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0 and 0 are the same place
    const auto [entry, added] =
        index_.try_emplace(q, static_cast<uint32_t>(model_.vertices.size()));
    if (added) model_.vertices.push_back(p);
    return entry->second;
  }

 private:
  struct Hash {
    size_t operator()(const Vec3& p) const {
      uint64_t h =
          0x9E3779B97F4A7C15u;  // splitmix64 (Steele et al. 2014) over the bits of the coordinates
      for (int k = 0; k < 3; ++k) {
        h ^= std::bit_cast<uint64_t>(p[k]);
        h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
        h ^= h >> 31;
      }
      return h;
    }
  };
  Model& model_;
  std::unordered_map<Vec3, uint32_t, Hash> index_;
};

}  // namespace jalon
