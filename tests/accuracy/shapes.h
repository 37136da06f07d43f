// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Areas of polygons and of what they have in common, by thin rows: shares nothing with the library's polygons.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/vec.h"

namespace jalon::test {

/// Closed chains of corners; a point inside an odd number of them is inside.
struct Shape {
  std::vector<std::vector<Vec2>> rings;
};

/// Shapes that may overlap: their union.
using Region = std::vector<Shape>;

struct Extent2 {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const Vec2& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  void add(const Region& region) {
    for (const Shape& shape : region)
      for (const auto& ring : shape.rings)
        for (const Vec2& p : ring) add(p);
  }
  bool meets(const Extent2& o) const {
    return low.u <= o.high.u && o.low.u <= high.u && low.v <= o.high.v && o.low.v <= high.v;
  }
};
inline Extent2 extent_of(const Region& region) {
  Extent2 out;
  out.add(region);
  return out;
}

/// Places along one row, in pairs: in, out.
using Crossings = std::vector<double>;

/// Where the middles of rows v0 + (k + 1/2) height cross the shape.
inline std::vector<Crossings> crossings_of(const Shape& shape, double v0, double height,
                                           size_t rows) {
  std::vector<Crossings> out(rows);
  for (const auto& ring : shape.rings)
    for (size_t i = 0; i < ring.size(); ++i) {
      Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a.v > b.v) std::swap(a, b);
      const double from = std::ceil((a.v - v0) / height - 0.5),
                   to = std::ceil((b.v - v0) / height - 0.5);
      for (double k = std::max(0.0, from); k < std::min(to, static_cast<double>(rows)); ++k) {
        const double v = v0 + (k + 0.5) * height;
        out[static_cast<size_t>(k)].push_back(a.u + (b.u - a.u) * (v - a.v) / (b.v - a.v));
      }
    }
  for (Crossings& row : out) std::sort(row.begin(), row.end());
  return out;
}

/// The union of the shapes' intervals, row by row.
inline std::vector<Crossings> crossings_of(const Region& region, double v0, double height,
                                           size_t rows) {
  std::vector<Crossings> out(rows);
  for (const Shape& shape : region) {
    std::vector<Crossings> more = crossings_of(shape, v0, height, rows);
    for (size_t k = 0; k < rows; ++k) out[k].insert(out[k].end(), more[k].begin(), more[k].end());
  }
  if (region.size() == 1) return out;
  for (Crossings& row : out) {
    std::vector<std::pair<double, double>> pieces;
    for (size_t i = 0; i + 1 < row.size(); i += 2) pieces.push_back({row[i], row[i + 1]});
    std::sort(pieces.begin(), pieces.end());
    row.clear();
    for (const auto& [from, to] : pieces)
      if (!row.empty() && from <= row.back()) row.back() = std::max(row.back(), to);
      else row.insert(row.end(), {from, to});
  }
  return out;
}

inline double length_of(const Crossings& row) {
  double sum = 0;
  for (size_t i = 0; i + 1 < row.size(); i += 2) sum += row[i + 1] - row[i];
  return sum;
}

inline double common_length(const Crossings& a, const Crossings& b) {
  double sum = 0;
  for (size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    sum += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    a[i + 1] < b[j + 1] ? i += 2 : j += 2;
  }
  return sum;
}

struct Areas {
  double a_m2 = 0, b_m2 = 0, both_m2 = 0;
  /// Intersection over union.
  double iou() const { return both_m2 > 0 ? both_m2 / (a_m2 + b_m2 - both_m2) : 0; }
  Areas& operator+=(const Areas& o) {
    a_m2 += o.a_m2, b_m2 += o.b_m2, both_m2 += o.both_m2;
    return *this;
  }
};

/// Exact along u, by rows of this height along v.
inline Areas areas(const Region& a, const Region& b, double row_m) {
  Extent2 all = extent_of(a);
  all.add(b);
  if (!(all.high.v > all.low.v)) return {};
  const auto rows = static_cast<size_t>(std::ceil((all.high.v - all.low.v) / row_m));
  const double height = (all.high.v - all.low.v) / static_cast<double>(rows);
  const auto in_a = crossings_of(a, all.low.v, height, rows),
             in_b = crossings_of(b, all.low.v, height, rows);
  Areas out;
  for (size_t k = 0; k < rows; ++k) {
    out.a_m2 += height * length_of(in_a[k]);
    out.b_m2 += height * length_of(in_b[k]);
    out.both_m2 += height * common_length(in_a[k], in_b[k]);
  }
  return out;
}

}  // namespace jalon::test
