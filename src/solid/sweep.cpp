// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/sweep.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "base/parallel.h"
#include "solid/sweep_contact.h"

namespace jalon {

namespace {

/// A contact closer than the margin: enough to find the place again.
struct Hit {
  ObstacleKind kind;
  uint32_t index, piece, interval;
  double time, clearance_m;

  bool operator<(const Hit& b) const {
    return std::tie(kind, index, clearance_m, interval, time, piece) <
           std::tie(b.kind, b.index, b.clearance_m, b.interval, b.time, b.piece);
  }
};

bool same_obstacle(const Hit& a, const Hit& b) { return a.kind == b.kind && a.index == b.index; }

/// Keeps the least contact of each obstacle.
void keep_least(std::vector<Hit>& hits) {
  std::sort(hits.begin(), hits.end());
  hits.erase(std::unique(hits.begin(), hits.end(), same_obstacle), hits.end());
}

/// One interval: all obstacles against all pieces.
class IntervalSweep {
 public:
  IntervalSweep(std::span<const ConvexPiece> pieces, const Motion& motion,
                const SweepSettings& settings, uint32_t interval, const Task& task)
      : pieces_(pieces), motion_(motion), settings_(settings), interval_(interval), task_(task) {
    nearest_ = std::max(settings.reach_m, settings.margin_m);
  }

  void points(const Octree& octree, std::span<const double> xyz) {
    const std::span<const uint32_t> order = octree.order();
    for (piece_ = 0; piece_ < pieces_.size(); ++piece_)
      walk_octree(
          octree, [&](const BoundingBall& ball, double& key) { return is_near(ball, key); },
          [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i) {
              const double* p = xyz.data() + 3 * static_cast<size_t>(order[i]);
              const Vec3 start = motion_.start({p[0], p[1], p[2]});
              measure({&start, 1}, ObstacleKind::kPoint, order[i]);
            }
          });
  }

  void triangles(const TriangleBoxes& boxes) {
    for (piece_ = 0; piece_ < pieces_.size(); ++piece_)
      boxes.walk([&](const BoundingBall& ball, double& key) { return is_near(ball, key); },
                 [&](uint32_t t) {
                   std::array<Vec3, 3> starts = boxes.corners(t);
                   for (Vec3& corner : starts) corner = motion_.start(corner);
                   measure(starts, ObstacleKind::kFace, t);
                 });
  }

  std::vector<Hit> hits;
  Hit least{ObstacleKind::kNone, 0, 0, 0, 0, 0};

 private:
  // What is farther interests nobody: neither a place nor the least of the interval.
  double limit() const { return std::max(settings_.margin_m, nearest_); }

  bool is_near(const BoundingBall& ball, double& key) {
    if (task_.cancelled()) throw Error(Status::kCancelled, "cancelled");
    return may_come_within(pieces_[piece_], motion_, motion_.start(ball.centre), ball.radius_m,
                           limit(), key);
  }

  void measure(std::span<const Vec3> starts, ObstacleKind kind, uint32_t index) {
    SweptContact found;
    if (!least_during(pieces_[piece_], motion_, starts, limit() + 2 * kSweepTolerance_m, found))
      return;
    const Hit hit{kind, index, piece_, interval_, found.time, found.contact.value};
    if (hit.clearance_m <= settings_.margin_m) hits.push_back(hit);
    if (hit.clearance_m > nearest_) return;
    if (least.kind != ObstacleKind::kNone && hit.clearance_m == least.clearance_m && !(hit < least))
      return;
    least = hit;
    nearest_ = hit.clearance_m;
  }

  std::span<const ConvexPiece> pieces_;
  const Motion& motion_;
  const SweepSettings& settings_;
  uint32_t interval_, piece_ = 0;
  const Task& task_;
  double nearest_;
};

/// The two points of a contact, from its time.
SweepPlace place_of(const Hit& hit, std::span<const ConvexPiece> pieces, const Motion& motion,
                    const Obstacles& obstacles) {
  SweepPlace place{hit.kind, hit.index, hit.piece, hit.interval, hit.time, hit.clearance_m, {}, {}};
  if (hit.kind == ObstacleKind::kNone) return place;
  std::array<Vec3, 3> corners;
  size_t count = 1;
  if (hit.kind == ObstacleKind::kPoint) {
    const double* p = obstacles.xyz.data() + 3 * static_cast<size_t>(hit.index);
    corners[0] = {p[0], p[1], p[2]};
    place.obstacle = corners[0];
  } else {
    corners = obstacles.triangles->corners(hit.index);
    count = 3;
  }
  for (size_t i = 0; i < count; ++i)
    corners[i] = motion.seen_at(motion.start(corners[i]), hit.time);
  const Contact contact = least_distance(pieces[hit.piece], {corners.data(), count});
  if (hit.kind == ObstacleKind::kFace) place.obstacle = motion.to_world(contact.point, hit.time);
  place.gauge = motion.to_world(contact.point - contact.gradient * contact.value, hit.time);
  return place;
}

}  // namespace

SweepResult sweep_gauge(std::span<const ConvexPiece> pieces, std::span<const Transform> poses,
                        const Obstacles& obstacles, const SweepSettings& settings, Task& task) {
  std::vector<Motion> motions;
  for (size_t i = 0; i + 1 < poses.size(); ++i) motions.emplace_back(poses[i], poses[i + 1]);
  if (poses.size() == 1) motions.emplace_back(poses[0], poses[0]);

  // 1. Every interval by itself.
  std::vector<std::vector<Hit>> hits(motions.size());
  std::vector<Hit> least(motions.size());
  SweepResult result;
  result.near_counts.resize(motions.size());
  parallel_chunks(task, motions.size(), [&](size_t i) {
    IntervalSweep sweep(pieces, motions[i], settings, static_cast<uint32_t>(i), task);
    if (obstacles.octree != nullptr) sweep.points(*obstacles.octree, obstacles.xyz);
    if (obstacles.triangles != nullptr) sweep.triangles(*obstacles.triangles);
    keep_least(sweep.hits);
    result.near_counts[i] = sweep.hits.size();
    hits[i] = std::move(sweep.hits);
    least[i] = sweep.least;
    least[i].interval = static_cast<uint32_t>(i);
  });

  // 2. The least contact of each obstacle over all intervals.
  std::vector<Hit> all;
  for (std::vector<Hit>& some : hits) {
    all.insert(all.end(), some.begin(), some.end());
    some = {};
  }
  keep_least(all);

  // 3. Where they are.
  const auto places = [&](const std::vector<Hit>& from, std::vector<SweepPlace>& to) {
    constexpr size_t kGrain = 1024;
    to.resize(from.size());
    parallel_for(task, from.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        to[i] = place_of(from[i], pieces, motions[from[i].interval], obstacles);
    });
  };
  places(least, result.intervals);
  places(all, result.places);
  return result;
}

}  // namespace jalon
