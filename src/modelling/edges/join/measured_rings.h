// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "modelling/contour/contour.h"
#include "modelling/edges/find/edge_line.h"
#include "modelling/plane/near_points.h"
#include "modelling/edges/join/vectorise_setting.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// What the rings of a plane are drawn from.
struct RingSource {
  const Contour& contour;
  double sigma_m = 0;  ///< of the plane's points across it
  /// The points of the cloud near these rings (polylines in the plane).
  std::function<NearPoints(std::span<const std::vector<Vec2>>, const NearSetting&)> near;
  /// Lines in which other planes meet this one.
  std::function<std::vector<EdgeLine>()> joints;
};

/// Rings with straight edges, arcs and nodes at their measured places (Boulaassal 2010, 4.3),
/// one a contour chain: of each piece its outline, then its openings.
/// 1. Straight and curved parts of each chain, as provisional edges.
/// 2. The points about them.
/// 3. Each edge moved to where the density of points begins and its reveals say, twice.
/// 4. Round heads touch their jambs.
/// 5. Nodes.
///
/// After: as many rings as chains, in their order. Each runs the way its chain does, does not cross
/// itself and encloses its chain's area, give or take the distance of contour points from the true
/// edge; one that cannot be drawn so is empty.
std::vector<VectorRing> measured_rings(const RingSource& source, const VectoriseSetting& setting,
                                       Task& task);

}  // namespace jalon
