// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/motion_features.h"

#include <algorithm>
#include <cmath>

#include "compare/changes/object_motion.h"

namespace jalon {

namespace {

constexpr double kLeastLength_m = 1e-9;

double ratio(size_t part, size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

// Of few points nothing is sure: as if so many more had been asked, of which a quarter was not explained.
constexpr double kUnsurePoints = 20, kUnsureShare = 0.25;

double unexplained_log(const LaidOn& laid) {
  const auto off = static_cast<double>(laid.all - laid.on), all = static_cast<double>(laid.all);
  return std::log((off + kUnsureShare * kUnsurePoints) / (all + kUnsurePoints));
}

double size_of(const ObjectMotionJob& job, const ChangedObject& object) {
  Box3 before, after;
  for (const uint32_t i : object.before) before.add(job.before.local(i));
  for (const uint32_t i : object.after) after.add(job.after.local(i));
  double size = 0;
  for (const Box3& box : {before, after})
    if (!box.empty()) size = std::max(size, norm(box.max - box.min));
  return size;
}

double like_extents(const ObjectMotionJob& job, const ChangedObject& object) {
  const Extents before = extents_of(job.before_of(object), object),
                after = extents_of(job.after_of(object), object);
  double least = 1;
  for (size_t k = 0; k < before.size(); ++k) {
    // What is thinner than its points lie apart is as thick as that.
    const double a = std::max(before[k], job.cell_m / 2), b = std::max(after[k], job.cell_m / 2);
    least = std::min(least, std::min(a, b) / std::max(a, b));
  }
  return std::log(least);
}

}  // namespace

void set_motion_features(const ObjectMotionJob& job, const Change& change, ChangeFeatures& f) {
  const MotionEvidence& m = change.motion;
  const double forth = unexplained_log(m.forth), back = unexplained_log(m.back);
  const double changed_forth = unexplained_log(m.changed_forth),
               changed_back = unexplained_log(m.changed_back);
  f[kFeatureWorst] = std::max(forth, back);
  f[kFeatureBest] = std::min(forth, back);
  f[kFeatureChangedWorst] = std::max(changed_forth, changed_back);
  f[kFeatureChangedBest] = std::min(changed_forth, changed_back);
  const double stay_forth = unexplained_log(m.stay_forth), stay_back = unexplained_log(m.stay_back);
  f[kFeatureStayBest] = std::min(stay_forth, stay_back);
  f[kFeatureStayWorst] = std::max(stay_forth, stay_back);
  f[kFeatureJudged] = std::min(ratio(m.forth.all, m.before), ratio(m.back.all, m.after));
  f[kFeatureChangedOfWhole] = ratio(m.changed_before + m.changed_after, m.before + m.after);
  f[kFeatureWay] = limited_log(m.way_m / job.threshold_m);
  const double size_m = std::max(kLeastLength_m, size_of(job, change.object));
  f[kFeatureWayOfSize] = limited_log(m.way_m / size_m);
  f[kFeatureTilt] = m.tilt_m / std::max(kLeastLength_m, m.way_m);
  f[kFeatureTiltOfSize] = f[kFeatureTilt] * f[kFeatureWayOfSize];
  f[kFeatureLikeCount] =
      limited_log(ratio(std::min(m.before, m.after), std::max(m.before, m.after)));
  f[kFeatureLikeExtents] = like_extents(job, change.object);
  f[kFeatureWhole] = m.is_whole ? 1 : 0;
}

}  // namespace jalon
