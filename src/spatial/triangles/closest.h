// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The point of a triangle that is closest to a point, for one triangle (V = double) or for four at a time (V = a vector
// of doubles) by the same operations in the same order, so that both give the same bits. It is compiled once an
// instruction set; everything is in an unnamed namespace, so that the linker cannot mix them.

namespace jalon {
namespace {

// Of the thinnest triangle that has a plane, height over longest side, squared. The normal of a thinner one is rounding
// and no more; its three sides stand for it.
constexpr double kFlattest2 = 0x1p-100;

template <class V>
struct Vector {
  V x, y, z;
};
template <class V>
[[gnu::always_inline]] inline Vector<V> minus(const Vector<V>& a, const Vector<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
[[gnu::always_inline]] inline V scalar(const Vector<V>& a, const Vector<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
[[gnu::always_inline]] inline Vector<V> normal_to(const Vector<V>& a, const Vector<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class M, class V>
[[gnu::always_inline]] inline Vector<V> choose(const M& mask, const Vector<V>& yes,
                                               const Vector<V>& no) {
  return {mask ? yes.x : no.x, mask ? yes.y : no.y, mask ? yes.z : no.z};
}

/// From the closest point of a side to the point, squared; and where on the side it is.
template <class V>
struct SideResult {
  Vector<V> rest;
  V squared;
  V length2;
  decltype(V{} > V{}) at_from, at_to;  ///< it is that corner
};

/// to_from, to_to: from either corner to the point.
template <class V>
[[gnu::always_inline]] inline SideResult<V> closest_on_side(const Vector<V>& side,
                                                            const Vector<V>& to_from,
                                                            const Vector<V>& to_to) {
  SideResult<V> out;
  const V along = scalar(to_from, side);
  out.length2 = scalar(side, side);
  out.at_from = along <= V{};
  out.at_to = along >= out.length2;  // with at_from too: a side without length
  const V t = along / out.length2;
  const Vector<V> between = {to_from.x - t * side.x, to_from.y - t * side.y,
                             to_from.z - t * side.z};
  out.rest = choose(out.at_from, to_from, choose(out.at_to, to_to, between));
  out.squared = scalar(out.rest, out.rest);
  return out;
}

template <class V>
struct ClosestResult {
  V squared;
  Vector<V> rest;    ///< from the closest point of the nearest side to the point
  Vector<V> normal;  ///< of the corners in their order, not normalised
  V height;          ///< of the point above the plane, times the normal's length
  V normal2;
  decltype(V{} >
           V{}) on_face;  ///< it lies inside; else it is the closest point of the nearest side
  decltype(V{} > V{}) use_ab, use_ac;  ///< the nearest side; neither: bc
  SideResult<V> ab, ac, bc;
};

/// Ericson 2005, Real-Time Collision Detection 5.1.5, by regions. A point beside the face has one of the three sides as
/// its closest; one above the face the plane. Two things keep the digits of slivers, whose normal is uncertain across
/// them: the height is counted from the closest point of the nearest side, which is then no corner; and that point is
/// no farther from the foot than the triangle's least height. Corners must come in one order whatever triangle they
/// belong to: then triangles that share a side or a corner find the same distance to it, bit by bit.
template <class V>
[[gnu::always_inline]] inline ClosestResult<V> closest_on_triangle(const Vector<V>& p,
                                                                   const Vector<V>& a,
                                                                   const Vector<V>& b,
                                                                   const Vector<V>& c) {
  ClosestResult<V> out;
  const Vector<V> ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
  const Vector<V> ap = minus(p, a), bp = minus(p, b), cp = minus(p, c);
  // 1. The three sides, and the nearest of them.
  out.ab = closest_on_side(ab, ap, bp);
  out.ac = closest_on_side(ac, ap, cp);
  out.bc = closest_on_side(bc, bp, cp);
  const auto ac_wins = out.ac.squared < out.ab.squared;
  const V first2 = ac_wins ? out.ac.squared : out.ab.squared;
  const auto bc_wins = out.bc.squared < first2;
  const V nearest2 = bc_wins ? out.bc.squared : first2;
  out.use_ab = (out.ab.squared <= out.ac.squared) & (out.ab.squared <= out.bc.squared);
  out.use_ac = ac_wins & (out.ac.squared <= out.bc.squared);
  out.rest = choose(bc_wins, out.bc.rest, choose(ac_wins, out.ac.rest, out.ab.rest));
  const auto at_corner =
      bc_wins ? out.bc.at_from | out.bc.at_to
              : (ac_wins ? out.ac.at_from | out.ac.at_to : out.ab.at_from | out.ab.at_to);
  // 2. The plane, for a point above the face.
  out.normal = normal_to(ab, ac);
  out.normal2 = scalar(out.normal, out.normal);
  V longest2 = out.ab.length2 > out.ac.length2 ? out.ab.length2 : out.ac.length2;
  longest2 = longest2 > out.bc.length2 ? longest2 : out.bc.length2;
  out.height = scalar(out.normal, out.rest);
  const V above2 = out.height * out.height / out.normal2,
          least2 = nearest2 - out.normal2 / longest2;
  const V face2 = above2 > least2 ? above2 : least2;
  out.on_face = (out.normal2 > longest2 * longest2 * kFlattest2) &
                (scalar(normal_to(ab, ap), out.normal) > V{}) &
                (scalar(normal_to(bc, bp), out.normal) > V{}) &
                (scalar(normal_to(ac, cp), out.normal) < V{}) & (face2 < nearest2) & ~at_corner;
  out.squared = out.on_face ? face2 : nearest2;
  return out;
}

}  // namespace
}  // namespace jalon
