// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

#include "registration/icp/clouds.h"

namespace jalon {

namespace {

Transform shift_by(const Vec3& v) {
  Transform out;
  for (int i = 0; i < 3; ++i) out.m[static_cast<size_t>(4 * i + 3)] = v[i];
  return out;
}

}  // namespace

Transform IcpClouds::to_local(const Transform& T_reference_moving_world) const {
  const Transform& pose = T_reference_moving_world;
  const Vec3 to = reference.tree->cube().origin, from = moving.tree->cube().origin;
  // In this order the large numbers meet before they are rounded.
  Transform T_reference_moving = pose;
  const Vec3 t = (from - to) + (pose.direction(from) - from + pose.translation());
  for (int i = 0; i < 3; ++i) T_reference_moving.m[static_cast<size_t>(4 * i + 3)] = t[i];
  return T_reference_moving;
}

Transform IcpClouds::to_world(const Transform& T_reference_moving) const {
  const Transform T_world_reference = shift_by(reference.tree->cube().origin);
  const Transform T_moving_world = shift_by(-moving.tree->cube().origin);
  return T_world_reference * T_reference_moving * T_moving_world;
}

}  // namespace jalon
