// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "modelling/edges/adjust/edge_density.h"

namespace jalon {

/// The surface that meets a plane at its edge (a reveal, the side of a post), as a line across the edge: at height h in
/// front of the plane it lies offset + slope h inside the edge.
struct Reveal {
  double offset_m = 0, slope = 0;
  double common_m2 = 0;             ///< variance of the offset that all places along the edge share
  double per_metre2 = 0;            ///< points a metre of edge and metre of height
  std::vector<EdgeOffset> offsets;  ///< along the edge
};

struct RevealSetting {
  double length_m = 1;  ///< of the edge
  double spacing_m = 0.01;
  double sigma_m = 0.003;  ///< noise of the points across the plane
};

/// Looks for a surface in the points beside an edge, all on one side of its plane: the most points
/// near one line across the edge (random draws, then least squares), in front of what fills the
/// opening, spread along the edge and in height, and more of them than a cloud without that surface
/// would put there. Nothing when there is none.
///
/// After: the slope is at most 31 degrees; offsets in ascending t, one a bin with points. The draws
/// depend on the points' order only.
std::optional<Reveal> find_reveal(std::span<const RevealPoint> points,
                                  const RevealSetting& setting);

}  // namespace jalon
