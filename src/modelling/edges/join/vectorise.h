// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/contour/contour.h"
#include "modelling/edges/join/vectorise_setting.h"
#include "modelling/plane/vector_plane.h"
#include "segment/segmentation.h"

namespace jalon {

/// Draws the contour of segment `segment` in place of extract_contour: same points, setting and tests.
using ContourMaker =
    std::function<Contour(size_t segment, std::span<const Vec2> points,
                          const ContourSetting& setting, const ForeignTest& foreign, Task& task)>;

/// 2D vector models of the planar segments (Boulaassal 2010, 4.2-4.3): out[s] of segments[s],
/// without faces where that is no plane or has too few points. Legend: plane/plane_frame.h.
///
/// After: faces are simple polygons with their openings inside and apart, the largest first. The
/// same bits for any number of threads. Time follows the points and the length of the contours:
/// O(n) + 2 us a contour point.
std::vector<VectorPlane> vectorise(const Segmentation& segmentation,
                                   const VectoriseSetting& setting, Task& task,
                                   const ContourMaker& make_contour = {});

}  // namespace jalon
