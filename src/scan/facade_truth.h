// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "scan/scanner.h"
#include "scan/scene.h"

namespace jalon {

enum class OpeningClass { kWindow, kDoor, kGateway, kShopFront, kVent, kOther, kRecess };
/// "window", "door", "gateway", "shop_front", "vent", "other", "recess".
const char* name_of(OpeningClass opening_class);

/// A corner in a wall's plane and the edge to the next: straight where the sagitta is 0, else an arc; positive: it
/// bulges to the right of the walk.
struct TruthCorner {
  Vec2 at;
  double sagitta_m = 0;
};
/// Counter-clockwise.
using TruthContour = std::vector<TruthCorner>;

/// What the stations could see of a place of a wall's plane.
enum class Sight : char {
  kOutside = '.',  ///< not on the wall and not in its openings
  kOpening = 'o',
  kCovered = 'c',  ///< something flat stands on the wall: a surround, a panel
  kSeen = 's',     ///< a beam reached it
  kHidden = 'h',   ///< every beam towards it was stopped before
  kNever = 'n'     ///< no station has a beam towards it
};

/// Cells of a wall's plane, row by row from below.
struct SightRaster {
  double cell_m = 0.1;
  Vec2 low;  ///< corner of the first cell
  uint32_t columns = 0, rows = 0;
  std::vector<Sight> cells;

  /// Outside of the raster: kOutside.
  Sight at(const Vec2& p) const;
};

struct TruthWall {
  std::string name;
  Vec3 origin, along, up, normal;  ///< p = origin + u along + v up; in the world
  TruthContour outline;            ///< walks round the openings at its border
  struct Cover {
    TruthContour outline;
    std::vector<TruthContour> holes;
  };
  std::vector<Cover> covers;
  double area_m2 = 0;                                        ///< openings and covers taken off
  double seen_share = 0, hidden_share = 0, never_share = 0;  ///< of that area
  SightRaster raster;
};

struct TruthOpening {
  uint32_t wall = 0;
  OpeningClass opening_class = OpeningClass::kWindow;
  TruthContour contour;
  double depth_m = 0;
  int storey = 0;  ///< 0: on the ground
  bool touches_ground = false, touches_border = false;
  /// Of the contour and of its area: a beam of some station reached the wall's plane there or went through it.
  double outline_seen_share = 0, area_seen_share = 0;
  double spacing_m = 0;  ///< of all stations' points on the wall's plane there; 0: none sees it
  double width_spacings = 0;  ///< the lesser of width and height in these spacings; 0 without
};

/// What is true of a facade and of its scan.
struct FacadeTruth {
  std::string kind;
  uint64_t seed = 0;
  std::vector<TruthWall> walls;
  std::vector<TruthOpening> openings;
};

/// A scene's own scanner: where it stands and how it measures.
struct SceneSurvey {
  std::vector<ScanStation> stations;
  StaticSettings scanner;
};
/// Of the scene "grammar" by its seed; of others no station and the defaults.
SceneSurvey scene_survey(const SceneSettings& settings);

/// Throws kUnsupported for scenes other than "grammar". survey: of the scan that is made of it; one without stations
/// stands for the scene's own.
FacadeTruth facade_truth(const SceneSettings& settings, const SceneSurvey& survey, Task& task);

/// As text; docs of the shape: jalon_scene_write_truth.
std::string json_of(const FacadeTruth& truth);

}  // namespace jalon
