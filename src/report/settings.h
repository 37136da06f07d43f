// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jalon {

/// Most points of a page's view in three dimensions, and what the rows "viewer_points" say of it.
constexpr int64_t kViewerPoints = 1000000;
constexpr const char* kViewerPointsHelp =
    "Most points in the view in three dimensions, evenly taken; 0: no view";

/// How front faces are filled: by the side of the main plane on which they lie (Boulaassal
/// 2010, 4.4.1: red in front, green behind, stronger with the distance), by depth alone, or not at
/// all.
enum class ElevationColours { kSides, kDepth, kNone };

/// What of a model an elevation shows.
struct ViewLimits {
  double in_front_m = 10, behind_m = 10;  ///< of the main plane: the front face of the largest area
  double element_reach_m = 3;             ///< of elements in front of the nearest wall behind them
  double front_angle_rad = 0.26;          ///< largest turn of a front face from the facade
};

/// Half a decimetre: masons' openings of one kind differ by some centimetres, kinds by more.
constexpr double kTypeTolerance_m = 0.05;

/// Operation "elevation".
struct ElevationSettings {
  std::string title = "Facade elevation";
  std::string source, date;    ///< for the title block; "": left out
  std::string paper = "auto";  ///< as lay_out_sheet
  int64_t scale = 0;           ///< denominator; 0 = the largest usual one that fits
  int64_t facade = 0;          ///< 0 = the whole model
  ViewLimits limits;
  ElevationColours colours = ElevationColours::kSides;
  double type_tolerance_m = kTypeTolerance_m;
  bool labels = true;
  bool dimensions = true;
  bool outlines_only = false;  ///< without border and title block: a figure for a page
};

/// Operation "report".
struct ReportSettings {
  int64_t bins = 60;  ///< of the histogram of residuals
  bool drawing = true;
  bool picture = true;
  bool orthoimage = true;
  int64_t viewer_points = kViewerPoints;
};

}  // namespace jalon
