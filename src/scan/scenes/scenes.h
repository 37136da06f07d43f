// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/scene.h"
#include "scan/builder/builder.h"

// One function a scene; scan/scenes.cpp chooses. All facades stand about y = 0 and look along -Y.

namespace jalon {

/// A town house: the bundled sample. The wall stands on y = 0 between x = 0 and the width.
void build_facade(const SceneSettings& settings, SceneBuilder& out);
/// The 60 m street of the measurements: six facades with recessed windows, ground, columns, gutters, boxes, a sphere.
void build_street(const SceneSettings& settings, SceneBuilder& out);
/// Angle about Z by which the street is turned, so that nothing is parallel to an axis.
constexpr double kStreetAngle_rad = 17 * 0.017453292519943295;

/// 6 x 5 x 2.8 m, seen from inside.
void build_room(const SceneSettings& settings, SceneBuilder& out);
/// A wall 8 m high, bent about an upright axis 6 m behind it, on the ground before it.
void build_bow(const SceneSettings& settings, SceneBuilder& out);
/// 4.2 x 1.8 x 1.5 m on a ground of 20 x 20 m.
void build_box(const SceneSettings& settings, SceneBuilder& out);

// After Boulaassal 2010, chapter 3.
/// S1: a wall of posts, bands and windows.
void build_insa(const SceneSettings& settings, SceneBuilder& out);
/// S2: wall, window surrounds, joinery.
void build_surrounds(const SceneSettings& settings, SceneBuilder& out);
/// S3: S2 behind trees and cars, with ghosts.
void build_unwanted(const SceneSettings& settings, SceneBuilder& out);
/// S5: ten planes of mixed sizes.
void build_std(const SceneSettings& settings, SceneBuilder& out);
/// S6: one plane of 10 x 10 m.
void build_normal(const SceneSettings& settings, SceneBuilder& out);
/// S7: six staggered strips.
void build_strips(const SceneSettings& settings, SceneBuilder& out);
/// S8: two rectangles of one plane.
void build_patches(const SceneSettings& settings, SceneBuilder& out);
/// S9: a wall and two sills on it.
void build_sills(const SceneSettings& settings, SceneBuilder& out);
/// S9b: a wall and a shelf along it.
void build_robbery(const SceneSettings& settings, SceneBuilder& out);
constexpr double kInsaAngle_rad = 37 * 0.017453292519943295;
constexpr double kInsaShift_m[] = {1000, 500, 40};

// After Boulaassal 2010, chapters 4 and 5.
/// DS1: S1's building, as it was surveyed.
void build_insa_surveyed(const SceneSettings& settings, SceneBuilder& out);
/// DS2: six facades, eight arched windows.
void build_lycee(const SceneSettings& settings, SceneBuilder& out);
/// DS3: two walls with eight windows.
void build_arches(const SceneSettings& settings, SceneBuilder& out);
/// DS4: DS1 with balconies.
void build_residence(const SceneSettings& settings, SceneBuilder& out);

// After Girardeau-Montaut 2006, 2.3.3.
/// 60 x 40 m of rolling ground with two high walls and a free one, on days 1 to 4. Ids: ground 1, heap 2, pit 3,
/// back wall 4, side wall 5, free wall 6 to 10, excavator from 11 on.
void build_earthworks(const SceneSettings& settings, SceneBuilder& out);

}  // namespace jalon
