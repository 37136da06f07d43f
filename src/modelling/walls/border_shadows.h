// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/contour/contour.h"
#include "modelling/evidence/wall_cells.h"
#include "modelling/walls/facade_parts.h"

namespace jalon {

/// What nobody measured of a wall beside its faces, at their borders: cells within the wall's border (wall above them,
/// and no lower than its foot) that show nothing or something before the wall, less the faces with all that lies within
/// their outlines, less openings beside them and shadows. So no area counts twice. What was seen through is no wall,
/// and not told.
/// Before: the plane's faces, the wall's openings and shadows are as they will be drawn. setting: what is small is left
/// out, as holes are.
std::vector<FacadeShadow> border_shadows(const VectorPlane& plane, const FacadeWall& wall,
                                         const WallCells& cells, const ContourSetting& setting,
                                         Task& task);

}  // namespace jalon
