// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/triangles/local_mesh.h"
#include "segment/triangles/scan_grid.h"

namespace jalon {

/// The triangles of a scanner's grid: four neighbours make two, divided by the shorter diagonal, three make one; none
/// has an edge longer than the search distance. Neighbours are known, so there is no search and nothing is projected.
/// Of the rule's numbers k tells the window that roughness is of, as many places at most; stars have no say. With
/// search_m = 0 an edge is as long as three times the least spacing at its triangle's corners: there a point's spacing
/// is the median of the distances to its eight neighbours, of which one side of a straight edge has five.
LocalMesh grid_mesh(const Octree& tree, std::span<const ScanGrid> grids, const MeshRule& rule,
                    Task& task);

}  // namespace jalon
