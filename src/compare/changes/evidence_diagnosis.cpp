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

// One epoch of a group.
ChangeGroup side_of(const ChangeGroup& group, bool is_after) {
  ChangeGroup out;
  out.moved_share = group.moved_share;
  out.box = group.box;
  if (is_after) {
    out.after_m2 = group.after_m2;
    out.object.after = group.object.after;
    out.object.regions_after = group.object.regions_after;
  } else {
    out.before_m2 = group.before_m2;
    out.object.before = group.object.before;
    out.object.regions_before = group.object.regions_before;
  }
  return out;
}

double own_confidence(const ObjectMotionJob& job, const ChangeGroup& group, ChangeClass what) {
  Change change;
  change.change_class = what;
  change.object = group.object;
  set_own_features(job, change);
  return confidence_of(change);
}

// Whether pieces of both epochs that touch are two things, one that went and one that came, rather than one change.
bool are_two_things(const ObjectMotionJob& job, const ChangeGroup& group, const ChangeGroup& was,
                    const ChangeGroup& is) {
  if (group.moved_share >= kMovedSurface || group.only_after() || group.only_before() ||
      std::min(was.points(), is.points()) < kLeastToldPoints)
    return false;
  const double apart = std::min(own_confidence(job, was, ChangeClass::kDisappearance),
                                own_confidence(job, is, ChangeClass::kAppearance));
  return apart > std::max(own_confidence(job, group, gave_way(job, group)),
                          own_confidence(job, group, one_sided(group)));
}

void part_two_things(const ObjectMotionJob& job, std::vector<ChangeGroup>& groups) {
  std::vector<ChangeGroup> out;
  for (ChangeGroup& group : groups) {
    ChangeGroup was = side_of(group, false), is = side_of(group, true);
    if (are_two_things(job, group, was, is)) {
      out.push_back(std::move(was));
      out.push_back(std::move(is));
    } else {
      out.push_back(std::move(group));
    }
  }
  groups = std::move(out);
}

}  // namespace

bool has_evidence(const Comparison& forward, const Comparison& reverse) {
  return forward.points.find("evidence") != nullptr && reverse.points.find("evidence") != nullptr;
}

WeighedChanges classes_by_evidence(const ObjectMotionJob& job, double twin_reach) {
  std::vector<ChangeGroup> groups = change_groups(job);
  MovedThings things = take_moved_things(job, twin_reach, groups);
  std::erase_if(groups, [](const ChangeGroup& g) { return g.points() < kLeastToldPoints; });
  part_two_things(job, groups);
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
