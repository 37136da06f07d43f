// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings, what lies behind them, and faces that are no rectangles.
#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "scan/builder/builder.h"

namespace jalon {

namespace {

constexpr double kJoineryWidth_m = 0.08;         // of a window frame (as in the scene surrounds)
constexpr double kOpeningsGlassBehind_m = 0.02;  // behind it (same place)
constexpr double kChord_m = 1e-4;                // of an arc from its chords
constexpr double kSameLevel_m = 1e-9;            // corners that rounding alone sets apart

Outline reversed(Outline ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Rect shrunk(const Rect& r, double by) { return {r.u0 + by, r.u1 - by, r.v0 + by, r.v1 - by}; }

/// Part of an edge between two levels.
struct Side {
  double low_u, high_u;
};

/// The sides of all edges that cross the strip between two levels, from left to right.
std::vector<Side> sides_between(const std::vector<Outline>& rings, double low, double high) {
  std::vector<Side> sides;
  for (const Outline& ring : rings)
    for (size_t i = 0; i < ring.size(); ++i) {
      Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a.v > b.v) std::swap(a, b);
      if (a.v > low + kSameLevel_m || b.v < high - kSameLevel_m) continue;
      const auto at = [&](double v) {
        return a.u + (b.u - a.u) * std::clamp((v - a.v) / (b.v - a.v), 0.0, 1.0);
      };
      sides.push_back({at(low), at(high)});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low_u + a.high_u < b.low_u + b.high_u; });
  return sides;
}

}  // namespace

Outline outline_of(const Rect& r) {
  return {{r.u0, r.v0}, {r.u1, r.v0}, {r.u1, r.v1}, {r.u0, r.v1}};
}

Outline arched_outline(const Rect& rect, double rise_m) {
  const double half = rect.width() / 2, radius = (half * half + rise_m * rise_m) / (2 * rise_m);
  const double half_angle = 2 * std::atan(rise_m / half), middle = rect.u0 + half,
               centre_v = rect.v1 - radius;
  const auto chords = static_cast<int>(std::ceil(half_angle / std::sqrt(2 * kChord_m / radius)));
  Outline ring{{rect.u0, rect.v0}, {rect.u1, rect.v0}, {rect.u1, rect.v1 - rise_m}};
  for (int i = 1; i < chords; ++i) {
    const double angle = half_angle * (1 - 2.0 * i / chords);
    ring.push_back({middle + radius * std::sin(angle), centre_v + radius * std::cos(angle)});
  }
  ring.push_back({rect.u0, rect.v1 - rise_m});
  return ring;
}

uint32_t SceneBuilder::polygon_face(uint32_t part, const Frame& frame, const Outline& outline,
                                    const std::vector<Outline>& openings) {
  // 1. The rings: openings run clockwise.
  std::vector<Outline> rings{outline};
  for (const Outline& o : openings) rings.push_back(reversed(o));
  double area_m2 = 0;
  std::vector<double> levels;
  for (const Outline& ring : rings) {
    area_m2 += signed_area(ring);
    for (const Vec2& c : ring) levels.push_back(c.v);
  }
  const uint32_t id = record(part, frame, rings, area_m2, 0);

  // 2. Trapezoids between the levels of neighbouring corners, two triangles each.
  std::sort(levels.begin(), levels.end());
  double low = levels.front();
  for (const double high : levels) {
    if (high - low <= kSameLevel_m) continue;
    const std::vector<Side> sides = sides_between(rings, low, high);
    for (size_t k = 0; k + 1 < sides.size(); k += 2) {
      const Vec3 a = frame.point(sides[k].low_u, low), b = frame.point(sides[k + 1].low_u, low);
      const Vec3 c = frame.point(sides[k + 1].high_u, high), d = frame.point(sides[k].high_u, high);
      if (sides[k + 1].low_u > sides[k].low_u) triangle(a, b, c, id);
      if (sides[k + 1].high_u > sides[k].high_u) triangle(a, c, d, id);
    }
    low = high;
  }
  return id;
}

void SceneBuilder::recess(uint32_t part, const Frame& frame, const Rect& opening, double depth_m,
                          bool has_sill, double frame_m, uint32_t pane_id) {
  const Vec3 n = frame.normal();
  const Vec3 corner = frame.point(opening.u0, opening.v0, -depth_m);
  const double width = opening.width(), height = opening.height();
  const uint32_t pane = this->part("pane", "pane", part);
  const Frame back = frame.raised(-depth_m);
  if (frame_m > 0 && width > 3 * kJoineryWidth_m && height > 3 * kJoineryWidth_m) {
    const Rect glass{opening.u0 + kJoineryWidth_m, opening.u1 - kJoineryWidth_m,
                     opening.v0 + kJoineryWidth_m, opening.v1 - kJoineryWidth_m};
    face(this->part("joinery", "joinery", part), back, opening, {&glass, 1});
    face(pane, back.raised(-frame_m), glass, {}, pane_id);
  } else {
    face(pane, back, opening, {}, pane_id);
  }
  if (!(depth_m > 0)) return;
  const uint32_t reveals = this->part("reveals", "reveal", part);
  face(reveals, {corner, frame.v, n}, {0, height, 0, depth_m});  // left, looks along +u
  face(reveals, {corner + frame.u * width, n, frame.v}, {0, depth_m, 0, height});  // right
  face(reveals, {corner + frame.v * height, frame.u, n}, {0, width, 0, depth_m});  // lintel
  if (has_sill) face(reveals, {corner, n, frame.u}, {0, depth_m, 0, width});
}

void SceneBuilder::arched_joinery(uint32_t part, const Frame& back, const Rect& opening,
                                  double rise_m) {
  // The inner arc is concentric with the outer one.
  const double width = opening.width();
  const double radius = (width * width / 4 + rise_m * rise_m) / (2 * rise_m),
               inner_radius = radius - kJoineryWidth_m;
  const Rect inner = shrunk(opening, kJoineryWidth_m);
  const double half = inner.width() / 2;
  const double inner_rise =
      inner_radius - std::sqrt(std::max(0.0, inner_radius * inner_radius - half * half));
  const Outline glass = arched_outline(inner, inner_rise);
  polygon_face(this->part("joinery", "joinery", part), back, arched_outline(opening, rise_m),
               {glass});
  polygon_face(this->part("glass", "glass", part), back.raised(-kOpeningsGlassBehind_m), glass);
}

void SceneBuilder::arched_recess(uint32_t part, const Frame& frame, const Rect& opening,
                                 double rise_m, double depth_m, bool has_joinery) {
  const Vec3 n = frame.normal();
  const Frame back = frame.raised(-depth_m);
  const double width = opening.width(), springing = opening.height() - rise_m;
  // 1. What fills it.
  if (has_joinery) arched_joinery(part, back, opening, rise_m);
  else polygon_face(this->part("pane", "pane", part), back, arched_outline(opening, rise_m));
  // 2. Jambs and sill.
  const Vec3 corner = back.point(opening.u0, opening.v0);
  const uint32_t reveals = this->part("reveals", "reveal", part);
  face(reveals, {corner, frame.v, n}, {0, springing, 0, depth_m});
  face(reveals, {corner + frame.u * width, n, frame.v}, {0, depth_m, 0, springing});
  face(reveals, {corner, n, frame.u}, {0, depth_m, 0, width});
  // 3. The head.
  const Outline outline = arched_outline(opening, rise_m);
  swept(frame, {outline.begin() + 2, outline.end()}, -depth_m, 0);
}

}  // namespace jalon
