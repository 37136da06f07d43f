// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_features.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "compare/changes/beside_change.h"
#include "compare/changes/change_pieces.h"
#include "compare/changes/motion_features.h"
#include "compare/changes/object_motion.h"
#include "compare/detection/detection.h"

namespace jalon {

namespace {

constexpr size_t kFamilyMoved = 1;      // see family_of
constexpr double kLowShare = 0.1;       // of the distances: the lower decile
constexpr double kNearBorder = 2;       // thresholds or spacings
constexpr size_t kExtentSample = 2000;  // points of an epoch whose extents are told
constexpr double kLikeReach = 3;        // sizes of the larger of two things that may be one
constexpr double kRightBeside = 0.25;
/// Sums over the changed points of a statement, in both epochs.
struct ChangedSums {
  std::vector<double> distances;
  size_t points = 0, through = 0, moved = 0;
  Box3 box;
  Moments moments;
};

void add_side(const Epoch& epoch, const std::vector<uint32_t>& points, ChangedSums& sums) {
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  const auto evidence = epoch.comparison->points.require("evidence").values<uint8_t>();
  for (const uint32_t i : points) {
    if (epoch.regions.labels[i] == 0) continue;
    const Vec3 p = epoch.local(i);
    if (sums.points++ == 0) sums.moments.reference = p;
    sums.moments.add(p);
    sums.box.add(p);
    sums.through += evidence[i] == static_cast<uint8_t>(ChangeEvidence::kSeenThrough) ? 1 : 0;
    sums.moved += evidence[i] == static_cast<uint8_t>(ChangeEvidence::kMovedSurface) ? 1 : 0;
    if (std::isfinite(distance[i])) sums.distances.push_back(std::abs(distance[i]));
  }
}

double quantile(std::vector<double>& values, double order) {
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(order * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double share(size_t part, size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

double number_of(const Comparison& comparison, const char* name) {
  const Column* column = comparison.summary.find(name);
  return column != nullptr && column->count() > 0 ? column->number(0) : 0;
}

// The changed points' box.
Box3 changed_box(const ObjectMotionJob& job, const ChangedObject& object) {
  Box3 out;
  for (const uint32_t i : object.before)
    if (job.before.regions.labels[i] != 0) out.add(job.before.local(i));
  for (const uint32_t i : object.after)
    if (job.after.regions.labels[i] != 0) out.add(job.after.local(i));
  return out;
}

// Of the changed points, least first; of one thing upright and fallen over they are the same.
Extents changed_extents(const ObjectMotionJob& job, const ChangedObject& object) {
  std::vector<Vec3> points;
  const auto add = [&](const Epoch& epoch, const std::vector<uint32_t>& all) {
    for (size_t k = 0; k < all.size(); k += all.size() / kExtentSample + 1)
      if (epoch.regions.labels[all[k]] != 0) points.push_back(epoch.local(all[k]));
  };
  add(job.before, object.before);
  add(job.after, object.after);
  Extents out{};
  if (!points.empty()) out = extents_of(points, object);
  // What is thinner than its points lie apart is as thick as that.
  for (double& extent : out) extent = std::max(extent, job.cell_m / 2);
  return out;
}

double like_shape(const Extents& a, const Extents& b) {
  double least = 1;
  for (size_t k = 0; k < a.size(); ++k)
    least = std::min(least, std::min(a[k], b[k]) / std::max(a[k], b[k]));
  return least;
}

// Does it hold most of the change's labels?
bool may_explain(const Change& motion, const Change& change) {
  const auto common = [](const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
    return static_cast<size_t>(std::count_if(
        a.begin(), a.end(), [&](uint32_t i) { return std::binary_search(b.begin(), b.end(), i); }));
  };
  const ChangedObject &part = change.object, &whole = motion.object;
  return 2 * (common(part.before, whole.before) + common(part.after, whole.after)) >
         part.before.size() + part.after.size();
}

}  // namespace

void set_own_features(const ObjectMotionJob& job, Change& change) {
  ChangedSums sums;
  add_side(job.before, change.object.before, sums);
  add_side(job.after, change.object.after, sums);
  // The after cloud's points were looked for by the stations of before, and the other way round.
  const bool asks_before = !change.object.after.empty(), asks_after = !change.object.before.empty();
  const bool is_blind = (asks_before && !(number_of(*job.after.comparison, "stations") > 0)) ||
                        (asks_after && !(number_of(*job.before.comparison, "stations") > 0));
  const double noise = std::max({number_of(*job.before.comparison, "noise"),
                                 number_of(*job.after.comparison, "noise"), 1e-9});
  const double spacing = std::max({asks_before ? job.after.regions.spacing_m : 0,
                                   asks_after ? job.before.regions.spacing_m : 0, 1e-9});
  const double distance = quantile(sums.distances, 0.5), low = quantile(sums.distances, kLowShare);
  const double through = share(sums.through, sums.points);
  const Eigen3 axes = symmetric_eigen(sums.moments.covariance());
  const double before_m2 = changed_area(job.before, change.object.regions_before),
               after_m2 = changed_area(job.after, change.object.regions_after);
  ChangeFeatures& f = change.features;
  f[kFeatureOne] = 1;
  f[kFeatureNoStations] = is_blind ? 1 : 0;
  f[kFeatureBothSides] = std::max(before_m2, after_m2) > 0
                             ? std::min(before_m2, after_m2) / std::max(before_m2, after_m2)
                             : 0;
  f[kFeatureMovedSurface] = share(sums.moved, sums.points);
  if (family_of(change) == kFamilyMoved) return set_motion_features(job, change, f);
  Beside beside;
  const double near_m = kNearBorder * std::max(job.threshold_m, spacing);
  add_beside(job.before, job.after, change.object.before, near_m, job.task, beside);
  add_beside(job.after, job.before, change.object.after, near_m, job.task, beside);
  f[kFeaturePoints] = limited_log(static_cast<double>(sums.points) / 64);
  f[kFeatureThrough] = is_blind ? 0 : through;
  f[kFeatureNothingNear] = is_blind ? through : 0;
  f[kFeatureThresholds] = limited_log(distance / job.threshold_m);
  f[kFeatureLevels] = limited_log(distance / noise);
  f[kFeatureSpacings] = limited_log(distance / spacing);
  f[kFeatureExtent] =
      sums.box.empty() ? 0 : limited_log(norm(sums.box.max - sums.box.min) / spacing);
  f[kFeatureSlender] =
      axes.values[2] > 0 ? std::sqrt(std::max(0.0, axes.values[1] / axes.values[2])) : 0;
  f[kFeatureBesideHidden] = share(beside.hidden, beside.asked);
  f[kFeatureBesideSame] = share(beside.same, beside.asked);
  f[kFeatureBorderAlong] = beside.border_along();
  f[kFeatureGone] = beside.gone_share();
  f[kFeatureFacing] = beside.facing_share();
  f[kFeatureFacingGone] = beside.facing_gone_share();
  f[kFeatureSpread] = distance > 0 ? limited_log(low / distance) : 0;
}

namespace {

// By area and not by class: what is told to have given way may have come.
bool has_come(const ObjectMotionJob& job, const Change& change) {
  return changed_area(job.after, change.object.regions_after) >
         changed_area(job.before, change.object.regions_before);
}

double area_of(const ObjectMotionJob& job, const Change& change) {
  return changed_area(job.before, change.object.regions_before) +
         changed_area(job.after, change.object.regions_after);
}

}  // namespace

double limited_log(double value) {
  constexpr double kMost = 5;
  return value > 0 ? std::clamp(std::log(value), -kMost, kMost) : -kMost;
}

size_t family_of(const Change& change) {
  switch (change.change_class) {
    case ChangeClass::kAppearance:
    case ChangeClass::kDisappearance:
      return 0;
    case ChangeClass::kDisplacement:
    case ChangeClass::kDisplacementOverlap:
      return kFamilyMoved;
    default:
      return 2;
  }
}

void set_features(const ObjectMotionJob& job, const std::vector<Change>& others,
                  std::vector<Change>& changes) {
  std::vector<Box3> boxes(changes.size());
  std::vector<Extents> extents(changes.size());
  parallel_for(job.task, changes.size(), 1, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      Change& change = changes[k];
      boxes[k] = changed_box(job, change.object);
      if (family_of(change) == kFamilyMoved) continue;
      set_own_features(job, change);
      extents[k] = changed_extents(job, change.object);
      for (const Change& other : others)
        if (other.confidence > change.features[kFeatureMayHaveMoved] && may_explain(other, change))
          change.features[kFeatureMayHaveMoved] = other.confidence;
    }
  });
  for (size_t a = 0; a < changes.size(); ++a) {
    if (family_of(changes[a]) == kFamilyMoved) continue;
    double like = 0, near = 0, like_in_shape = 0;
    for (size_t b = 0; b < changes.size(); ++b) {
      if (a == b || boxes[a].empty() || boxes[b].empty()) continue;
      const double size =
          std::max(norm(boxes[a].max - boxes[a].min), norm(boxes[b].max - boxes[b].min));
      const double gap = box_gap(boxes[a], boxes[b]);
      if (gap <= kRightBeside * size) near = 1;
      if (family_of(changes[b]) == kFamilyMoved || gap > kLikeReach * size ||
          has_come(job, changes[a]) == has_come(job, changes[b]))
        continue;
      const double p = area_of(job, changes[a]), q = area_of(job, changes[b]);
      if (!(std::max(p, q) > 0)) continue;
      const double by_area = std::min(p, q) / std::max(p, q);
      like = std::max(like, by_area);
      like_in_shape = std::max(like_in_shape, by_area * like_shape(extents[a], extents[b]));
    }
    changes[a].features[kFeatureLike] = like;
    changes[a].features[kFeatureNear] = near;
    changes[a].features[kFeatureLikeShape] = like_in_shape;
  }
}

}  // namespace jalon
