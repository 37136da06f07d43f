// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "spatial/polylines.h"

namespace jalon {

/// A straight piece of a chain: its line, and the nodes that it was fitted to.
struct SectionPiece {
  Vec2 middle, along;
  size_t from = 0, to = 0;  ///< places in the chain, both included
  Vec2 foot(const Vec2& p) const { return middle + along * dot(p - middle, along); }
  double offset(const Vec2& p) const { return cross(along, p - middle); }  ///< to the left
  double distance(const Vec2& p) const { return std::fabs(offset(p)); }
};

/// Chains of nodes as straight pieces. `kept`: where pieces end, places in the chain, first and last included.
class SectionPieces {
 public:
  /// Of the tolerance: what chains are simplified by before they are tidied up.
  static constexpr double kFirstShare = 0.25;

  /// points, nodes, order: see thin_points(), by cells of cell_m.
  SectionPieces(std::span<const Vec2> points, std::span<const ProfileNode> nodes,
                std::span<const uint32_t> order, double cell_m, double tolerance_m)
      : points_(points), nodes_(nodes), order_(order), cell_m_(cell_m), tolerance_m_(tolerance_m) {}

  Vec2 at(uint32_t node) const { return nodes_[node].middle; }
  template <class F>
  void for_each_point(uint32_t node, F&& f) const {
    for (uint32_t k = nodes_[node].first; k < nodes_[node].first + nodes_[node].count; ++k)
      f(points_[order_[k]]);
  }

  /// The least-squares line of the points between two places.
  SectionPiece fit(const std::vector<uint32_t>& chain, size_t from, size_t to) const;
  /// Where two lines meet; beside the node where they meet too far from it, or anywhere.
  Vec2 corner(const SectionPiece& a, const SectionPiece& b, const Vec2& node) const;
  /// As few pieces as keep the nodes within the tolerance: neighbours joined, and what the cells cut off corners gone.
  std::vector<uint32_t> tidied(const std::vector<uint32_t>& chain,
                               std::vector<uint32_t> kept) const;
  /// The same of a loop, whose first node stands at its end again; the loop then begins at a corner.
  std::vector<uint32_t> tidied_loop(std::vector<uint32_t>& chain, std::vector<uint32_t> kept) const;

 private:
  std::vector<uint32_t> with_longest(const std::vector<uint32_t>& chain,
                                     const std::vector<uint32_t>& kept, double tolerance_m) const;
  std::vector<uint32_t> without_short(const std::vector<uint32_t>& chain,
                                      const std::vector<uint32_t>& kept) const;
  std::vector<uint32_t> at_meetings(const std::vector<uint32_t>& chain,
                                    std::vector<uint32_t> kept) const;
  bool one_line(const std::vector<uint32_t>& chain, size_t from, size_t to,
                double tolerance_m) const;
  bool meet_between(const std::vector<uint32_t>& chain, const SectionPiece& before,
                    const SectionPiece& behind, uint32_t& place) const;

  std::span<const Vec2> points_;
  std::span<const ProfileNode> nodes_;
  std::span<const uint32_t> order_;
  double cell_m_, tolerance_m_;
};

}  // namespace jalon
