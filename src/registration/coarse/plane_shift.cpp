// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "registration/coarse/plane_match.h"

namespace jalon {

namespace {

constexpr double kOwnDirection = 0.5;  // cosine: directions of shift at least 60 degrees apart
constexpr double kVoteWindow = 1.5;    // cells
constexpr size_t kPeaks = 5;           // shifts kept along a direction

/// A shift along a direction, and what speaks for it.
struct Vote {
  double shift, weight;
};

// The strongest shifts: sums of votes within a window, no two of one window.
std::vector<Vote> peaks_of(std::vector<Vote> votes, double window_m) {
  std::stable_sort(votes.begin(), votes.end(),
                   [](const Vote& a, const Vote& b) { return a.shift < b.shift; });
  std::vector<Vote> sums;
  for (size_t i = 0, first = 0, last = 0; i < votes.size(); ++i) {
    while (votes[first].shift < votes[i].shift - window_m) ++first;
    while (last < votes.size() && votes[last].shift <= votes[i].shift + window_m) ++last;
    Vote sum{0, 0};
    for (size_t k = first; k < last; ++k) {
      sum.shift += votes[k].shift * votes[k].weight;
      sum.weight += votes[k].weight;
    }
    sums.push_back({sum.shift / sum.weight, sum.weight});
  }
  std::stable_sort(sums.begin(), sums.end(),
                   [](const Vote& a, const Vote& b) { return a.weight > b.weight; });
  std::vector<Vote> out;
  for (const Vote& sum : sums) {
    if (out.size() == kPeaks) break;
    const bool is_new = std::none_of(out.begin(), out.end(), [&](const Vote& v) {
      return std::abs(v.shift - sum.shift) <= 2 * window_m;
    });
    if (is_new) out.push_back(sum);
  }
  return out;
}

struct Parallel {
  Vec3 normal;
  Vote vote;
};

// Pairs of planes that the rotation makes parallel, the largest first, with the shift along the reference's normal
// that lays them together. Shifts are those of the moving centroid: a small error of the rotation moves it least.
std::vector<Parallel> parallels_of(const Transform& rotation, const PlaneSets& planes,
                                   const Vec3& centroid) {
  std::vector<Parallel> out;
  for (const CoarsePlane& m : planes.moving)
    for (const CoarsePlane& r : planes.reference) {
      const double facing = dot(rotation.direction(m.plane.normal), r.plane.normal);
      if (std::abs(facing) < kParallel) continue;
      const double from = -m.plane.distance(centroid) * (facing < 0 ? -1 : 1);
      out.push_back({r.plane.normal, {r.plane.offset - from, common_area(m, r)}});
    }
  std::stable_sort(out.begin(), out.end(), [](const Parallel& a, const Parallel& b) {
    return a.vote.weight > b.vote.weight;
  });
  return out;
}

// Directions across which planes fix the shift: at most three, well apart.
std::vector<Vec3> directions_of(const std::vector<Parallel>& parallels) {
  std::vector<Vec3> out;
  for (const Parallel& p : parallels) {
    const bool is_own = std::none_of(out.begin(), out.end(), [&](const Vec3& d) {
      return std::abs(dot(d, p.normal)) > kOwnDirection;
    });
    if (!is_own) continue;
    if (out.size() == 2 && std::abs(dot(cross(out[0], out[1]), p.normal)) < kOwnDirection) continue;
    out.push_back(p.normal);
    if (out.size() == 3) break;
  }
  return out;
}

std::vector<Vote> votes_along(const Vec3& direction, const std::vector<Parallel>& parallels) {
  std::vector<Vote> out;
  for (const Parallel& p : parallels) {
    const double facing = dot(direction, p.normal);
    if (std::abs(facing) >= kParallel)
      out.push_back({facing < 0 ? -p.vote.shift : p.vote.shift, p.vote.weight});
  }
  return out;
}

// The place where three planes meet, given by unit normals and offsets.
Vec3 meeting(const Vec3 (&n)[3], const double (&d)[3]) {
  const double volume = dot(n[0], cross(n[1], n[2]));
  return (cross(n[1], n[2]) * d[0] + cross(n[2], n[0]) * d[1] + cross(n[0], n[1]) * d[2]) / volume;
}

/// Combines the shifts along the directions that planes fix, and by votes of features along the one they leave open.
class ShiftFinder {
 public:
  ShiftFinder(const Transform& rotation, const CoarseSurface& reference,
              const CoarseSurface& moving, std::span<const FeatureMatch> matches)
      : rotation_(rotation), reference_(reference), moving_(moving), matches_(matches) {}

  struct Shift {
    Vec3 to;  ///< of the moving centroid
    double weight;
  };

  std::vector<Shift> across_three(const std::vector<Vec3>& n,
                                  const std::vector<Vote> (&peaks)[3]) const {
    std::vector<Shift> out;
    for (const Vote& a : peaks[0])
      for (const Vote& b : peaks[1])
        for (const Vote& c : peaks[2])
          out.push_back({meeting({n[0], n[1], n[2]}, {a.shift, b.shift, c.shift}),
                         a.weight + b.weight + c.weight});
    return out;
  }

  std::vector<Shift> across_two(const std::vector<Vec3>& n,
                                const std::vector<Vote> (&peaks)[3]) const {
    const Vec3 open = normalized(cross(n[0], n[1]));
    const double window_m = kVoteWindow * reference_.cell_m;
    std::vector<Shift> out;
    for (const Vote& a : peaks[0])
      for (const Vote& b : peaks[1]) {
        std::vector<Vote> along;
        for (const FeatureMatch& match : matches_) {
          const Vec3 to = reference_.points[match.reference] -
                          rotation_.direction(moving_.points[match.moving] - moving_.centroid);
          if (std::abs(dot(to, n[0]) - a.shift) > 2 * window_m ||
              std::abs(dot(to, n[1]) - b.shift) > 2 * window_m)
            continue;
          along.push_back({dot(to, open), 1});
        }
        // Without a word on it the middle of both is as good as any.
        if (along.empty()) along.push_back({dot(reference_.centroid, open), 1});
        for (const Vote& c : peaks_of(std::move(along), window_m))
          out.push_back({meeting({n[0], n[1], open}, {a.shift, b.shift, c.shift}),
                         a.weight + b.weight + c.weight});
      }
    return out;
  }

 private:
  const Transform& rotation_;
  const CoarseSurface &reference_, &moving_;
  std::span<const FeatureMatch> matches_;
};

}  // namespace

// 1. Pairs of planes that the rotation makes parallel; 2. the directions across which they fix the
// shift; 3. the peaks of their votes along each; 4. the peaks combined, by features along a
// direction left open.
std::vector<Transform> plane_poses(const Transform& rotation, const PlaneSets& planes,
                                   const CoarseSurface& reference, const CoarseSurface& moving,
                                   std::span<const FeatureMatch> matches, size_t most) {
  const Vec3& centroid = moving.centroid;
  const std::vector<Parallel> parallels = parallels_of(rotation, planes, centroid);
  const std::vector<Vec3> directions = directions_of(parallels);
  if (directions.size() < 2) return {};
  std::vector<Vote> peaks[3];
  for (size_t k = 0; k < directions.size(); ++k)
    peaks[k] = peaks_of(votes_along(directions[k], parallels), kVoteWindow * reference.cell_m);
  const ShiftFinder finder(rotation, reference, moving, matches);
  auto shifts = directions.size() == 3 ? finder.across_three(directions, peaks)
                                       : finder.across_two(directions, peaks);
  std::stable_sort(shifts.begin(), shifts.end(),
                   [](const auto& a, const auto& b) { return a.weight > b.weight; });
  if (shifts.size() > most) shifts.resize(most);
  std::vector<Transform> out;
  for (const auto& shift : shifts) {
    Transform T_reference_moving = rotation;
    const Vec3 t = shift.to - rotation.direction(centroid);
    T_reference_moving.m[3] = t.x, T_reference_moving.m[7] = t.y, T_reference_moving.m[11] = t.z;
    out.push_back(T_reference_moving);
  }
  return out;
}

}  // namespace jalon
