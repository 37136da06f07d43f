// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "modelling/edges/find/edge_shape.h"

namespace jalon {

/// Upright and level lines that several edges of a plane or a long one lie on, so that a short edge of few points may
/// be taken to lie on one of them too: the sides of a post are the same lines from the ground to the cornice, its foot
/// is level with its neighbours', and all posts end at the soffit above them. With the solid on one side.
class GuideLines {
 public:
  GuideLines() = default;
  /// Of the exactly vertical and horizontal edges among these, and of these lines with points of a
  /// contour on them. After: the places of a direction ascend; lines of other planes are there both
  /// ways.
  GuideLines(std::span<const EdgeShape> shapes, std::span<const EdgeLine> joints,
             std::span<const std::vector<Vec2>> chains, double spacing_m);

  bool empty() const;
  /// Calls f(line) for those within reach_m of a point.
  template <class F>
  void visit(const Vec2& p, double reach_m, F&& f) const {
    for (const Family& family : families_) {
      const double at = family.coordinate(p);
      auto it = std::lower_bound(family.places.begin(), family.places.end(), at - reach_m);
      for (; it != family.places.end() && *it <= at + reach_m; ++it) f(family.line(*it));
    }
    for (const EdgeLine& line : joints_)
      if (std::fabs(line.distance(p)) <= reach_m) f(line);
  }

 private:
  /// The lines of one direction.
  struct Family {
    Vec2 direction{1, 0};
    std::vector<double> places;  ///< ascending

    double coordinate(const Vec2& p) const { return direction.u == 0 ? p.u : p.v; }
    EdgeLine line(double place) const {
      return {direction.u == 0 ? Vec2{place, 0} : Vec2{0, place}, direction};
    }
  };
  std::array<Family, 4> families_;
  std::vector<EdgeLine> joints_;
};

}  // namespace jalon
