// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/evidence_diagnosis.h"

#include <algorithm>
#include <iterator>

#include "compare/changes/change_confidence.h"
#include "compare/changes/moved_things.h"

namespace jalon {

namespace {

constexpr double kMovedSurface = 0.5;  // of the points of a change: it is a surface that moved

ChangeClass one_sided(const ChangeGroup& group) {
  return group.after_m2 > group.before_m2 ? ChangeClass::kAppearance : ChangeClass::kDisappearance;
}

ChangeClass gave_way(const ObjectMotionJob& job, const ChangeGroup& group) {
  const bool has_both = !group.object.before.empty() && !group.object.after.empty();
  return group.moved_share >= kMovedSurface || !has_both || overlaps(job, group.object, 0)
             ? ChangeClass::kDeformationOverlap
             : ChangeClass::kDeformation;
}

// What it looks like comes first.
struct TwoWays {
  ChangeClass first, second;
};
TwoWays ways_of(const ObjectMotionJob& job, const ChangeGroup& group) {
  const bool is_one_sided =
      group.moved_share < kMovedSurface && (group.only_after() || group.only_before());
  const ChangeClass one = one_sided(group), both = gave_way(job, group);
  return is_one_sided ? TwoWays{one, both} : TwoWays{both, one};
}

// The likelier of both; the other one is kept among those weighed.
void weigh_ways(const TwoWays& ways, Change& change, std::vector<Change>& others) {
  Change second = change;
  second.change_class = ways.second;
  change.confidence = confidence_of(change);
  second.confidence = confidence_of(second);
  if (second.confidence > change.confidence) std::swap(change, second);
  others.push_back(std::move(second));
}

}  // namespace

bool has_evidence(const Comparison& forward, const Comparison& reverse) {
  return forward.points.find("evidence") != nullptr && reverse.points.find("evidence") != nullptr;
}

WeighedChanges classes_by_evidence(const ObjectMotionJob& job, double twin_reach) {
  std::vector<ChangeGroup> groups = change_groups(job);
  MovedThings things = take_moved_things(job, twin_reach, groups);
  std::erase_if(groups, [](const ChangeGroup& g) { return g.points() < kLeastToldPoints; });
  WeighedChanges out{{}, std::move(things.others)};
  std::vector<TwoWays> ways;
  for (ChangeGroup& group : groups) {
    ways.push_back(ways_of(job, group));
    Change& change = out.changes.emplace_back();
    change.change_class = ways.back().first;
    change.object = std::move(group.object);
  }
  std::move(things.moved.begin(), things.moved.end(), std::back_inserter(out.changes));
  set_features(job, out.others, out.changes);
  for (size_t k = 0; k < ways.size(); ++k) weigh_ways(ways[k], out.changes[k], out.others);
  return out;
}

}  // namespace jalon
