// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan/facade_truth.h"
#include "scan/grammar/shape.h"
#include "scan/grammar_settings.h"

// A facade before it is built: x along the front, z up, y into the house; walls look along -Y. What a draughtsman would
// name, with its place; realise.h makes faces of it.

namespace jalon::grammar {

/// What stands in an opening.
struct Filling {
  enum class Kind {
    kSash,     ///< a frame with panes between mullions and transoms
    kLeaf,     ///< a closed door leaf or gate, with raised panels
    kClosed,   ///< a closed blind, at little depth
    kLouvre,   ///< slats
    kNothing,  ///< a passage
    kRecess    ///< a back wall, which is a wall of the plan
  };
  Kind kind = Kind::kSash;
  double frame_m = 0.07;
  int mullions = 1, transoms = 0;
  double stall_m = 0;        ///< solid panel below the glass: of shop fronts
  double blind_share = 0;    ///< how far a roller blind is down
  double curtain_share = 0;  ///< of the width behind the glass
  bool mirrors = false;      ///< the glass returns nothing
};

struct PlannedOpening {
  Shape shape;
  OpeningClass opening_class = OpeningClass::kWindow;
  double depth_m = 0.2;
  int storey = 0;
  Filling filling;
  double surround_m = 0, proud_m = 0.04;  ///< stone round it, and how far that stands out
  bool has_sill = false, has_shutters = false;
};

/// Something flat on a wall, or before it.
struct Pad {
  std::string part_class;
  Contour outline;
  std::vector<Contour> holes;
  double low_m = 0, high_m = 0.04;  ///< heights over the wall of its back and its front
};

struct PlannedWall {
  std::string name;
  double y_m = 0;
  Contour outline;  ///< u is x, v is z
  std::vector<PlannedOpening> openings;
  std::vector<Pad> pads;
  bool is_open_behind = true;  ///< rooms are seen through its openings

  Frame frame() const { return {{0, y_m, 0}, {1, 0, 0}, {0, 0, 1}}; }
};

/// A face that is part of no wall's front: sides between walls, roofs, canopies.
struct Plate {
  std::string part_class;
  Frame frame;
  Rect rect;
};
struct Block {
  std::string part_class;
  Vec3 corner, size;
};
struct Pipe {
  Vec3 foot;
  double radius_m, height_m;
};

struct Plan {
  FacadeKind kind = FacadeKind::kAny;
  double width_m = 0;
  std::vector<double> floors_m;  ///< levels of the floors, the eaves last
  std::vector<PlannedWall> walls;
  std::vector<Plate> plates;
  std::vector<Block> blocks;
  std::vector<Pipe> pipes;
  double rooms_from_m = 0.45, rooms_to_m = 4;  ///< y of the rooms' floors and of their back wall
  bool has_rooms = true;                       ///< floors between the storeys
  double rooms_top_m = 0;                      ///< of their outer walls; 0: the eaves
  bool has_gaps = false;

  double top_m() const;
};

inline bool decided(BySeed asked, bool drawn) {
  return asked == BySeed::kSeed ? drawn : asked == BySeed::kYes;
}

/// The facade that the settings and the seed ask for. Throws kInvalidArgument where the front has no room for one bay.
Plan plan_facade(const GrammarSettings& settings, uint64_t seed);

}  // namespace jalon::grammar
