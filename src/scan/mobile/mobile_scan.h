// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "scan/mobile/georeference.h"

namespace jalon {

/// The settings of scanner method "mobile". One beam (a plane scanner: theta turns, phi is a right
/// angle) or a fan of them (a rotating multi-beam head).
struct MobileSettings {
  GeoreferenceSettings mount{};
  double revolutions_per_s = 100;
  int64_t pulses = 1000;  ///< a revolution and beam
  int64_t beams = 1;
  double fan_rad = 0.4;
  double min_range_m = 0.5, max_range_m = 150;
  double noise_range_m = 0, noise_angle_rad = 0;
  uint64_t seed = 1;
};
std::span<const ParamRow> mobile_scanner_rows();

/// Drives along the trajectory and sends every pulse from where the vehicle then is; the nearest
/// triangle within range returns it. Range and angles get their noise before the point is made of
/// them, so that "true_xyz" is where the beam ended and the point is what a user has.
/// Fields beside those of georeferenced(): "range" (float64, m), "theta", "phi" (float64, rad), "face"
/// (uint32: the id of the face hit), "block", "facade", "strip" (uint32: the n-th part of that class
/// above the face, UINT32_MAX where there is none), "true_xyz" (float64 x 3, m).
Cloud scan_mobile(const Model& model, const Trajectory& trajectory, const MobileSettings& settings,
                  Task& task);

}  // namespace jalon
