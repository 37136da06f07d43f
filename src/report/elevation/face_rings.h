// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/model.h"
#include "modelling/plane/plane_frame.h"
#include "report/elevation/opening_list.h"

namespace jalon {

/// Chords of arcs stay this near to them where areas and boxes are computed; drawings have the arcs themselves.
constexpr double kChordError_m = 0.001;

/// Upright box in the plane of a face: u to the right for an eye in front of it, v up.
struct FaceBox {
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
  void add(const Vec2& p) {
    left = std::min(left, p.u);
    right = std::max(right, p.u);
    low = std::min(low, p.v);
    high = std::max(high, p.v);
  }
  FaceBox& operator+=(const FaceBox& b) {
    left = std::min(left, b.left);
    right = std::max(right, b.right);
    low = std::min(low, b.low);
    high = std::max(high, b.high);
    return *this;
  }
  double width() const { return right - left; }
  double height() const { return high - low; }
};

bool has_arc(const Model& model, const Ring& ring);
/// The drawing frame of a face, its origin a whole metre near its first corner.
PlaneFrame frame_of(const Model& model, const Face& face);
/// Corners of a ring in that frame, arcs as chords.
std::vector<Vec2> ring_polygon(const Model& model, const Ring& ring, const PlaneFrame& frame);
FaceBox ring_box(const Model& model, const FaceRing& at);

}  // namespace jalon
