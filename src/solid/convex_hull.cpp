// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/error.h"

namespace jalon {

namespace {

__extension__ using Wide = __int128;
using Corner = std::array<int64_t, 3>;
using Triple = std::array<uint32_t, 3>;

/// Differences of 37 bits: their determinant fits 114 of the 127.
constexpr double kGridSteps = 68719476736.0;  // 2^36
/// A coordinate is rounded by half a step, a point by 0.87. The base that flat() takes multiplies that by 8 at most.
constexpr double kFlatRoundings = 8;

struct Grid {
  std::vector<Corner> points;
  double rounding =
      1;  // steps: what the coordinates themselves, and the grid, have been rounded by
};

Grid on_grid(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const Vec3 size = box.max - box.min;
  const double extent = std::max({size.x, size.y, size.z}),
               scale = extent > 0 ? kGridSteps / extent : 0;
  Grid out;
  double largest = 0;
  for (const Vec3& p : points) {
    const Vec3 q = (p - box.min) * scale;
    out.points.push_back({std::llround(q.x), std::llround(q.y), std::llround(q.z)});
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  out.rounding = std::max(1.0, largest * std::numeric_limits<double>::epsilon() * scale);
  return out;
}

// Six times the volume of (a, b, c, d): positive when d lies where the anticlockwise triangle (a, b, c) faces.
Wide volume(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  std::array<std::array<Wide, 3>, 3> m;
  for (size_t i = 0; i < 3; ++i)
    m[0][i] = b[i] - a[i], m[1][i] = c[i] - a[i], m[2][i] = d[i] - a[i];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

bool collinear(const Corner& a, const Corner& b, const Corner& c) {
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    if (Wide(b[i] - a[i]) * (c[j] - a[j]) != Wide(b[j] - a[j]) * (c[i] - a[i])) return false;
  }
  return true;
}

// Normal of the triangle (a, b, c), as long as twice its area.
std::array<double, 3> twice_area(const Corner& a, const Corner& b, const Corner& c) {
  std::array<double, 3> out;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] =
        static_cast<double>(Wide(b[j] - a[j]) * (c[k] - a[k]) - Wide(b[k] - a[k]) * (c[j] - a[j]));
  }
  return out;
}

double length(const std::array<double, 3>& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// The point that is farthest by that measure, and how far.
template <class F>
std::pair<Corner, double> farthest(const std::vector<Corner>& p, F&& distance) {
  std::pair<Corner, double> out{p[0], 0};
  for (const Corner& q : p)
    if (const double d = distance(q); d > out.second) out = {q, d};
  return out;
}

// All in one plane, but for what rounding moves them: a plane that was no plane of the grid's has a thickness on it.
// From a wide base, since a narrow one would magnify that.
bool flat(const Grid& grid) {
  const Corner a = grid.points[0];
  const auto [second, far] = farthest(grid.points, [&](const Corner& q) {
    return length({static_cast<double>(q[0] - a[0]), static_cast<double>(q[1] - a[1]),
                   static_cast<double>(q[2] - a[2])});
  });
  const Corner b = second;
  const double least = kFlatRoundings * grid.rounding;
  if (!(far > least)) return true;
  const auto [third, area] =
      farthest(grid.points, [&](const Corner& q) { return length(twice_area(a, b, q)); });
  const Corner c = third;
  if (!(area > least * far)) return true;
  const double most = farthest(grid.points, [&](const Corner& q) {
                        return std::fabs(static_cast<double>(volume(a, b, c, q)));
                      }).second;
  return !(most > least * area);
}

// Four points of a volume, of points that are not flat: the start of the hull.
std::array<uint32_t, 4> first_tetrahedron(const std::vector<Corner>& p) {
  const auto n = static_cast<uint32_t>(p.size());
  uint32_t b = 1, c, d;
  while (b < n && p[b] == p[0]) ++b;
  for (c = b + 1; c < n && collinear(p[0], p[b], p[c]);) ++c;
  for (d = c + 1; d < n && volume(p[0], p[b], p[c], p[d]) == 0;) ++d;
  if (volume(p[0], p[b], p[c], p[d]) > 0) std::swap(b, c);
  return {0, b, c, d};
}

// Replaces the facets that see point i by those that join it to their border.
void add_point(std::vector<Triple>& facets, const std::vector<Corner>& p, uint32_t i) {
  std::vector<Triple> kept;
  std::set<std::pair<uint32_t, uint32_t>> seen_edges;
  for (const Triple& f : facets) {
    if (volume(p[f[0]], p[f[1]], p[f[2]], p[i]) <= 0) {
      kept.push_back(f);
      continue;
    }
    for (size_t k = 0; k < 3; ++k) seen_edges.insert({f[k], f[(k + 1) % 3]});
  }
  for (const auto& [from, to] : seen_edges)
    if (!seen_edges.contains({to, from})) kept.push_back({from, to, i});
  facets = std::move(kept);
}

// From the integers, exactly: the plane of a sliver supports the hull too.
Vec3 normal_of(const Corner& a, const Corner& b, const Corner& c) {
  const auto [x, y, z] = twice_area(a, b, c);
  return normalized(Vec3{x, y, z});
}

ConvexHull with_planes(const std::vector<Triple>& facets, std::span<const Vec3> points,
                       const std::vector<Corner>& grid) {
  ConvexHull hull;
  std::vector<uint32_t> number(points.size(), ~uint32_t{0});
  for (const Triple& f : facets) {
    ConvexHull::Facet facet;
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& at = number[f[k]];
      if (at == ~uint32_t{0}) {
        at = static_cast<uint32_t>(hull.corners.size());
        hull.corners.push_back(points[f[k]]);
      }
      facet.corners[k] = at;
    }
    facet.normal = normal_of(grid[f[0]], grid[f[1]], grid[f[2]]);
    hull.facets.push_back(facet);
  }
  for (ConvexHull::Facet& facet : hull.facets) {
    facet.offset = dot(facet.normal, hull.corners[facet.corners[0]]);
    for (const Vec3& corner : hull.corners)
      facet.offset = std::max(facet.offset, dot(facet.normal, corner));
  }
  return hull;
}

}  // namespace

ConvexHull convex_hull(std::span<const Vec3> points) {
  if (points.size() < 4)
    fail(Status::kInsufficientData, "%zu points; a hull needs at least 4", points.size());
  if (points.size() > kMaxHullPoints)
    fail(Status::kLimit, "%zu points of a hull; at most %zu", points.size(), kMaxHullPoints);
  const Grid grid = on_grid(points);
  if (flat(grid))
    fail(Status::kDegenerate, "the %zu points of a hull lie in one plane", points.size());
  const auto [a, b, c, d] = first_tetrahedron(grid.points);
  std::vector<Triple> facets{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  for (uint32_t i = 0; i < grid.points.size(); ++i) add_point(facets, grid.points, i);
  return with_planes(facets, points, grid.points);
}

}  // namespace jalon
