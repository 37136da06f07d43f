// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/truth.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.h"
#include "base/parallel.h"
#include "scan/touching.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

/// Corners of a triangle without area give no plane: below this share of the longest edge squared.
constexpr double kSliver = 1e-12;
constexpr double kOfFace_m = 1e-5;  // of a triangle's corners from the plane of its face

/// First face of each id.
std::unordered_map<uint32_t, uint32_t> faces_of_ids(const Model& model) {
  std::unordered_map<uint32_t, uint32_t> faces;
  for (uint32_t f = 0; f < model.faces.size(); ++f) faces.try_emplace(model.faces[f].id, f);
  return faces;
}

/// The face's plane says more than the rounded corners of a narrow triangle, unless the id is of several planes.
void take_plane_of(const Face& face, const Vec3& origin, FlatTriangle& triangle) {
  const Plane plane{face.plane.normal, face.plane.offset - dot(face.plane.normal, origin)};
  for (const Vec3& c : triangle.corners)
    if (!(std::abs(plane.distance(c)) <= kOfFace_m)) return;
  triangle.plane = plane;
}

/// The triangles that may belong to a plane, with their planes, relative to the origin.
std::vector<FlatTriangle> flat_triangles(const Model& model, const Vec3& origin,
                                         const std::unordered_map<uint32_t, uint32_t>& faces) {
  std::vector<FlatTriangle> out;
  for (uint32_t t = 0; t < model.triangles.size(); ++t) {
    const auto face = faces.find(model.triangle_faces[t]);
    if (!model.faces.empty() && face == faces.end()) continue;
    FlatTriangle flat;
    flat.number = t;
    for (size_t k = 0; k < 3; ++k) flat.corners[k] = model.vertices[model.triangles[t][k]] - origin;
    const Vec3 a = flat.corners[1] - flat.corners[0], b = flat.corners[2] - flat.corners[0];
    const Vec3 twice = cross(a, b);
    const double length = norm(twice);
    if (!(length > kSliver * std::max(squared_norm(a), squared_norm(b)))) continue;
    flat.area = length / 2;
    flat.plane.normal = twice / length;
    flat.plane.offset = dot(flat.plane.normal, flat.corners[0]);
    if (face != faces.end()) take_plane_of(model.faces[face->second], origin, flat);
    out.push_back(flat);
  }
  return out;
}

struct Edge {
  Vec3 a, b;
  uint32_t triangle;
};

bool less(const Vec3& a, const Vec3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// Joins coplanar triangles with an edge in common, by its coordinates: meshes need not share vertices.
void join_by_edges(const std::vector<FlatTriangle>& flats, UnionFind& groups, Task& task) {
  std::vector<Edge> edges;
  edges.reserve(3 * flats.size());
  for (uint32_t i = 0; i < flats.size(); ++i)
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 &a = flats[i].corners[k], &b = flats[i].corners[(k + 1) % 3];
      edges.push_back(less(a, b) ? Edge{a, b, i} : Edge{b, a, i});
    }
  task.checkpoint(0.1);
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return !(a.a == b.a) ? less(a.a, b.a) : !(a.b == b.b) ? less(a.b, b.b) : a.triangle < b.triangle;
  });
  task.checkpoint(0.3);
  for (size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i + 1; j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b; ++j)
      for (size_t k = i; k < j; ++k)
        if (are_coplanar(flats[edges[k].triangle], flats[edges[j].triangle]))
          groups.join(edges[k].triangle, edges[j].triangle);
  }
}

/// Numbers the groups that are large enough by their first triangle.
Truth numbered(const Model& model, const Vec3& origin, const std::vector<FlatTriangle>& flats, UnionFind& groups,
               const std::unordered_map<uint32_t, uint32_t>& faces, double min_area_m2) {
  // 1. Area, and the largest triangle, of each group's root.
  std::vector<double> area(flats.size(), 0);
  std::vector<uint32_t> largest(flats.size());
  for (uint32_t i = 0; i < flats.size(); ++i) {
    const uint32_t root = groups.find(i);
    if (root == i) largest[root] = i;
    area[root] += flats[i].area;
    if (flats[i].area > flats[largest[root]].area) largest[root] = i;
  }
  // 2. Numbers: a root is the first triangle of its group.
  Truth truth;
  truth.triangle_segments.assign(model.triangles.size(), kNoSegment);
  std::vector<uint32_t> number(flats.size(), kNoSegment);
  for (uint32_t i = 0; i < flats.size(); ++i) {
    const uint32_t root = groups.find(i);
    if (root == i && area[i] >= min_area_m2) {
      const FlatTriangle& main = flats[largest[i]];
      TruePlane plane{main.plane, area[i], model.triangle_faces[main.number], 0};
      plane.plane.offset += dot(plane.plane.normal, origin);
      if (const auto face = faces.find(plane.face); face != faces.end()) plane.part = model.faces[face->second].part;
      truth.planes.push_back(plane);
      number[i] = static_cast<uint32_t>(truth.planes.size());
    }
    truth.triangle_segments[flats[i].number] = number[root];
  }
  return truth;
}

}  // namespace

Truth find_truth(const Model& model, double min_area_m2, Task& task) {
  const Vec3 first = model.triangles.empty() ? Vec3{} : model.vertices[model.triangles[0][0]];
  const Vec3 origin{std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  const auto faces = faces_of_ids(model);
  const std::vector<FlatTriangle> flats = flat_triangles(model, origin, faces);
  UnionFind groups(flats.size());
  join_by_edges(flats, groups, task);
  task.checkpoint(0.5);
  join_touching(flats, groups, task);
  return numbered(model, origin, flats, groups, faces, min_area_m2);
}

FieldTable truth_table(const Truth& truth, const Vec3& shift, std::span<const uint32_t> labels, Task& task) {
  constexpr size_t kGrain = 1 << 16;
  const size_t n = truth.planes.size();
  std::vector<uint32_t> segment, face, part;
  std::vector<double> normal, offset, area;
  std::vector<uint64_t> count(n, 0);
  for (size_t begin = 0; begin < labels.size(); begin += kGrain) {
    task.checkpoint(static_cast<double>(begin) / static_cast<double>(labels.size()));
    for (size_t i = begin; i < std::min(labels.size(), begin + kGrain); ++i)
      if (labels[i] != kNoSegment && labels[i] <= n) ++count[labels[i] - 1];
  }
  for (const TruePlane& p : truth.planes) {
    segment.push_back(static_cast<uint32_t>(segment.size() + 1));
    face.push_back(p.face);
    part.push_back(p.part);
    normal.insert(normal.end(), {p.plane.normal.x, p.plane.normal.y, p.plane.normal.z});
    offset.push_back(p.plane.offset + dot(p.plane.normal, shift));
    area.push_back(p.area_m2);
  }
  FieldTable table;
  const auto set = [&]<class T>(const char* name, uint32_t components, const char* unit, const char* meaning,
                                const std::vector<T>& values) {
    table.set(make_column<T>({name, element_type_of<T>(), components, unit, meaning}, values));
  };
  set("segment", 1, "", "number in the field segment of the points", segment);
  set("face", 1, "", "id of its largest face", face);
  set("part", 1, "", "part of that face", part);
  set("normal", 3, "1", "unit normal", normal);
  set("offset", 1, "m", "normal . p = offset", offset);
  set("area", 1, "m2", "openings taken off", area);
  set("count", 1, "", "points of the cloud", count);
  return table;
}

}  // namespace jalon
