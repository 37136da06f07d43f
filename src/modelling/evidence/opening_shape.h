// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

/// Forms that openings of buildings have. Their sizes, in this order:
enum class ShapeKind : uint8_t {
  kRectangle,  ///< left, right, foot, head
  kTrapezium,  ///< left and right of the foot, foot, head, left and right of the head
  kTriangle,   ///< left, right, foot, head, place of the apex along
  kGable,      ///< left, right, foot, apex, rise: a rectangle with two slopes on it
  kArch,       ///< left, right, foot, crown, rise: round up to half the width, pointed above
  kCircle,     ///< centre, centre, radius
};
/// A shape in a plane; any unit.
struct OpeningShape {
  ShapeKind kind = ShapeKind::kRectangle;
  std::array<double, 6> sizes{};

  size_t size_count() const;
  bool has_arcs() const { return kind == ShapeKind::kArch || kind == ShapeKind::kCircle; }
  /// Sides in order, rise and radius above 0 and within the rest.
  bool is_valid() const;
  RingBox box() const;
  /// Left and right border at a height within the box.
  Vec2 span_at(double v) const;
  /// Its border included.
  bool holds(const Vec2& p) const {
    if (!box().holds(p)) return false;
    const Vec2 span = span_at(p.v);
    return p.u >= span.u && p.u <= span.v;
  }
  /// Moved by `by` after all lengths were multiplied.
  OpeningShape placed(double scale, const Vec2& by) const;
  /// All sides moved outward so far, across themselves; heads keep their form.
  OpeningShape grown(double by) const;
  /// Anticlockwise, with arcs.
  VectorRing ring() const;
};

/// The shape of the kind that fills the box, as a start: heads as low as half the box.
OpeningShape shape_in(ShapeKind kind, const RingBox& box);

}  // namespace jalon
