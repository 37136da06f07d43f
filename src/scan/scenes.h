// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "scan/scene_builder.h"

// One function a scene; scan/scenes.cpp chooses.

namespace jalon {

/// A town house: the bundled sample. The wall stands on y = 0 between x = 0 and the width and looks along -Y.
void build_facade(const ParamSet& params, SceneBuilder& out);
/// The 60 m street of the measurements: six facades with recessed windows, ground, columns, gutters, boxes, a sphere.
void build_street(const ParamSet& params, SceneBuilder& out);
/// Angle about Z by which the street is turned, so that nothing is parallel to an axis.
constexpr double kStreetAngle_rad = 17 * 0.017453292519943295;

void build_room(SceneBuilder& out);       ///< 6 x 5 x 2.8 m, seen from inside
void build_box(SceneBuilder& out);        ///< 4.2 x 1.8 x 1.5 m on a ground of 20 x 20 m
void build_surrounds(SceneBuilder& out);  ///< facade-segmentation S2: wall, window surrounds, joinery
void build_strips(SceneBuilder& out);  ///< facade-segmentation S7: six staggered strips, the trap of slanted planes

}  // namespace jalon
