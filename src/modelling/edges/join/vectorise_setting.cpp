// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/vectorise_setting.h"

namespace jalon {

VectoriseSetting vectorise_setting(const ParamSet& params) {
  VectoriseSetting s;
  s.contour.max_edge_m = params.number("max_edge_m");
  s.contour.mode = params.text("contour") == "alpha" ? ContourMode::kAlpha : ContourMode::kLongEdge;
  s.contour.alpha_factor = params.number("alpha_factor");
  s.contour.min_area_m2 = params.number("min_area_m2");
  s.contour.min_opening_area_m2 = params.number("min_opening_area_m2");
  s.contour.min_opening_width_m = params.number("min_opening_width_m");
  s.straighten = params.flag("straighten");
  s.arcs = params.flag("arcs");
  s.direction_angle_rad = params.number("direction_angle_rad");
  s.reveal_depth_m = params.number("reveal_depth_m");
  s.straight.tolerance_m = params.number("tolerance_m");
  s.straight.snap_angle_rad = params.number("snap_angle_rad");
  s.straight.rectangles = params.flag("rectangles");
  return s;
}

}  // namespace jalon
