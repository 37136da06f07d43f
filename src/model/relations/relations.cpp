// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/relations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "geometry/region_relation.h"
#include "model/chords.h"
#include "model/relations/directions.h"
#include "model/relations/face_relation.h"
#include "model/relations/part_shapes.h"
#include "model/relations/solid_relation.h"

namespace jalon {

namespace {

constexpr auto kRelationRows = setting_rows(
    choice_row<&RelationSettings::elements>(
        "elements", "parts|faces|solids", "",
        "What is compared: parts with all that is below them, as seen by somebody before their "
        "facade; faces in space; closed volumes."),
    number_row<&RelationSettings::tolerance_m>(
        "tolerance_m", 1e-4, 1, "m", "",
        "Points this near to a border are on it; arcs are chords within it."),
    number_row<&RelationSettings::max_distance_m>("max_distance_m", 0, 1e6, "m", "",
                                                  "Pairs at a larger distance are left out."));

Vec3 whole_metres(const Model& model) {
  const Vec3& p = model.vertices[model.corners[0]];
  return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
}

// Step 1: the elements, each with what the pairs need.
struct Compared {
  const RelationSettings& settings;
  std::vector<PartShape> parts;
  std::vector<PlacedFace> faces;
  std::vector<PlacedSolid> solids;
  std::vector<Box3> boxes;       ///< in space
  std::vector<Box3> seen_boxes;  ///< right, up, out

  Compared(const Model& model, const RelationSettings& chosen, Task& task);
  uint32_t row(size_t i) const {
    return settings.elements == RelationSettings::Elements::kParts ? parts[i].part
                                                                   : static_cast<uint32_t>(i);
  }
  bool are_comparable(const Model& model, size_t i, size_t j) const;
  NineIntersection matrix(size_t i, size_t j) const;
  double distance(size_t i, size_t j) const;
};

Box3 box_of(const std::vector<PlacedFace>& faces) {
  Box3 out;
  for (const PlacedFace& face : faces) out += face.box;
  return out;
}

Box3 seen_box(std::span<const PlacedFace> faces, const ViewAxes& axes, const Vec3& origin) {
  Box3 out;
  for (const PlacedFace& face : faces)
    for (const Vec3& p : corners_of(face)) out.add(axes.seen(p - origin));
  return out;
}

ViewAxes axes_of_model(const std::vector<PartShape>& parts) {
  return parts.empty() ? ViewAxes{} : parts.front().axes;
}

// Two sets of faces as surfaces in space.
NineIntersection surfaces_intersection(const std::vector<PlacedFace>& a,
                                       const std::vector<PlacedFace>& b, double tolerance) {
  using enum NineIntersection::Place;
  NineIntersection out;
  for (const PlacedFace& p : a)
    for (const PlacedFace& q : b) {
      const NineIntersection pair = face_intersection(p, q, tolerance);
      for (const auto i : {kBoundary, kInterior})
        for (const auto j : {kBoundary, kInterior}) out.raise(i, j, pair.at(i, j));
    }
  out.raise(kBoundary, kExterior, 1), out.raise(kExterior, kBoundary, 1);
  out.raise(kInterior, kExterior, 2), out.raise(kExterior, kInterior, 2);
  out.raise(kExterior, kExterior, 3);
  return out;
}

Compared::Compared(const Model& model, const RelationSettings& chosen, Task& task)
    : settings(chosen) {
  const Vec3 origin = whole_metres(model);
  parts = part_shapes(model, origin, settings.tolerance_m, task);
  const ViewAxes axes = axes_of_model(parts);
  if (settings.elements == RelationSettings::Elements::kParts) {
    for (const PartShape& part : parts) {
      boxes.push_back(box_of(part.faces));
      seen_boxes.push_back(part.box);
    }
  } else if (settings.elements == RelationSettings::Elements::kFaces) {
    for (const Face& face : model.faces) {
      faces.push_back(placed_face(model, face, settings.tolerance_m));
      boxes.push_back(faces.back().box);
      seen_boxes.push_back(seen_box(std::span(faces).last(1), axes, origin));
    }
  } else {
    for (const Solid& solid : model.solids) {
      solids.push_back(placed_solid(model, solid, settings.tolerance_m));
      boxes.push_back(solids.back().box);
      seen_boxes.push_back(seen_box(solids.back().faces, axes, origin));
    }
  }
}

bool is_below(const Model& model, uint64_t part, uint64_t above) {
  while (part != kNoParent && part != above) part = model.parts[part].parent;
  return part == above;
}

// What is seen edge-on and is part of the other has no relation to it but that.
bool Compared::are_comparable(const Model& model, size_t i, size_t j) const {
  if (settings.elements != RelationSettings::Elements::kParts) return true;
  const PartShape &a = parts[i], &b = parts[j];
  if (a.facade != b.facade) return false;
  const bool have_regions = !a.region.empty() && !b.region.empty();
  return have_regions || (!is_below(model, a.part, b.part) && !is_below(model, b.part, a.part));
}

NineIntersection Compared::matrix(size_t i, size_t j) const {
  const double tolerance = settings.tolerance_m;
  if (settings.elements == RelationSettings::Elements::kFaces)
    return face_intersection(faces[i], faces[j], tolerance);
  if (settings.elements == RelationSettings::Elements::kSolids)
    return solid_intersection(solids[i], solids[j], tolerance);
  const PartShape &a = parts[i], &b = parts[j];
  if (a.region.empty() || b.region.empty())
    return surfaces_intersection(a.faces, b.faces, tolerance);
  return region_intersection(a.region, b.region, tolerance);
}

double Compared::distance(size_t i, size_t j) const {
  const double tolerance = settings.tolerance_m;
  if (settings.elements == RelationSettings::Elements::kFaces)
    return face_distance(faces[i], faces[j], tolerance);
  if (settings.elements == RelationSettings::Elements::kSolids)
    return solid_distance(solids[i], solids[j], tolerance);
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedFace& p : parts[i].faces)
    for (const PlacedFace& q : parts[j].faces)
      if (least > 0 && box_distance(p.box, q.box) < least)
        least = std::min(least, face_distance(p, q, tolerance));
  return least;
}

}  // namespace

std::span<const ParamRow> relation_rows() { return kRelationRows; }

std::vector<Relation> find_relations(const Model& model, const RelationSettings& settings,
                                     Task& task) {
  if (model.faces.empty())
    fail(Status::kInsufficientData, "the model has no faces, so nothing in it has relations");
  if (settings.elements == RelationSettings::Elements::kSolids && model.solids.empty())
    fail(Status::kInsufficientData,
         "the model has no solids; a modeller makes them with \"solids\", or compare \"faces\"");
  // 1. Elements.
  const Compared all(model, settings, task);
  // 2. Pairs that are near.
  const size_t n = all.boxes.size();
  std::vector<std::vector<Relation>> rows(n);
  parallel_for(task, n, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      for (size_t j = i + 1; j < n; ++j) {
        if (task.cancelled()) fail(Status::kCancelled, "cancelled");
        if (!all.are_comparable(model, i, j) ||
            box_distance(all.boxes[i], all.boxes[j]) > settings.max_distance_m)
          continue;
        const double distance_m = all.distance(i, j);
        if (distance_m > settings.max_distance_m) continue;
        const Box3 &a = all.seen_boxes[i], &b = all.seen_boxes[j];
        rows[i].push_back({all.row(i), all.row(j), all.matrix(i, j), distance_m,
                           directions(a, b, settings.tolerance_m),
                           (b.min + b.max - a.min - a.max) * 0.5});
      }
  });
  std::vector<Relation> out;
  for (const auto& more : rows) out.insert(out.end(), more.begin(), more.end());
  return out;
}

FieldTable relation_table(const std::vector<Relation>& relations) {
  FieldTable t;
  add_column<uint32_t>(t, relations, "first", "", "part, face or solid",
                       [](const Relation& r) { return r.first; });
  add_column<uint32_t>(t, relations, "second", "", "part, face or solid",
                       [](const Relation& r) { return r.second; });
  add_column<uint8_t>(
      t, relations, "relation", "", "of the region calculus",
      [](const Relation& r) { return static_cast<uint8_t>(relation_of(r.matrix)); });
  add_columns<int8_t, 9>(t, relations, "matrix", "", "9-intersection: dimensions, -1 nothing",
                         [](const Relation& r, int8_t* o) {
                           std::copy(r.matrix.dimensions.begin(), r.matrix.dimensions.end(), o);
                         });
  add_column<double>(t, relations, "distance", "m", "least, in space",
                     [](const Relation& r) { return r.distance_m; });
  add_column<uint8_t>(t, relations, "direction", "", "of the second from the first",
                      [](const Relation& r) { return r.direction; });
  add_columns<double, 3>(t, relations, "offset", "m", "of their middles: right, up, out",
                         [](const Relation& r, double* o) {
                           o[0] = r.offset_m.x, o[1] = r.offset_m.y, o[2] = r.offset_m.z;
                         });
  return t;
}

}  // namespace jalon
