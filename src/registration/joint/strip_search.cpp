// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "registration/joint/point_cells.h"
#include "registration/joint/ray_matching.h"
#include "registration/joint/strip_extents.h"
#include "registration/joint/strip_surfaces.h"

namespace jalon {

namespace {

// Difference of chi-squares from which one of two strips is the wall: a thousand times as likely, as of facades
// (facade_exchange.cpp). With 20 times three strips of 50 streets stood on another's wall.
constexpr double kClear = 14;

constexpr double kBridged_m = 0.5;  // by the loop: beams come 0.2 m beside, as obliquely as they do

double plus_squares(double v, double more) { return v + more * more; }

double sure_part_m(const JointPoints& points, const JointSettings& settings) {
  double variance = points.mean_plan_variance_m2();
  variance = plus_squares(variance, settings.sigma_facade_m);
  variance = plus_squares(variance, settings.sigma_block_x_m);
  return std::sqrt(plus_squares(variance, settings.sigma_block_y_m));
}

double widest_of(const std::vector<StripExtent>& extents) {
  double widest = 0;
  for (const StripExtent& e : extents)
    if (!e.is_empty()) widest = std::max(widest, e.to - e.from);
  return widest;
}

// What was found of each strip: its wall's points from front to back, and their numbers ascending.
struct StripWalls {
  std::vector<std::vector<MetPoint>> points;
  std::vector<std::vector<uint32_t>> numbers;
};

std::vector<uint32_t> numbers_of(const std::vector<MetPoint>& wall) {
  std::vector<uint32_t> made;
  for (const MetPoint& p : wall) made.push_back(p.number);
  std::sort(made.begin(), made.end());
  return made;
}

// wall: not empty.
const MetPoint& middle_of(const std::vector<MetPoint>& wall) { return wall[wall.size() / 2]; }

bool share_one(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();)
    if (*i == *j) return true;
    else if (*i < *j) ++i;
    else ++j;
  return false;
}

class StripSearch {
 public:
  StripSearch(const JointPoints& points, const StripScene& scene, const JointSettings& settings)
      : points_(points),
        scene_(scene),
        settings_(settings),
        cells_(points.at),
        extents_(strip_extents(scene)),
        middles_(strip_middles(scene, extents_)),
        widest_m_(widest_of(extents_)),
        middle_cells_(middles_),
        reach_m_(kMostDeviations * settings.sigma_strip_m),
        least_alignment_(std::cos(settings.greatest_turn_rad)) {}

  /// The points of the strip's wall, from front to back; none where too few are seen.
  std::vector<MetPoint> wall_of(uint32_t s) const {
    if (extents_[s].is_empty()) return {};
    std::vector<MetPoint> wall = points_of_wall(before_and_behind(s));
    if (wall.size() < settings_.least_points) wall.clear();
    return wall;
  }

  /// Most of its wall's points are as likely on a parallel strip, which has no other wall.
  bool is_doubtful(uint32_t s, const StripWalls& walls) const {
    const std::vector<uint32_t> rivals = rivals_of(s, walls);
    size_t shared = 0;
    for (const MetPoint& p : walls.points[s])
      shared += std::any_of(rivals.begin(), rivals.end(),
                            [&](uint32_t rival) { return is_as_likely(rival, p); });
    return 2 * shared > walls.points[s].size();
  }

 private:
  std::vector<MetPoint> before_and_behind(uint32_t s) const {
    const GivenStrip& strip = scene_.strips[s];
    const StripExtent& extent = extents_[s];
    const Vec2 n = strip.normal, h = along(strip);
    std::vector<MetPoint> made;
    Box3 box;
    for (const double by : {reach_m_, -reach_m_ - kBehind_m})
      for (const double to : {extent.from, extent.to}) {
        const Vec2 corner = n * (strip.offset_m + by) + h * to;
        box.add({corner.u, corner.v, 0});
      }
    cells_.each({box.min.x, box.min.y}, {box.max.x, box.max.y}, [&](uint32_t i) {
      const Vec3 &p = points_.at[i], &way = points_.direction[i];
      const double off = n.u * p.x + n.v * p.y - strip.offset_m, level = n.u * way.x + n.v * way.y;
      if (!(level < 0) || off > reach_m_ || off < -reach_m_ - kBehind_m) return;
      const double climb = way.z / -level;
      // Of points that are too far behind it counts where their beams come through the strip.
      const bool is_near = off > -reach_m_;
      const double back = is_near ? 0 : off / level;
      const double place = h.u * (p.x - back * way.x) + h.v * (p.y - back * way.y);
      const double height = p.z - back * way.z;
      if (!extent.contains(place, height)) return;
      const bool is_aligned =
          points_.normal.empty() || std::fabs(dot(points_.normal[i], n)) >= least_alignment_;
      made.push_back({i, off, p.z, climb, is_near && is_aligned});
    });
    return made;
  }

  // Strips that look the same way, whose wall is this one's or none, or farther off than this one may be of them.
  std::vector<uint32_t> rivals_of(uint32_t s, const StripWalls& walls) const {
    std::vector<uint32_t> made;
    const std::vector<uint32_t>& own = walls.numbers[s];
    if (own.empty()) return made;
    const Vec3 mid = middles_[s];
    const double about = 2 * reach_m_ + widest_m_;
    middle_cells_.each(
        {mid.x - about, mid.y - about}, {mid.x + about, mid.y + about}, [&](uint32_t other) {
          if (other == s || dot(scene_.strips[other].normal, scene_.strips[s].normal) < kParallel)
            return;
          const std::vector<uint32_t>& its = walls.numbers[other];
          if (its.empty() || share_one(its, own) || is_nearer_than_its_own(other, s, walls))
            made.push_back(other);
        });
    return made;
  }

  // The wall of a strip, seen from another that looks the same way and was found on a wall of its own.
  bool is_nearer_than_its_own(uint32_t other, uint32_t s, const StripWalls& walls) const {
    const GivenStrip& strip = scene_.strips[other];
    const Vec3& p = points_.at[middle_of(walls.points[s]).number];
    const double off = strip.normal.u * p.x + strip.normal.v * p.y - strip.offset_m;
    return std::fabs(off) < std::fabs(middle_of(walls.points[other]).distance_m);
  }

  // By the prior of the strips alone, the rest being surer.
  bool is_as_likely(uint32_t rival, const MetPoint& met) const {
    const GivenStrip& strip = scene_.strips[rival];
    const StripExtent& extent = extents_[rival];
    const Vec3& p = points_.at[met.number];
    const double place = dot(along(strip), {p.x, p.y});
    if (!extent.contains(place, p.z)) return false;
    const double off = strip.normal.u * p.x + strip.normal.v * p.y - strip.offset_m;
    const double sigma = settings_.sigma_strip_m;
    return std::fabs(off) < reach_m_ &&
           off * off - met.distance_m * met.distance_m < kClear * sigma * sigma;
  }

  const JointPoints& points_;
  const StripScene& scene_;
  const JointSettings& settings_;
  PointCells cells_;
  std::vector<StripExtent> extents_;
  std::vector<Vec3> middles_;
  double widest_m_ = 0;
  PointCells middle_cells_;
  double reach_m_, least_alignment_;
};

}  // namespace

bool is_strip_search_wanted(const JointPoints& points, const JointSettings& settings) {
  constexpr double kSurer = 3;  // the rest must be so much surer
  const double reach = greatest_deviation(settings) * settings.sigma_strip_m;
  return reach > kBridged_m && settings.sigma_strip_m > kSurer * sure_part_m(points, settings);
}

bool FoundStrips::is_elsewhere(uint32_t strip, double offset_m) const {
  return is_searched && std::fabs(offset_m - offsets_m[strip]) > kBridged_m;
}

FoundStrips find_strips(const JointPoints& points, const StripScene& scene,
                        const JointSettings& settings, Task& task) {
  const size_t n = scene.strips.size();
  FoundStrips made{std::vector<double>(n, 0), std::vector<bool>(n, false),
                   is_strip_search_wanted(points, settings)};
  if (!made.is_searched) return made;
  const StripSearch search(points, scene, settings);
  StripWalls walls{std::vector<std::vector<MetPoint>>(n), std::vector<std::vector<uint32_t>>(n)};
  std::vector<uint8_t> is_doubtful(n, 0);
  constexpr size_t kStripsGrain = 64;
  parallel_for(task, n, kStripsGrain, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) {
      walls.points[s] = search.wall_of(static_cast<uint32_t>(s));
      walls.numbers[s] = numbers_of(walls.points[s]);
    }
  });
  parallel_for(task, n, kStripsGrain, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      is_doubtful[s] = search.is_doubtful(static_cast<uint32_t>(s), walls);
  });
  const double accepted_m = greatest_deviation(settings) * settings.sigma_strip_m;
  for (size_t s = 0; s < n; ++s) {
    const std::vector<MetPoint>& wall = walls.points[s];
    const double offset_m = wall.empty() ? 0 : middle_of(wall).distance_m;
    made.is_doubtful[s] = is_doubtful[s] != 0 || std::fabs(offset_m) > accepted_m;
    if (!made.is_doubtful[s]) made.offsets_m[s] = offset_m;
  }
  return made;
}

}  // namespace jalon
