// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "modelling/facade/plan.h"
#include "modelling/plane/ring_tools.h"
#include "unit/modelling/plane_rings.h"

// Plans of facades drawn by hand: walls seen from the street, u = x, v = z, each this far before y = 0.
namespace planned {

using namespace rings;

inline FacadeOpening opening_at(const Vec2& low, const Vec2& high, double depth_m,
                                OpeningKind kind = OpeningKind::kWindow) {
  FacadeOpening out;
  out.outline = rectangle(low, high);
  out.depth_m = depth_m;
  out.kind = kind;
  out.evidence = Evidence::kRevealed;
  return out;
}

struct PlannedScene {
  FacadePlan plan;
  Segmentation segmentation;

  PlannedScene() { segmentation.cloud = std::make_shared<const Cloud>(); }

  size_t add_plane(VectorFace face, double height = 0) {
    Segment segment;
    segment.label = static_cast<uint32_t>(segmentation.segments.size() + 1);
    segment.fit.plane = {{0, -1, 0}, height};
    segmentation.segments.push_back(segment);
    plan.planes.push_back(wall_of({std::move(face)}, 0.02, height));
    plan.planes.back().label = segment.label;
    return plan.planes.size() - 1;
  }

  /// A wall with these openings as holes of its face, of the last facade.
  PlannedWall& add_wall(const Vec2& low, const Vec2& high, std::vector<FacadeOpening> openings,
                        double height = 0) {
    VectorFace face{rectangle(low, high), {}};
    for (const FacadeOpening& o : openings) face.openings.push_back(reversed(o.outline));
    PlannedWall wall;
    wall.plane = add_plane(std::move(face), height);
    wall.wall.label = plan.planes[wall.plane].label;
    wall.wall.frame = plan.planes[wall.plane].frame;
    wall.wall.outlines = {rectangle(low, high)};
    wall.wall.openings = std::move(openings);
    if (plan.facades.empty()) plan.facades.emplace_back();
    PlannedFacade& facade = plan.facades.back();
    for (const Vec2& p : {low, high}) facade.group.box.add({p.u, height, p.v});
    facade.walls.push_back(std::move(wall));
    return facade.walls.back();
  }
};

/// Of the faces of a model between two indices, by the divergence theorem.
inline double volume_within(const Model& model, uint64_t first, uint64_t count) {
  double sum = 0;
  for (uint64_t f = first; f < first + count; ++f)
    sum += model.faces[f].area_m2 * model.faces[f].plane.offset / 3;
  return sum;
}

}  // namespace planned
