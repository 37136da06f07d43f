// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/compared_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "model/topology.h"

namespace jalon {

namespace {

constexpr double kLeastArea_m2 = 1e-8;  // a square of the polygons' grid
constexpr size_t kFacesPerChunk = 16;   // areas of polygons: some 10 us each
constexpr size_t kComparedFacesFacesPerCheckpoint = 256;
constexpr Vec3 kAlongX{1, 0, 0};

// Twice the vector area of a closed chain (Newell), about its first corner.
Vec3 vector_area(const std::vector<Vec3>& corners) {
  Vec3 sum;
  for (size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

std::vector<Vec3> ring_corners(const Model& model, const Ring& ring, const Vec3& origin) {
  std::vector<Vec3> out;
  for (uint64_t i = 0; i < ring.count; ++i)
    out.push_back(model.vertices[model.corners[ring.first + i]] - origin);
  return out;
}

// The plane that the corners tell; where they tell none (a circle of two arcs) the face's own.
PlaneFrame frame_of(const std::vector<Vec3>& corners, const Vec3& fallback_normal) {
  Vec3 centre, area = vector_area(corners);
  for (const Vec3& p : corners) centre += p;
  if (!corners.empty()) centre = centre / static_cast<double>(corners.size());
  const Vec3 normal = norm(area) > kLeastArea_m2 ? normalized(area) : normalized(fallback_normal);
  return plane_frame({normal, dot(normal, centre)}, centre, kAlongX);
}

// A ring in a frame, its arcs as chords. mirrored: the frame's normal is against the face's.
std::vector<Vec2> chorded(const Model& model, const Ring& ring, const Vec3& origin,
                          const PlaneFrame& frame, bool mirrored) {
  std::vector<Vec2> out;
  const std::vector<Vec3> corners = ring_corners(model, ring, origin);
  for (size_t i = 0; i < corners.size(); ++i) {
    const double sagitta_m = model.sagitta(ring.first + i);
    append_arc(out, frame.project(corners[i]), frame.project(corners[(i + 1) % corners.size()]),
               mirrored ? -sagitta_m : sagitta_m, kPolygonGrid_m);
  }
  return out;
}

void finish(ComparedFace& face) {
  face.area_m2 = region_area(face.region);
  for (const PolygonWithHoles& polygon : face.region)
    for (const Vec2& p : polygon.outline) face.box.add(face.frame.lift(p));
}

// Where a ring turns, or an arc begins or ends: what others would survey too. The joints of an arc drawn as chords are
// nobody's corners.
void add_vertices(const Model& model, const Ring& ring, double corner_angle_rad,
                  std::vector<uint32_t>& out) {
  for (uint64_t i = 0; i < ring.count; ++i) {
    const uint64_t before = ring.first + (i + ring.count - 1) % ring.count, here = ring.first + i,
                   after = ring.first + (i + 1) % ring.count;
    const Vec3& p = model.vertices[model.corners[here]];
    const Vec3 in = p - model.vertices[model.corners[before]],
               on = model.vertices[model.corners[after]] - p;
    const bool turns = std::atan2(norm(cross(in, on)), dot(in, on)) >= corner_angle_rad;
    if (turns || model.sagitta(before) != 0 || model.sagitta(here) != 0)
      out.push_back(model.corners[here]);
  }
}

ComparedFace whole_face(const Model& model, size_t f, const Vec3& origin, double corner_angle_rad) {
  const Face& face = model.faces[f];
  ComparedFace out;
  out.face = static_cast<uint32_t>(f);
  out.part = face.part;
  PolygonWithHoles polygon;
  for (uint64_t r = 0; r < face.ring_count; ++r) {
    const Ring& ring = model.rings[face.first_ring + r];
    if (r == 0) out.frame = frame_of(ring_corners(model, ring, origin), face.plane.normal);
    const bool mirrored = dot(out.frame.normal, face.plane.normal) < 0;
    std::vector<Vec2> corners = chorded(model, ring, origin, out.frame, mirrored);
    if (r == 0) polygon.outline = std::move(corners);
    else polygon.holes.push_back(std::move(corners));
    add_vertices(model, ring, corner_angle_rad, out.vertices);
  }
  out.region.push_back(std::move(polygon));
  finish(out);
  return out;
}

ComparedFace opening_face(const Model& model, size_t f, size_t r, const Vec3& origin,
                          double corner_angle_rad) {
  const Face& face = model.faces[f];
  const Ring& ring = model.rings[r];
  ComparedFace out;
  out.face = static_cast<uint32_t>(f);
  out.ring = static_cast<uint32_t>(r);
  out.part = ring.part < model.parts.size() ? ring.part : face.part;
  std::vector<Vec3> corners = ring_corners(model, ring, origin);
  std::reverse(corners.begin(), corners.end());  // openings run clockwise: the normal is the face's
  out.frame = frame_of(corners, face.plane.normal);
  const bool mirrored = dot(out.frame.normal, face.plane.normal) < 0;
  out.region.push_back({chorded(model, ring, origin, out.frame, mirrored), {}});
  add_vertices(model, ring, corner_angle_rad, out.vertices);
  finish(out);
  return out;
}

ComparedFace triangle_face(const Model& model, size_t t, const Vec3& origin) {
  ComparedFace out;
  out.face = static_cast<uint32_t>(t);
  std::vector<Vec3> corners;
  for (const uint32_t v : model.triangles[t])
    corners.push_back(model.vertices[v] - origin), out.vertices.push_back(v);
  out.frame = frame_of(corners, {0, 0, 1});
  PolygonWithHoles polygon;
  for (const Vec3& p : corners) polygon.outline.push_back(out.frame.project(p));
  out.region.push_back(std::move(polygon));
  finish(out);
  return out;
}

bool is_chosen(const Model& model, uint32_t part, const FaceChoice& choice) {
  const std::string name = part < model.parts.size() ? model.parts[part].part_class : "";
  const auto among = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return (choice.classes.empty() || among(choice.classes)) && !among(choice.ignored_classes);
}

// Largest first, so that a plane is that of its largest face; then in the order of those.
std::vector<ComparedFace> merged_by_plane(std::vector<ComparedFace> faces, const FaceChoice& choice,
                                          Task& task) {
  std::vector<size_t> order(faces.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return faces[a].area_m2 > faces[b].area_m2; });
  std::vector<ComparedFace> planes;
  size_t done = 0;
  for (const size_t f : order) {
    if (done++ % kComparedFacesFacesPerCheckpoint == 0) task.checkpoint(0);
    const auto plane = std::find_if(planes.begin(), planes.end(), [&](const ComparedFace& p) {
      return on_plane_of(p, faces[f], {}, choice);
    });
    if (plane == planes.end()) {
      planes.push_back(std::move(faces[f]));
      continue;
    }
    for (PolygonWithHoles& polygon : region_in(plane->frame, faces[f], {}))
      plane->region.push_back(std::move(polygon));
    plane->vertices.insert(plane->vertices.end(), faces[f].vertices.begin(),
                           faces[f].vertices.end());
    plane->merged += faces[f].merged;
  }
  parallel_for(task, planes.size(), 1, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (planes[p].merged > 1)  // borders inside are none
        planes[p].region = combined(SetOperation::kUnion, planes[p].region, {});
      finish(planes[p]);
    }
  });
  return planes;
}

}  // namespace

bool on_plane_of(const ComparedFace& reference, const ComparedFace& face, const Vec3& shift,
                 const FaceChoice& choice) {
  return plane_angle(reference.frame.normal, face.frame.normal) <= choice.angle_rad &&
         std::fabs(plane_distance(reference, face, shift)) <= choice.distance_m;
}

double plane_distance(const ComparedFace& reference, const ComparedFace& face, const Vec3& shift) {
  return dot(reference.frame.normal, face.frame.origin + shift - reference.frame.origin);
}

double plane_angle(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), std::fabs(dot(a, b)));
}

std::vector<PolygonWithHoles> region_in(const PlaneFrame& frame, const ComparedFace& face,
                                        const Vec3& shift) {
  const auto moved = [&](std::vector<Vec2> corners) {
    for (Vec2& p : corners) p = frame.project(face.frame.lift(p) + shift);
    return corners;
  };
  std::vector<PolygonWithHoles> out;
  for (const PolygonWithHoles& polygon : face.region) {
    out.push_back({moved(polygon.outline), {}});
    for (const auto& hole : polygon.holes) out.back().holes.push_back(moved(hole));
  }
  return out;
}

std::vector<ComparedFace> compared_faces(const Model& model, const Vec3& origin,
                                         const FaceChoice& choice, Task& task) {
  struct Source {
    size_t face, ring;  ///< of a mesh the triangle
  };
  const bool is_mesh = model.faces.empty();
  std::vector<Source> sources;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const size_t first = model.faces[f].first_ring, count = model.faces[f].ring_count;
    for (size_t r = 0; r < count; ++r)
      if ((r > 0) == choice.openings) sources.push_back({f, first + r});
  }
  if (is_mesh && !choice.openings)
    for (size_t t = 0; t < model.triangles.size(); ++t) sources.push_back({t, 0});
  std::vector<ComparedFace> faces(sources.size());
  parallel_for(task, sources.size(), kFacesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto [f, r] = sources[i];
      faces[i] = is_mesh           ? triangle_face(model, f, origin)
                 : choice.openings ? opening_face(model, f, r, origin, choice.corner_angle_rad)
                                   : whole_face(model, f, origin, choice.corner_angle_rad);
    }
  });
  std::erase_if(faces, [&](const ComparedFace& face) {
    return !(face.area_m2 > kLeastArea_m2) || (!is_mesh && !is_chosen(model, face.part, choice));
  });
  if (choice.by_plane || is_mesh) faces = merged_by_plane(std::move(faces), choice, task);
  for (ComparedFace& face : faces) face.kept = face.area_m2 >= choice.min_area_m2;
  return faces;
}

}  // namespace jalon
