// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/joint/joint_settings.h"
#include "registration/joint/ray_matching.h"

namespace jalon {

/// What each match counts: 0 unless it is accepted; with the kernel "tukey" less the farther the point stands from
/// the median of its strip's points (Beaton & Tukey 1974), in units of their scatter, the median absolute deviation,
/// and 0 from 4.685 of them on. A strip keeps half of its points and more: what stands before it does not pull it.
std::vector<double> strip_weights(const JointPoints& points, const StripScene& scene,
                                  const std::vector<PointMatch>& matches,
                                  const JointSettings& settings);

}  // namespace jalon
