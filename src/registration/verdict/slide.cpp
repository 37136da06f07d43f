// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/slide.h"

#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

// Reaches that the pose is moved by to see whether it holds, beyond what both clouds' planes are blurred by, and by how
// many standard deviations of the difference of two shares they must agree less there. Neighbouring surfels say the
// same thing, so that deviations of independent ones are too small by half; where nothing holds a pose both sides are
// lower together by chance one time in some thousand at the nearest places, and never at the farthest.
struct SlidOff {
  double reaches, deviations;
};
constexpr SlidOff kSlidOff[] = {{4, 2}, {8, 3}, {16, 5}};
constexpr double kClearly = 6;
constexpr double kJeffreys = 0.5;  // of either answer (Jeffreys): no share is known without doubt
constexpr size_t kSlideEvery = 4;  // of the surfels, to look for better places
constexpr double kSlideStep = 4;   // reaches from place to place
constexpr double kPlacesEachWay = 64;  // each way

// How much of what both clouds could see they have in common.
struct Common {
  double agreeing = kJeffreys, answers = 2 * kJeffreys;

  void add(const Agreement& a) {
    agreeing += static_cast<double>(a.explained);
    answers += static_cast<double>(a.judged);
  }
  double share() const { return agreeing / answers; }
  double variance() const { return share() * (1 - share()) / answers; }
};

// The difference of two shares, in its standard deviations.
double deviations_between(const Common& more, const Common& less) {
  return (more.share() - less.share()) / std::sqrt(more.variance() + less.variance());
}

}  // namespace

Slide slide_along(const JudgedCloud& reference, const JudgedCloud& moving,
                  const Transform& T_reference_moving, const SlideWay& along, double farthest_m,
                  Task& task) {
  const auto common_at = [&](double slid_m, size_t every) {
    const Transform T = motion_about(along.centre, along.turn_rad * slid_m, along.way * slid_m) *
                        T_reference_moving;
    Common out;
    out.add(agreement_of(moving, reference, T, task, every));
    out.add(agreement_of(reference, moving, inverse(T), task, every));
    return out;
  };
  const double reach_m = reach_of(reference, moving);
  Slide out;
  // 1. Whether it holds where it is.
  const Common here = common_at(0, 1);
  out.is_fixed = std::ranges::all_of(kSlidOff, [&](const SlidOff& off) {
    return deviations_between(here, common_at(off.reaches * reach_m, 1)) > off.deviations &&
           deviations_between(here, common_at(-off.reaches * reach_m, 1)) > off.deviations;
  });
  // 2. Whether it would be better elsewhere: the best place by few surfels, then by all.
  Common best = common_at(0, kSlideEvery);
  const double least_answers = best.answers / 2;  // what hardly meets agrees by chance
  double best_m = 0;
  const double step_m = std::max(kSlideStep * reach_m, farthest_m / kPlacesEachWay);
  for (double slid_m = step_m; slid_m <= farthest_m; slid_m += step_m) {
    for (const double at_m : {slid_m, -slid_m}) {
      const Common there = common_at(at_m, kSlideEvery);
      if (there.answers < least_answers || there.share() <= best.share()) continue;
      best = there;
      best_m = at_m;
    }
  }
  if (best_m != 0 && deviations_between(common_at(best_m, 1), here) > kClearly)
    out.better_m = best_m;
  return out;
}

}  // namespace jalon
