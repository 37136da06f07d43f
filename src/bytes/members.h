// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "base/shared_text.h"
#include "cloud/cloud.h"
#include "geometry/cylinder.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/vec.h"
#include "model/model.h"

/// The members of plain structs in the order in which they are written: said once, for ByteWriter and ByteReader. The
/// structs of results have theirs in the file that writes them. A change here is a new layout (bytes/envelope.h).
namespace jalon {

/// T, const or not.
template <class U, class T>
concept Maybe = std::same_as<std::remove_const_t<U>, T>;

template <Maybe<Vec3> T>
auto members(T& v) {
  return std::tie(v.x, v.y, v.z);
}
template <Maybe<Transform> T>
auto members(T& t) {
  return std::tie(t.m);
}
template <Maybe<Plane> T>
auto members(T& p) {
  return std::tie(p.normal, p.offset);
}
template <Maybe<PlaneFit> T>
auto members(T& f) {
  return std::tie(f.plane, f.centroid, f.axis_u, f.axis_v, f.eigenvalues, f.n, f.sigma,
                  f.local_covariance, f.covariance);
}
template <Maybe<SphereFit> T>
auto members(T& f) {
  return std::tie(f.sphere.centre, f.sphere.radius, f.n, f.sigma, f.covariance);
}
template <Maybe<CylinderFit> T>
auto members(T& f) {
  return std::tie(f.cylinder.point, f.cylinder.direction, f.cylinder.radius, f.length_m, f.n,
                  f.sigma, f.covariance);
}
template <Maybe<Station> T>
auto members(T& s) {
  return std::tie(s.name, s.has_pose, s.pose, s.first, s.count);
}
template <Maybe<Ring> T>
auto members(T& r) {
  return std::tie(r.first, r.count, r.part);
}
template <Maybe<Face> T>
auto members(T& f) {
  return std::tie(f.part, f.first_ring, f.ring_count, f.id, f.face_class, f.plane, f.area_m2,
                  f.sigma_m, f.covariance);
}
template <Maybe<Part> T>
auto members(T& p) {
  return std::tie(p.name, p.part_class, p.parent, p.width_m, p.height_m, p.depth_m, p.copied_from,
                  p.level_of_detail, p.evidence, p.class_confidence);
}
template <Maybe<Solid> T>
auto members(T& s) {
  return std::tie(s.part, s.first_face, s.face_count);
}

/// Written as it lies in memory: numbers, and arrays of them.
template <class T>
inline constexpr bool kIsFlat =
    (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_same_v<T, std::byte>;
template <class T, size_t N>
inline constexpr bool kIsFlat<std::array<T, N>> = kIsFlat<T>;
template <>
inline constexpr bool kIsFlat<Vec3> = sizeof(Vec3) == 3 * sizeof(double);

template <class T>
constexpr bool kIsText = std::is_same_v<T, std::string> || std::is_same_v<T, SharedText>;

/// The fewest bytes that a value takes: how many can there be in what is left?
template <class T>
constexpr size_t least_bytes();

template <class... T>
constexpr size_t least_bytes_of(std::type_identity<std::tuple<T&...>>) {
  return (least_bytes<T>() + ... + 0);
}

template <class T>
constexpr size_t least_bytes() {
  if constexpr (kIsFlat<T> || std::is_enum_v<T> || std::is_same_v<T, bool>) return sizeof(T);
  else if constexpr (kIsText<T>) return sizeof(uint64_t);
  else return least_bytes_of(std::type_identity<decltype(members(std::declval<T&>()))>{});
}

}  // namespace jalon
