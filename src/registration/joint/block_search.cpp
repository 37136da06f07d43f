// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/block_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "registration/joint/point_cells.h"

namespace jalon {

namespace {

// Standard deviations. Of a city's thousands of blocks some are off by four; one that is not found is lost.
constexpr double kReach = 5;
constexpr double kWithin = 3;  // and of points that stand on a wall
// A coarse place in the grid is this far from the next: fronts step and end walls stand apart by more. A wide prior
// has a coarser grid instead of ever more places.
constexpr double kCoarse_m = 0.5;
constexpr int kMostSteps = 20;  // to each side
constexpr size_t kCoarsePoints = 200, kFinePoints = 400, kKept = 16;
constexpr double kThrough = 0.5;  // what a beam through a wall counts against one that ends on it

double square(double v) { return v * v; }

// Of a point off its wall, blocks aside.
double rest_m(const JointPoints& points, const JointSettings& settings) {
  return std::sqrt(points.mean_plan_variance_m2() + square(settings.sigma_facade_m) +
                   square(settings.sigma_strip_m));
}

struct Place {
  Vec2 by;
  double score = 0;
};
bool is_better(const Place& a, const Place& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.by.u != b.by.u ? a.by.u < b.by.u : a.by.v < b.by.v;
}

// What each block asks for, found once for all of them: a city has thousands.
struct BlockParts {
  std::vector<std::vector<uint32_t>> triangles;  ///< of each block
  PointCells points;

  BlockParts(const JointPoints& of, const StripScene& scene)
      : triangles(scene.blocks), points(of.at) {
    for (uint32_t t = 0; t < scene.face_of.size(); ++t)
      if (const uint32_t block = scene.block_of_face[scene.face_of[t]]; block != kNoStrip)
        triangles[block].push_back(t);
  }
};

class BlockSearch {
 public:
  BlockSearch(const JointPoints& points, const StripScene& scene, const BlockParts& parts,
              const JointSettings& settings, uint32_t block, Task& task)
      : points_(points),
        scene_(scene),
        settings_(settings),
        task_(task),
        least_alignment_(std::cos(settings.greatest_turn_rad)),
        least_tolerance_m_(kWithin * rest_m(points, settings)) {
    std::vector<Vec3> corners;
    std::vector<std::array<uint32_t, 3>> triangles;
    for (const uint32_t t : parts.triangles[block]) {
      const auto first = static_cast<uint32_t>(corners.size());
      for (uint32_t k = 0; k < 3; ++k) corners.push_back(scene.corners[3 * size_t{t} + k]);
      triangles.push_back({first, first + 1, first + 2});
      strips_.push_back(scene.strip_of_face[scene.face_of[t]]);
    }
    if (triangles.empty()) return;
    tree_ = TriangleTree::build(corners, triangles, task);
    find_near(corners, parts.points);
  }

  Vec2 found() const {
    // Fewer points than a strip needs say nothing of a block.
    if (near_.size() < settings_.least_points) return {};
    double step = 0;
    std::vector<Place> places = coarse(step);
    while (step > least_tolerance_m_ / 2) {
      step /= 2;
      places = finer(places, step);
    }
    return places.front().by;
  }

 private:
  void find_near(const std::vector<Vec3>& corners, const PointCells& cells) {
    Box3 box;
    for (const Vec3& c : corners) box.add(c);
    const Vec2 about{kReach * settings_.sigma_block_x_m, kReach * settings_.sigma_block_y_m};
    const Vec2 low = Vec2{box.min.x, box.min.y} - about, high = Vec2{box.max.x, box.max.y} + about;
    cells.each(low, high, [&](uint32_t i) {
      const Vec3& p = points_.at[i];
      if (p.x > low.u && p.x < high.u && p.y > low.v && p.y < high.v) near_.push_back(i);
    });
    std::sort(near_.begin(), near_.end());
  }

  // 1. All places of a grid, by few points.
  std::vector<Place> coarse(double& step) const {
    const double x = kReach * settings_.sigma_block_x_m, y = kReach * settings_.sigma_block_y_m;
    step = std::max(kCoarse_m, std::max(x, y) / kMostSteps);
    const int nx = static_cast<int>(x / step), ny = static_cast<int>(y / step);
    std::vector<Place> places;
    for (int i = -nx; i <= nx; ++i)
      for (int j = -ny; j <= ny; ++j) places.push_back({{i * step, j * step}, 0});
    return best_of(std::move(places), step, kCoarsePoints);
  }

  // 2. About the best, half a step to each side.
  std::vector<Place> finer(const std::vector<Place>& about, double step) const {
    std::vector<Place> places;
    for (const Place& at : about)
      for (const int i : {-1, 0, 1})
        for (const int j : {-1, 0, 1}) places.push_back({at.by + Vec2{i * step, j * step}, 0});
    const auto is_before = [](const Place& a, const Place& b) {
      return a.by.u != b.by.u ? a.by.u < b.by.u : a.by.v < b.by.v;
    };
    std::sort(places.begin(), places.end(), is_before);
    const auto is_same = [](const Place& a, const Place& b) {
      return a.by.u == b.by.u && a.by.v == b.by.v;
    };
    places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
    return best_of(std::move(places), step, kFinePoints);
  }

  std::vector<Place> best_of(std::vector<Place> places, double step, size_t most_points) const {
    const double tolerance = std::max(step, least_tolerance_m_);
    const size_t every = (near_.size() + most_points - 1) / most_points;
    constexpr size_t kPlacesGrain = 8;
    parallel_for(task_, places.size(), kPlacesGrain, [&](size_t begin, size_t end) {
      for (size_t k = begin; k < end; ++k)
        places[k].score = score(places[k].by, tolerance, every) - improbability(places[k].by);
    });
    std::sort(places.begin(), places.end(), is_better);
    if (places.size() > kKept) places.resize(kKept);
    return places;
  }

  double improbability(const Vec2& by) const {
    return (square(by.u / settings_.sigma_block_x_m) + square(by.v / settings_.sigma_block_y_m)) /
           2;
  }

  double score(const Vec2& by, double tolerance_m, size_t every) const {
    double sum = 0;
    for (size_t k = 0; k < near_.size(); k += every) sum += score_of(near_[k], by, tolerance_m);
    return sum;
  }

  // 1 for a beam that ends on the wall that it meets, less the farther from it; nothing for one that ends before it.
  double score_of(uint32_t i, const Vec2& by, double tolerance_m) const {
    const Vec3 shift{by.u, by.v, 0};
    const Vec3& way = points_.direction[i];
    RayHit hit;
    if (!tree_->nearest({points_.origin[i] - shift, way}, hit)) return 0;
    const uint32_t number = strips_[hit.triangle];
    if (number == kNoStrip) return 0;
    const GivenStrip& strip = scene_.strips[number];
    const Vec3 p = points_.at[i] - shift;
    const double off = strip.normal.u * p.x + strip.normal.v * p.y - strip.offset_m;
    if (!(strip.normal.u * way.x + strip.normal.v * way.y < 0) || off > tolerance_m) return 0;
    if (off < -tolerance_m) return -kThrough;
    if (!points_.normal.empty() &&
        std::fabs(dot(points_.normal[i], strip.normal)) < least_alignment_)
      return 0;
    return 1 - square(off / tolerance_m);
  }

  const JointPoints& points_;
  const StripScene& scene_;
  const JointSettings& settings_;
  Task& task_;
  double least_alignment_, least_tolerance_m_;
  std::shared_ptr<const TriangleTree> tree_;
  std::vector<uint32_t> strips_, near_;  ///< of each triangle; points
};

}  // namespace

bool is_block_search_wanted(const JointPoints& points, const JointSettings& settings) {
  const double least = std::min(settings.sigma_block_x_m, settings.sigma_block_y_m);
  constexpr double kSurer = 3;  // the rest must be so much surer
  return kReach * least > kCoarse_m && least > kSurer * rest_m(points, settings);
}

std::vector<Vec2> find_blocks(const JointPoints& points, const StripScene& scene,
                              const JointSettings& settings, Task& task) {
  std::vector<Vec2> made(scene.blocks);
  if (!is_block_search_wanted(points, settings)) return made;
  const BlockParts parts(points, scene);
  for (uint32_t b = 0; b < scene.blocks; ++b)
    made[b] = BlockSearch(points, scene, parts, settings, b, task).found();
  return made;
}

}  // namespace jalon
