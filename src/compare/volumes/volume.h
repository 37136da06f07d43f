// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

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

struct VolumeSettings {
  enum class Surfaces { kAutomatic, kClosed, kPrisms };
  std::vector<double> direction = {0, 0, 1};  ///< along which heights are counted
  double cell_m = 0;                          ///< 0: by the spacing, or the models' extent
  CellValue cell_value = CellValue::kMean;    ///< of clouds
  double dead_band_m = 0;                     ///< up to it a cell is neither cut nor filled
  Surfaces surfaces = Surfaces::kAutomatic;   ///< of models
};
/// Parameter table of operation "volume".
std::span<const ParamRow> volume_rows();
/// Between two clouds, by cells across a direction (Girardeau-Montaut 2006, 5.2).
Volume volume_between(const Cloud& reference, const Cloud& compared, const VolumeSettings& settings,
                      Task& task);
/// Between two models: that of two closed surfaces by the divergence theorem, else by prisms along the direction.
Volume volume_between(const Model& reference, const Model& compared, const VolumeSettings& settings,
                      Task& task);

/// Sums up two states on one grid; see VolumeSettings for the dead band.
Volume sum_up_volume(const VolumeGrid& grid, const CellHeights& reference,
                     const CellHeights& compared, double dead_band_m, Task& task);

}  // namespace jalon
