// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "base/error.h"
#include "cloud/statistics.h"
#include "compare/changes/change_confidence.h"
#include "compare/changes/changed_points.h"
#include "compare/changes/evidence_diagnosis.h"
#include "compare/changes/object_shape.h"
#include "compare/changes/twin_pairs.h"
#include "compare/visibility/visibility.h"

namespace jalon {

namespace {

constexpr double kToleranceShare =
    0.5;  // of the threshold: what is less than half a change lies on the surface
// Of twins far apart, where nothing but the shape speaks for a motion: other boxes of much the same size reach 96 %.
constexpr double kTwinShare = 0.97;
constexpr double kSideShare =
    0.05;  // of the changed surface: less than that on one side is its edge

using Job = ObjectMotionJob;

// Did no part of it move by more than the threshold? Then small things changed on something large that stayed.
bool stayed(const Job& job, const Change& change) {
  if (!change.match.found) return false;
  Box3 box;
  for (const uint32_t i : change.object.before) box.add(job.before.local(i));
  return norm(change.match.displacement) +
             norm(change.match.rotation) * norm(box.max - box.min) / 2 <
         job.threshold_m;
}

struct Sides {
  std::vector<ChangedObject> gone, come;  ///< changed in one epoch only
};

// Step 4: twins, the best explained first.
void pair_twins(const Job& job, Sides& sides, std::vector<Change>& changes) {
  std::vector<Extents> gone_extents, come_extents;
  for (const ChangedObject& o : sides.gone) gone_extents.push_back(extents_of(job.before_of(o), o));
  for (const ChangedObject& o : sides.come) come_extents.push_back(extents_of(job.after_of(o), o));
  std::map<std::pair<size_t, size_t>, Change> moved;
  const auto pairs = twin_pairs(sides.gone.size(), sides.come.size(), [&](size_t g, size_t c) {
    constexpr double kNone = -1;
    if (!are_twins(job, gone_extents[g], come_extents[c])) return kNone;
    Change change = moved_or_deformed(job, joined(sides.gone[g], sides.come[c]));
    if (!change.match.found || !(change.match.explained >= kTwinShare)) return kNone;
    const double share = change.confidence;
    moved.emplace(std::pair{g, c}, std::move(change));
    return share;
  });
  std::vector<uint8_t> gone_used(sides.gone.size(), 0), come_used(sides.come.size(), 0);
  for (const TwinPair& pair : pairs) {
    gone_used[pair.gone] = come_used[pair.come] = 1;
    changes.push_back(std::move(moved.at({pair.gone, pair.come})));
  }
  const auto drop = [](std::vector<ChangedObject>& objects, const std::vector<uint8_t>& used) {
    size_t kept = 0;
    for (size_t i = 0; i < objects.size(); ++i)
      if (used[i] == 0) std::swap(objects[kept++], objects[i]);
    objects.resize(kept);
  };
  drop(sides.gone, gone_used);
  drop(sides.come, come_used);
}

// Step 4: what lies where something else was before is that thing, deformed.
void pair_places(const Job& job, Sides& sides, std::vector<Change>& changes) {
  for (size_t g = 0; g < sides.gone.size();) {
    size_t c = 0;
    while (c < sides.come.size() &&
           !overlaps(job, joined(sides.gone[g], sides.come[c]), 2 * job.cell_m))
      ++c;
    if (c == sides.come.size()) {
      ++g;
      continue;
    }
    changes.push_back(moved_or_deformed(job, joined(sides.gone[g], sides.come[c])));
    sides.gone.erase(sides.gone.begin() + static_cast<std::ptrdiff_t>(g));
    sides.come.erase(sides.come.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

// Whether the scanners of an epoch could have seen a place; says nothing where a point has no scanner.
SeenTest seen_by(const Epoch& epoch, double margin_m, Task& task) {
  uint64_t placed = 0;
  for (const Station& s : epoch.cloud().stations) placed += s.has_pose ? s.count : 0;
  if (placed < epoch.cloud().size()) return {};
  DepthSettings settings;
  settings.margin_m = margin_m;
  const auto test = std::make_shared<const VisibilityTest>(epoch.cloud(), settings, task);
  const Vec3 origin = epoch.origin;
  return [test, origin](const Vec3& p) { return test->label(p + origin) == Visibility::kVisible; };
}

Change one_sided(const Job& job, ChangedObject object, bool is_after) {
  Change out;
  const Epoch& epoch = is_after ? job.after : job.before;
  const std::vector<uint32_t>& points = is_after ? object.after : object.before;
  const Epoch& other = is_after ? job.before : job.after;
  const BorderOfChange border = border_of_change(epoch, other, points, job.cell_m, job.task);
  if (border.is_soft(job.threshold_m)) {
    out.change_class = ChangeClass::kDeformationOverlap;
    out.confidence = border.soft_share(job.threshold_m);
  } else {
    out.change_class = is_after ? ChangeClass::kAppearance : ChangeClass::kDisappearance;
    out.confidence = 1 - border.soft_share(job.threshold_m) / 2;
  }
  out.object = std::move(object);
  return out;
}

// What lies on a surface, by the noise of both where that is known.
double tolerance_of(const Comparison& forward, const Comparison& reverse, double threshold_m) {
  constexpr double kNoises = 4, kLeast_m = 0.002;  // the least for gentle curves between the points
  const double noise = std::max(forward.summary.require("noise").number(0),
                                reverse.summary.require("noise").number(0));
  return std::min(kToleranceShare * threshold_m, kNoises * noise + kLeast_m);
}

// The nearest points of one comparison are points of the other, or none.
void require_both_ways(const Comparison& comparison, const Comparison& other) {
  for (const uint32_t nearest : comparison.points.require("nearest").values<uint32_t>())
    if (nearest != kNoPoint && nearest >= other.cloud->size())
      fail(Status::kInvalidArgument,
           "the two comparisons are not of the same two clouds: one names point %u of %zu", nearest,
           other.cloud->size());
}

}  // namespace

Diagnosis diagnose(const Comparison& forward, const Comparison& reverse,
                   const RegionSettings& settings, Task& task) {
  for (const Comparison* c : {&forward, &reverse})
    if (c->points.find("nearest") == nullptr)
      fail(Status::kInvalidArgument,
           "the diagnosis needs two comparisons of method distance between clouds");
  require_both_ways(forward, reverse);
  require_both_ways(reverse, forward);
  const double threshold_m = settings.threshold_m;
  if (!(threshold_m > 0))
    fail(Status::kInvalidArgument,
         "threshold_m is 0; half of it is the tolerance of the diagnosis");
  Diagnosis out;
  out.after.comparison = &forward;
  out.before.comparison = &reverse;
  {
    ProgressSpan span(task, 0, 0.3, "regions");
    out.after.regions = change_regions(forward, settings, task, reverse.cloud.get());
    out.before.regions = change_regions(reverse, settings, task, forward.cloud.get());
    out.after.origin = out.before.origin = local_origin(*forward.cloud, task);
  }
  const double cell_m = std::max({out.before.regions.cell_m, out.after.regions.cell_m, 1e-6});
  if (has_evidence(forward, reverse)) {
    const ProgressSpan span(task, 0.3, 1, "classes");
    WeighedChanges found = classes_by_evidence(
        {out.before, out.after, tolerance_of(forward, reverse, threshold_m), threshold_m, cell_m,
         seen_by(out.before, threshold_m, task), seen_by(out.after, threshold_m, task), task},
        settings.twin_reach);
    out.weighed = std::move(found.others);
    for (Change& change : found.changes)
      (is_told(change) ? out.changes : out.untold).push_back(std::move(change));
    return out;
  }
  for (Epoch* epoch : {&out.before, &out.after}) drop_shadow_rims(*epoch, threshold_m, cell_m);
  const Job job{out.before,
                out.after,
                kToleranceShare * threshold_m,
                threshold_m,
                cell_m,
                seen_by(out.before, threshold_m, task),
                seen_by(out.after, threshold_m, task),
                task};
  std::vector<ChangedObject> objects;
  {
    ProgressSpan span(task, 0.3, 0.6, "objects");
    objects = whole_objects(out.before, out.after, job.tolerance_m, task);
  }
  ProgressSpan span(task, 0.6, 1, "classes");
  Sides sides;
  for (ChangedObject& object : objects) {
    const double gone_m2 = changed_area(out.before, object.regions_before);
    const double come_m2 = changed_area(out.after, object.regions_after);
    if (std::min(gone_m2, come_m2) <= kSideShare * std::max(gone_m2, come_m2)) {
      (gone_m2 < come_m2 ? sides.come : sides.gone).push_back(std::move(object));
      continue;
    }
    Change change = moved_or_deformed(job, object);
    if (!stayed(job, change)) {
      out.changes.push_back(std::move(change));
      continue;
    }
    for (ChangedObject& one : single_regions(out.before, out.after, object, cell_m))
      (one.regions_before.empty() ? sides.come : sides.gone).push_back(std::move(one));
  }
  pair_twins(job, sides, out.changes);
  pair_places(job, sides, out.changes);
  for (ChangedObject& object : sides.come)
    out.changes.push_back(one_sided(job, std::move(object), true));
  for (ChangedObject& object : sides.gone)
    out.changes.push_back(one_sided(job, std::move(object), false));
  return out;
}

}  // namespace jalon
