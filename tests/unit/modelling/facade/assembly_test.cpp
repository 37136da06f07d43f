// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Models from plans drawn by hand: their tree, their sizes, their shared vertices and their solids.
#include "modelling/facade/assembly.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "unit/modelling/facade_scenes.h"
#include "unit/modelling/model_checks.h"
#include "unit/modelling/planned_scene.h"

using namespace planned;
using facades::child_of;
using facades::parts_of;

namespace {

Model assembled_from(const PlannedScene& scene, const AssemblySetting& setting = {}) {
  Task task;
  Model model = assemble_facades(scene.segmentation, scene.plan, setting, task);
  validate(model);
  return model;
}

size_t named(const Model& model, const std::string& name) {
  size_t found = model.parts.size();
  for (size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].name == name) {
      CHECK(found == model.parts.size());
      found = i;
    }
  REQUIRE(found < model.parts.size());
  return found;
}

/// A wall of 6 x 4 m with a window on the right, a copy of it on the left and a door between.
PlannedScene windows_and_door() {
  PlannedScene scene;
  FacadeOpening copy = opening_at({0.5, 1.5}, {1.5, 3}, 0.2);
  copy.copied_from = 0;
  scene.add_wall({0, 0}, {6, 4},
                 {opening_at({4.5, 1.5}, {5.5, 3}, 0.2), copy,
                  opening_at({2.5, 0.1}, {3.7, 2.3}, 0.3, OpeningKind::kDoor)});
  return scene;
}

}  // namespace

TEST_CASE("assembly__makes_the_tree_of_parts_with_names_sizes_and_evidence") {
  PlannedScene scene = windows_and_door();
  // A cornice of 6 x 0.4 m, 0.3 m before the wall at its top, and a shadow.
  scene.plan.facades[0].elements = {scene.add_plane({rectangle({0, 3.6}, {6, 4}), {}}, 0.3)};
  scene.plan.facades[0].walls[0].wall.shadows.push_back({rectangle({4, 0}, {5, 1}), 0, false});
  const Model model = assembled_from(scene);
  const size_t facade = named(model, "facade"), wall = named(model, "wall 1"),
               left = named(model, "window 1.1"), right = named(model, "window 1.2"),
               door = named(model, "door 1.1"), cornice = named(model, "cornice 1");
  CHECK(model.parts[facade].parent == kNoParent);
  for (const size_t part : {wall, cornice}) CHECK(model.parts[part].parent == facade);
  for (const size_t part : {left, right, door, named(model, "no data 1")})
    CHECK(model.parts[part].parent == wall);
  CHECK(parts_of(model, "building").empty());
  CHECK(model.parts[left].evidence == Evidence::kCopied);
  CHECK(model.parts[left].copied_from == right);
  CHECK(model.parts[right].evidence == Evidence::kRevealed);
  CHECK(model.parts[right].width_m == doctest::Approx(1));
  CHECK(model.parts[right].height_m == doctest::Approx(1.5));
  CHECK(model.parts[door].depth_m == 0.3);
  CHECK(model.parts[cornice].depth_m == doctest::Approx(-0.3));
  CHECK(model.parts[wall].width_m == doctest::Approx(6));
  for (const size_t part : {left, right, door}) {
    CHECK(child_of(model, part, "joinery") < model.parts.size());
    CHECK(child_of(model, part, "reveal") < model.parts.size());
    // Each fills one hole.
    size_t holes = 0;
    for (const Ring& ring : model.rings) holes += ring.part == part;
    CHECK(holes == 1);
  }
  AssemblySetting alone;
  alone.walls_only = true;
  const Model walls = assembled_from(scene, alone);
  CHECK(parts_of(walls, "joinery").empty());
  CHECK(parts_of(walls, "cornice").empty());
  CHECK(parts_of(walls, "window").size() == 2);
}

TEST_CASE("assembly__faces_share_their_vertices_and_have_the_areas_of_the_plan") {
  const Model model = assembled_from(windows_and_door());
  // The wall's corners, and for each opening those of its hole and of its pane.
  CHECK(model.vertices.size() == 4 + 3 * 8);
  double wall = 0, panes = 0, reveals = 0;
  for (const Face& face : model.faces) {
    const std::string& part_class = model.parts[face.part].part_class;
    (part_class == "wall" ? wall : part_class == "joinery" ? panes : reveals) += face.area_m2;
    CHECK(checks::flatness(model, face) < 1e-12);
    CHECK(checks::ring_fault(model, face).empty());
  }
  CHECK(wall == doctest::Approx(24 - 2 * 1.5 - 1.2 * 2.2).epsilon(1e-12));
  CHECK(panes == doctest::Approx(2 * 1.5 + 1.2 * 2.2).epsilon(1e-12));
  CHECK(reveals == doctest::Approx(2 * 5 * 0.2 + 6.8 * 0.3).epsilon(1e-12));
  // Neighbours that the plan joins have two corners in common.
  PlannedScene pair;
  pair.add_wall({0, 0}, {6, 4}, {});
  pair.add_wall({6, 0}, {9, 4}, {});
  CHECK(assembled_from(pair).vertices.size() == 8);
  for (const double z : {0.0, 4.0})
    pair.plan.shared.push_back({{6, 0, z}, {{0, {6, z}}, {1, {6, z}}}});
  CHECK(assembled_from(pair).vertices.size() == 6);
}

TEST_CASE("assembly__several_facades_stand_under_a_building_and_walls_count_on") {
  PlannedScene scene;
  scene.add_wall({5, 0}, {9, 4}, {});
  scene.add_wall({0, 4.5}, {5, 8}, {}, 0.1);
  scene.add_wall({0, 0}, {5, 4}, {}, 0.1);
  scene.plan.facades.emplace_back();
  scene.add_wall({0, 0}, {6, 4}, {}, 20);
  const Model model = assembled_from(scene);
  const size_t building = named(model, "building");
  CHECK(model.parts[named(model, "facade 1")].parent == building);
  CHECK(model.parts[named(model, "facade 2")].parent == building);
  // From left to right, then from below.
  CHECK(model.parts[named(model, "wall 1")].width_m == doctest::Approx(5));
  CHECK(model.parts[named(model, "wall 1")].depth_m == doctest::Approx(-0.1));
  CHECK(model.parts[named(model, "wall 1")].height_m == doctest::Approx(4));
  CHECK(model.parts[named(model, "wall 2")].height_m == doctest::Approx(3.5));
  CHECK(model.parts[named(model, "wall 3")].width_m == doctest::Approx(4));
  CHECK(model.parts[named(model, "wall 4")].parent == named(model, "facade 2"));
}

TEST_CASE("assembly__solids_are_closed_and_as_thick_as_openings_are_deep") {
  AssemblySetting setting;
  setting.solids = true;
  PlannedScene scene = windows_and_door();
  scene.plan.facades[0].walls[0].wall.openings[1].outline.edges[2].sagitta_m = 0.2;
  scene.plan.planes[0].faces[0].openings[1] =
      reversed(scene.plan.facades[0].walls[0].wall.openings[1].outline);
  for (const double thickness_m : {0.0, 0.45}) {
    setting.thickness_m = thickness_m;
    const Model model = assembled_from(scene, setting);
    REQUIRE(model.solids.size() == 1);
    CHECK(checks::solid_fault(model, model.solids[0]).empty());
    const double arc = checks::area(checks::flat_rings(model, model.faces[0])[2]) + 1.5;
    CHECK(arc < -0.1);  // clockwise: the head takes its segment of 1 m x 0.2 m off
    const double front = 24 - 2 * 1.5 - 1.2 * 2.2 + arc;
    // The median of 0.2, 0.2 and 0.3 m unless it is given.
    CHECK(planned::volume_within(model, model.solids[0].first_face, model.solids[0].face_count) ==
          doctest::Approx(front * (thickness_m > 0 ? thickness_m : 0.2)).epsilon(1e-9));
    CHECK(parts_of(model, "reveal").size() == 3);
  }
}
