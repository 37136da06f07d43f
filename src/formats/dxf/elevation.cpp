// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "formats/dxf/drawing.h"
#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon::dxf {

namespace {

constexpr double kEdgeOn =
    0.1;  // cosine to the view below which a face is a line: seen at 6 degrees or less
constexpr double kUpright = 0.5;  // |z| of the normal of what may be the front of a facade
constexpr double kFlatArc =
    0.99995;  // cosine (0.6 degrees) up to which an arc of 5 m stays within 0.25 mm of a circle
constexpr double kSameDepth_m =
    0.005;  // steps in which depths are told apart for the order of drawing
constexpr double kRounding_m = 1e-6;  // far above that of map coordinates
constexpr double kGap_m = 2;          // between two facades side by side
constexpr uint32_t kNoFacade = ~uint32_t{0};

/// Seen from the front: x to the right, y up.
struct View {
  Vec3 origin, right, towards;
  Vec3 flat(const Vec3& p) const { return {dot(p - origin, right), p.z, 0}; }
};

// The facade that a part stands in: itself or its nearest ancestor of that class.
uint32_t facade_of(const Model& model, uint32_t part) {
  for (size_t steps = 0; part < model.parts.size() && steps <= model.parts.size(); ++steps) {
    if (model.parts[part].part_class == part_class::kFacade) return part;
    const uint64_t parent = model.parts[part].parent;
    part = parent < model.parts.size() ? static_cast<uint32_t>(parent) : kNoPart;
  }
  return kNoFacade;
}

/// The front of a facade: its largest upright face, of class wall where there is one.
bool find_view(const Model& model, const std::vector<uint32_t>& faces, View& view) {
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
  if (best == nullptr || model.rings[best->first_ring].count == 0) return false;
  const Vec3 normal = normal_of(model, *best);
  view.towards = normalized({normal.x, normal.y, 0});
  view.right = cross({0, 0, 1}, view.towards);
  view.origin = model.vertices[model.corners[model.rings[best->first_ring].first]];
  return true;
}

std::vector<uint8_t> faces_of_solids(const Model& model) {
  std::vector<uint8_t> out(model.faces.size(), 0);
  for (const Solid& solid : model.solids)
    for (uint64_t f = 0; f < solid.face_count; ++f) out[solid.first_face + f] = 1;
  return out;
}

struct Depth {
  size_t line;
  double depth_m;
  double step = 0;  ///< in which it is drawn
};

std::vector<Depth> depths_of(const Drawing& drawing, size_t first, const View& view) {
  std::vector<Depth> out;
  for (size_t i = first; i < drawing.polylines.size(); ++i) {
    const std::vector<Vec3>& corners = drawing.polylines[i].corners;
    double sum = 0;
    for (const Vec3& p : corners) sum += dot(p - view.origin, view.towards);
    const double depth_m = sum / static_cast<double>(corners.size());
    out.push_back({i, std::isfinite(depth_m) ? depth_m : 0});
  }
  return out;
}

// What lies in front is drawn last, so that joinery does not hide the opening before it. Rounding
// must not shuffle what lies in one plane: the lines of a plane have its step together, and the
// front wall lies in the middle of one.
void sort_by_depth(Drawing& drawing, size_t first, const View& view) {
  std::vector<Depth> depths = depths_of(drawing, first, view);
  std::ranges::stable_sort(depths, {}, &Depth::depth_m);
  double plane_m = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    const bool same_plane = i > 0 && depths[i].depth_m - depths[i - 1].depth_m <= kRounding_m;
    if (!same_plane) plane_m = depths[i].depth_m;
    depths[i].step = std::round(plane_m / kSameDepth_m);
  }
  std::ranges::sort(depths, {}, [](const Depth& d) { return std::pair(d.step, d.line); });
  std::vector<Polyline> lines;
  for (const Depth& depth : depths) lines.push_back(std::move(drawing.polylines[depth.line]));
  std::ranges::move(lines, drawing.polylines.begin() + static_cast<ptrdiff_t>(first));
}

void flatten(Polyline& line, const View& view, double chord_error_m) {
  const double facing = dot(line.normal, view.towards);
  Polyline flat = line;
  flat.corners.clear();
  flat.sagittas_m.clear();
  for (size_t i = 0; i < line.corners.size(); ++i) {
    const double sagitta_m = line.sagittas_m.empty() ? 0 : line.sagittas_m[i];
    const bool stays = std::fabs(facing) >= kFlatArc;
    const Vec3 &a = line.corners[i], &b = line.corners[(i + 1) % line.corners.size()];
    flat.corners.push_back(view.flat(a));
    flat.sagittas_m.push_back(stays ? (facing > 0 ? sagitta_m : -sagitta_m) : 0);
    if (stays) continue;
    for (const Vec3& p : arc_points(a, b, sagitta_m, line.normal, chord_error_m)) {
      flat.corners.push_back(view.flat(p));
      flat.sagittas_m.push_back(0);
    }
  }
  flat.normal = {0, 0, 1};
  line = std::move(flat);
}

/// Draws one facade with its left end at x = left_m; returns its right end.
double add_facade(Drawing& drawing, const Model& model, const std::vector<uint32_t>& faces,
                  const std::vector<uint8_t>& in_solid,
                  const std::vector<std::vector<uint32_t>>& shown, double left_m,
                  double chord_error_m) {
  View view;
  if (!find_view(model, faces, view)) return left_m - kGap_m;
  const size_t first = drawing.polylines.size();
  for (const uint32_t f : faces) {
    const Face& face = model.faces[f];
    const Vec3 normal = normal_of(model, face);
    const double facing = dot(normal, view.towards);
    if (std::fabs(facing) < kEdgeOn || (facing < 0 && in_solid[f] != 0)) continue;
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      add_ring(drawing, model, face, r, normal);
    add_openings(drawing, model, face, normal, shown[f]);
  }
  sort_by_depth(drawing, first, view);
  Box3 box;
  for (size_t i = first; i < drawing.polylines.size(); ++i) {
    flatten(drawing.polylines[i], view, chord_error_m);
    for (const Vec3& p : drawing.polylines[i].corners) box.add(p);
  }
  if (box.empty()) return left_m - kGap_m;
  for (size_t i = first; i < drawing.polylines.size(); ++i)
    for (Vec3& p : drawing.polylines[i].corners) {
      p.x += left_m - box.min.x;
      drawing.box.add(p);
    }
  return left_m + box.max.x - box.min.x;
}

}  // namespace

Drawing draw_elevation(const Model& model, double chord_error_m, Task& task) {
  Drawing drawing;
  std::map<uint32_t, std::vector<uint32_t>> facades;  // faces by facade; those of none last
  for (uint32_t f = 0; f < model.faces.size(); ++f)
    facades[facade_of(model, model.faces[f].part)].push_back(f);
  if (facades.size() == 2 &&
      facades.contains(kNoFacade)) {  // ground, roof and the like belong to the only facade
    const std::vector<uint32_t> others = std::move(facades[kNoFacade]);
    facades.erase(kNoFacade);
    auto& faces = facades.begin()->second;
    faces.insert(faces.end(), others.begin(), others.end());
  }
  const std::vector<uint8_t> in_solid = faces_of_solids(model);
  const auto shown = openings_shown_by(model);
  double left_m = 0;
  size_t done = 0;
  for (const auto& [facade, faces] : facades) {
    task.checkpoint(static_cast<double>(done++) / static_cast<double>(facades.size()));
    left_m = add_facade(drawing, model, faces, in_solid, shown, left_m, chord_error_m) + kGap_m;
  }
  return drawing;
}

}  // namespace jalon::dxf
