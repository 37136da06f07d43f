// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan/builder/builder.h"
#include "scan/yard_settings.h"

// Four one-storey buildings of corrugated sheet about a yard, after the annexes of the master's thesis on feature codes
// (University of Liege 2021): outlines, openings, gutters and targets stand where they were surveyed, in metres from
// (734 500, 642 100); what hides between them is invented.
namespace jalon::yard {

constexpr double kGround_m = 246.70;  // the surveyed foot points, to a few centimetres
constexpr double kGutterRadius_m = 0.038, kGutterTop_m = 249.53;
constexpr double kSillDrop_m = 0.07;  // of an inclined sill, from the frame to the wall
// Behind the front: the middle of a window's frame, 4 cm deep; of a door's leaf as far as the eight targets of the list
// that stick on its pane lie behind what was surveyed of it, 6 mm on average (from -11 to 22).
constexpr double kWindowPaneBehind_m = 0.02, kDoorPaneBehind_m = 0.006;
constexpr double kFrameWidth_m = 0.08;                     // of frames, mullions
constexpr double kCorrugation_m = 0.025, kPitch_m = 0.20;  // amplitude and wave length of the sheet
constexpr double kTargetHalf_m = 0.05;

struct Opening {
  bool is_door = false;
  int id = 0;  ///< of its first surveyed point
  double left_m = 0, right_m = 0, low_m = 0, high_m = 0;
  double depth_m = 0;  ///< of the frame's front behind the wall
  bool is_half_open = false, has_blind = false;

  double pane_behind_m() const { return is_door ? kDoorPaneBehind_m : kWindowPaneBehind_m; }
  /// The panes of the frame, in the wall's coordinates.
  std::vector<Rect> lights() const;
  /// The hole in the wall: with its sill.
  double hole_low_m() const { return is_door ? low_m : low_m - kSillDrop_m; }
};

/// A wall that is built, seen from outside: u to the right from its left end, v = the height.
struct Side {
  char building = 'A';
  Frame wall;
  double length_m = 0, top_m = 0;
  std::vector<Opening> openings;

  /// The plane of an opening's front; it turns inward about its left edge where it is half open.
  Frame front_of(const Opening& opening) const;
};

struct Building {
  char name = 'A';
  int sequence = 300;
  std::vector<Vec2> outline;  ///< as it was surveyed, in either order
  double low_m = 0, top_m = 0;
};

struct Gutter {
  Vec2 centre;
  Vec2 outward;
};

struct Target {
  int id = 0, code = 0;
  Vec3 place;
  bool has_patch = false;  ///< a sheet of its own; those of gutters follow the pipe
  Frame frame;             ///< of the patch
  double u_m = 0, v_m = 0;
};

struct Plan {
  std::vector<Building> buildings;
  std::vector<Side> sides;
  std::vector<Gutter> gutters;
  std::vector<Target> targets;
};

/// By the seed: which windows are half open (two) and have blinds (a third).
Plan plan_of(const YardSettings& settings, uint64_t seed);

/// The plane of the targets on a wall: the even one about which its sheet waves. Those of the list stand 3 mm before it
/// on average, the farthest 28 mm before and 11 mm behind.
inline const Frame& target_sheet(const Side& side) { return side.wall; }

/// Targets of the list that have a place on the sides and gutters that are built (targets.cpp).
void add_targets(const YardSettings& settings, Plan& plan);

}  // namespace jalon::yard
