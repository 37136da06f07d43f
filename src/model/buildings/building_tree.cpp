// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/building_tree.h"

#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "geometry/polygon2.h"
#include "model/buildings/facades.h"
#include "model/buildings/given_strips.h"
#include "model/buildings/vertical_pieces.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr auto kBuildingStripRows = setting_rows(
    number_row<&BuildingSettings::width_m>("width_m", 0.05, 1000, "m", "", "Width of a strip."),
    choice_row<&BuildingSettings::remainder>(
        "remainder", "keep|equal", "",
        "What is left at a facade's end: a strip from half a width on, else added to the last "
        "(keep); "
        "or as many equal strips as come nearest to the width (equal)."),
    choice_row<&BuildingSettings::top>(
        "top", "rectangle|clip", "",
        "Strips from the facade's lowest to its highest, or clipped to its outline: gables."),
    number_row<&BuildingSettings::least_length_m>(
        "least_length_m", 0, 1000, "m", "", "Least length of a facade: shorter ones are left out."),
    number_row<&BuildingSettings::touch_m>(
        "touch_m", 0, 100, "m", "",
        "Greatest distance of footprints that touch: such buildings are of one block."),
    bool_row<&BuildingSettings::corners>("corners", "",
                                         "Buildings that touch at a corner alone touch."),
    number_row<&BuildingSettings::tilt_rad>("tilt_rad", 0, 0.7, "rad", "",
                                            "Faces within this of the vertical are facades."),
    bool_row<&BuildingSettings::others>(
        "others", "",
        "What is no facade comes along as it is, below its building: roofs and ground hide what is "
        "behind them."));

uint32_t add_part(Model& model, std::string name, const char* part_class, uint64_t parent) {
  Part part;
  part.name = std::move(name);
  part.part_class = part_class;
  part.parent = parent;
  part.level_of_detail = 2;
  model.parts.push_back(std::move(part));
  return static_cast<uint32_t>(model.parts.size() - 1);
}

void add_strip(Model& model, const BuildingTree& tree, uint32_t number, uint32_t part) {
  const BuildingStrip& strip = tree.strips[number];
  const BuildingFacade& facade = tree.facades[strip.facade];
  model.parts[part].width_m = strip.to_m - strip.from_m;
  model.parts[part].height_m = facade.top_m - facade.bottom_m;
  for (const auto& outline : strip.outlines) {
    std::vector<Vec3> ring;
    for (const Vec2& p : outline) ring.push_back(facade.place(p) + facade.normal * strip.offset_m);
    Face face;
    face.part = part;
    face.id = number;
    face.plane = {facade.normal, facade.offset_m + strip.offset_m};
    face.area_m2 = std::fabs(signed_area(outline));
    const auto first = static_cast<uint32_t>(model.vertices.size());
    model.add_face(face, {ring});
    for (const auto& [a, b, c] : triangulate({outline})) {
      model.triangles.push_back({first + a, first + b, first + c});
      model.triangle_faces.push_back(number);
    }
  }
}

// A file that lost its transform is ten thousand times too large; no wall of a building has so many strips.
void require_lengths(const std::vector<BuildingFacade>& facades, double width_m) {
  constexpr double kMostStrips = 20000;
  for (const BuildingFacade& f : facades)
    if (const double length_m = f.to_m - f.from_m; length_m > kMostStrips * width_m)
      fail(Status::kInvalidArgument,
           "a facade is %s km long, too long for strips of %s m: are the coordinates in metres, "
           "and did the file keep its transform?",
           text_of(length_m / 1000, 0).c_str(), text_of(width_m).c_str());
}

}  // namespace

std::span<const ParamRow> building_strip_rows() { return kBuildingStripRows; }

BuildingTree building_tree(const Model& model, const BuildingSettings& settings, Task& task) {
  if (is_of_strips(model)) return given_strips(model);
  // 1. Upright faces, by building.
  VerticalPieces pieces = vertical_pieces(model, settings.tilt_rad);
  task.checkpoint(0.3);
  // 2. Facades, their normals outward.
  BuildingTree tree;
  tree.facades = facades_of(pieces, settings.least_length_m);
  if (tree.facades.empty())
    fail(Status::kInsufficientData, "the model has no facades: no face of it stands upright");
  require_lengths(tree.facades, settings.width_m);
  turn_outward(tree.facades);
  task.checkpoint(0.6);
  // 3. Blocks of buildings that touch.
  Blocks blocks =
      blocks_of(tree.facades, pieces.buildings.size(), settings.touch_m, settings.corners);
  tree.blocks = blocks.count;
  tree.block_of_building = std::move(blocks.of_building);
  tree.buildings = std::move(pieces.buildings);
  tree.others = std::move(pieces.others);
  tree.crs = model.crs;
  // 4. Strips.
  for (uint32_t f = 0; f < tree.facades.size(); ++f) {
    if (f % 256 == 0)
      task.checkpoint(0.7 +
                      0.3 * static_cast<double>(f) / static_cast<double>(tree.facades.size()));
    for (BuildingStrip& strip : strips_of(tree.facades[f], f, settings))
      tree.strips.push_back(std::move(strip));
  }
  return tree;
}

Model strip_model(const BuildingTree& tree) {
  Model model;
  model.crs = tree.crs;
  std::vector<uint32_t> building_parts, facade_parts, block_parts;
  for (uint32_t b = 0; b < tree.blocks; ++b)
    block_parts.push_back(
        add_part(model, "block " + std::to_string(b + 1), part_class::kBlock, kNoParent));
  for (size_t b = 0; b < tree.buildings.size(); ++b)
    building_parts.push_back(add_part(model, tree.buildings[b], part_class::kBuilding,
                                      block_parts[tree.block_of_building[b]]));
  for (size_t f = 0; f < tree.facades.size(); ++f)
    facade_parts.push_back(add_part(model, "facade " + std::to_string(f + 1), part_class::kFacade,
                                    building_parts[tree.facades[f].building]));
  for (uint32_t s = 0; s < tree.strips.size(); ++s)
    add_strip(model, tree, s,
              add_part(model, "strip " + std::to_string(s + 1), part_class::kStrip,
                       facade_parts[tree.strips[s].facade]));
  return model;
}

void add_others(Model& strips, const BuildingTree& tree, const Model& buildings) {
  for (size_t i = 0; i < tree.others.size(); ++i) {
    const auto [number, building] = tree.others[i];
    const Face& from = buildings.faces[number];
    const bool is_ground = building == kNoPart;
    Face face = from;
    // Buildings stand behind the blocks (strip_model).
    face.part = add_part(strips, (is_ground ? "ground " : "roof ") + std::to_string(i + 1),
                         is_ground ? part_class::kGround : part_class::kRoof,
                         is_ground ? kNoParent : uint64_t{tree.blocks} + building);
    face.id = static_cast<uint32_t>(strips.faces.size());
    std::vector<std::vector<Vec3>> rings;
    for (uint64_t r = from.first_ring; r < from.first_ring + from.ring_count; ++r) {
      const Ring& ring = buildings.rings[r];
      rings.emplace_back();
      for (uint64_t c = ring.first; c < ring.first + ring.count; ++c)
        rings.back().push_back(buildings.vertices[buildings.corners[c]]);
    }
    const size_t added = strips.add_face(face, rings);
    for (const auto& triangle : triangles_of_face(strips, strips.faces[added])) {
      strips.triangles.push_back(triangle);
      strips.triangle_faces.push_back(face.id);
    }
  }
}

}  // namespace jalon
