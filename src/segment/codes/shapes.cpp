// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/shapes.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "geometry/polygon2.h"
#include "segment/codes/curves.h"
#include "segment/codes/openings.h"

namespace jalon {

namespace {

constexpr double kFootBelowEaves_m = 0.5;    // the low point lies this far below all upper corners
constexpr double kUsualPipeRadius_m = 0.04;  // mean of twelve surveyed downpipes, 0.039

class Shapes {
 public:
  Shapes(const CodeTable& table, CodedObjects& all) : modifiers_(table.modifiers), all_(all) {}

  void give(CodedObject& object) {
    switch (object.row.geometry) {
      case CodeGeometry::kPrism:
        return prism(object);
      case CodeGeometry::kTwoCorners:
      case CodeGeometry::kThreePoints:
      case CodeGeometry::kFourPoints:
        return rectangle(object);
      case CodeGeometry::kOutline:
        return outline(object);
      case CodeGeometry::kCylinderCentre:
        return cylinder(object);
      case CodeGeometry::kPipe:
        return pipe(object);
      default:
        return;
    }
  }

 private:
  Vec3 local(const CodedPoint& p) const { return p.position - all_.origin; }
  void warn(const CodedObject& object, size_t at, std::string text) {
    all_.warnings.push_back({object.points[at].line, object.name, std::move(text)});
  }

  // The low points are removed from the outline; they are those at the foot, well below the rest.
  void prism(CodedObject& object) {
    double lowest = INFINITY, highest = -INFINITY;
    for (const CodedPoint& p : object.points) {
      lowest = std::min(lowest, local(p).z);
      highest = std::max(highest, local(p).z);
    }
    const bool has_foot = highest - lowest > kFootBelowEaves_m;
    std::vector<LinkagePoint> corners;
    for (const CodedPoint& p : object.points)
      if (!has_foot || local(p).z > lowest + kFootBelowEaves_m)
        corners.push_back({in_plan(local(p)), p.modifier == modifiers_.curve});
    std::vector<Vec2> polygon = linkage_line(corners, true);
    if (!is_outline(object, polygon)) return;
    if (!has_foot)
      warn(object, 0, "has no low point: its walls reach down as far as the cloud does");
    object.shape.kind = CodeShape::Kind::kPrism;
    object.shape.polygon = std::move(polygon);
    object.shape.low_m = has_foot ? lowest : -INFINITY;
    object.shape.high_m = highest;
  }

  bool is_outline(const CodedObject& object, const std::vector<Vec2>& polygon) {
    if (polygon.size() < 3) {
      warn(object, 0,
           "an outline of " + std::to_string(polygon.size()) + " points holds nothing: left out");
      return false;
    }
    if (!is_simple(polygon)) {
      warn(object, 0, "its outline crosses itself: left out");
      return false;
    }
    return true;
  }

  void rectangle(CodedObject& object) {
    const OpeningCorners corners = opening_corners(object.points, modifiers_.offset);
    if (!corners.fault.empty()) return warn(object, corners.fault_at, corners.fault);
    object.shape.kind = CodeShape::Kind::kRectangle;
    object.shape.corner_a = corners.a - all_.origin;
    object.shape.corner_b = corners.b - all_.origin;
    object.shape.low_m = std::min(object.shape.corner_a.z, object.shape.corner_b.z);
    object.shape.high_m = std::max(object.shape.corner_a.z, object.shape.corner_b.z);
  }

  // The wall's line in plan joins the two points that lie farthest apart along it.
  void outline(CodedObject& object) {
    if (object.points.back().modifier != modifiers_.close)
      warn(object, object.points.size() - 1, "is not closed: joined to its first point");
    size_t a = 0, b = 0;
    for (size_t i = 0; i < object.points.size(); ++i)
      for (size_t k = 0; k < i; ++k)
        if (norm(in_plan(local(object.points[i]) - local(object.points[k]))) >
            norm(in_plan(local(object.points[b]) - local(object.points[a])))) {
          a = k;
          b = i;
        }
    const Vec3 from = local(object.points[a]), to = local(object.points[b]);
    const Vec2 along = in_plan(to - from);
    if (norm(along) == 0) return warn(object, 0, "its points stand above each other: left out");
    std::vector<LinkagePoint> border;
    for (const CodedPoint& p : object.points)
      border.push_back({{dot(in_plan(local(p) - from), along) / norm(along), local(p).z},
                        p.modifier == modifiers_.curve});
    std::vector<Vec2> polygon = linkage_line(border, true);
    if (!is_outline(object, polygon)) return;
    CodeShape& shape = object.shape;
    shape.kind = CodeShape::Kind::kOutline;
    shape.corner_a = from;
    shape.corner_b = to;
    shape.low_m = INFINITY;
    shape.high_m = -INFINITY;
    for (const Vec2& p : polygon) {
      shape.low_m = std::min(shape.low_m, p.v);
      shape.high_m = std::max(shape.high_m, p.v);
    }
    shape.polygon = std::move(polygon);
  }

  // Upright, from the foot to the height of the top: where the prism was held there does not count.
  void cylinder(CodedObject& object) {
    const Vec3 centre = local(object.points[0]);
    const double top = local(object.points[2]).z;
    const double radius = norm(in_plan(local(object.points[1]) - centre));
    if (!(radius > 0) || !(top > centre.z))
      return warn(object, 0, "has no radius or no height: left out");
    object.shape.kind = CodeShape::Kind::kPipe;
    object.shape.axis = {centre, {centre.x, centre.y, top}};
    object.shape.radius_m = radius;
    object.shape.low_m = centre.z;
    object.shape.high_m = top;
  }

  // Its axis bends at the points; the offset point lies on the skin of the first length.
  void pipe(CodedObject& object) {
    CodeShape& shape = object.shape;
    const CodedPoint* skin = nullptr;
    for (const CodedPoint& p : object.points)
      if (p.modifier == modifiers_.offset) skin = &p;
      else shape.axis.push_back(local(p));
    if (shape.axis.size() < 2 || shape.axis[0] == shape.axis[1])
      return warn(object, 0, "has fewer than two points on its axis: left out");
    shape.kind = CodeShape::Kind::kPipe;
    shape.radius_m = kUsualPipeRadius_m;
    if (skin != nullptr) {
      const Vec3 along = normalized(shape.axis[1] - shape.axis[0]);
      shape.radius_m = norm(cross(local(*skin) - shape.axis[0], along));
    } else {
      warn(object, 0, "has no offset point on its skin: a radius of 0.04 m is taken");
    }
    shape.low_m = INFINITY;
    shape.high_m = -INFINITY;
    for (const Vec3& p : shape.axis) {
      shape.low_m = std::min(shape.low_m, p.z - shape.radius_m);
      shape.high_m = std::max(shape.high_m, p.z + shape.radius_m);
    }
  }

  const CodeModifiers& modifiers_;
  CodedObjects& all_;
};

// The outward normal of the building's edge that is nearest to a place in plan.
Vec2 outward_at(const std::vector<Vec2>& polygon, const Vec2& place, double& distance) {
  const double side = signed_area(polygon) > 0 ? 1 : -1;
  Vec2 normal;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double d = segment_distance(place, a, b);
    if (d >= distance) continue;
    distance = d;
    normal = Vec2{(b - a).v, (a - b).u} * side;
  }
  return normal;
}

// The hinge side of a door is measured first (field rules): seen from outside it is on the left or right.
void give_hinge(const CodedObjects& all, CodedObject& door) {
  const CodeShape& shape = door.shape;
  if (shape.kind != CodeShape::Kind::kRectangle) return;
  const Vec2 middle = in_plan(0.5 * (shape.corner_a + shape.corner_b));
  double nearest = 1;  // m: farther walls are not the door's
  Vec2 outward;
  for (const CodedObject& building : all.objects)
    if (building.shape.kind == CodeShape::Kind::kPrism) {
      double distance = nearest;
      const Vec2 normal = outward_at(building.shape.polygon, middle, distance);
      if (distance < nearest) outward = normal;
      nearest = distance;
    }
  if (norm(outward) == 0) return;
  const Vec2 right{-outward.v, outward.u};
  const Vec2 first = in_plan(door.points[0].position - all.origin);
  door.hinge = dot(first - middle, right) > 0 ? Hinge::kRight : Hinge::kLeft;
}

}  // namespace

const char* name_of(CodeShape::Kind kind) {
  constexpr const char* kNames[] = {"none", "prism", "rectangle", "outline", "cylinder"};
  return kNames[static_cast<size_t>(kind)];
}

void give_shapes(const CodeTable& table, CodedObjects& all) {
  Shapes shapes(table, all);
  for (CodedObject& object : all.objects) shapes.give(object);
  for (CodedObject& object : all.objects)
    if (object.row.is_hinged) give_hinge(all, object);
}

}  // namespace jalon
