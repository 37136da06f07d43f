// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "coded_variants.h"
#include "model/model.h"
#include "model/part_classes.h"

namespace jalon::test {

/// An object of a model of codes: what it is, and the box of its corners.
struct DrawnObject {
  std::string part_class;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
};

/// Doors, windows, gutters and walls with a face, moved back. The place of an opening in a wall is that of its frame.
inline std::vector<DrawnObject> drawn_objects(const Model& model, const CodedMotion& motion) {
  const auto object_of = [&](uint32_t part) -> uint32_t {
    const std::string& word = model.parts[part].part_class;
    if (word == part_class::kJoinery) return static_cast<uint32_t>(model.parts[part].parent);
    const bool is_object =
        word == part_class::kWall || word == part_class::kGutter || part_class::is_opening(word);
    return is_object ? part : kNoPart;
  };
  std::vector<DrawnObject> of_part(model.parts.size());
  for (const Face& face : model.faces) {
    const uint32_t part = object_of(face.part);
    if (part == kNoPart) continue;
    DrawnObject& drawn = of_part[part];
    drawn.part_class = model.parts[part].part_class;
    const Ring& border = model.rings[face.first_ring];
    for (uint64_t k = border.first; k < border.first + border.count; ++k) {
      const Vec3 p = motion.back(model.vertices[model.corners[k]]);
      for (int axis = 0; axis < 3; ++axis) {
        drawn.low[axis] = std::min(drawn.low[axis], p[axis]);
        drawn.high[axis] = std::max(drawn.high[axis], p[axis]);
      }
    }
  }
  std::erase_if(of_part, [](const DrawnObject& drawn) { return drawn.part_class.empty(); });
  return of_part;
}

/// How far any side of an object's box lies from the other's.
inline double moved_m(const DrawnObject& a, const DrawnObject& b) {
  double out = 0;
  for (int axis = 0; axis < 3; ++axis)
    out = std::max(
        {out, std::fabs(a.low[axis] - b.low[axis]), std::fabs(a.high[axis] - b.high[axis])});
  return out;
}

/// Objects of the same class that are one another's nearest, and those that have none in the other drawing.
struct DrawnChange {
  size_t before = 0, after = 0;
  std::vector<double> moved;  ///< m, of those in both

  size_t lost() const { return before - moved.size(); }
  size_t added() const { return after - moved.size(); }
  size_t within(double limit_m) const {
    return static_cast<size_t>(
        std::count_if(moved.begin(), moved.end(), [&](double m) { return m <= limit_m; }));
  }
  double most_m() const {
    return moved.empty() ? 0 : *std::max_element(moved.begin(), moved.end());
  }
};

inline DrawnChange change_of(const std::vector<DrawnObject>& before,
                             const std::vector<DrawnObject>& after, const std::string& word) {
  const auto nearest = [&](const DrawnObject& to, const std::vector<DrawnObject>& among) {
    size_t best = among.size();
    double least = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < among.size(); ++k)
      if (among[k].part_class == word && moved_m(to, among[k]) < least)
        least = moved_m(to, among[k]), best = k;
    return best;
  };
  DrawnChange out;
  for (const DrawnObject& b : after) out.after += b.part_class == word;
  for (size_t k = 0; k < before.size(); ++k) {
    if (before[k].part_class != word) continue;
    ++out.before;
    const size_t partner = nearest(before[k], after);
    if (partner < after.size() && nearest(after[partner], before) == k)
      out.moved.push_back(moved_m(before[k], after[partner]));
  }
  return out;
}

}  // namespace jalon::test
