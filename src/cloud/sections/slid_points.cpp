// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/slid_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/serial.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr size_t kSlidPerLook = 1 << 12;
constexpr size_t kCellsOfLook = 1 << 8;  // with a plane each
constexpr double kSlideCells = 2;        // thicknesses: so that a lean shows beside the noise
constexpr uint64_t kSlideLeast = 12;     // points of a plane
// Of the tolerance, which is four sigma of the points: what one surface leaves at most (rms).
constexpr double kSurfaceShare = 0.35;
// Reached for where the planes next to a point, by a corner, have another surface in them.
constexpr int64_t kFarCells = 2;
constexpr double kLeanSigmas = 4;   // below them the lean is that of the noise
constexpr double kFlattest = 0.94;  // |cosine| of 20 degrees to the section: a face, not a line
constexpr double kFarthestCell = 0x1p60;  // beyond, doubles tell no neighbours apart

using Cell = std::pair<int64_t, int64_t>;

// What lies on a plane u d = offset + lean w, d being across its trace in the section.
struct LeaningPlane {
  Vec2 across;
  double offset = 0;
  double lean = 0, lean_sigma = 0;  ///< metres across the trace for each metre off the section
  double off(const Vec3& p) const { return across.u * p.x + across.v * p.y - offset - lean * p.z; }
};

class Slider {
 public:
  Slider(std::span<const Vec3> points, double thickness_m, double tolerance_m, Task& task)
      : points_(points), cell_m_(kSlideCells * thickness_m), tolerance_m_(tolerance_m) {
    serial_for(task, points_.size(), kSlidPerLook, [&](size_t begin, size_t end) {
      for (const Vec3& p : points_.subspan(begin, end - begin)) {
        Moments& own =
            sums_.try_emplace(cell_at(p), Moments{points_.front(), 0, {}, {}}).first->second;
        own.add(p);
      }
    });
    size_t done = 0;
    for (const auto& [cell, own] : sums_) {
      if (done++ % kCellsOfLook == 0) task.checkpoint(0);
      add_plane(cell);
    }
  }

  // Along the surface whose lean is known best: those by corners have points of another in them.
  Vec2 slid(const Vec3& p) const {
    const LeaningPlane* best = nullptr;
    for (int64_t reach = 1; reach <= kFarCells && best == nullptr; ++reach)
      for_each_about(planes_, cell_at(p), reach, [&](const LeaningPlane& plane) {
        if (std::fabs(plane.off(p)) > tolerance_m_) return;
        if (best == nullptr || plane.lean_sigma < best->lean_sigma) best = &plane;
      });
    return best == nullptr ? Vec2{p.x, p.y} : Vec2{p.x, p.y} - best->across * (best->lean * p.z);
  }

 private:
  Cell cell_at(const Vec3& p) const {
    const auto number = [&](double at) {
      return static_cast<int64_t>(
          std::clamp(std::floor(at / cell_m_), -kFarthestCell, kFarthestCell));
    };
    return {number(p.x), number(p.y)};
  }

  template <class T, class F>
  static void for_each_about(const std::map<Cell, T>& of, const Cell& cell, int64_t reach,
                             F&& use) {
    for (int64_t u = -reach; u <= reach; ++u)
      for (int64_t v = -reach; v <= reach; ++v)
        if (const auto found = of.find({cell.first + u, cell.second + v}); found != of.end())
          use(found->second);
  }

  void add_plane(const Cell& cell) {
    Moments sum{points_.front(), 0, {}, {}};
    for_each_about(sums_, cell, 1, [&](const Moments& some) { sum += some; });
    PlaneFit fit;
    if (sum.n < kSlideLeast || !fit_plane(sum, fit) || fit.sigma > kSurfaceShare * tolerance_m_)
      return;
    const Vec3& n = fit.plane.normal;
    const double upright = std::hypot(n.x, n.y);
    if (std::fabs(n.z) > kFlattest) return;
    LeaningPlane plane;
    plane.across = {n.x / upright, n.y / upright};
    plane.lean = -n.z / upright;
    plane.offset = fit.plane.offset / upright;
    const double spread = std::sqrt(sum.covariance()[5] * static_cast<double>(sum.n));
    plane.lean_sigma = fit.sigma / (upright * spread);
    if (std::fabs(plane.lean) < kLeanSigmas * plane.lean_sigma) plane.lean = 0;
    planes_.emplace(cell, plane);
  }

  std::span<const Vec3> points_;
  double cell_m_, tolerance_m_;
  std::map<Cell, Moments> sums_;
  std::map<Cell, LeaningPlane> planes_;
};

}  // namespace

std::vector<Vec2> slid_points(std::vector<Vec3> points, double thickness_m, double tolerance_m,
                              Task& task) {
  std::vector<Vec2> out;
  if (points.empty()) return out;
  serial_sort(task, points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  const Slider slider(points, thickness_m, tolerance_m, task);
  out.reserve(points.size());
  serial_for(task, points.size(), kSlidPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out.push_back(slider.slid(points[i]));
  });
  return out;
}

}  // namespace jalon
