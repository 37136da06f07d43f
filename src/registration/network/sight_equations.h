// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "registration/network/network_settings.h"
#include "registration/network/survey.h"

namespace jalon {

/// What a sight measures.
enum class SightKind : uint8_t { kDirection = 1, kZenith = 2, kDistance = 3 };

/// What a sight from I to T would measure, and by how much each coordinate of T changes it; I does the opposite.
struct SightEquation {
  double value = 0;  ///< azimuth clockwise from north (y), zenith angle, or distance in the field
  Vec3 by_target;
};

/// instrument, target: where the axes cross and what is sighted, in the map. A sight that refraction bends (k) over an
/// Earth of radius R seems to end (1 - k) s^2 / 2R below the map's plane (Torge & Mueller 2012, 5.1.3); lengths are
/// those of the map over the scale.
SightEquation sight_equation(SightKind kind, const Vec3& instrument, const Vec3& target,
                             const NetworkSettings& settings);

/// v less whole turns: in [-pi, pi].
double within_half_turn(double v_rad);

}  // namespace jalon
