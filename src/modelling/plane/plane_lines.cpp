// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/plane_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "geometry/polygon2.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kGapOfSpacing =
    2;  // an edge misses the line by its last spacing and as much by noise and beam width
constexpr double kPlaneLinesFlattest =
    0.94;                             // |cos| of 20 degrees: flatter planes have no useful line
constexpr double kEdgeAlong = 0.996;  // 5 degrees between edge and line
constexpr double kChord_m = 0.01;     // of arcs, where only "near or not" is asked
constexpr int kProbes = 5;            // along an edge ...
constexpr int kNeeded = 3;            // ... of which so many must find the other face there

struct FaceAt {
  size_t plane = 0, face = 0;
  std::vector<Vec2> outline;
  Box3 box;
  double gap_m = 0;
};

std::vector<FaceAt> list_faces(const std::vector<VectorPlane>& planes,
                               const JointSetting& setting) {
  std::vector<FaceAt> out;
  for (size_t p = 0; p < planes.size(); ++p)
    for (size_t f = 0; f < planes[p].faces.size(); ++f) {
      FaceAt face{p, f, flattened(planes[p].faces[f].outline, kChord_m), {}, setting.gap_m};
      if (!(face.gap_m > 0)) face.gap_m = kGapOfSpacing * planes[p].spacing_m;
      for (const Vec2& c : face.outline) face.box.add(planes[p].frame.lift(c));
      out.push_back(std::move(face));
    }
  return out;
}

bool are_near(const Box3& a, const Box3& b, double gap_m) {
  for (int i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] + gap_m || b.min[i] > a.max[i] + gap_m) return false;
  return true;
}

// Height of a point above a plane, about the plane's own origin: nothing is lost on a national grid.
double height_above(const PlaneFrame& frame, const Vec3& p) {
  return dot(p - frame.origin, frame.normal) - frame.height;
}

// The line of both planes, p nearest to `near`; none when they are too flat to each other.
std::optional<PlaneLine> line_of(const PlaneFrame& a, const PlaneFrame& b, const Vec3& near) {
  const double cosine = dot(a.normal, b.normal);
  if (std::fabs(cosine) > kPlaneLinesFlattest) return std::nullopt;
  PlaneLine out;
  const double ha = height_above(a, near), hb = height_above(b, near), square = 1 - cosine * cosine;
  out.d = normalized(cross(a.normal, b.normal));
  out.p =
      near - a.normal * ((ha - cosine * hb) / square) - b.normal * ((hb - cosine * ha) / square);
  return out;
}

bool is_there(const VectorPlane& plane, const FaceAt& face, const Vec3& p, double gap_m) {
  const Vec2 q = plane.frame.project(p);
  return contains(face.outline, q) || border_distance(face.outline, q) <= gap_m;
}

// Edges of face a along the line, where face b is.
void find_edges(const std::vector<VectorPlane>& planes, const FaceAt& a, const FaceAt& b,
                const PlaneLine& line, std::vector<EdgeJoint>& out) {
  const double gap_m = a.gap_m;
  const VectorPlane& plane = planes[a.plane];
  const VectorRing& ring = plane.faces[a.face].outline;
  for (size_t e = 0; e < ring.corners.size(); ++e) {
    if (ring.edges[e].sagitta_m != 0) continue;
    const Vec3 from = plane.frame.lift(ring.corners[e]);
    const Vec3 to = plane.frame.lift(ring.corners[(e + 1) % ring.corners.size()]);
    const double t0 = line.at(from), t1 = line.at(to);
    const double d0 = norm(from - line.p - line.d * t0), d1 = norm(to - line.p - line.d * t1);
    if (std::max(d0, d1) > gap_m || std::fabs(t1 - t0) < kEdgeAlong * norm(to - from) ||
        norm(to - from) < gap_m)
      continue;
    int there = 0;
    for (int k = 0; k < kProbes; ++k)
      there += is_there(planes[b.plane], b,
                        line.p + line.d * (t0 + (t1 - t0) * (k + 0.5) / kProbes), b.gap_m);
    if (there >= kNeeded)
      out.push_back({a.plane, a.face, e, b.plane, b.face, line, (d0 + d1) / 2, gap_m});
  }
}

}  // namespace

std::vector<EdgeJoint> find_joints(const std::vector<VectorPlane>& planes,
                                   const JointSetting& setting, Task& task) {
  const std::vector<FaceAt> faces = list_faces(planes, setting);
  std::vector<EdgeJoint> all;
  for (size_t i = 0; i < faces.size(); ++i) {
    task.checkpoint(0);
    for (size_t j = i + 1; j < faces.size(); ++j) {
      const FaceAt &a = faces[i], &b = faces[j];
      if (a.plane == b.plane || !are_near(a.box, b.box, std::max(a.gap_m, b.gap_m))) continue;
      // One line for a pair of planes, whichever faces meet: about the corner of the first plane's frame.
      const PlaneFrame& first = planes[a.plane].frame;
      const auto line = line_of(first, planes[b.plane].frame, first.origin);
      if (!line) continue;
      find_edges(planes, a, b, *line, all);
      find_edges(planes, b, a, *line, all);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const EdgeJoint& a, const EdgeJoint& b) {
    return std::tie(a.plane, a.face, a.edge, a.distance_m) <
           std::tie(b.plane, b.face, b.edge, b.distance_m);
  });
  const auto same_edge = [](const EdgeJoint& a, const EdgeJoint& b) {
    return a.plane == b.plane && a.face == b.face && a.edge == b.edge;
  };
  all.erase(std::unique(all.begin(), all.end(), same_edge), all.end());
  return all;
}

}  // namespace jalon
