// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/facade/plan.h"

namespace jalon {

/// How walls are drawn.
struct AssemblySetting {
  bool solids = false;
  bool walls_only = false;  ///< no panes, no elements: method "extrusion"
  double thickness_m =
      0;  ///< of solids; 0: the median depth of the facade's openings, or of all facades'
};

/// Faces, vertices and the tree of parts from a plan: [building ->] facade -> wall -> opening
/// (window, door) -> reveal, joinery; no_data under its wall; elements under their facade. The
/// building stands above when there are several facades. Names: class and number; openings by row
/// from below and place from the left ("window 2.3"), other parts from left to right and from
/// below.
///
/// Walls as solids: each face of a wall stands before a second one thickness_m behind it, and sides
/// join both all round and in each opening (Boulaassal 2010, 4.4.2); these reveals take the place of those that end at
/// the panes. Arcs become chords within kRevealChord_m then, for the faces of a solid to meet in
/// their edges.
///
/// After: every face is under a part and every part but the topmost under another; corners that
/// faces share are one vertex.
Model assemble_facades(const Segmentation& segmentation, FacadePlan plan,
                       const AssemblySetting& setting, Task& task);

}  // namespace jalon
