// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.h"

namespace jalon {

bool has_arcs(const Model& model);

/// The same model with chords at most chord_error_m from its arcs, for formats that know no arcs. The new vertices
/// stand behind the old ones; rings, faces, parts and solids keep their numbers; arcs that several rings run along get
/// the same vertices, so that what was closed stays closed. area_m2 stays that of the arcs. O(n log n).
Model with_chords(const Model& model, double chord_error_m);

/// Points on the arc from a to b in the plane of this normal, without both ends; none when it is straight.
std::vector<Vec3> arc_points(const Vec3& a, const Vec3& b, double sagitta_m, const Vec3& normal,
                             double chord_error_m);

/// The face's stated normal, or that of its outline by Newell's sums where none is stated; a unit vector, or zero for
/// a face without extent.
Vec3 normal_of(const Model& model, const Face& face);

}  // namespace jalon
