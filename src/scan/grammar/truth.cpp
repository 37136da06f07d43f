// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/truth.h"

#include <cmath>

#include "base/error.h"
#include "scan/builder/contour.h"

namespace jalon {

const char* name_of(OpeningClass opening_class) {
  constexpr const char* kNames[] = {"window", "door",  "gateway", "shop_front",
                                    "vent",   "other", "recess"};
  return kNames[static_cast<size_t>(opening_class)];
}

Sight SightRaster::at(const Vec2& p) const {
  const double i = std::floor((p.u - low.u) / cell_m), j = std::floor((p.v - low.v) / cell_m);
  if (!(i >= 0 && j >= 0 && i < columns && j < rows)) return Sight::kOutside;
  return cells[static_cast<size_t>(j) * columns + static_cast<size_t>(i)];
}

}  // namespace jalon

namespace jalon::grammar {

namespace {

TruthContour truth_contour(const Contour& contour) {
  TruthContour out;
  for (const ContourCorner& c : contour) out.push_back({c.at, c.sagitta_m});
  return out;
}

}  // namespace

FacadeTruth truth_of(const Plan& plan, const Transform& T) {
  FacadeTruth out;
  out.kind = jalon::name_of(plan.kind);
  for (const PlannedWall& planned : plan.walls) {
    const Frame frame = planned.frame();
    TruthWall wall;
    wall.name = planned.name;
    wall.origin = T.point(frame.origin);
    wall.along = T.direction(frame.u);
    wall.up = T.direction(frame.v);
    wall.normal = T.direction(frame.normal());
    std::vector<Contour> notches;
    double taken = 0;
    for (const PlannedOpening& o : planned.openings) {
      const Contour contour = contour_of(o.shape);
      TruthOpening opening;
      opening.wall = static_cast<uint32_t>(out.walls.size());
      opening.opening_class = o.opening_class;
      opening.contour = truth_contour(contour);
      opening.depth_m = o.depth_m;
      opening.storey = o.storey;
      opening.touches_border = touches_border(planned.outline, contour);
      opening.touches_ground = opening.touches_border && bounds_of(contour).v0 == 0;
      if (opening.touches_border) notches.push_back(contour);
      taken += area_of(contour);
      out.openings.push_back(std::move(opening));
    }
    wall.outline = truth_contour(notched(planned.outline, notches));
    for (const Pad& pad : planned.pads) {
      TruthWall::Cover cover{truth_contour(pad.outline), {}};
      taken += area_of(pad.outline);
      for (const Contour& hole : pad.holes) {
        cover.holes.push_back(truth_contour(hole));
        taken -= area_of(hole);
      }
      wall.covers.push_back(std::move(cover));
    }
    wall.area_m2 = area_of(planned.outline) - taken;
    out.walls.push_back(std::move(wall));
  }
  return out;
}

}  // namespace jalon::grammar
