// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace jalon {

/// An upright polygon of a building.
struct VerticalPiece {
  uint32_t building = 0,
           face = kNoFace;  ///< face: of the model; kNoFace: a triangle of a bare mesh
  Vec3 normal;              ///< level, as the input has it
  std::vector<Vec3> corners;
};
/// A face of the model that is not upright: roofs, ground.
struct OtherFace {
  uint32_t face = 0, building = kNoPart;  ///< kNoPart: of no building that has upright faces
};
struct VerticalPieces {
  std::vector<VerticalPiece> pieces;
  std::vector<OtherFace> others;
  std::vector<std::string> buildings;
};
/// Those within tilt_rad of the vertical. A face's or triangle's building is the highest part above it
/// of class "building"; in a model without such parts, what hangs together by corners (1 mm).
VerticalPieces vertical_pieces(const Model& model, double tilt_rad);

}  // namespace jalon
