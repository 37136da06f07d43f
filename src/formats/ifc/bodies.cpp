// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/bodies.h"

#include <algorithm>

#include "model/chords.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon::ifc {

namespace {

// A cut ends in the air before and behind the wall: faces that lie on one another are what programs that subtract
// solids stumble over.
constexpr double kBeyond_m = 0.05;

// Without corners that repeat the one before them.
template <class T>
void drop_repeated(std::vector<T>& loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
}

}  // namespace

Bodies::Loop Bodies::loop_of(Points& points, const Ring& ring) const {
  Loop loop;
  for (uint64_t i = ring.first; i < ring.first + ring.count; ++i) {
    const uint32_t vertex = model_.corners[i];
    const auto [at, is_new] =
        points.of_vertex.emplace(vertex, static_cast<uint32_t>(points.places.size()));
    if (is_new) points.places.push_back(model_.vertices[vertex] - origin_);
    loop.push_back(at->second);
  }
  drop_repeated(loop);
  return loop;
}

void Bodies::add_face(Points& points, std::vector<Polygon>& polygons, uint32_t f) const {
  const Face& face = model_.faces[f];
  Polygon polygon;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r) {
    Loop loop = loop_of(points, model_.rings[r]);
    if (loop.size() >= 3) polygon.loops.push_back(std::move(loop));
    else if (r == face.first_ring) return;
  }
  if (!polygon.loops.empty()) polygons.push_back(std::move(polygon));
}

std::vector<Id> Bodies::items_of(const Shape& shape) {
  std::vector<Id> items;
  for (const uint32_t s : shape.solids) {
    const Solid& solid = model_.solids[s];
    Points points;
    std::vector<Polygon> polygons;
    for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f)
      add_face(points, polygons, static_cast<uint32_t>(f));
    if (!polygons.empty()) items.push_back(face_set(points, polygons, true));
  }
  if (!shape.faces.empty()) {
    Points points;
    std::vector<Polygon> polygons;
    for (const uint32_t f : shape.faces) add_face(points, polygons, f);
    if (!polygons.empty()) items.push_back(face_set(points, polygons, false));
  }
  if (!shape.triangles.empty()) {
    Points points;
    Values corners;
    for (const uint32_t t : shape.triangles) {
      Values triangle;
      for (const uint32_t vertex : model_.triangles[t]) {
        const auto [at, is_new] =
            points.of_vertex.emplace(vertex, static_cast<uint32_t>(points.places.size()));
        if (is_new) points.places.push_back(model_.vertices[vertex] - origin_);
        triangle.integer(at->second + 1);
      }
      corners.list(triangle);
    }
    const Id list = point_list(points.places);
    items.push_back(file_.add("IFCTRIANGULATEDFACESET",
                              Values().id(list).none().flag(false).list(corners).none()));
  }
  return items;
}

std::vector<Vec3> Bodies::corners_of(const Ring& ring) const {
  std::vector<Vec3> corners;
  for (uint64_t i = ring.first; i < ring.first + ring.count; ++i)
    corners.push_back(model_.vertices[model_.corners[i]] - origin_);
  drop_repeated(corners);
  return corners;
}

// rings: the outline anticlockwise seen from where "along" comes from, then its holes clockwise.
Id Bodies::prism(const std::vector<std::vector<Vec3>>& rings, const Vec3& along) {
  Points points;
  Polygon near, far;
  std::vector<Polygon> polygons;
  for (const auto& ring : rings) {
    const auto first = static_cast<uint32_t>(points.places.size());
    const auto n = static_cast<uint32_t>(ring.size());
    Loop front(n), back(n);
    for (uint32_t i = 0; i < n; ++i) front[i] = first + i, back[n - 1 - i] = first + n + i;
    for (const Vec3& p : ring) points.places.push_back(p);
    for (const Vec3& p : ring) points.places.push_back(p + along);
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t j = (i + 1) % n;
      polygons.push_back({{{first + i, first + n + i, first + n + j, first + j}}});
    }
    near.loops.push_back(std::move(front));
    far.loops.push_back(std::move(back));
  }
  polygons.push_back(std::move(near));
  polygons.push_back(std::move(far));
  return face_set(points, polygons, true);
}

std::vector<Id> Bodies::walls_of(const Shape& shape, double thickness_m) {
  std::vector<Id> items = items_of({shape.solids, {}, shape.triangles});
  for (const uint32_t f : shape.faces) {
    const Face& face = model_.faces[f];
    std::vector<std::vector<Vec3>> rings;
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r) {
      const Ring& ring = model_.rings[r];
      const bool is_opening = r > face.first_ring && ring.part < model_.parts.size() &&
                              part_class::is_opening(model_.parts[ring.part].part_class);
      if (is_opening) continue;
      auto corners = corners_of(ring);
      if (corners.size() >= 3) rings.push_back(std::move(corners));
      else if (r == face.first_ring) break;
    }
    if (!rings.empty()) items.push_back(prism(rings, -thickness_m * normal_of(model_, face)));
  }
  return items;
}

std::vector<Id> Bodies::outlines_of(const std::vector<Hole>& holes) {
  Points points;
  std::vector<Polygon> polygons;
  for (const Hole& hole : holes) {
    Loop loop = loop_of(points, model_.rings[hole.ring]);
    if (loop.size() < 3) continue;
    std::ranges::reverse(loop);  // holes run clockwise
    polygons.push_back({{std::move(loop)}});
  }
  if (polygons.empty()) return {};
  return {face_set(points, polygons, false)};
}

std::vector<Id> Bodies::cuts_of(const std::vector<Hole>& holes, double thickness_m) {
  std::vector<Id> items;
  for (const Hole& hole : holes) {
    auto corners = corners_of(model_.rings[hole.ring]);
    if (corners.size() < 3) continue;
    const Vec3 normal = normal_of(model_, model_.faces[hole.face]);
    std::ranges::reverse(corners);
    for (Vec3& p : corners) p = p + kBeyond_m * normal;
    items.push_back(prism({corners}, -(thickness_m + 2 * kBeyond_m) * normal));
  }
  return items;
}

Id Bodies::point_list(const std::vector<Vec3>& places) {
  Values list;
  for (const Vec3& p : places) list.point(p);
  return file_.add("IFCCARTESIANPOINTLIST3D", Values().list(list));
}

Id Bodies::face_set(const Points& points, const std::vector<Polygon>& polygons, bool is_closed) {
  const Id list = point_list(points.places);
  const auto numbers = [](const Loop& loop) {
    Values out;
    for (const uint32_t at : loop) out.integer(at + 1);
    return out;
  };
  std::vector<Id> faces;
  for (const Polygon& polygon : polygons) {
    Values outline = Values().list(numbers(polygon.loops[0]));
    if (polygon.loops.size() == 1) {
      faces.push_back(file_.add("IFCINDEXEDPOLYGONALFACE", outline));
      continue;
    }
    Values holes;
    for (size_t k = 1; k < polygon.loops.size(); ++k) holes.list(numbers(polygon.loops[k]));
    faces.push_back(file_.add("IFCINDEXEDPOLYGONALFACEWITHVOIDS", outline.list(holes)));
  }
  return file_.add("IFCPOLYGONALFACESET", Values().id(list).flag(is_closed).ids(faces).none());
}

double Bodies::volume_m3(uint32_t s) const {
  const Solid& solid = model_.solids[s];
  double six = 0;
  for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f)
    for (const auto& t : triangles_of_face(model_, model_.faces[f])) {
      const auto at = [&](size_t k) { return model_.vertices[t[k]] - origin_; };
      six += dot(at(0), cross(at(1), at(2)));
    }
  return six / 6;
}

}  // namespace jalon::ifc
