// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/guide_lines.h"

#include <algorithm>

namespace jalon {

namespace {

// In spacings: provisional edges this near to each other are one line, and so much of them makes it one that guides.
constexpr double kSameLine = 0.75, kLeastLength = 12;
constexpr double kNearJoint = 1;  // spacings: contour points this near to another plane's line ...
constexpr int kLeastPoints = 3;   // ... and so many of them
constexpr std::array<Vec2, 4> kDirections{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};

struct Stretch {
  double place, length_m;
};

bool has_points(const EdgeLine& line, std::span<const std::vector<Vec2>> chains, double reach_m) {
  int near = 0;
  for (const auto& chain : chains)
    for (const Vec2& p : chain)
      if (std::fabs(line.distance(p)) <= reach_m && ++near >= kLeastPoints) return true;
  return false;
}

}  // namespace

GuideLines::GuideLines(std::span<const EdgeShape> shapes, std::span<const EdgeLine> joints,
                       std::span<const std::vector<Vec2>> chains, double spacing_m) {
  for (const EdgeLine& line : joints) {
    if (!has_points(line, chains, kNearJoint * spacing_m)) continue;
    joints_.push_back(line);  // the solid may lie on either side
    joints_.push_back({line.point, line.direction * -1});
  }
  for (size_t k = 0; k < families_.size(); ++k) {
    Family& family = families_[k];
    family.direction = kDirections[k];
    std::vector<Stretch> stretches;
    for (const EdgeShape& s : shapes)
      if (!s.is_arc && s.line.direction.u == family.direction.u &&
          s.line.direction.v == family.direction.v)
        stretches.push_back({family.coordinate(s.line.point), s.length_m});
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.place < b.place; });
    for (size_t i = 0; i < stretches.size();) {
      double length = 0, moment = 0;
      const double first = stretches[i].place;
      for (; i < stretches.size(); ++i) {
        const Stretch& s = stretches[i];
        if (length > 0 && s.place - (first + moment / length) > kSameLine * spacing_m) break;
        length += s.length_m;
        moment += s.length_m * (s.place - first);
      }
      if (length >= kLeastLength * spacing_m) family.places.push_back(first + moment / length);
    }
  }
}

bool GuideLines::empty() const {
  const auto is_empty = [](const Family& f) { return f.places.empty(); };
  return joints_.empty() && std::all_of(families_.begin(), families_.end(), is_empty);
}

}  // namespace jalon
