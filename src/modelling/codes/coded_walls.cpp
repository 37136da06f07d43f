// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_walls.h"

#include <algorithm>
#include <cmath>

#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kFarthestFrame_m = 1;  // as for the hinges of doors: farther walls are not its
constexpr double kMostSkewSine =
    0.1736;                         // 10 degrees: corners measured 0.16 m apart in depth make 5
constexpr double kFlush_m = 0.001;  // below what a total station tells without a reflector

double depth_of(const CodedWall& wall, const Vec3& p) {
  return dot(Vec2{p.x, p.y} - wall.a, wall.inward());
}
double place_of(const CodedWall& wall, const Vec3& p) {
  return dot(Vec2{p.x, p.y} - wall.a, wall.along());
}

double area_seen(const CodedWall& wall, const Corners& ring) {
  double twice = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double s = place_of(wall, p), t = place_of(wall, q);
    twice += s * (q.z - p.z) - (t - s) * p.z;
  }
  return twice / 2;
}

// How far its frame leans off the wall in plan, as a sine.
double skew_of(const CodedWall& wall, const Corners& border) {
  double low = INFINITY, high = -INFINITY, from = INFINITY, to = -INFINITY;
  for (const Vec3& p : border) {
    low = std::min(low, depth_of(wall, p)), high = std::max(high, depth_of(wall, p));
    from = std::min(from, place_of(wall, p)), to = std::max(to, place_of(wall, p));
  }
  return (high - low) / std::hypot(high - low, to - from);
}

// The floor of a notch and the sides of what the wall is cut by.
void add_reveals(SharedFaces& faces, const WallOpening& o, uint32_t opening) {
  if (o.is_flush) return;
  const uint32_t reveal = faces.part("reveal", part_class::kReveal, opening, Evidence::kDerived);
  const size_t n = o.frame.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t k = (i + 1) % n;
    if (o.has_notch && i == 0) continue;  // that side lies in the building's foot
    faces.add(reveal, o.opening->id, {o.hole[i], o.hole[k], o.frame[k], o.frame[i]});
  }
}

void measure(Part& part, const WallOpening& o) {
  part.width_m = o.right_m - o.left_m;
  part.height_m = o.head_m - o.foot_m;
  part.depth_m = o.depth_m;
}

}  // namespace

std::optional<WallOpening> opening_in(const CodedWall& wall, const CodedOpening& opening) {
  if (opening.border.size() < 3 || !(wall.length_m() > 0)) return std::nullopt;
  if (!(skew_of(wall, opening.border) < kMostSkewSine)) return std::nullopt;
  WallOpening out;
  out.opening = &opening;
  out.frame = opening.border;
  if (area_seen(wall, out.frame) < 0) std::reverse(out.frame.begin(), out.frame.end());
  // A door that was measured down to the ground or below ends at the wall's foot; its lower left corner comes first.
  if (out.frame.size() == 4) {
    const auto first =
        std::min_element(out.frame.begin(), out.frame.end(), [&](const Vec3& p, const Vec3& q) {
          return p.z != q.z ? p.z < q.z : place_of(wall, p) < place_of(wall, q);
        });
    std::rotate(out.frame.begin(), first, out.frame.end());
    out.has_notch = std::max(out.frame[0].z, out.frame[1].z) <= wall.low_m + kFlush_m;
  }
  for (Vec3& p : out.frame)
    if (out.has_notch && p.z <= wall.low_m + kFlush_m) p.z = wall.low_m;
  out.left_m = out.foot_m = INFINITY;
  out.right_m = out.head_m = -INFINITY;
  double least = INFINITY, most = -INFINITY;
  for (const Vec3& p : out.frame) {
    const double s = place_of(wall, p), depth = depth_of(wall, p);
    out.hole.push_back(wall.point(s, p.z));
    out.left_m = std::min(out.left_m, s), out.right_m = std::max(out.right_m, s);
    out.foot_m = std::min(out.foot_m, p.z), out.head_m = std::max(out.head_m, p.z);
    least = std::min(least, depth), most = std::max(most, depth);
    out.depth_m += depth / static_cast<double>(out.frame.size());
  }
  out.is_flush = std::max(std::fabs(least), std::fabs(most)) <= kFlush_m;
  if (out.is_flush) out.frame = out.hole;
  const bool is_behind = out.is_flush || (least > kFlush_m && most < kFarthestFrame_m);
  const bool is_within = out.left_m > kFlush_m && out.right_m < wall.length_m() - kFlush_m &&
                         (out.has_notch || out.foot_m > wall.low_m + kFlush_m) &&
                         out.head_m < wall.high_m - kFlush_m;
  if (!is_behind || !is_within) return std::nullopt;
  return out;
}

bool overlap(const WallOpening& a, const WallOpening& b) {
  return a.left_m < b.right_m + kFlush_m && b.left_m < a.right_m + kFlush_m &&
         a.foot_m < b.head_m + kFlush_m && b.foot_m < a.head_m + kFlush_m;
}

Corners add_coded_wall(SharedFaces& faces, const CodedWall& wall, uint32_t part, uint32_t id,
                       std::vector<WallOpening> openings) {
  std::sort(openings.begin(), openings.end(),
            [](const WallOpening& a, const WallOpening& b) { return a.left_m < b.left_m; });
  Corners outline{wall.point(0, wall.low_m)}, foot = outline;
  std::vector<SharedFaces::Hole> holes;
  std::vector<uint32_t> parts;
  for (const WallOpening& o : openings) {
    parts.push_back(faces.part(o.opening->name, o.opening->part_class, part));
    measure(faces.at(parts.back()), o);
    if (!o.has_notch) {
      holes.push_back({Corners(o.hole.rbegin(), o.hole.rend()), parts.back()});
      continue;
    }
    outline.insert(outline.end(), {o.hole[0], o.hole[3], o.hole[2], o.hole[1]});
    foot.push_back(o.hole[0]);
    if (!o.is_flush) foot.insert(foot.end(), {o.frame[0], o.frame[1]});
    foot.push_back(o.hole[1]);
  }
  const Vec3 end{wall.b.u, wall.b.v, wall.low_m}, end_top{wall.b.u, wall.b.v, wall.high_m};
  outline.insert(outline.end(), {end, end_top, {wall.a.u, wall.a.v, wall.high_m}});
  foot.push_back(end);
  faces.add(part, id, outline, holes);
  for (size_t k = 0; k < openings.size(); ++k) {
    const WallOpening& o = openings[k];
    faces.add(faces.part(o.opening->name, part_class::kJoinery, parts[k]), o.opening->id, o.frame);
    add_reveals(faces, openings[k], parts[k]);
  }
  return foot;
}

}  // namespace jalon
