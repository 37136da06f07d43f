// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Walls of random points with windows and shadows, told as method "facade" tells them.
#pragma once

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "modelling/patterns/patterns.h"

namespace jalon::test {

struct Rectangle {
  Vec2 low, size;
  bool holds(const Vec2& p) const {
    return p.u >= low.u && p.v >= low.v && p.u <= low.u + size.u && p.v <= low.v + size.v;
  }
  bool meets(const Rectangle& o, double apart_m) const {
    return low.u < o.low.u + o.size.u + apart_m && o.low.u < low.u + size.u + apart_m &&
           low.v < o.low.v + o.size.v + apart_m && o.low.v < low.v + size.v + apart_m;
  }
};

inline VectorRing ring_of(const Rectangle& r, double sigma_m) {
  VectorRing ring;
  ring.corners = {
      r.low, {r.low.u + r.size.u, r.low.v}, r.low + r.size, {r.low.u, r.low.v + r.size.v}};
  ring.edges.assign(4, {});
  for (VectorEdge& e : ring.edges) e.sigma_m = sigma_m;
  return ring;
}

/// A wall from (0, 0) on with openings whose edges were measured with a tenth of the spacing.
class DrawnWall {
 public:
  std::vector<Rectangle> truth;

  DrawnWall(double width_m, double height_m, double spacing_m, uint64_t seed)
      : size_{width_m, height_m}, spacing_m_(spacing_m), random_(seed, 77) {}

  void add(const Vec2& low, const Vec2& size, OpeningKind kind = OpeningKind::kWindow) {
    truth.push_back({low, size});
    kinds_.push_back(kind);
    found_.push_back(true);
  }
  void add_if_free(const Vec2& low, const Vec2& size) {
    const Rectangle r{low, size};
    if (std::none_of(truth.begin(), truth.end(),
                     [&](const Rectangle& o) { return r.meets(o, 0.3); }))
      add(low, size);
  }
  /// Hides an opening altogether: nothing is found there, and nothing in its surroundings.
  Rectangle hide(size_t i) {
    found_[i] = false;
    shade({truth[i].low - Vec2{0.3, 0.3}, truth[i].size + Vec2{0.6, 0.6}});
    return truth[i];
  }
  void wall_up(size_t i) {
    truth.erase(truth.begin() + static_cast<long>(i));
    kinds_.erase(kinds_.begin() + static_cast<long>(i));
    found_.erase(found_.begin() + static_cast<long>(i));
  }
  void shade(const Rectangle& r) { shadows_.push_back(r); }

  FacadeWall wall() {
    FacadeWall out;
    out.spacing_m = spacing_m_;
    out.sigma_m = 0.003;
    out.outlines = {ring_of({{0, 0}, size_}, 0.1 * spacing_m_)};
    out.map = map();
    for (size_t i = 0; i < truth.size(); ++i)
      if (found_[i]) out.openings.push_back(opening(i));
    return out;
  }

 private:
  bool is_shaded(const Vec2& p) const {
    return std::any_of(shadows_.begin(), shadows_.end(),
                       [&](const Rectangle& s) { return s.holds(p); });
  }
  bool is_open(const Vec2& p) const {
    return std::any_of(truth.begin(), truth.end(), [&](const Rectangle& t) { return t.holds(p); });
  }

  WallMap map() const {
    WallMap map;
    map.cell_m = 2 * spacing_m_;
    map.columns = static_cast<uint32_t>(size_.u / map.cell_m);
    map.rows = static_cast<uint32_t>(size_.v / map.cell_m);
    for (uint32_t r = 0; r < map.rows; ++r)
      for (uint32_t c = 0; c < map.columns; ++c) {
        const Vec2 p = Vec2{c + 0.5, r + 0.5} * map.cell_m;
        map.cells.push_back(is_shaded(p) ? WallCell::kHidden
                            : is_open(p) ? WallCell::kThrough
                                         : WallCell::kSolid);
      }
    return map;
  }

  /// What was measured of it: the border points in the light, and the box that they and the shadow leave.
  FacadeOpening opening(size_t i) {
    const Rectangle& t = truth[i];
    FacadeOpening out;
    out.kind = kinds_[i];
    out.evidence = Evidence::kSeenBehind;
    out.depth_m = 0.2;
    const double around = 2 * (t.size.u + t.size.v);
    const auto count = static_cast<size_t>(around / spacing_m_);
    size_t lit = 0;
    for (size_t k = 0; k < count; ++k) {
      const Vec2 p = border_point(t, (static_cast<double>(k) + random_.uniform()) * spacing_m_);
      if (is_shaded(p)) continue;
      ++lit;
      out.border_points.push_back(p);
    }
    out.coverage = static_cast<double>(lit) / static_cast<double>(count);
    out.residual_m = 0.3 * spacing_m_;
    Rectangle box = t;
    const auto noise = [&] { return 0.1 * spacing_m_ * random_.normal(); };
    box.low = box.low + Vec2{noise(), noise()};
    box.size = box.size + Vec2{noise(), noise()};
    for (const Rectangle& s : shadows_)
      if (s.meets(t, 0)) {  // hole and shadow are one
        const Vec2 low{std::min(box.low.u, s.low.u), std::min(box.low.v, s.low.v)};
        const Vec2 high{std::max(box.low.u + box.size.u, s.low.u + s.size.u),
                        std::max(box.low.v + box.size.v, s.low.v + s.size.v)};
        box = {low, high - low};
      }
    out.outline = ring_of(box, 0.1 * spacing_m_);
    return out;
  }

  /// The wall's last point beside the border, this far round: up to one spacing outside.
  Vec2 border_point(const Rectangle& t, double way_m) {
    const double off = random_.uniform() * 0.8 * spacing_m_, w = t.size.u, h = t.size.v;
    if (way_m < w) return {t.low.u + way_m, t.low.v - off};
    if (way_m < w + h) return {t.low.u + w + off, t.low.v + way_m - w};
    if (way_m < 2 * w + h) return {t.low.u + way_m - w - h, t.low.v + h + off};
    return {t.low.u - off, t.low.v + std::min(way_m - 2 * w - h, h)};
  }

  Vec2 size_;
  double spacing_m_;
  RandomStream random_;
  std::vector<Rectangle> shadows_;
  std::vector<OpeningKind> kinds_;
  std::vector<bool> found_;
};

}  // namespace jalon::test
