// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/corrections.h"

namespace jalon {

Trajectory corrected(const Trajectory& trajectory, const Corrections& corrections) {
  Trajectory out = trajectory;
  TimePlace at;
  for (size_t i = 0; i < out.size(); ++i) {
    at = time_place(corrections.times_s, out.times_s[i], i, at.epoch);
    const Vec2 by = corrections.at(at);
    out.positions[i] += Vec3{by.u, by.v, 0};
  }
  return out;
}

}  // namespace jalon
