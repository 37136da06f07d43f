// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Gaps of polygons in planes that meet are closed along the planes' common line (Boulaassal 2010, 5.6.3.3): what the
// relations of a model say with and without it.
#include <doctest/doctest.h>

#include "model/relations/relations.h"
#include "unit/modelling/facade_scenes.h"

using namespace facades;

namespace {

// Pairs of neighbouring walls of the chain of six, and by how much they stand apart.
struct Joined {
  size_t met_in_a_line = 0;
  double widest_m = 0;
};

Joined walls_of(const Segmentation& segmentation, const char* json) {
  const Model model = facade_of(segmentation, json);
  Task task;
  Joined out;
  for (const Relation& r :
       find_relations(model, {.elements = RelationSettings::Elements::kFaces}, task)) {
    const Face &a = model.faces[r.first], &b = model.faces[r.second];
    if (model.parts[a.part].part_class != "wall" || model.parts[b.part].part_class != "wall")
      continue;
    using enum NineIntersection::Place;
    if (r.matrix.at(kBoundary, kBoundary) == 1 && r.matrix.is_empty(kInterior, kInterior))
      ++out.met_in_a_line;
    out.widest_m = std::max(out.widest_m, r.distance_m);
  }
  return out;
}

}  // namespace

TEST_CASE("facade: walls that scans leave apart meet in the common line of their planes") {
  const Scan scan("{\"name\":\"lycee\"}");
  const Joined closed = walls_of(scan.segmentation, "{}"),
               open = walls_of(scan.segmentation, "{\"joints\":false}");
  MESSAGE("FIGURE gaps of walls: "
          << closed.met_in_a_line << " of 5 corners closed, " << open.met_in_a_line
          << " without joints, where they stand up to " << 1000 * open.widest_m << " mm apart");
  CHECK(closed.met_in_a_line == 5);
  CHECK(closed.widest_m == 0);
  CHECK(open.met_in_a_line < closed.met_in_a_line);
  CHECK(open.widest_m > 0.001);
}
