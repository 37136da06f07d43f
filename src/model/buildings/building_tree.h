// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "geometry/plane.h"
#include "model/buildings/vertical_pieces.h"
#include "model/model.h"

// Buildings as blocks, facades and strips, each of which may be moved by itself: a block as a whole,
// a facade and a strip along the facade's normal (Monnier 2014).
namespace jalon {

enum class StripRemainder {
  kKeep,  ///< cut at multiples of the width; a rest of half a width and more is a strip, else it goes to the last
  kEqual,  ///< as many equal strips as come nearest to the width
};
enum class StripTop {
  kRectangle,  ///< from the lowest to the highest of the facade
  kClip,       ///< only where the facade is: gables keep their slopes
};

/// The settings of operation "building_strips".
struct BuildingSettings {
  double width_m = 1.5;
  StripRemainder remainder = StripRemainder::kKeep;
  StripTop top = StripTop::kRectangle;
  double least_length_m = 0.1;
  double touch_m = 0.1;
  bool corners = true;
  double tilt_rad = 0.08726646259971647;  // 5 degrees
  bool others = false;                    ///< of who makes a model: with add_others()
};
std::span<const ParamRow> building_strip_rows();

/// A vertical wall of a building: a region of a plane, in metres along it and up.
struct BuildingFacade {
  uint32_t building = 0;
  Vec3 normal;          ///< level, out of the building
  double offset_m = 0;  ///< normal . p
  double from_m = 0, to_m = 0, bottom_m = 0, top_m = 0;
  std::vector<std::vector<Vec2>> pieces;  ///< (along . p, z), counter-clockwise seen from outside
  bool was_turned = false;                ///< the input's normal looked inward

  Vec3 along() const { return {-normal.y, normal.x, 0}; }  ///< to the right, seen from outside
  Vec3 place(const Vec2& p) const { return along() * p.u + normal * offset_m + Vec3{0, 0, p.v}; }
};

struct BuildingStrip {
  uint32_t facade = 0;
  double from_m = 0, to_m = 0;
  std::vector<std::vector<Vec2>>
      outlines;         ///< as the facade's pieces; one rectangle, or what was clipped
  double offset_m = 0;  ///< off the facade's plane, along its normal: of strips that were adjusted
};

struct BuildingTree {
  uint32_t blocks = 0;
  std::vector<uint32_t> block_of_building;
  std::vector<std::string> buildings;  ///< names
  std::vector<BuildingFacade> facades;
  std::vector<BuildingStrip> strips;
  std::vector<OtherFace> others;  ///< of the model that it was made of
  SharedText crs;

  uint32_t block_of(const BuildingFacade& facade) const {
    return block_of_building[facade.building];
  }
};

/// Steps: the vertical faces of each building (triangles that touch in one plane, where the model has
/// no faces); normals turned outward by the footprint; strips; blocks of buildings that touch.
/// A model of strips keeps its blocks, facades and strips (given_strips.h).
/// Error(kInsufficientData) for a model without vertical faces. O(n log n); triangles
/// of a bare mesh are compared pair by pair within a building.
BuildingTree building_tree(const Model& model, const BuildingSettings& settings, Task& task);

/// The tree as a model: parts block -> building -> facade -> strip, a face a strip (more where
/// clipping cuts it), whose id is the strip's number; two triangles a rectangle.
Model strip_model(const BuildingTree& tree);
/// Adds to it what is no facade, as it is: roofs and ground hide what is behind them. Each is a part of class "roof"
/// below its building, or "ground" of none. buildings: the model that the tree was made of.
void add_others(Model& strips, const BuildingTree& tree, const Model& buildings);

}  // namespace jalon
