// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/vec.h"
#include "model/polygon_triangles.h"
#include "scan/yard/sheets.h"

namespace jalon::yard {

namespace {

constexpr int kStripsPerWave = 8;   // chords stay within 2 mm of the sine
constexpr double kSliver_m = 1e-6;  // strips and pieces below are rounding

double corrugation(double u) {
  return kCorrugation_m * std::sin(2 * std::numbers::pi * u / kPitch_m);
}

// Of openings, and behind targets, which hide what they stick on.
std::vector<Rect> holes_of(const Side& side, const std::vector<Target>& targets) {
  std::vector<Rect> holes;
  for (const Opening& o : side.openings)
    holes.push_back({o.left_m, o.right_m, o.hole_low_m(), o.high_m});
  for (const Target& t : targets)
    if (t.code == 1 && t.frame.origin == target_sheet(side).origin)
      holes.push_back({t.u_m - kTargetHalf_m, t.u_m + kTargetHalf_m, t.v_m - kTargetHalf_m,
                       t.v_m + kTargetHalf_m});
  return holes;
}

// Where strips begin and end: at even steps, and at the edges of holes.
std::vector<double> strip_edges(const Side& side, const std::vector<Rect>& holes) {
  const double step = kPitch_m / kStripsPerWave;
  std::vector<double> edges{0, side.length_m};
  for (double u = step; u < side.length_m; u += step) edges.push_back(u);
  for (const Rect& hole : holes) edges.insert(edges.end(), {hole.u0, hole.u1});
  std::sort(edges.begin(), edges.end());
  std::vector<double> apart;
  for (const double u : edges)
    if (apart.empty() || u - apart.back() > kSliver_m) apart.push_back(u);
  return apart;
}

}  // namespace

void Sheets::corners(uint32_t part, PointClass c, const std::vector<Vec3>& corners) {
  const Vec3 normal = normalized(newell_normal(corners));
  const Vec3 u = normalized(corners[1] - corners[0]);
  const Frame frame{corners[0], u, cross(normal, u)};
  Outline outline;
  for (const Vec3& p : corners)
    outline.push_back({dot(p - frame.origin, frame.u), dot(p - frame.origin, frame.v)});
  mark(out_.polygon_face(part, frame, outline), c);
}

void add_sheet_wall(Sheets& out, const Side& side, const std::vector<Target>& targets) {
  const uint32_t part = out.part("wall", "wall");
  const std::vector<Rect> holes = holes_of(side, targets);
  const std::vector<double> edges = strip_edges(side, holes);
  for (size_t k = 0; k + 1 < edges.size(); ++k) {
    const double middle = (edges[k] + edges[k + 1]) / 2;
    const Vec3 from = side.wall.point(edges[k], 0, corrugation(edges[k])),
               to = side.wall.point(edges[k + 1], 0, corrugation(edges[k + 1]));
    const Frame strip{from, normalized(to - from), side.wall.v};
    std::vector<Rect> open;
    for (const Rect& hole : holes)
      if (middle > hole.u0 && middle < hole.u1) open.push_back(hole);
    std::sort(open.begin(), open.end(), [](const Rect& a, const Rect& b) { return a.v0 < b.v0; });
    double low = kGround_m;
    for (const Rect& hole : open) {
      if (hole.v0 - low > kSliver_m)
        out.rect(part, kWall, strip, {0, norm(to - from), low, hole.v0});
      low = hole.v1;
    }
    if (side.top_m - low > kSliver_m)
      out.rect(part, kWall, strip, {0, norm(to - from), low, side.top_m});
  }
}

}  // namespace jalon::yard
