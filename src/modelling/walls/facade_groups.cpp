// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/facade_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon2.h"
#include "modelling/contour/contour.h"
#include "modelling/plane/ring_tools.h"
#include "segment/upright.h"

namespace jalon {

namespace {

constexpr double kSameDirection = 0.985;  // 10 degrees
constexpr double kChord_m = 0.005;        // of arcs, where only "inside or not" is asked
constexpr double kInsideShare = 0.6;      // of a face's probes in a wall's holes: it fills them
constexpr double kMeasuredShare = 0.5;    // of the least area of a wall
constexpr int kProbes = 8;                // per side of a face's box

bool is_upright(const VectorPlane& plane) { return std::fabs(plane.frame.normal.z) <= kWallSine; }

struct Candidate {
  size_t plane = 0;
  double gross_m2 = 0, width_m = 0, height_m = 0;
};

// By the largest face of a plane.
Candidate by_face(const VectorPlane& plane, size_t index) {
  Candidate c{index};
  for (const VectorFace& face : plane.faces) {
    const double area = signed_area(face.outline);
    if (area <= c.gross_m2) continue;
    c.gross_m2 = area;
    c.height_m = ring_box(face.outline).height();
    c.width_m = equivalent_width(area, perimeter(face.outline.corners));
  }
  return c;
}

// By all that was measured of it: a wall in pieces, between shop fronts, is as wide as its border.
Candidate by_claim(const VectorPlane& plane, size_t index, const WallClaim& claim,
                   const GroupSetting& setting) {
  Candidate c{index};
  if (plane.faces.empty() || claim.measured_m2 < kMeasuredShare * setting.min_wall_area_m2)
    return c;
  RingBox box;
  for (const VectorFace& face : plane.faces) {
    const RingBox own = ring_box(face.outline);
    box.add(own.low);
    box.add(own.high);
  }
  c.gross_m2 = claim.gross_m2;
  c.height_m = box.height();
  c.width_m = std::min(box.width(), box.height());
  return c;
}

// Planes that may be walls, by falling gross area; ties by index.
std::vector<Candidate> wall_candidates(const std::vector<VectorPlane>& planes,
                                       const GroupSetting& setting,
                                       std::span<const WallClaim> claims) {
  std::vector<Candidate> out;
  for (size_t i = 0; i < planes.size(); ++i) {
    if (!is_upright(planes[i]) || (!claims.empty() && claims[i].is_none)) continue;
    const bool is_claimed = !claims.empty() && claims[i].gross_m2 > 0;
    const Candidate c =
        is_claimed ? by_claim(planes[i], i, claims[i], setting) : by_face(planes[i], i);
    if (c.gross_m2 > 0) out.push_back(c);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gross_m2 > b.gross_m2; });
  return out;
}

FacadeFrame frame_on(const VectorPlane& plane) {
  FacadeFrame frame;
  const Vec3& n = plane.frame.normal;
  frame.outward = normalized({n.x, n.y, 0});
  frame.along = {-frame.outward.y, frame.outward.x, 0};
  frame.origin = plane.frame.lift(ring_box(plane.faces.front().outline).low);
  return frame;
}

Box3 box_in(const FacadeFrame& frame, const VectorPlane& plane) {
  Box3 box;
  for (const Vec3& p : outline_corners(plane)) box.add(frame.local(p));
  return box;
}

// The wall's holes, seen from a plane parallel to it.
struct Holes {
  const VectorPlane* wall = nullptr;
  std::vector<std::vector<Vec2>> polygons;
  std::vector<RingBox> boxes;

  Holes(const VectorPlane& plane, const NotchSetting& setting) : wall(&plane) {
    for (const WallHole& hole : holes_of(plane, setting)) {
      polygons.push_back(flattened(hole.outline, kChord_m));
      boxes.emplace_back().add(polygons.back());
    }
  }
  bool are_behind(const Vec3& p) const {
    return dot(p - wall->frame.origin, wall->frame.normal) > wall->frame.height;
  }
  bool hold(const Vec3& p) const {
    const Vec2 q = wall->frame.project(p);
    for (size_t k = 0; k < polygons.size(); ++k)
      if (boxes[k].holds(q) && contains(polygons[k], q)) return true;
    return false;
  }
};

// Whether the faces of a plane lie in the holes of a wall: most of the probes, a grid over each face.
bool fills_holes(const VectorPlane& plane, const Holes& holes) {
  size_t inside = 0, all = 0;
  for (const VectorFace& face : plane.faces) {
    const std::vector<Vec2> outline = flattened(face.outline, kChord_m);
    const RingBox box = ring_box(face.outline);
    for (int i = 0; i < kProbes * kProbes; ++i) {
      const Vec2 p{box.low.u + box.width() * (i % kProbes + 0.5) / kProbes,
                   box.low.v + box.height() * (i / kProbes + 0.5) / kProbes};
      if (!contains(outline, p)) continue;
      ++all;
      inside += holes.hold(plane.frame.lift(p));
    }
  }
  return all > 0 && static_cast<double>(inside) >= kInsideShare * static_cast<double>(all);
}

bool is_beside(const FacadeGroup& group, const Box3& box, const GroupSetting& setting) {
  return box.min.x <= group.box.max.x + setting.facade_gap_m &&
         box.max.x >= group.box.min.x - setting.facade_gap_m &&
         box.min.y <= setting.facade_depth_m && box.max.y >= -setting.facade_depth_m;
}

// Walls of the facades, main walls by falling area; further ones join the first facade they belong to.
std::vector<FacadeGroup> group_walls(const std::vector<VectorPlane>& planes,
                                     const GroupSetting& setting,
                                     std::span<const WallClaim> claims) {
  std::vector<FacadeGroup> groups;
  std::vector<std::vector<Holes>> holes;
  const std::vector<Candidate> candidates = wall_candidates(planes, setting, claims);
  for (const Candidate& c : candidates) {
    if (c.gross_m2 < setting.min_wall_area_m2 || c.width_m < setting.min_wall_width_m) continue;
    const VectorPlane& plane = planes[c.plane];
    bool taken = false;
    for (size_t g = 0; g < groups.size() && !taken; ++g) {
      if (dot(plane.frame.normal, groups[g].frame.outward) < kSameDirection) continue;
      const Box3 box = box_in(groups[g].frame, plane);
      if (!is_beside(groups[g], box, setting)) continue;
      taken = true;
      const WallClaim claim = claims.empty() ? WallClaim{} : claims[c.plane];
      const Vec3 place = plane.frame.lift(ring_box(plane.faces.front().outline).low);
      if (!claim.is_recess && std::any_of(holes[g].begin(), holes[g].end(), [&](const Holes& h) {
            return !(claim.is_windowed && h.are_behind(place)) && fills_holes(plane, h);
          }))
        break;
      groups[g].walls.push_back(c.plane);
      groups[g].box += box;
      holes[g].emplace_back(plane, setting.notch);
    }
    if (taken || c.gross_m2 < setting.min_facade_share * candidates.front().gross_m2 ||
        c.height_m < setting.min_facade_height_m)
      continue;
    FacadeGroup group;
    group.frame = frame_on(plane);
    group.walls = {c.plane};
    group.box = box_in(group.frame, plane);
    groups.push_back(std::move(group));
    holes.emplace_back().emplace_back(plane, setting.notch);
  }
  return groups;
}

// How far a plane is from a facade: from its middle to the facade's box.
double distance_to(const FacadeGroup& group, const VectorPlane& plane) {
  Box3 box;
  for (const Vec3& p : outline_corners(plane)) box.add(p);
  const Vec3 p = group.frame.local((box.min + box.max) * 0.5);
  const auto beyond = [](double x, double low, double high) {
    return std::max({0.0, low - x, x - high});
  };
  return norm(Vec3{beyond(p.x, group.box.min.x, group.box.max.x),
                   beyond(p.y, group.box.min.y, group.box.max.y),
                   beyond(p.z, group.box.min.z, group.box.max.z)});
}

}  // namespace

std::vector<Vec3> outline_corners(const VectorPlane& plane) {
  std::vector<Vec3> out;
  for (const VectorFace& face : plane.faces)
    for (const Vec2& p : face.outline.corners) out.push_back(plane.frame.lift(p));
  return out;
}

std::vector<FacadeGroup> group_facades(const std::vector<VectorPlane>& planes,
                                       const GroupSetting& setting,
                                       std::span<const WallClaim> claims) {
  std::vector<FacadeGroup> groups = group_walls(planes, setting, claims);
  if (groups.empty()) groups.emplace_back();
  std::vector<uint8_t> is_wall(planes.size(), 0);
  for (const FacadeGroup& group : groups)
    for (const size_t wall : group.walls) is_wall[wall] = 1;
  for (size_t i = 0; i < planes.size(); ++i) {
    if (is_wall[i] != 0 || planes[i].faces.empty()) continue;
    size_t nearest = 0;
    double least = INFINITY;
    for (size_t g = 0; g < groups.size(); ++g) {
      const double d = groups[g].walls.empty() ? 0 : distance_to(groups[g], planes[i]);
      if (d < least) {
        least = d;
        nearest = g;
      }
    }
    groups[nearest].others.push_back(i);
  }
  return groups;
}

}  // namespace jalon
