// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "report/elevation/faces.h"

namespace jalon {

namespace {

// Front faces of the drawing by their number in the model.
using Shown = std::map<size_t, const DrawnFace*>;

Shown front_faces(const ElevationFaces& faces) {
  Shown out;
  for (const DrawnFace& face : faces.faces)
    if (face.kind == DrawnFace::Kind::kFront) out[face.face] = &face;
  return out;
}

// A wall's hole lies in the wall; the outline of what closes a notch lies behind it.
double wall_depth(const OpeningRow& row, const DrawnFace& face) {
  const bool is_hole = row.contour.front().ring != face.rings.front().ring;
  return is_hole || !std::isfinite(row.depth_m) ? face.depth_m : face.depth_m - row.depth_m;
}

bool draw_opening(DrawnOpening& out, const OpeningRow& row, const Model& model,
                  const ElevationView& view, const Shown& shown) {
  out.low = {INFINITY, INFINITY};
  out.high = {-INFINITY, -INFINITY};
  for (const FaceRing& at : row.contour) {
    const auto face = shown.find(at.face);
    if (face == shown.end()) continue;
    if (out.contour.empty()) out.depth_m = wall_depth(row, *face->second);
    const DrawnRing& ring =
        out.contour.emplace_back(drawn_ring(model, model.faces[at.face], at.ring, view));
    for (const Vec2& p : ring.polygon) {
      out.low = {std::min(out.low.u, p.u), std::min(out.low.v, p.v)};
      out.high = {std::max(out.high.u, p.u), std::max(out.high.v, p.v)};
    }
  }
  out.is_empty = row.part != kNoPart && row.joinery.empty();
  return !out.contour.empty();
}

}  // namespace

void add_openings(ElevationFaces& out, const Model& model, const ElevationView& view) {
  const Shown shown = front_faces(out);
  out.has_named_openings = !out.list.rows.empty() && out.list.rows.front().part != kNoPart;
  for (size_t i = 0; i < out.list.rows.size(); ++i) {
    DrawnOpening opening;
    opening.row = i;
    if (draw_opening(opening, out.list.rows[i], model, view, shown))
      out.openings.push_back(std::move(opening));
  }
  std::stable_sort(
      out.openings.begin(), out.openings.end(),
      [](const DrawnOpening& a, const DrawnOpening& b) { return a.depth_m > b.depth_m; });
  for (const DrawnFace& face : out.faces)
    if (face.kind == DrawnFace::Kind::kFront && face.role != DrawnFace::Role::kInside)
      for (size_t r = 1; r < face.rings.size(); ++r)
        if (model.rings[face.rings[r].ring].part == kNoPart) out.unknown.push_back(face.rings[r]);
}

}  // namespace jalon
