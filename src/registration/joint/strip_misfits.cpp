// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_misfits.h"

#include "base/distributions.h"

namespace jalon {

double strip_misfit_m(const StripCondition& strip, const JointPlaces& places,
                      const Vec3& attitude_rad) {
  double sum = strip.distance_m + dot(strip.normal, places.model.blocks[strip.block]) +
               places.model.facades[strip.facade];
  for (const auto& [control, share] : strip.shares)
    sum -= share * dot(strip.normal, places.trajectory[control]);
  for (size_t k = 0; k < 3; ++k) sum += strip.turns_m[k] * attitude_rad[static_cast<int>(k)];
  return sum;
}

double rare_deviations(size_t strips) {
  constexpr double kRare = 0.05;
  return normal_quantile(1 - kRare / 2 / static_cast<double>(strips));
}

}  // namespace jalon
