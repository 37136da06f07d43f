// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/ray_matching.h"

#include <cmath>

#include "base/distributions.h"
#include "base/parallel.h"

namespace jalon {

namespace {

class RayMatcher {
 public:
  RayMatcher(const JointPoints& points, const StripScene& scene, const JointPlaces& places,
             const JointSettings& settings, const TriangleTree& tree)
      : points_(points),
        scene_(scene),
        places_(places),
        settings_(settings),
        tree_(tree),
        greatest_(greatest_deviation(settings)),
        least_alignment_(std::cos(settings.greatest_turn_rad)) {
    for (uint32_t s = 0; s < scene.strips.size(); ++s)
      offsets_.push_back(scene.strips[s].offset_m + shift_of(scene.strips[s], s, places.model));
  }

  PointMatch match(size_t i) const {
    PointMatch made;
    const TimePlace& at = points_.places[i];
    const Vec2 by =
        places_.trajectory[at.epoch] * (1 - at.share) + places_.trajectory[at.epoch + 1] * at.share;
    const Vec3 shift{by.u, by.v, 0};
    // The ray has no end: the wall may stand behind the point.
    RayHit hit;
    if (!tree_.nearest({points_.origin[i] + shift, points_.direction[i]}, hit)) return made;
    made.strip = strip_of(hit);
    if (made.strip == kNoStrip) return made;
    if (settings_.kernel == JointSettings::Kernel::kTukey)
      made.strip =
          nearer_to_its_place(made.strip, hit, {points_.origin[i] + shift, points_.direction[i]});
    const GivenStrip& strip = scene_.strips[made.strip];
    const Vec3 p = points_.at[i] + shift;
    made.distance_m = strip.normal.u * p.x + strip.normal.v * p.y - offsets_[made.strip];
    const Vec3& u = points_.direction[i];
    if (!(strip.normal.u * u.x + strip.normal.v * u.y < 0)) made.state = MatchState::kBehind;
    else if (!(std::fabs(made.distance_m) < greatest_ * sigma_of(i, strip)))
      made.state = MatchState::kFar;
    else if (!points_.normal.empty() &&
             std::fabs(dot(points_.normal[i], strip.normal)) < least_alignment_)
      made.state = MatchState::kTurned;
    else made.state = MatchState::kMatched;
    return made;
  }

 private:
  uint32_t strip_of(const RayHit& hit) const {
    return scene_.strip_of_face[scene_.face_of[hit.triangle]];
  }

  // Two strips that have come to stand in one place, one of which was moved onto the wall of the
  // other: the beam ends on the one that was moved less.
  uint32_t nearer_to_its_place(uint32_t strip, const RayHit& hit, Ray ray) const {
    constexpr double kOnePlace_m = 0.15;
    constexpr double kAlike = 0.94;          // 20 degrees
    ray.t_min = hit.t * (1 + 1e-12) + 1e-9;  // not the same triangle again
    const Vec2& n = scene_.strips[strip].normal;
    ray.t_max = hit.t + kOnePlace_m / std::fabs(n.u * ray.direction.x + n.v * ray.direction.y);
    RayHit next;
    if (!tree_.nearest(ray, next)) return strip;
    const uint32_t other = strip_of(next);
    if (other == kNoStrip || dot(scene_.strips[strip].normal, scene_.strips[other].normal) < kAlike)
      return strip;
    const std::vector<double>& off = places_.model.strips;
    return std::fabs(off[other]) < std::fabs(off[strip]) ? other : strip;
  }

  // Of the distance: the point along the normal, its pose included, and the three groups of the model.
  double sigma_of(size_t i, const GivenStrip& strip) const {
    const auto& c = points_.plan_covariance_m2[i];
    const double x = strip.normal.u, y = strip.normal.v;
    const auto square = [](double v) { return v * v; };
    return std::sqrt(c[0] * x * x + 2 * c[1] * x * y + c[2] * y * y +
                     square(settings_.sigma_block_x_m * x) + square(settings_.sigma_block_y_m * y) +
                     square(settings_.sigma_facade_m) + square(settings_.sigma_strip_m));
  }

  const JointPoints& points_;
  const StripScene& scene_;
  const JointPlaces& places_;
  const JointSettings& settings_;
  const TriangleTree& tree_;
  double greatest_, least_alignment_;
  std::vector<double> offsets_;  ///< of the moved strips' planes
};

std::vector<PointMatch> matches_by_ids(const JointPoints& points, const StripScene& scene) {
  std::vector<PointMatch> made;
  for (size_t i = 0; i < points.size(); ++i)
    made.push_back(points.id[i] < scene.strips.size()
                       ? PointMatch{points.id[i], MatchState::kMatched, 0}
                       : PointMatch{});
  return made;
}

}  // namespace

double greatest_deviation(const JointSettings& settings) {
  return settings.bound == JointSettings::Bound::kLogarithm
             ? -std::log(settings.refused_share)
             : normal_quantile(1 - settings.refused_share / 2);
}

std::vector<PointMatch> match_points(const JointPoints& points, const StripScene& scene,
                                     const JointPlaces& places, const JointSettings& settings,
                                     Task& task) {
  if (settings.matches == JointSettings::Matches::kIds) return matches_by_ids(points, scene);
  const auto tree = tree_of(scene, places.model, task);
  const RayMatcher matcher(points, scene, places, settings, *tree);
  std::vector<PointMatch> made(points.size());
  constexpr size_t kMatchGrain = 1 << 12;
  parallel_for(task, points.size(), kMatchGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) made[i] = matcher.match(i);
  });
  return made;
}

}  // namespace jalon
