// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "formats/dxf/drawing.h"
#include "formats/facade_views.h"
#include "model/chords.h"

namespace jalon::dxf {

namespace {

constexpr double kFlatArc =
    0.99995;  // cosine (0.6 degrees) up to which an arc of 5 m stays within 0.25 mm of a circle

// As order_of_drawing() says.
void sort_by_depth(Drawing& drawing, size_t first, const FrontView& view) {
  std::vector<double> depths_m;
  for (size_t i = first; i < drawing.polylines.size(); ++i) {
    const std::vector<Vec3>& corners = drawing.polylines[i].corners;
    double sum = 0;
    for (const Vec3& p : corners) sum += view.depth_m(p);
    const double depth_m = sum / static_cast<double>(corners.size());
    depths_m.push_back(std::isfinite(depth_m) ? depth_m : 0);
  }
  std::vector<Polyline> lines;
  for (const size_t i : order_of_drawing(depths_m))
    lines.push_back(std::move(drawing.polylines[first + i]));
  std::ranges::move(lines, drawing.polylines.begin() + static_cast<ptrdiff_t>(first));
}

void flatten(Polyline& line, const FrontView& view, double chord_error_m) {
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

void add_facade(Drawing& drawing, const Model& model, const PlacedFacade& facade,
                const std::vector<std::vector<uint32_t>>& openings, double chord_error_m) {
  const size_t first = drawing.polylines.size();
  for (const uint32_t f : facade.shown) {
    const Face& face = model.faces[f];
    const Vec3 normal = normal_of(model, face);
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      add_ring(drawing, model, face, r, normal);
    add_openings(drawing, model, face, normal, openings[f]);
  }
  sort_by_depth(drawing, first, facade.view);
  for (size_t i = first; i < drawing.polylines.size(); ++i) {
    flatten(drawing.polylines[i], facade.view, chord_error_m);
    for (Vec3& p : drawing.polylines[i].corners) {
      p.x += facade.shift_m;
      drawing.box.add(p);
    }
  }
}

}  // namespace

Drawing draw_elevation(const Model& model, double chord_error_m, Task& task) {
  Drawing drawing;
  const std::vector<PlacedFacade> facades = facades_side_by_side(model);
  const auto openings = openings_shown_by(model);
  for (size_t i = 0; i < facades.size(); ++i) {
    task.checkpoint(static_cast<double>(i) / static_cast<double>(facades.size()));
    add_facade(drawing, model, facades[i], openings, chord_error_m);
  }
  return drawing;
}

}  // namespace jalon::dxf
