// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/model.h"

namespace jalon {

/// Tree of parts, walkable downward. Parents that no part has count as none, and so does one parent of each ring of
/// parts that name each other.
class PartTree {
 public:
  explicit PartTree(const Model& model);

  struct Step {
    uint32_t part = 0;
    uint32_t depth = 0;  ///< 0: a root
  };
  /// Every part once, parents before their children, children in their order.
  const std::vector<Step>& walk() const { return walk_; }
  /// The part itself or the nearest above it that satisfies the test, else kNoPart.
  template <class Test>
  uint32_t nearest(uint32_t part, const Test& test) const {
    for (; part != kNoPart; part = parents_[part])
      if (test(part)) return part;
    return kNoPart;
  }
  bool is_below(uint32_t part, uint32_t ancestor) const {
    return nearest(part, [&](uint32_t p) { return p == ancestor; }) != kNoPart;
  }
  /// Faces of each part, ascending.
  const std::vector<std::vector<size_t>>& faces() const { return faces_; }

 private:
  std::vector<uint32_t> parents_;  ///< kNoPart: a root
  std::vector<Step> walk_;
  std::vector<std::vector<size_t>> faces_;
};

/// "window 3" for a part without a name as "part 17".
std::string part_label(const Model& model, uint64_t part);

}  // namespace jalon
