// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "cloud/statistics.h"
#include "compare/changes/changed_points.h"
#include "compare/changes/object_shape.h"
#include "compare/matching/match_starts.h"
#include "compare/visibility/visibility.h"

namespace jalon {

namespace {

constexpr double kToleranceShare =
    0.5;  // of the threshold: what is less than half a change lies on the surface
// Of the points explained by one motion: scanned again after a rigid one 98 to 99.8 % were, of a beam of 3 m bent by
// 0.25 m up to 88 %.
constexpr double kRigidShare = 0.93;
// Of twins far apart, where nothing but the shape speaks for a motion: other boxes of much the same size reach 96 %.
constexpr double kTwinShare = 0.97;
constexpr double kSizeRatio =
    1.5;  // between the extents of twins: one epoch may see less of it than the other
constexpr double kSizeCells = 4;
constexpr double kSideShare =
    0.05;  // of the changed surface: less than that on one side is its edge
constexpr double kDiagnosisInsideShare =
    0.02;  // of the points, in the box of the other: more than touches it

struct Job {
  const Epoch &before, &after;
  double tolerance_m, threshold_m, cell_m;
  SeenTest seen_before, seen_after;
  Task& task;

  std::vector<Vec3> points(const Epoch& epoch, const std::vector<uint32_t>& indices) const {
    std::vector<Vec3> out;
    out.reserve(indices.size());
    for (const uint32_t i : indices) out.push_back(epoch.local(i));
    return out;
  }
  std::vector<Vec3> before_of(const ChangedObject& o) const { return points(before, o.before); }
  std::vector<Vec3> after_of(const ChangedObject& o) const { return points(after, o.after); }
};

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

// Does the object after take up room that it took before?
bool overlaps(const Job& job, const ChangedObject& object, double margin_m) {
  const std::vector<Vec3> after = job.after_of(object);
  const StandingBox box = standing_box(job.before_of(object), up_of(object));
  const auto inside = static_cast<double>(std::count_if(
      after.begin(), after.end(), [&](const Vec3& p) { return box.contains(p, margin_m); }));
  return inside > kDiagnosisInsideShare * static_cast<double>(after.size());
}

RigidMatch match(const Job& job, const ChangedObject& object) {
  const MatchSurface before(job.before_of(object), job.task), after(job.after_of(object), job.task);
  return match_rigidly(before, after, match_setting(job, object), job.task);
}

// Steps 3 and 4: one motion, or none that explains enough.
Change moved_or_deformed(const Job& job, ChangedObject object) {
  Change out;
  out.match = match(job, object);
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

// Did no part of it move by more than the threshold? Then small things changed on something large that stayed.
bool stayed(const Job& job, const Change& change) {
  if (!change.match.found) return false;
  Box3 box;
  for (const uint32_t i : change.object.before) box.add(job.before.local(i));
  return norm(change.match.displacement) +
             norm(change.match.rotation) * norm(box.max - box.min) / 2 <
         job.threshold_m;
}

// Could one be the other, moved? Extents of the upright boxes, largest first.
bool is_twin(const Job& job, const ChangedObject& gone, const ChangedObject& come) {
  const StandingBox a = standing_box(job.before_of(gone), up_of(gone));
  const StandingBox b = standing_box(job.after_of(come), up_of(come));
  std::array<double, 3> x{a.half[0], a.half[1], a.half[2]}, y{b.half[0], b.half[1], b.half[2]};
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  for (size_t k = 0; k < 3; ++k)
    if (std::max(x[k], y[k]) > kSizeRatio * std::min(x[k], y[k]) + kSizeCells * job.cell_m)
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

struct Sides {
  std::vector<ChangedObject> gone, come;  ///< changed in one epoch only
};

// Step 4: twins, the best explained first.
void pair_twins(const Job& job, Sides& sides, std::vector<Change>& changes) {
  struct Pair {
    size_t gone, come;
    Change change;
  };
  std::vector<Pair> pairs;
  for (size_t g = 0; g < sides.gone.size(); ++g)
    for (size_t c = 0; c < sides.come.size(); ++c) {
      if (!is_twin(job, sides.gone[g], sides.come[c])) continue;
      Change change = moved_or_deformed(job, joined(sides.gone[g], sides.come[c]));
      if (change.match.found && change.match.explained >= kTwinShare)
        pairs.push_back({g, c, std::move(change)});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.change.confidence > b.change.confidence;
  });
  std::vector<uint8_t> gone_used(sides.gone.size(), 0), come_used(sides.come.size(), 0);
  for (Pair& pair : pairs) {
    if (gone_used[pair.gone] != 0 || come_used[pair.come] != 0) continue;
    gone_used[pair.gone] = come_used[pair.come] = 1;
    changes.push_back(std::move(pair.change));
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
