// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation_faces.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// Depths this close are one colour to begin with: the thickness of a coat of plaster.
constexpr double kFirstStep_m = 0.02;

struct Extent {
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY}, sum;
  size_t n = 0;
  void add(const Vec3& p) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
    sum += p;
    ++n;
  }
  Vec3 mean() const { return sum / static_cast<double>(n); }
};

// Facade coordinates: x along, y away from the eye, z world height.
struct FacadeView {
  Transform T_facade_world;
  Vec3 operator()(const Vec3& p) const {
    Vec3 q = T_facade_world.point(p);
    q.z -= T_facade_world.m[11];  // the frame turns about Z: what it adds to the height is taken off again
    return q;
  }
};

// A face turned away from the facade by less than the front angle is drawn as a front, whatever its class: dormers and
// wings are seldom parallel to a degree.
DrawnFace::Kind kind_of(const Face& face, const FacadeView& view, double front_angle_rad) {
  const double facing = std::fabs(view.T_facade_world.direction(face.plane.normal).y);
  if (facing >= std::cos(front_angle_rad)) return DrawnFace::Kind::kFront;
  const auto orientation = static_cast<Orientation>(face.face_class);
  return orientation == Orientation::kVertical || orientation == Orientation::kHorizontal ? DrawnFace::Kind::kEdgeOn
                                                                                          : DrawnFace::Kind::kSlanted;
}

DrawnFace draw_face(const Model& model, const Face& face, const FacadeView& view, double front_angle_rad) {
  DrawnFace out;
  out.kind = kind_of(face, view, front_angle_rad);
  out.label = face.id;
  Extent extent;
  for (uint64_t r = 0; r < face.ring_count; ++r) {
    const Ring& ring = model.rings[face.first_ring + r];
    auto& points = out.rings.emplace_back();
    for (uint64_t i = 0; i < ring.count; ++i) {
      const Vec3 q = view(model.vertices[model.corners[ring.first + i]]);
      if (r == 0) extent.add(q);
      points.push_back({q.x, q.z});
    }
  }
  if (extent.n == 0) return out;
  const Vec3 mean = extent.mean();
  out.depth_m = mean.y;
  if (out.kind != DrawnFace::Kind::kEdgeOn) return out;
  if (static_cast<Orientation>(face.face_class) == Orientation::kHorizontal)
    out.rings = {{{extent.low.x, mean.z}, {extent.high.x, mean.z}}};
  else
    out.rings = {{{mean.x, extent.low.z}, {mean.x, extent.high.z}}};
  return out;
}

// Depths in steps around the main plane (step 0); the steps double until the groups can be told apart by colour.
std::vector<DepthGroup> group_depths(std::vector<DrawnFace>& faces) {
  std::vector<DrawnFace*> front;
  for (DrawnFace& face : faces)
    if (face.kind == DrawnFace::Kind::kFront) front.push_back(&face);
  std::stable_sort(front.begin(), front.end(),
                   [](const DrawnFace* a, const DrawnFace* b) { return a->depth_m < b->depth_m; });
  std::vector<DepthGroup> groups;
  for (double step = kFirstStep_m;; step *= 2) {
    groups.clear();
    double current = 0;
    for (DrawnFace* face : front) {
      const double at = std::floor(face->depth_m / step + 0.5);
      if (groups.empty() || at != current) groups.push_back({face->depth_m, face->depth_m, 0});
      current = at;
      groups.back().to_m = face->depth_m;
      ++groups.back().faces;
      face->group = groups.size() - 1;
    }
    if (groups.size() <= kMaxDepthGroups) return groups;
  }
}

void set_box(ElevationFaces& out) {
  const bool has_front = !out.groups.empty();
  Extent extent;
  for (const DrawnFace& face : out.faces)
    if (!has_front || face.kind == DrawnFace::Kind::kFront)
      for (const auto& ring : face.rings)
        for (const Vec2& p : ring) extent.add({p.u, 0, p.v});
  out.empty = extent.n == 0;
  if (out.empty) return;
  out.low = {extent.low.x, extent.low.z};
  out.high = {extent.high.x, extent.high.z};
}

}  // namespace

ElevationFaces elevation_faces(const Segmentation& segmentation, const Model& model, const ViewLimits& limits,
                               Task& task) {
  const FacadeView view{segmentation.T_facade_world};
  ElevationFaces out;
  double main_area = -1, main_depth = 0;
  for (size_t i = 0; i < model.faces.size(); ++i) {
    if (i % 64 == 0) task.checkpoint(static_cast<double>(i) / static_cast<double>(model.faces.size()));
    const Face& face = model.faces[i];
    DrawnFace drawn = draw_face(model, face, view, limits.front_angle_rad);
    if (drawn.rings.empty() || drawn.rings.front().size() < 2) continue;
    if (drawn.kind == DrawnFace::Kind::kFront && face.area_m2 > main_area) {
      main_area = face.area_m2;
      main_depth = drawn.depth_m;
    }
    out.faces.push_back(std::move(drawn));
  }
  // Without any face to the front the depths mean nothing, and nothing is left out.
  for (DrawnFace& face : out.faces) face.depth_m = main_area >= 0 ? face.depth_m - main_depth : 0;
  std::erase_if(out.faces,
                [&](const DrawnFace& face) {
                  return face.depth_m < -limits.in_front_m || face.depth_m > limits.behind_m;
                });
  out.groups = group_depths(out.faces);
  std::stable_sort(out.faces.begin(), out.faces.end(),
                   [](const DrawnFace& a, const DrawnFace& b) { return a.depth_m > b.depth_m; });
  set_box(out);
  if (!out.empty)
    out.corner_world = inverse(segmentation.T_facade_world)
                           .point({out.low.u, main_depth, out.low.v + segmentation.T_facade_world.m[11]});
  return out;
}

}  // namespace jalon
