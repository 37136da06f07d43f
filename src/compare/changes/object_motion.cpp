// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/object_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/matching/match_starts.h"

namespace jalon {

namespace {

using Job = ObjectMotionJob;

// Of the points explained by one motion: scanned again after a rigid one 98 to 99.8 % were, of a beam of 3 m bent by
// 0.25 m up to 88 %.
constexpr double kRigidShare = 0.93;
// Of a motion that is weighed against other explanations: how much of it could be seen is weighed as well.
constexpr double kJudgedOfWhole = 0.3;
// What explains less of a thing, or of what changed of it, is no motion of it: a fence that leans here and bulges there
// slides along itself as well.
constexpr double kLeastExplained = 0.5, kLeastChangedExplained = 0.5;
constexpr size_t kFewChanged = 30;  // points by its edges find planes round the corner
constexpr double kSizeRatio =
    1.5;  // between the extents of twins: one epoch may see less of it than the other
constexpr double kSizeCells = 4;
constexpr double kDiagnosisInsideShare =
    0.02;  // of the points, in the box of the other: more than touches it

MatchSetting match_setting(const Job& job, const ChangedObject& object) {
  MatchSetting setting;
  setting.tolerance_m = job.tolerance_m;
  setting.seen_before = job.seen_before;
  setting.seen_after = job.seen_after;
  setting.stands = !object.supports.empty();
  if (setting.stands) setting.up = object.supports.front().plane.normal;
  return setting;
}

Vec3 up_of(const ChangedObject& object) {
  return object.supports.empty() ? Vec3{0, 0, 1} : object.supports.front().plane.normal;
}

RigidMatch match(const Job& job, const ChangedObject& object) {
  const MatchSurface before(job.before_of(object), job.task), after(job.after_of(object), job.task);
  return match_rigidly(before, after, match_setting(job, object), job.task);
}

std::vector<Vec3> changed_of(const Epoch& epoch, const std::vector<uint32_t>& points) {
  std::vector<Vec3> out;
  for (const uint32_t i : points)
    if (epoch.regions.labels[i] != 0) out.push_back(epoch.local(i));
  return out;
}

bool may_explain_change(const LaidOn& laid) {
  return laid.all < kFewChanged || laid.share() >= kLeastChangedExplained;
}

// Do points that a motion moves come to lie behind what the thing stands on?
bool is_behind(const std::vector<Vec3>& points, const Transform& motion, const Support& support,
               double tolerance_m) {
  Vec3 middle;
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const double side = support.plane.distance(middle) > 0 ? 1 : -1;
  const auto behind = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    return side * support.plane.distance(motion.point(p)) < -support.tolerance_m - tolerance_m;
  });
  return static_cast<double>(behind) > kDiagnosisInsideShare * static_cast<double>(points.size());
}

// A stack that lost its upmost box did not sink into the floor, and one that got a box did not rise out of it.
bool goes_through_support(const Job& job, const ChangedObject& whole, const Transform& motion) {
  const std::vector<Vec3> before = job.before_of(whole), after = job.after_of(whole);
  const Transform back = inverse(motion);
  return std::any_of(whole.supports.begin(), whole.supports.end(), [&](const Support& support) {
    return is_behind(before, motion, support, job.tolerance_m) ||
           is_behind(after, back, support, job.tolerance_m);
  });
}

}  // namespace

bool overlaps(const Job& job, const ChangedObject& object, double margin_m) {
  const std::vector<Vec3> after = job.after_of(object);
  const StandingBox box = standing_box(job.before_of(object), up_of(object));
  const auto inside = static_cast<double>(std::count_if(
      after.begin(), after.end(), [&](const Vec3& p) { return box.contains(p, margin_m); }));
  return inside > kDiagnosisInsideShare * static_cast<double>(after.size());
}

namespace {

// Along the support that it turns off least: what slides along a wall on the floor does so along both.
double tilt_of(const ChangedObject& object, const Transform& motion, double size_m) {
  double least = INFINITY;
  for (const Support& support : object.supports)
    least = std::min(least, norm(motion.direction(support.plane.normal) - support.plane.normal));
  if (object.supports.empty()) least = norm(motion.direction(up_of(object)) - up_of(object));
  return least * size_m / 2;
}

}  // namespace

bool motion_of_whole(const Job& job, ChangedObject whole, Change& out) {
  const MatchSurface before(job.before_of(whole), job.task), after(job.after_of(whole), job.task);
  MatchSetting setting = match_setting(job, whole);
  setting.judged = kJudgedOfWhole;
  const RigidMatch found = match_rigidly(before, after, setting, job.task);
  if (!found.found) return false;
  MotionEvidence& motion = out.motion;
  const double size_m = norm(before.box().max - before.box().min);
  motion.way_m = norm(found.displacement) + norm(found.rotation) * size_m / 2;
  motion.tilt_m = tilt_of(whole, found.motion, size_m);
  if (motion.way_m < job.threshold_m) return false;  // it stayed, and something on it changed
  if (goes_through_support(job, whole, found.motion)) return false;
  const std::vector<Vec3> gone = changed_of(job.before, whole.before),
                          come = changed_of(job.after, whole.after);
  const Transform back = inverse(found.motion);
  const auto laid_forth = [&](const std::vector<Vec3>& points, const Transform& by) {
    return laid_on(points, by, after, job.seen_after, job.tolerance_m, job.task);
  };
  const auto laid_back = [&](const std::vector<Vec3>& points, const Transform& by) {
    return laid_on(points, by, before, job.seen_before, job.tolerance_m, job.task);
  };
  motion.forth = laid_forth(before.points(), found.motion);
  motion.back = laid_back(after.points(), back);
  out.explained = std::min(motion.forth.share(), motion.back.share());
  if (out.explained < kLeastExplained) return false;
  motion.changed_forth = laid_forth(gone, found.motion);
  motion.changed_back = laid_back(come, back);
  if (!may_explain_change(motion.changed_forth) || !may_explain_change(motion.changed_back))
    return false;
  motion.stay_forth = laid_forth(before.points(), {});
  motion.stay_back = laid_back(after.points(), {});
  motion.before = before.size();
  motion.after = after.size();
  motion.changed_before = gone.size();
  motion.changed_after = come.size();
  motion.is_whole = !whole.supports.empty();
  out.match = found;
  out.object = std::move(whole);
  out.change_class =
      overlaps(job, out.object, 0) ? ChangeClass::kDisplacementOverlap : ChangeClass::kDisplacement;
  return true;
}

Change moved_or_deformed(const Job& job, ChangedObject object) {
  Change out;
  out.match = match(job, object);
  out.explained = out.match.explained;
  out.object = std::move(object);
  const bool is_rigid = out.match.found && out.match.explained >= kRigidShare;
  const bool overlap = overlaps(job, out.object, 0);
  out.change_class = is_rigid
                         ? overlap ? ChangeClass::kDisplacementOverlap : ChangeClass::kDisplacement
                     : overlap ? ChangeClass::kDeformationOverlap
                               : ChangeClass::kDeformation;
  out.confidence =
      is_rigid ? out.match.explained : std::clamp(1 - out.match.explained / 2, 0.0, 1.0);
  if (!is_rigid) out.match = {};
  return out;
}

Extents extents_of(const std::vector<Vec3>& points, const ChangedObject& object) {
  const StandingBox box = standing_box(points, up_of(object));
  Extents out{box.half[0], box.half[1], box.half[2]};
  std::sort(out.begin(), out.end());
  return out;
}

bool are_twins(const Job& job, const Extents& gone, const Extents& come) {
  for (size_t k = 0; k < 3; ++k)
    if (std::max(gone[k], come[k]) >
        kSizeRatio * std::min(gone[k], come[k]) + kSizeCells * job.cell_m)
      return false;
  return true;
}

ChangedObject joined(const ChangedObject& gone, const ChangedObject& come) {
  ChangedObject out = gone;
  out.after = come.after;
  out.regions_after = come.regions_after;
  if (out.supports.empty()) out.supports = come.supports;
  return out;
}

}  // namespace jalon
