// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan/yard/plan.h"

namespace jalon::yard {

/// Classes of the truth, as the codes' source numbers them.
enum PointClass : uint8_t { kRest = 0, kWall = 1, kDoor = 2, kWindow = 3, kGutter = 4 };

/// A scene under construction in which each face has a class.
class Sheets {
 public:
  explicit Sheets(SceneBuilder& out) : out_(out) {}

  uint32_t part(const char* name, const char* part_class, uint64_t parent = kNoParent) {
    return out_.part(name, part_class, parent);
  }
  void rect(uint32_t part, PointClass c, const Frame& frame, const Rect& rect,
            std::span<const Rect> holes = {}) {
    mark(out_.face(part, frame, rect, holes), c);
  }
  /// A planar face of these corners, anticlockwise as it is seen.
  void corners(uint32_t part, PointClass c, const std::vector<Vec3>& corners);
  void crown(const Vec3& centre, double radius_m, int leaves, double leaf_m, RandomStream random) {
    out_.crown(centre, radius_m, leaves, leaf_m, random);
  }
  /// Of each face id, from 1; ids beyond are kRest.
  const std::vector<uint8_t>& classes() const { return classes_; }

 private:
  void mark(uint32_t id, PointClass c) {
    if (classes_.size() < id) classes_.resize(id, kRest);
    classes_[id - 1] = c;
  }
  SceneBuilder& out_;
  std::vector<uint8_t> classes_;
};

/// Wall of corrugated sheet with the holes of its openings, and without what the targets on it hide (walls.cpp).
void add_sheet_wall(Sheets& out, const Side& side, const std::vector<Target>& targets);
/// Reveals, sill, frame or leaf, panes, blinds and what is behind (fittings.cpp).
void add_fittings(Sheets& out, const Side& side, const Opening& opening, RandomStream random);
/// Ground, bushes, the edge of the roof, gutters (surroundings.cpp).
void add_surroundings(Sheets& out, const Plan& plan, uint64_t seed);

}  // namespace jalon::yard
