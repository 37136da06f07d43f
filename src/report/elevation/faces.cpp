// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/faces.h"

#include <algorithm>
#include <cmath>

#include "model/part_classes.h"
#include "report/elevation/ground_level.h"
#include "report/names/part_tree.h"
#include "segment/orientation.h"

namespace jalon {

namespace {

// Depths this close are one colour to begin with: the thickness of a coat of plaster.
constexpr double kFirstStep_m = 0.02;
// |cos| between eye and normal below which a face is a line on the drawing: 2 degrees.
constexpr double kEdgeOnCosine = 0.035;
constexpr double kRounding_m = 1e-6;  // of depths in map coordinates, with room
constexpr double kNoArea = -1;

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

// A face turned away from the facade by less than the front angle is drawn as a front, whatever its class: dormers and
// wings are seldom parallel to a degree.
DrawnFace::Kind kind_of(const Face& face, const ElevationView& view, double front_angle_rad) {
  const double facing = std::fabs(view.T_view_world.direction(face.plane.normal).y);
  if (facing >= std::cos(front_angle_rad)) return DrawnFace::Kind::kFront;
  if (facing < kEdgeOnCosine) return DrawnFace::Kind::kEdgeOn;
  const auto orientation = static_cast<Orientation>(face.face_class);
  return orientation == Orientation::kVertical || orientation == Orientation::kHorizontal
             ? DrawnFace::Kind::kEdgeOn
             : DrawnFace::Kind::kSlanted;
}

bool is_hole_class(const Model& model, uint32_t part) {
  return part_class::is_opening(model.parts[part].part_class);
}

DrawnFace::Role role_of(const Model& model, const PartTree& tree, const Face& face) {
  if (face.part >= model.parts.size()) return DrawnFace::Role::kElement;
  const std::string& c = model.parts[face.part].part_class;
  if (c == part_class::kNoData) return DrawnFace::Role::kNoData;
  if (c == part_class::kGround) return DrawnFace::Role::kGround;
  if (c == part_class::kWall) return DrawnFace::Role::kWall;
  const bool is_inside =
      tree.nearest(face.part, [&](uint32_t p) { return is_hole_class(model, p); }) != kNoPart;
  return is_inside ? DrawnFace::Role::kInside : DrawnFace::Role::kElement;
}

bool is_copied(const Model& model, const PartTree& tree, const Face& face) {
  if (face.part >= model.parts.size()) return false;
  return tree.nearest(face.part, [&](uint32_t p) {
    return model.parts[p].evidence == Evidence::kCopied || model.parts[p].copied_from != kNoParent;
  }) != kNoPart;
}

bool is_reveal(const Model& model, const Face& face) {
  return face.part < model.parts.size() && model.parts[face.part].part_class == part_class::kReveal;
}

// A face seen edge-on is a line: level for horizontal planes, upright for the others.
void set_edge(DrawnFace& out, const Face& face, const ElevationView& view, const Extent& extent) {
  const Vec3 mean = extent.mean();
  const bool is_level =
      std::fabs(view.T_view_world.direction(face.plane.normal).z) > std::sqrt(0.5);
  out.edge[0] = is_level ? Vec2{extent.low.x, mean.z} : Vec2{mean.x, extent.low.z};
  out.edge[1] = is_level ? Vec2{extent.high.x, mean.z} : Vec2{mean.x, extent.high.z};
}

DrawnFace draw_face(const Model& model, const PartTree& tree, size_t index,
                    const ElevationView& view, double front_angle_rad) {
  const Face& face = model.faces[index];
  DrawnFace out;
  out.face = index;
  out.kind = kind_of(face, view, front_angle_rad);
  out.role = role_of(model, tree, face);
  out.is_copy = is_copied(model, tree, face);
  out.label = face.id;
  for (uint64_t r = 0; r < face.ring_count; ++r)
    out.rings.push_back(drawn_ring(model, face, face.first_ring + r, view));
  Extent extent;
  if (face.ring_count > 0) {
    const Ring& ring = model.rings[face.first_ring];
    for (uint64_t i = 0; i < ring.count; ++i)
      extent.add(view(model.vertices[model.corners[ring.first + i]]));
  }
  if (extent.n == 0) return out;
  out.depth_m = extent.mean().y;
  if (out.kind == DrawnFace::Kind::kEdgeOn) set_edge(out, face, view, extent);
  return out;
}

// Places of the groups on their sides: the colours grow from the main plane outward.
void rank_groups(std::vector<DepthGroup>& groups) {
  size_t front = 0, behind = 0;
  for (DepthGroup& group : groups)
    if (group.side > 0) group.rank = behind++;
  for (size_t i = groups.size(); i-- > 0;)
    if (groups[i].side < 0) groups[i].rank = front++;
}

// Front faces from near to far, those within half a step of the main plane together, the others as far as a step
// reaches; the steps double until the groups can be told apart by colour. Faces of one plane, whose depths rounding
// alone tells apart, are one colour wherever a step ends.
std::vector<DepthGroup> group_depths(std::vector<DrawnFace>& faces) {
  std::vector<DrawnFace*> front;
  for (DrawnFace& face : faces)
    if (face.kind == DrawnFace::Kind::kFront && face.role != DrawnFace::Role::kNoData)
      front.push_back(&face);
  std::stable_sort(front.begin(), front.end(),
                   [](const DrawnFace* a, const DrawnFace* b) { return a->depth_m < b->depth_m; });
  std::vector<DepthGroup> groups;
  for (double step = kFirstStep_m;; step *= 2) {
    groups.clear();
    double depth = 0;  // of the first face of the plane
    for (size_t i = 0; i < front.size(); ++i) {
      DrawnFace* face = front[i];
      if (i == 0 || face->depth_m - front[i - 1]->depth_m > kRounding_m) depth = face->depth_m;
      const int side = std::fabs(depth) <= step / 2 ? 0 : depth < 0 ? -1 : 1;
      if (groups.empty() || side != groups.back().side ||
          (side != 0 && depth - groups.back().from_m > step))
        groups.push_back({depth, depth, 0, side, 0});
      groups.back().to_m = face->depth_m;
      ++groups.back().faces;
      face->group = groups.size() - 1;
    }
    if (groups.size() <= kMaxDepthGroups) break;
  }
  rank_groups(groups);
  return groups;
}

// The farthest first; of one plane in the order of the model, whatever rounding makes of their depths, and marks of
// missing data last: they lie on their wall.
void sort_for_drawing(std::vector<DrawnFace>& faces) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const DrawnFace& a, const DrawnFace& b) { return a.depth_m > b.depth_m; });
  for (auto begin = faces.begin(), end = begin; begin != faces.end(); begin = end) {
    do ++end;
    while (end != faces.end() && (end - 1)->depth_m - end->depth_m <= kRounding_m);
    std::stable_sort(begin, end, [](const DrawnFace& a, const DrawnFace& b) {
      const auto order = [](const DrawnFace& f) {
        return std::pair(f.role == DrawnFace::Role::kNoData, f.face);
      };
      return order(a) < order(b);
    });
  }
}

void set_box(ElevationFaces& out) {
  const bool has_front = !out.groups.empty();
  Extent extent, wall;
  for (const DrawnFace& face : out.faces) {
    if (has_front && face.kind != DrawnFace::Kind::kFront) continue;
    for (const auto& ring : face.rings)
      for (const Vec2& p : ring.polygon) {
        extent.add({p.u, 0, p.v});
        if (face.role == DrawnFace::Role::kWall) wall.add({p.u, 0, p.v});
      }
  }
  out.empty = extent.n == 0;
  if (out.empty) return;
  out.low = {extent.low.x, extent.low.z};
  out.high = {extent.high.x, extent.high.z};
  const Extent& body = wall.n > 0 ? wall : extent;
  out.wall_low = {body.low.x, body.low.z};
  out.wall_high = {body.high.x, body.high.z};
}

// The front face of the largest area that is a wall; of any role where none is.
size_t main_face(const ElevationFaces& out, const Model& model) {
  size_t best = out.faces.size();
  double best_area = kNoArea;
  bool best_is_wall = false;
  for (size_t i = 0; i < out.faces.size(); ++i) {
    const DrawnFace& face = out.faces[i];
    const bool is_wall = face.role == DrawnFace::Role::kWall;
    const double area = model.faces[face.face].area_m2;
    if (face.kind != DrawnFace::Kind::kFront || face.role == DrawnFace::Role::kNoData) continue;
    if (std::pair(is_wall, area) <= std::pair(best_is_wall, best_area)) continue;
    best = i, best_area = area, best_is_wall = is_wall;
  }
  return best;
}

// What lies beyond the limits; of the elements also what no wall is near behind: cars, trees.
void leave_out(std::vector<DrawnFace>& faces, const ViewLimits& limits) {
  std::vector<double> walls;
  for (const DrawnFace& face : faces)
    if (face.role == DrawnFace::Role::kWall) walls.push_back(face.depth_m);
  std::sort(walls.begin(), walls.end());
  std::erase_if(faces, [&](const DrawnFace& face) {
    if (face.depth_m < -limits.in_front_m || face.depth_m > limits.behind_m) return true;
    if (walls.empty() || face.role != DrawnFace::Role::kElement) return false;
    const auto behind = std::lower_bound(walls.begin(), walls.end(), face.depth_m);
    return behind != walls.end() && *behind > face.depth_m + limits.element_reach_m;
  });
}

}  // namespace

ElevationFaces elevation_faces(const Model& model, const ElevationView& view,
                               const ViewLimits& limits, Task& task) {
  ElevationFaces out;
  const PartTree tree(model);
  for (size_t i = 0; i < model.faces.size(); ++i) {
    if (i % 64 == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(model.faces.size()));
    if (!view.shows(i)) continue;
    DrawnFace drawn = draw_face(model, tree, i, view, limits.front_angle_rad);
    if (drawn.rings.empty() || drawn.rings.front().corners.size() < 2) continue;
    if (drawn.kind == DrawnFace::Kind::kEdgeOn && is_reveal(model, model.faces[i]))
      continue;  // the contour itself
    out.faces.push_back(std::move(drawn));
  }
  const size_t main = main_face(out, model);
  const bool has_main = main < out.faces.size();
  const double main_depth = has_main ? out.faces[main].depth_m : 0;
  if (has_main) out.main_sigma_m = model.faces[out.faces[main].face].sigma_m;
  // Without any face to the front the depths mean nothing, and nothing is left out.
  for (DrawnFace& face : out.faces) face.depth_m = has_main ? face.depth_m - main_depth : 0;
  leave_out(out.faces, limits);
  out.groups = group_depths(out.faces);
  sort_for_drawing(out.faces);
  set_box(out);
  if (out.empty) return out;
  out.ground_m = ground_level(out, model, view);
  out.corner_world = inverse(view.T_view_world)
                         .point({out.wall_low.u, main_depth, out.low.v + view.T_view_world.m[11]});
  return out;
}

}  // namespace jalon
