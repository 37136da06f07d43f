// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/builder/builder.h"

// What stands between the scanner and a facade; places are those of the foot.

namespace jalon {

/// A closed box, 1.8 m wide and 1.5 m high, its corner of least coordinates here, its length along X.
void add_car(SceneBuilder& out, uint32_t parent, const Vec3& corner, double length_m);
/// A straight flight of 16 steel treads along X on two rows of posts, open between them.
void add_stair(SceneBuilder& out, uint32_t parent, const Vec3& corner);
/// A ball of loose leaves that stops this share of a beam through its middle.
void add_crown(SceneBuilder& out, uint32_t parent, const Vec3& middle, double radius_m,
               double opacity, const RandomStream& random);
/// The same on a trunk.
void add_tree(SceneBuilder& out, uint32_t parent, const Vec3& crown_middle, double crown_radius_m,
              double opacity, const RandomStream& random);
/// 1.75 m tall: a round body and a head.
void add_pedestrian(SceneBuilder& out, uint32_t parent, const Vec3& foot);

}  // namespace jalon
