// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

/// The same measure on both sides of a wall: before it along its normal, and behind it.
struct BothSides {
  double before = 0, behind = 0;
};

/// What tells from which side a wall was seen, in m2.
struct FrontEvidence {
  BothSides filling;  ///< cells without the wall that hold something within a metre: panes, reveals
  BothSides hung;     ///< cells of the wall that do: sills, cornices, balconies, people
  BothSides ground;   ///< level surfaces at its foot
  BothSides reach;    ///< whatever lies more than a metre away
  BothSides blocked;  ///< of a viewer on that side: what beams through the wall alone would meet
};

}  // namespace jalon
