// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "registration/verdict/sight_map.h"
#include "registration/verdict/surface_sample.h"

namespace jalon {

/// A cloud as the verdict looks at it.
struct JudgedCloud {
  const SurfacePlanes* surface = nullptr;
  std::vector<Surfel> surfels;
  std::vector<SightMap> sights;  ///< empty: nobody knows where the cloud was taken from
  /// Of the residuals at the pose, robust: what the two clouds differ by beyond the noise of either, as of beams that
  /// are not quite in line, or of a scanner that moved.
  double misfit_m = 0;
  bool are_told = false;  ///< the stations by the cloud; found ones may lie behind what they saw
};

/// Surfels and what the stations saw. The stations are those of the cloud that have a pose. A cloud without any may
/// be of one station, which is then found by the density of its points and believed when it could have seen all but a
/// few of them.
///
/// is_of_lines: of a spinning head. How dense its points lie tells where they were taken from along a line alone: no
/// station is looked for.
///
/// thinned_index: where the surface is of a thinned cloud, of each of its points one of the raw ones; empty: it is of
/// the raw cloud. The surface outlives the result.
JudgedCloud judged_cloud(const Cloud& raw, const SurfacePlanes& surface,
                         std::span<const uint32_t> thinned_index, Task& task,
                         bool is_of_lines = false);

}  // namespace jalon
