// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "segment/codes/opening_front.h"

namespace jalon {

/// Where an opening ends: along its plane, and heights.
struct OpeningEnds {
  double left_m = 0, right_m = 0, low_m = 0, high_m = 0;
};

/// The reveals of an opening where they meet its front.
class OpeningSides {
 public:
  /// A reveal in the section across it: its place by the distance before the front. A sill is inclined, a jamb may be.
  struct Side {
    bool is_found = false;
    double at_m = 0, slope = 0;
  };

  /// Points as of find_opening_front, their front, and where the opening about ends, to 2 cm.
  OpeningSides(std::span<const Vec3> points, const OpeningFront& front, const OpeningEnds& about);

  /// Nearer to a reveal than to the front, before it: what two surfaces meet in goes to the nearer one.
  bool is_reveal(const Vec3& p, const OpeningFront& front) const;
  /// Left, right, low, high.
  const std::array<Side, 4>& sides() const { return sides_; }

 private:
  std::array<Side, 4> sides_;
};

}  // namespace jalon
