// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/field.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "compare/volumes/volume_grid.h"
#include "model/model.h"

namespace jalon {

/// Volumes between two states and what they are made of; columns as told in jalon/volumes.h.
struct Volume {
  FieldTable summary;  ///< one row
  FieldTable cells;    ///< one row a cell that either state has data in
};

/// Parameter table of operation "volume".
std::span<const ParamRow> volume_rows();
/// Between two clouds, by cells across a direction (Girardeau-Montaut 2006, 5.2).
Volume volume_between(const Cloud& reference, const Cloud& compared, const ParamSet& params, Task& task);
/// Between two models: that of two closed surfaces by the divergence theorem, else by prisms along the direction.
Volume volume_between(const Model& reference, const Model& compared, const ParamSet& params, Task& task);

/// Sums up two states on one grid.
Volume sum_up_volume(const VolumeGrid& grid, const CellHeights& reference, const CellHeights& compared,
                     const ParamSet& params, Task& task);

}  // namespace jalon
