// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/opening_faces.h"

#include <cmath>

#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kLeastReveal_m = 0.005;  // shallower: the pane is flush with the wall

void append_pane(Model& model, PlaneVertices& wall, const FacadeOpening& opening, double depth_m,
                 uint32_t part, Face face) {
  face.part = part;
  face.id = opening.joinery_label;
  const Vec3& n = wall.frame().normal;
  face.plane = {n, dot(n, wall.lift(opening.outline.corners.front(), -depth_m))};
  append_face(model, face, {part_ring(wall, opening.outline, -depth_m)});
}

}  // namespace

void append_sides(Model& model, PlaneVertices& wall, const VectorRing& ring, double w_front,
                  double w_back, bool to_the_right, uint32_t part) {
  const std::vector<Vec2> corners = flattened(ring, kRevealChord_m);
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const uint32_t a = wall.at(p, w_front), b = wall.at(q, w_front);
    const uint32_t a_back = wall.at(p, w_back), b_back = wall.at(q, w_back);
    const Vec2 d = (q - p) * (1 / norm(q - p));
    const Vec3 right = wall.frame().axis_u * d.v - wall.frame().axis_v * d.u;
    if (to_the_right) append_polygon(model, part, {a, a_back, b_back, b}, right);
    else append_polygon(model, part, {a, b, b_back, a_back}, -right);
  }
}

void append_opening_faces(Model& model, PlaneVertices& wall, const FacadeOpening& opening,
                          uint32_t opening_part, const Face& joinery, bool with_reveals) {
  if (!std::isfinite(opening.depth_m)) {
    // A hole of the wall shows where it is; at the border nothing else would.
    if (opening.is_notch) append_pane(model, wall, opening, 0, opening_part, joinery);
    return;
  }
  if (with_reveals && opening.depth_m >= kLeastReveal_m) {
    const uint32_t reveal =
        append_part(model, "reveal", part_class::kReveal, opening_part, Evidence::kDerived);
    model.parts[reveal].depth_m = opening.depth_m;
    append_sides(model, wall, opening.outline, 0, -opening.depth_m, false, reveal);
  }
  const Evidence evidence = opening.copied_from >= 0 ? Evidence::kCopied : Evidence::kMeasured;
  const uint32_t pane = append_part(model, "joinery", part_class::kJoinery, opening_part, evidence);
  model.parts[pane].depth_m = opening.depth_m;
  append_pane(model, wall, opening, opening.depth_m, pane, joinery);
}

}  // namespace jalon
