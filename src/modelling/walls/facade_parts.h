// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/numbers.h"
#include "geometry/plane.h"
#include "model/model.h"
#include "modelling/plane/vector_plane.h"

// What method "facade" knows of a wall before it makes faces of it. All 2D coordinates are those of the wall's frame
// (PlaneFrame: u to the right, v up, seen by an eye in front of the wall).

namespace jalon {

enum class OpeningKind : uint8_t {
  kOpening,  ///< none of the others for certain
  kWindow,
  kDoor,
  kGateway,    ///< wide enough for a cart, open or with gates
  kShopFront,  ///< glazed from about the ground, wider than a door
  kVent,       ///< small, with slats or a grating
  kRecess,     ///< a wall stands back in it: a loggia, an arcade
};
inline constexpr size_t kOpeningKinds = 7;

/// What lies in an opening: shares of its box in cells of the wall's map.
struct OpeningContent {
  double joinery = 0;  ///< with points of the joinery, or on the wall's plane where none is known
  double behind = 0;   ///< with points behind that
  double empty = 1;    ///< with none
};

/// What fills a hole of a wall's face.
struct FacadeOpening {
  VectorRing outline;  ///< anticlockwise, seen as the face that fills the hole
  uint32_t piece = 0;  ///< of FacadeWall::outlines: the face whose hole it is
  /// It comes in from the lower border of the face (a door) and is no hole of it: the outline begins at its left foot.
  bool is_notch = false;
  bool ends_at_sill =
      false;  ///< its first edge is the upper edge of a sill that hides the wall there
  OpeningKind kind = OpeningKind::kOpening;
  double kind_confidence = kNaN;  ///< probability of the likeliest kind; NaN: not told yet
  OpeningContent content;
  Evidence evidence = Evidence::kNone;
  /// Of the joinery (frame, pane, leaf) behind the wall, along its normal; negative in front of it; NaN: nothing seen.
  double depth_m = kNaN;
  double depth_sigma_m = kNaN;
  uint32_t joinery_label = 0;  ///< segment the depth was measured on; 0: none
  std::vector<uint32_t>
      standing_labels;  ///< segments in it before the joinery: parapets, mullions, surrounds
  /// Share of the outline's length, less that at a sill, along which points of the wall end and nothing in front hides
  /// the opening: 1 = seen all round, 0 = its place is a guess.
  double coverage = 0;
  /// Root mean square distance of border_points to the outline, less the wall's set-back; NaN without such points.
  double residual_m = kNaN;
  /// Points of the wall next to the opening where coverage holds: what its outline was drawn from.
  std::vector<Vec2> border_points;
  int32_t copied_from =
      -1;  ///< index in FacadeWall::openings of the opening it repeats; -1: measured itself
};

/// A stretch of the wall that no station saw.
struct FacadeShadow {
  VectorRing outline;  ///< anticlockwise
  uint32_t piece = 0;
  bool is_notch = false;  ///< it came in from the lower border
  bool is_filled =
      false;  ///< the wall is closed over it; else it is a hole of its face, or a notch
};

/// Where points prove what: one byte a cell.
enum class WallCell : uint8_t {
  kUnknown = 0,  ///< no point and no ray
  kSolid = 1,    ///< points of the wall
  kThrough = 2,  ///< seen through: rays passed, or points lie behind
  kHidden = 3,   ///< something in front hides it
};

/// Cells of the wall's plane from origin on, row by row.
struct WallMap {
  Vec2 origin;
  double cell_m = 1;
  uint32_t columns = 0, rows = 0;
  std::vector<WallCell> cells;

  /// kUnknown outside.
  WallCell at(const Vec2& p) const {
    const double c = (p.u - origin.u) / cell_m, r = (p.v - origin.v) / cell_m;
    if (!(c >= 0 && r >= 0 && c < columns && r < rows)) return WallCell::kUnknown;
    return cells[static_cast<size_t>(r) * columns + static_cast<size_t>(c)];
  }
};

/// One wall plane of a facade: the large faces of one segment.
struct FacadeWall {
  uint32_t label = 0;  ///< of the segment
  PlaneFrame frame;
  double spacing_m = 0;
  double sigma_m = 0;                   ///< of its points from its plane
  std::array<double, 16> covariance{};  ///< of normal and offset
  std::vector<VectorRing> outlines;     ///< of its faces, anticlockwise
  std::vector<FacadeOpening> openings;
  std::vector<FacadeShadow> shadows;
  WallMap map;
};

}  // namespace jalon
