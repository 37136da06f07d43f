// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/facade_views.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kEdgeOn =
    0.1;  // cosine to the view below which a face is a line: seen at 6 degrees or less
constexpr double kDepthStep_m = 0.005;  // in which depths are told apart for the order of drawing
constexpr double kRounding_m = 1e-6;    // far above that of map coordinates

std::vector<uint8_t> faces_of_solids(const Model& model) {
  std::vector<uint8_t> out(model.faces.size(), 0);
  for (const Solid& solid : model.solids)
    for (uint64_t f = 0; f < solid.face_count; ++f) out[solid.first_face + f] = 1;
  return out;
}

// facing: cosine of the normal to the view.
bool is_shown(double facing, bool in_solid) {
  return std::fabs(facing) >= kEdgeOn && !(facing < 0 && in_solid);
}

void add_outline(Box3& box, const Model& model, const Face& face, const FrontView& view) {
  if (face.ring_count == 0) return;
  const Ring& outline = model.rings[face.first_ring];
  for (uint64_t i = 0; i < outline.count; ++i)
    box.add(view.flat(model.vertices[model.corners[outline.first + i]]));
}

}  // namespace

uint32_t facade_of(const Model& model, uint32_t part) {
  for (size_t steps = 0; part < model.parts.size() && steps <= model.parts.size(); ++steps) {
    if (model.parts[part].part_class == part_class::kFacade) return part;
    const uint64_t parent = model.parts[part].parent;
    part = parent < model.parts.size() ? static_cast<uint32_t>(parent) : kNoPart;
  }
  return kNoFacade;
}

std::map<uint32_t, std::vector<uint32_t>> faces_by_facade(const Model& model) {
  std::map<uint32_t, std::vector<uint32_t>> facades;
  for (uint32_t f = 0; f < model.faces.size(); ++f)
    facades[facade_of(model, model.faces[f].part)].push_back(f);
  if (facades.size() == 2 && facades.contains(kNoFacade)) {
    const std::vector<uint32_t> others = std::move(facades[kNoFacade]);
    facades.erase(kNoFacade);
    auto& faces = facades.begin()->second;
    faces.insert(faces.end(), others.begin(), others.end());
  }
  return facades;
}

std::optional<FrontView> front_of(const Model& model, const std::vector<uint32_t>& faces) {
  const Face* best = nullptr;
  bool best_is_wall = false;
  for (const uint32_t f : faces) {
    const Face& face = model.faces[f];
    if (std::fabs(normal_of(model, face).z) > kUpright || face.ring_count == 0) continue;
    const bool wall =
        face.part < model.parts.size() && model.parts[face.part].part_class == part_class::kWall;
    if (best != nullptr && (wall != best_is_wall ? best_is_wall : face.area_m2 <= best->area_m2))
      continue;
    best = &face;
    best_is_wall = wall;
  }
  if (best == nullptr || model.rings[best->first_ring].count == 0) return {};
  const Vec3 normal = normal_of(model, *best);
  FrontView view;
  view.towards = normalized({normal.x, normal.y, 0});
  view.right = cross({0, 0, 1}, view.towards);
  view.origin = model.vertices[model.corners[model.rings[best->first_ring].first]];
  return view;
}

std::vector<PlacedFacade> facades_side_by_side(const Model& model) {
  const std::vector<uint8_t> in_solid = faces_of_solids(model);
  std::vector<PlacedFacade> out;
  double left_m = 0;
  for (auto& [facade, faces] : faces_by_facade(model)) {
    const std::optional<FrontView> view = front_of(model, faces);
    if (!view) continue;
    PlacedFacade placed{.facade = facade, .faces = std::move(faces), .shown = {}, .view = *view};
    Box3 box;
    for (const uint32_t f : placed.faces) {
      const double facing = dot(normal_of(model, model.faces[f]), view->towards);
      if (!is_shown(facing, in_solid[f] != 0)) continue;
      placed.shown.push_back(f);
      add_outline(box, model, model.faces[f], *view);
    }
    if (box.empty()) continue;
    placed.shift_m = left_m - box.min.x;
    placed.left_m = left_m;
    placed.right_m = left_m + (box.max.x - box.min.x);
    placed.bottom_m = box.min.y;
    placed.top_m = box.max.y;
    left_m = placed.right_m + kFacadeGap_m;
    out.push_back(std::move(placed));
  }
  return out;
}

std::vector<size_t> order_of_drawing(const std::vector<double>& depths_m) {
  std::vector<size_t> order(depths_m.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, {}, [&](size_t i) { return depths_m[i]; });
  std::vector<double> steps(depths_m.size());
  double plane_m = 0;
  for (size_t k = 0; k < order.size(); ++k) {
    const bool same_plane = k > 0 && depths_m[order[k]] - depths_m[order[k - 1]] <= kRounding_m;
    if (!same_plane) plane_m = depths_m[order[k]];
    steps[order[k]] = std::round(plane_m / kDepthStep_m);
  }
  std::ranges::sort(order, {}, [&](size_t i) { return std::pair(steps[i], i); });
  return order;
}

}  // namespace jalon
