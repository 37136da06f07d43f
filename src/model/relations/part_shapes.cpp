// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/part_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kUpright = 0.5;  // most |z| of the normal of a face that may tell the axes
constexpr double kEdgeOn = 0.1;   // faces within 6 degrees of the line of sight have no area

uint64_t facade_of(const Model& model, uint64_t part) {
  for (; part != kNoParent; part = model.parts[part].parent)
    if (model.parts[part].part_class == part_class::kFacade) return part;
  return kNoParent;
}

// Largest upright face of each facade (kNoParent: of the model), walls first.
std::map<uint64_t, ViewAxes> axes_of_facades(const Model& model) {
  struct Best {
    bool is_wall = false;
    double area_m2 = 0;
    Vec3 normal;
  };
  std::map<uint64_t, Best> best;
  for (const Face& face : model.faces) {
    const Vec3 normal = normal_of(model, face);
    if (std::fabs(normal.z) > kUpright) continue;
    const bool is_wall = model.parts[face.part].part_class == part_class::kWall;
    for (const uint64_t key : {facade_of(model, face.part), kNoParent}) {
      Best& held = best[key];
      if (is_wall == held.is_wall ? face.area_m2 <= held.area_m2 : held.is_wall) continue;
      held = {is_wall, face.area_m2, normal};
    }
  }
  std::map<uint64_t, ViewAxes> out;
  for (const auto& [facade, face] : best) out[facade] = axes_before(face.normal);
  return out;
}

// A face goes to its part and to all above it.
void add_to(const Model& model, uint64_t part, const PlacedFace& face,
            std::vector<PartShape>& shapes) {
  for (; part != kNoParent; part = model.parts[part].parent) shapes[part].faces.push_back(face);
}

void see(PartShape& shape, const Vec3& origin) {
  std::vector<PolygonWithHoles> pieces;
  for (const PlacedFace& face : shape.faces) {
    for (const Vec3& p : corners_of(face)) shape.box.add(shape.axes.seen(p - origin));
    if (std::fabs(dot(face.plane.normal, shape.axes.out)) < kEdgeOn) continue;
    PolygonWithHoles piece = face.polygon;
    const auto turn = [&](std::vector<Vec2>& ring) {
      for (Vec2& p : ring) {
        const Vec3 q = shape.axes.seen(face.lift(p) - origin);
        p = {q.x, q.y};
      }
    };
    turn(piece.outline);
    for (auto& hole : piece.holes) turn(hole);
    pieces.push_back(std::move(piece));
  }
  shape.region = combined(SetOperation::kUnion, pieces, {});
}

}  // namespace

std::vector<PartShape> part_shapes(const Model& model, const Vec3& origin, double chord_error_m,
                                   Task& task) {
  const auto axes = axes_of_facades(model);
  const bool has_facades = std::any_of(model.parts.begin(), model.parts.end(), [](const Part& p) {
    return p.part_class == part_class::kFacade;
  });
  std::vector<PartShape> out(model.parts.size());
  for (size_t i = 0; i < out.size(); ++i) {
    out[i].part = static_cast<uint32_t>(i);
    out[i].facade = facade_of(model, i);
    if (const auto found = axes.find(out[i].facade); found != axes.end())
      out[i].axes = found->second;
    else if (const auto all = axes.find(kNoParent); all != axes.end()) out[i].axes = all->second;
  }
  for (const Face& face : model.faces) {
    add_to(model, face.part, placed_face(model, face, chord_error_m), out);
    for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r)
      if (model.rings[r].part != kNoPart)
        add_to(model, model.rings[r].part,
               placed_filling(model, face, model.rings[r], chord_error_m), out);
  }
  std::erase_if(out, [&](const PartShape& shape) {
    return shape.faces.empty() || (has_facades && shape.facade == kNoParent);
  });
  parallel_for(task, out.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) see(out[i], origin);
  });
  return out;
}

}  // namespace jalon
