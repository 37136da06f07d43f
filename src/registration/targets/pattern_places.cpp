// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/pattern_places.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr int kDeepestSearch = 20;      // of the tree, which has 21 levels
constexpr double kSearchSteps = 4;      // places in a pattern's size
constexpr double kCheckerReach = 0.45;  // of a checker's edge: what its quadrants surely fill
constexpr double kDiscReach = 0.75;     // of a disc's diameter: half as much again shows its ground
// So much is left of a noisy pattern half a step beside its centre; of a disc also when it is larger than looked for.
constexpr double kLeastCheckerLikeness = 0.3, kLeastDiscLikeness = 0.25;
// First the means of cells are looked at, so many of them in the reach, where a cell has so many points: so few cells
// may be in the reach of a place on an edge.
constexpr double kCellsInReach = 3, kLeastThinning = 1.5;
constexpr uint64_t kLeastCells = 8;
// Of the least likeness, what the means must have: cells across a pattern's edges blur it, and others have less noise
// than points. On the developed walls 0.2 to 0.5 leave out the same few places, and no target.
constexpr double kLeastOfMeans = 0.4;
constexpr size_t kMostSpots = 400;  // looked at of a place: they tell whether it is worth measuring
constexpr int kCoarser = 2;         // levels: a coarse cell is about a pattern's size
constexpr double kLeastOfCell = 4;  // points whose scatter tells of noise
constexpr double kLeastContrast = 2;  // noises: less is not looked at
constexpr size_t kCellsAtOnce = 64;
constexpr const char* kMeanField = "mean";
// Of a size: nearer places are of one pattern. The place nearest to a centre may be half a cell off it, and a corner of
// the sheet, half a size from it, more alike.
constexpr double kApart = 0.3;

struct Spot {
  double u, v, value;
  Vec2 doubled;  ///< cos and sin of twice the angle about the place
};

Vec2 doubled_direction(double u, double v) {
  const double r2 = u * u + v * v;
  return r2 > 0 ? Vec2{(u * u - v * v) / r2, 2 * u * v / r2} : Vec2{};
}

// Squared correlation of the brightness with the sign of cos(2 angle - turn), at the turn of the
// second harmonic.
double checker_likeness(std::vector<Spot>& spots, double mean, double squares) {
  Vec2 sum;
  for (Spot& s : spots) {
    s.doubled = doubled_direction(s.u, s.v);
    sum.u += (s.value - mean) * s.doubled.u, sum.v += (s.value - mean) * s.doubled.v;
  }
  double with = 0, signs = 0;
  for (const Spot& s : spots) {
    const double sign = s.doubled.u * sum.u + s.doubled.v * sum.v > 0 ? 1 : -1;
    with += sign * (s.value - mean), signs += sign;
  }
  const auto n = static_cast<double>(spots.size());
  const double spread = n - signs * signs / n;
  return spread > 0 ? with * with / (spread * squares) : 0;
}

double disc_likeness(const std::vector<Spot>& spots, double mean, double squares, double radius_m) {
  double inside = 0, with = 0;
  for (const Spot& s : spots)
    if (s.u * s.u + s.v * s.v < radius_m * radius_m) ++inside, with += s.value - mean;
  const auto n = static_cast<double>(spots.size());
  const double spread = inside - inside * inside / n;
  return spread > 0 ? with * with / (spread * squares) : 0;
}

double reach_of(TargetKind kind, double size_m) {
  return (kind == TargetKind::kChecker ? kCheckerReach : kDiscReach) * size_m;
}

class Looking {
 public:
  Looking(const Cloud& cloud, const Octree& tree, const Column& intensity, TargetKind kind,
          double size_m, double tolerance_m, uint64_t min_points)
      : cloud_(cloud),
        tree_(tree),
        intensity_(intensity),
        kind_(kind),
        size_m_(size_m),
        tolerance_m_(tolerance_m),
        min_points_(min_points) {}

  double likeness_at(const Vec3& place, std::vector<Neighbour>& near,
                     std::vector<Spot>& spots) const {
    tree_.radius_positions(place, reach_of(kind_, size_m_), near);
    if (near.size() < min_points_) return 0;
    const size_t stride = near.size() / kMostSpots + 1;
    Moments moments;
    moments.reference = place;
    const auto order = tree_.order();
    for (size_t i = 0; i < near.size(); i += stride)
      moments.add(cloud_.point(order[near[i].index]));
    PlaneFit fit;
    if (!fit_plane(moments, fit)) return 0;
    spots.clear();
    double mean = 0, squares = 0;
    for (size_t i = 0; i < near.size(); i += stride) {
      const uint32_t index = order[near[i].index];
      const Vec3 d = cloud_.point(index) - place;
      const double value = intensity_.number(index), off = fit.plane.distance(place + d);
      if (std::fabs(off) > tolerance_m_ || !std::isfinite(value)) continue;
      spots.push_back({dot(d, fit.axis_u), dot(d, fit.axis_v), value, {}});
      mean += value;
    }
    if (spots.size() < std::min<size_t>(min_points_, kMostSpots / 2)) return 0;
    mean /= static_cast<double>(spots.size());
    for (const Spot& s : spots) squares += (s.value - mean) * (s.value - mean);
    if (!(squares > 0)) return 0;
    return kind_ == TargetKind::kChecker ? checker_likeness(spots, mean, squares)
                                         : disc_likeness(spots, mean, squares, size_m_ / 2);
  }

 private:
  const Cloud& cloud_;
  const Octree& tree_;
  const Column& intensity_;
  TargetKind kind_;
  double size_m_, tolerance_m_;
  uint64_t min_points_;
};

void look(const Looking& looking, std::vector<PatternPlace>& places, Task& task) {
  parallel_for(task, places.size(), kCellsAtOnce, [&](size_t begin, size_t end) {
    std::vector<Neighbour> near;
    std::vector<Spot> spots;
    for (size_t i = begin; i < end; ++i)
      places[i].likeness = looking.likeness_at(places[i].place, near, spots);
  });
}

int level_of(const Cube& cube, double edge_m) {
  int level = 0;
  while (level < kDeepestSearch && std::ldexp(cube.edge, -level) > edge_m) ++level;
  return level;
}

Vec3 centre_of(const Cloud& cloud, std::span<const uint32_t> points) {
  const Vec3 origin = cloud.point(points[0]);
  Vec3 sum;
  for (const uint32_t index : points) sum += cloud.point(index) - origin;
  return origin + sum / static_cast<double>(points.size());
}

struct CellBrightness {
  double n = 0, sum = 0, squares = 0;
  double mean() const { return n > 0 ? sum / n : NAN; }
  double variance() const { return std::max(0.0, squares / n - mean() * mean()) * n / (n - 1); }
};

CellBrightness brightness_of(const Column& intensity, std::span<const uint32_t> points) {
  CellBrightness out;
  for (const uint32_t index : points)
    if (const double value = intensity.number(index); std::isfinite(value))
      ++out.n, out.sum += value, out.squares += value * value;
  return out;
}

// One point for each cell, with the mean of the brightness.
Cloud means_of_cells(const Cloud& cloud, const Octree& tree, const std::vector<Octree::Cell>& cells,
                     const Column& intensity) {
  Buffer<double> xyz(3 * cells.size());
  std::vector<double> values(cells.size());
  for (size_t i = 0; i < cells.size(); ++i) {
    const auto points = tree.order().subspan(cells[i].first, cells[i].count);
    const Vec3 centre = centre_of(cloud, points);
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = centre[k];
    values[i] = brightness_of(intensity, points).mean();
  }
  Cloud out = make_cloud(std::move(xyz));
  out.fields.set(make_column<double>({.name = kMeanField}, values));
  return out;
}

// Which coarse cells have, with those around them, cells of clearly different brightness: most of a wall has not.
// A cell of one point tells nothing of noise; where all are, all are looked at.
class Contrasts {
 public:
  Contrasts(const Octree& tree, const std::vector<Octree::Cell>& cells, int level,
            const Column& intensity, Task& task)
      : coarse_(tree.cells(std::max(0, level - kCoarser), task)),
        shift_(3 * std::min(level, kCoarser)) {
    std::vector<double> means(cells.size()), noises;
    for (size_t i = 0; i < cells.size(); ++i) {
      const CellBrightness cell =
          brightness_of(intensity, tree.order().subspan(cells[i].first, cells[i].count));
      means[i] = cell.mean();
      if (cell.n >= kLeastOfCell) noises.push_back(std::sqrt(cell.variance()));
    }
    std::vector<std::pair<double, double>> range(coarse_.size(), {INFINITY, -INFINITY});
    for (size_t i = 0; i < cells.size(); ++i) {
      auto& [low, high] = range[place_of(cells[i])];
      low = std::min(low, means[i]), high = std::max(high, means[i]);
    }
    double least = 0;
    if (!noises.empty()) {
      const auto middle = noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 2);
      std::nth_element(noises.begin(), middle, noises.end());
      least = kLeastContrast * *middle;
    }
    for (size_t i = 0; i < coarse_.size(); ++i) {
      auto [low, high] = range[i];
      for (const uint64_t code :
           tree.neighbour_cells(std::max(0, level - kCoarser), coarse_[i].code, 1)) {
        const auto& [other_low, other_high] = range[index_of(code)];
        low = std::min(low, other_low), high = std::max(high, other_high);
      }
      has_contrast_.push_back(high - low > least);
    }
  }

  bool around(const Octree::Cell& cell) const { return has_contrast_[place_of(cell)]; }

 private:
  size_t index_of(uint64_t code) const {
    const auto at = std::lower_bound(coarse_.begin(), coarse_.end(), code,
                                     [](const Octree::Cell& c, uint64_t v) { return c.code < v; });
    return static_cast<size_t>(at - coarse_.begin());
  }
  size_t place_of(const Octree::Cell& cell) const { return index_of(cell.code >> shift_); }

  std::vector<Octree::Cell> coarse_;
  int shift_;
  std::vector<bool> has_contrast_;
};

// The most alike of places that are near each other. Ties by the order of the tree.
std::vector<PatternPlace> best_of(std::vector<PatternPlace> places) {
  std::stable_sort(places.begin(), places.end(), [](const PatternPlace& a, const PatternPlace& b) {
    return a.likeness > b.likeness;
  });
  if (places.empty()) return places;
  Buffer<double> xyz(3 * places.size());
  Box3 box;
  for (size_t i = 0; i < places.size(); ++i) {
    box.add(places[i].place);
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = places[i].place[k];
  }
  Task task;
  const auto tree = Octree::build(xyz, enclosing_cube(box), task);
  std::vector<bool> is_gone(places.size());
  std::vector<PatternPlace> out;
  std::vector<Neighbour> near;
  for (size_t i = 0; i < places.size(); ++i) {
    if (is_gone[i]) continue;
    out.push_back(places[i]);
    tree->radius(places[i].place, kApart * places[i].size_m, near);
    for (const Neighbour& n : near) is_gone[n.index] = true;
  }
  return out;
}

}  // namespace

std::vector<PatternPlace> pattern_places(const Cloud& cloud, const Octree& tree,
                                         const Column& intensity, TargetKind kind, double size_m,
                                         double tolerance_m, uint64_t min_points, Task& task) {
  const int level = level_of(tree.cube(), size_m / kSearchSteps);
  auto cells = tree.cells(level, task);
  const Contrasts contrasts(tree, cells, level, intensity, task);
  std::erase_if(cells, [&](const Octree::Cell& c) { return !contrasts.around(c); });
  std::vector<PatternPlace> all(cells.size());
  for (size_t i = 0; i < cells.size(); ++i) {
    const auto points = tree.order().subspan(cells[i].first, cells[i].count);
    all[i] = {centre_of(cloud, points), kind, size_m, 0};
  }
  const double least = kind == TargetKind::kChecker ? kLeastCheckerLikeness : kLeastDiscLikeness;
  const int fine = level_of(tree.cube(), reach_of(kind, size_m) / kCellsInReach);
  const auto fine_cells = tree.cells(fine, task);
  if (static_cast<double>(fine_cells.size()) * kLeastThinning < static_cast<double>(cloud.size())) {
    const Cloud means = means_of_cells(cloud, tree, fine_cells, intensity);
    const auto means_tree = means.octree(task);
    look({means, *means_tree, *means.fields.find(kMeanField), kind, size_m, tolerance_m,
          kLeastCells},
         all, task);
    std::erase_if(all, [&](const PatternPlace& p) { return p.likeness < kLeastOfMeans * least; });
  }
  look({cloud, tree, intensity, kind, size_m, tolerance_m, min_points}, all, task);
  std::erase_if(all, [&](const PatternPlace& p) { return p.likeness < least; });
  return best_of(std::move(all));
}

}  // namespace jalon
