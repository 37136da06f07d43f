// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/view.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "model/part_classes.h"
#include "report/names/part_tree.h"

namespace jalon {

namespace {

// World to view for walls with this outward normal; no turn but about Z.
Transform view_against(const Vec3& outward, const Vec3& origin) {
  const Vec3 away = normalized(Vec3{-outward.x, -outward.y, 0});
  const Vec3 along{away.y, -away.x, 0};  // to the right of an eye that looks along `away`
  Transform t;
  t.m = {along.x, along.y, 0, -dot(along, origin), away.x, away.y, 0, -dot(away, origin), 0,
         0,       1,       0};
  return t;
}

struct WallSum {
  Vec3 normal;  ///< times area
  Vec3 origin;
  bool found = false;
};

// Mean direction of the walls below a part; of all its faces when none is a wall.
WallSum sum_walls(const Model& model, const ElevationView& view, bool walls_only) {
  WallSum sum;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    if (!view.shows(f) || face.ring_count == 0 || face.part >= model.parts.size()) continue;
    if (walls_only && model.parts[face.part].part_class != part_class::kWall) continue;
    if (!sum.found && model.rings[face.first_ring].count > 0) {
      const Vec3 p = model.vertices[model.corners[model.rings[face.first_ring].first]];
      sum.origin = {std::floor(p.x), std::floor(p.y), 0};
      sum.found = true;
    }
    sum.normal += face.plane.normal * face.area_m2;
  }
  return sum;
}

}  // namespace

double ElevationView::azimuth_rad() const {
  return std::atan2(T_view_world.m[4], T_view_world.m[5]);
}

std::vector<uint32_t> facade_parts(const Model& model) {
  std::vector<uint32_t> out;
  for (uint32_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].part_class == part_class::kFacade) out.push_back(i);
  return out;
}

ElevationView elevation_view(const Segmentation& segmentation, const Model& model, int64_t facade) {
  ElevationView view;
  view.T_view_world = segmentation.T_facade_world;
  if (facade == 0) return view;
  const auto facades = facade_parts(model);
  if (facade < 0 || static_cast<uint64_t>(facade) > facades.size())
    fail(Status::kInvalidArgument, "facade %lld of a model that has %zu",
         static_cast<long long>(facade), facades.size());
  const uint32_t chosen = facades[static_cast<size_t>(facade - 1)];
  view.name = part_label(model, chosen);
  const PartTree tree(model);
  const auto facade_of = [&](const Face& face) {
    return face.part >= model.parts.size() ? kNoPart : tree.nearest(face.part, [&](uint32_t p) {
      return model.parts[p].part_class == part_class::kFacade;
    });
  };
  view.shown.resize(model.faces.size());
  for (size_t f = 0; f < model.faces.size(); ++f)
    view.shown[f] = facade_of(model.faces[f]) == chosen;
  WallSum sum = sum_walls(model, view, true);
  if (!sum.found) sum = sum_walls(model, view, false);
  if (std::hypot(sum.normal.x, sum.normal.y) > 0)
    view.T_view_world = view_against(sum.normal, sum.origin);
  for (size_t f = 0; f < model.faces.size(); ++f)
    if (facade_of(model.faces[f]) == kNoPart) view.shown[f] = true;
  return view;
}

}  // namespace jalon
