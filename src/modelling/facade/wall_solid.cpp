// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/wall_solid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "modelling/facade/opening_faces.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add_depths(const PlannedFacade& facade, std::vector<double>& out) {
  for (const PlannedWall& wall : facade.walls)
    for (const FacadeOpening& opening : wall.wall.openings)
      if (opening.depth_m > 0) out.push_back(opening.depth_m);  // NaN is not
}

// The face seen from behind: rings turned, plane and covariance of its own.
Face back_of(const Face& front, double thickness_m) {
  Face back = front;
  back.plane = {-front.plane.normal, thickness_m - front.plane.offset};
  return back;
}

}  // namespace

void draw_chords(FacadePlan& plan, double chord_error_m) {
  const auto draw = [&](VectorRing& ring) { ring = with_chords(ring, chord_error_m); };
  for (PlannedFacade& facade : plan.facades)
    for (PlannedWall& wall : facade.walls) {
      for (VectorFace& face : plan.planes[wall.plane].faces) {
        draw(face.outline);
        for (VectorRing& opening : face.openings) draw(opening);
      }
      for (VectorRing& outline : wall.wall.outlines) draw(outline);
      for (FacadeOpening& opening : wall.wall.openings) draw(opening.outline);
      for (FacadeShadow& shadow : wall.wall.shadows) draw(shadow.outline);
    }
}

std::vector<double> wall_thicknesses(const FacadePlan& plan, double given_m) {
  std::vector<double> all, out;
  for (const PlannedFacade& facade : plan.facades) add_depths(facade, all);
  if (!(given_m > 0) && all.empty())
    fail(Status::kInsufficientData,
         "no opening with a measured depth tells how thick the walls are: set thickness_m");
  const double common = given_m > 0 ? given_m : median(all);
  for (const PlannedFacade& facade : plan.facades) {
    std::vector<double> depths;
    add_depths(facade, depths);
    out.push_back(given_m > 0 || depths.empty() ? common : median(depths));
  }
  return out;
}

void append_wall_solid(Model& model, PlaneVertices& vertices, const VectorFace& face,
                       const Face& front, const std::vector<uint32_t>& hole_parts,
                       const std::vector<uint32_t>& reveal_parts, double thickness_m) {
  const uint64_t first = model.faces.size();
  std::vector<PartRing> before, behind;
  for (size_t r = 0; r <= face.openings.size(); ++r) {
    const VectorRing& ring = r == 0 ? face.outline : face.openings[r - 1];
    before.push_back(part_ring(vertices, ring));
    behind.push_back(turned(part_ring(vertices, ring, -thickness_m)));
    if (r > 0) before.back().part = behind.back().part = hole_parts[r - 1];
  }
  append_face(model, front, before);
  append_face(model, back_of(front, thickness_m), behind);
  append_sides(model, vertices, face.outline, 0, -thickness_m, true, front.part);
  for (size_t r = 0; r < face.openings.size(); ++r)
    append_sides(model, vertices, face.openings[r], 0, -thickness_m, true, reveal_parts[r]);
  model.solids.push_back({front.part, first, model.faces.size() - first});
}

}  // namespace jalon
