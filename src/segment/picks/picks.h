// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"

namespace jalon {

/// Parameter table of operation "pick".
std::span<const ParamRow> pick_rows();

/// A segmentation of the cloud without segments, to pick from.
Segmentation empty_segmentation(const CloudPtr& cloud, Task& task);

/// The segmentation with one segment more, grown from picks among the points of label 0 (Boulaassal 2010, 5.5.2). Of a
/// plane: 1 pick is a seed, 3 and more bound it. Sphere: 2 picks with normals of the points around, or 4 and more.
/// Cylinder: 2 picks with normals, or 3 and more of a vertical one.
Segmentation with_pick(const Segmentation& before, PrimitiveType type, std::span<const Vec3> picks, const ParamSet& params,
                       Task& task);

/// The points of label 0, with their fields.
Cloud remaining_points(const Segmentation& segmentation, Task& task);

/// The parameter file of Boulaassal 2010, 5.5.2: a row a segment, its type code first; plane: normal, offset; sphere: centre,
/// radius; cylinder: axis point, direction, radius.
std::string primitive_text(const Segmentation& segmentation);

}  // namespace jalon
