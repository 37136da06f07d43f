// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/model.h"

// Facades as elevations show them: which faces belong to one, its front, what is seen from there.
namespace jalon {

constexpr uint32_t kNoFacade = ~uint32_t{0};
constexpr double kUpright = 0.5;    // |z| of the normal of what may be the front of a facade
constexpr double kFacadeGap_m = 2;  // between two elevations side by side

/// Seen from the front: x to the right, y up, towards the viewer.
struct FrontView {
  Vec3 origin, right, towards;
  Vec3 flat(const Vec3& p) const { return {dot(p - origin, right), p.z, 0}; }
  double depth_m(const Vec3& p) const { return dot(p - origin, towards); }
};

/// The facade that a part stands in: itself or its nearest ancestor of that class; kNoFacade for none.
uint32_t facade_of(const Model& model, uint32_t part);

/// Faces by facade; those of none last (kNoFacade). Ground, roof and the like belong to the only facade.
std::map<uint32_t, std::vector<uint32_t>> faces_by_facade(const Model& model);

/// The front of a facade: its largest upright face, of class wall where there is one; none where nothing is upright.
std::optional<FrontView> front_of(const Model& model, const std::vector<uint32_t>& faces);

/// A facade that has a front, on the sheet of an elevation.
struct PlacedFacade {
  uint32_t facade = kNoFacade;
  std::vector<uint32_t> faces;  ///< that belong to it
  std::vector<uint32_t> shown;  ///< of these: neither edge-on nor the far side of a solid
  FrontView view;
  double shift_m = 0;              ///< x on the sheet less x of the view
  double left_m = 0, right_m = 0;  ///< of the shown faces, on the sheet
  double bottom_m = 0, top_m = 0;  ///< their heights

  /// On the sheet: x, the height, the depth before the front (m).
  Vec3 on_sheet(const Vec3& p) const { return view.flat(p) + Vec3{shift_m, 0, view.depth_m(p)}; }
  Vec3 in_space(const Vec3& q) const {
    Vec3 p = view.origin + view.right * (q.x - shift_m) + view.towards * q.z;
    p.z = q.y;
    return p;
  }
};

/// Side by side from x = 0, kFacadeGap_m apart; those without a shown face are left out.
std::vector<PlacedFacade> facades_side_by_side(const Model& model);

/// The order in which what lies at these depths (m, towards the viewer) is drawn: what lies in front last, so that
/// joinery does not hide the opening before it. Rounding must not shuffle what lies in one plane: the lines of a plane
/// have its step together, and the front wall lies in the middle of one.
std::vector<size_t> order_of_drawing(const std::vector<double>& depths_m);

}  // namespace jalon
