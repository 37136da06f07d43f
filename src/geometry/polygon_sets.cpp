// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon_sets.h"

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/error.h"
#include "geometry/polygon2.h"

namespace jalon {

namespace {

namespace bp = boost::polygon;
using Point = bp::point_data<int>;
using Ring = std::vector<Point>;
using Region = bp::polygon_set_data<int>;

constexpr double kMostSteps = 0x1p27;  // sums of products of two coordinates stay far below 2^63

int snapped(double coordinate, double grid_m) {
  const double steps = std::round(coordinate / grid_m);
  if (!(std::fabs(steps) <= kMostSteps))  // also NaN
    fail(Status::kLimit, "a polygon lies too far from its origin for its grid, or is not finite");
  return static_cast<int>(steps);
}

// Without repeated corners; fewer than 3 left: no area.
Ring snapped(const std::vector<Vec2>& corners, double grid_m) {
  Ring out;
  for (const Vec2& p : corners) {
    const Point q(snapped(p.u, grid_m), snapped(p.v, grid_m));
    if (out.empty() || !(out.back() == q)) out.push_back(q);
  }
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

// The holes of one polygon are its own: what another polygon covers there stays covered.
Region region_of(std::span<const PolygonWithHoles> polygons, double grid_m) {
  using namespace bp::operators;
  Region out;
  for (const PolygonWithHoles& polygon : polygons) {
    const Ring outline = snapped(polygon.outline, grid_m);
    if (outline.size() < 3) continue;
    Region one, holes;
    one.insert(bp::polygon_data<int>(outline.begin(), outline.end()));
    for (const auto& corners : polygon.holes)
      if (const Ring hole = snapped(corners, grid_m); hole.size() >= 3)
        holes.insert(bp::polygon_data<int>(hole.begin(), hole.end()));
    if (!holes.empty()) one -= holes;
    out.insert(one);
  }
  out.clean();
  return out;
}

// The border, the region on its left. Boost.Polygon forms polygons too, but loses memory when there is none left.
struct BorderEdge {
  Point from, to;
};

// Edges are stored from the lesser to the greater point; the sign tells on which side the region lies.
std::vector<BorderEdge> border_of(const Region& region) {
  region.clean();
  std::vector<BorderEdge> out;
  for (const auto& [edge, count] : region) {
    const bool is_upright = edge.first.x() == edge.second.x();
    if (count != 0)
      out.push_back((count > 0) != is_upright ? BorderEdge{edge.first, edge.second}
                                              : BorderEdge{edge.second, edge.first});
  }
  return out;
}

int64_t cross(const Point& a, const Point& b, const Point& c) {
  return static_cast<int64_t>(b.x() - a.x()) * (c.y() - a.y()) -
         static_cast<int64_t>(b.y() - a.y()) * (c.x() - a.x());
}

double area_of(const Region& region, double grid_m) {
  const std::vector<BorderEdge> border = border_of(region);
  __int128 twice = 0;
  for (const BorderEdge& e : border) twice += cross(border[0].from, e.from, e.to);
  return 0.5 * static_cast<double>(twice) * grid_m * grid_m;
}

// Is direction b met before c when turning clockwise from a? a itself counts as a whole turn.
bool comes_first_clockwise(const Point& at, const Point& a, const Point& b, const Point& c) {
  const auto half = [&](const Point& p) {  // 0: the right half turn, 1: straight on or the left one
    const int64_t side = cross(at, a, p);
    const int64_t ahead = static_cast<int64_t>(a.x() - at.x()) * (p.x() - at.x()) +
                          static_cast<int64_t>(a.y() - at.y()) * (p.y() - at.y());
    return side < 0 ? 0 : side == 0 && ahead > 0 ? 2 : 1;
  };
  if (half(b) != half(c)) return half(b) < half(c);
  return cross(at, b, c) < 0;
}

class RingTracer {
 public:
  explicit RingTracer(std::vector<BorderEdge> border)
      : border_(std::move(border)), used_(border_.size()) {
    std::sort(border_.begin(), border_.end(), [](const BorderEdge& a, const BorderEdge& b) {
      return !(a.from == b.from) ? a.from < b.from : a.to < b.to;
    });
  }

  /// Rings that touch neither themselves nor, but in corners, each other.
  std::vector<Ring> trace() {
    std::vector<Ring> out;
    for (size_t first = 0; first < border_.size(); ++first)
      if (used_[first] == 0) split(walk(first), out);
    return out;
  }

 private:
  Ring walk(size_t edge) {
    Ring out;
    while (edge < border_.size() && used_[edge] == 0) {
      used_[edge] = 1;
      out.push_back(border_[edge].from);
      edge = next(border_[edge]);
    }
    return out;
  }

  // Of the free edges from its end the one that keeps closest to the region.
  size_t next(const BorderEdge& e) const {
    const auto from =
        std::lower_bound(border_.begin(), border_.end(), e.to,
                         [](const BorderEdge& b, const Point& p) { return b.from < p; });
    size_t best = border_.size();
    for (auto b = from; b != border_.end() && b->from == e.to; ++b) {
      const auto i = static_cast<size_t>(b - border_.begin());
      if (used_[i] == 0 &&
          (best == border_.size() || comes_first_clockwise(e.to, e.from, b->to, border_[best].to)))
        best = i;
    }
    return best;
  }

  // Cuts a ring where it comes back to a corner, and leaves out corners on straight edges.
  static void split(const Ring& walked, std::vector<Ring>& out) {
    Ring open;
    std::map<std::pair<int, int>, size_t> places;
    for (const Point& p : walked) {
      const auto [place, is_new] = places.try_emplace({p.x(), p.y()}, open.size());
      if (!is_new) {
        const size_t from = place->second;
        add(Ring(open.begin() + static_cast<std::ptrdiff_t>(from), open.end()), out);
        for (size_t i = from + 1; i < open.size(); ++i) places.erase({open[i].x(), open[i].y()});
        open.resize(from);
      }
      open.push_back(p);
    }
    add(open, out);
  }

  static void add(const Ring& ring, std::vector<Ring>& out) {
    Ring kept;
    for (size_t i = 0; i < ring.size(); ++i)
      if (cross(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]) !=
          0)
        kept.push_back(ring[i]);
    if (kept.size() >= 3) out.push_back(std::move(kept));
  }

  std::vector<BorderEdge> border_;
  std::vector<uint8_t> used_;
};

// Clockwise rings are holes: each of the smallest outline round one of its edges' middles.
std::vector<PolygonWithHoles> nested(const std::vector<Ring>& rings, double grid_m) {
  std::vector<PolygonWithHoles> out;
  std::vector<double> areas;
  std::vector<std::vector<Vec2>> holes;
  for (const Ring& ring : rings) {
    std::vector<Vec2> corners;
    for (const Point& p : ring) corners.push_back({p.x() * grid_m, p.y() * grid_m});
    if (const double area = signed_area(corners); area > 0) {
      out.push_back({std::move(corners), {}});
      areas.push_back(area);
    } else {
      holes.push_back(std::move(corners));
    }
  }
  for (auto& hole : holes) {
    const Vec2 middle = (hole[0] + hole[1]) * 0.5;
    size_t best = out.size();
    for (size_t k = 0; k < out.size(); ++k)
      if ((best == out.size() || areas[k] < areas[best]) && contains(out[k].outline, middle))
        best = k;
    if (best < out.size()) out[best].holes.push_back(std::move(hole));
  }
  return out;
}

}  // namespace

std::vector<PolygonWithHoles> combined(SetOperation operation, std::span<const PolygonWithHoles> a,
                                       std::span<const PolygonWithHoles> b, double grid_m) {
  using namespace bp::operators;
  Region region = region_of(a, grid_m);
  const Region other = region_of(b, grid_m);
  switch (operation) {
    case SetOperation::kIntersection:
      region &= other;
      break;
    case SetOperation::kUnion:
      region |= other;
      break;
    case SetOperation::kDifference:
      region -= other;
      break;
    case SetOperation::kXor:
      region ^= other;
      break;
  }
  return nested(RingTracer(border_of(region)).trace(), grid_m);
}

SharedArea shared_area(std::span<const PolygonWithHoles> a, std::span<const PolygonWithHoles> b,
                       double grid_m) {
  using namespace bp::operators;
  Region both = region_of(a, grid_m);
  const Region other = region_of(b, grid_m);
  SharedArea out{area_of(both, grid_m), area_of(other, grid_m), 0};
  both &= other;
  out.both =
      std::min({area_of(both, grid_m), out.a, out.b});  // rounded crossings must not add to it
  return out;
}

double region_area(std::span<const PolygonWithHoles> region, double grid_m) {
  return area_of(region_of(region, grid_m), grid_m);
}

}  // namespace jalon
