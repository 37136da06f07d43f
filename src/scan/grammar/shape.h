// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/builder/contour.h"

namespace jalon::grammar {

/// The forms of openings.
struct Shape {
  enum class Form { kFlat, kArched, kPointed, kRound, kPolygon };
  Form form = Form::kFlat;
  Rect rect{};        ///< of kPolygon unused
  double rise_m = 0;  ///< of kArched: at most half the width
  Outline corners;    ///< of kPolygon: convex, counter-clockwise

  static Shape flat(const Rect& rect) { return {Form::kFlat, rect, 0, {}}; }
  static Shape arched(const Rect& rect, double rise_m) { return {Form::kArched, rect, rise_m, {}}; }
  /// Two arcs of the width as radius about the springing points: the rect's top is their meeting.
  static Shape pointed(const Rect& rect) { return {Form::kPointed, rect, 0, {}}; }
  static Shape round(const Vec2& middle, double radius_m);
  static Shape polygon(Outline corners) { return {Form::kPolygon, {}, 0, std::move(corners)}; }
};

Contour contour_of(const Shape& shape);
/// All edges moved outward by this, inward when negative. The foot stays where it is if asked to: of doors.
Shape grown(const Shape& shape, double by_m, bool keeps_foot);
/// Whether something is left when it shrinks by this.
bool can_shrink(const Shape& shape, double by_m);
/// Level where the upright sides of the shape end: bars of windows are cut there.
double springing_of(const Shape& shape);

}  // namespace jalon::grammar
