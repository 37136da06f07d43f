// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/normals.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "geometry/symmetric_eigen.h"
#include "spatial/neighbours/many_in_ball.h"

namespace jalon {

namespace {

using Kind = M3c2Settings::Normals;

// The first point that no station with a pose covers; size() if there is none.
uint64_t first_without_pose(const Cloud& cloud) {
  uint64_t covered = 0;
  for (const Station& station : cloud.stations) {
    if (station.count == 0) continue;
    if (station.first > covered || !station.has_pose) break;
    covered = station.first + station.count;
  }
  return covered;
}

ColumnPtr require_given_normals(const Cloud& core) {
  ColumnPtr column = core.fields.find_shared("normal");
  if (!column) fail(Status::kNotFound, "normals = given: the core points have no field \"normal\"");
  if (column->info().components != 3 || !is_floating(column->info().type))
    fail(Status::kInvalidArgument,
         "normals = given: field \"normal\" does not hold 3 floating-point numbers a point");
  return column;
}

Vec3 vec_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// Scatter of the points no farther than a distance from the core point, about their mean.
struct Scatter {
  size_t count = 0;
  Symmetric3 matrix{};
};
void about_mean(const Vec3& sum, Scatter& out) {
  if (out.count == 0) return;
  Symmetric3& m = out.matrix;
  const Vec3 mean = sum / static_cast<double>(out.count);
  m[0] -= sum.x * mean.x, m[1] -= sum.x * mean.y, m[2] -= sum.x * mean.z;
  m[3] -= sum.y * mean.y, m[4] -= sum.y * mean.z, m[5] -= sum.z * mean.z;
}
Scatter scatter_within(std::span<const Vec3> offsets, std::span<const double> squared_m2,
                       double limit_m2) {
  Scatter out;
  Vec3 sum;
  Symmetric3& m = out.matrix;
  for (size_t i = 0; i < offsets.size(); ++i) {
    if (squared_m2[i] > limit_m2) continue;
    const Vec3& d = offsets[i];
    ++out.count;
    sum += d;
    m[0] += d.x * d.x, m[1] += d.x * d.y, m[2] += d.x * d.z;
    m[3] += d.y * d.y, m[4] += d.y * d.z, m[5] += d.z * d.z;
  }
  about_mean(sum, out);
  return out;
}

// The same of points that are summed already.
Scatter scatter_of(const PowerSums<2>& sums) {
  Scatter out;
  out.count = static_cast<size_t>(sums.count());
  out.matrix = {sums.of(2, 0, 0), sums.of(1, 1, 0), sums.of(1, 0, 1),
                sums.of(0, 2, 0), sums.of(0, 1, 1), sums.of(0, 0, 2)};
  about_mean({sums.of(1, 0, 0), sums.of(0, 1, 0), sums.of(0, 0, 1)}, out);
  return out;
}

/// The plane of least surface variation of those offered, the first on a tie.
struct FlattestBall {
  CoreNormals::Normal normal;
  double least = std::numeric_limits<double>::infinity();

  void offer(const Scatter& scatter, double radius_m) {
    if (scatter.count < 3) return;
    const Eigen3 e = symmetric_eigen(scatter.matrix);
    constexpr double kLine =
        1e-12;  // the second eigenvalue of points on a line is what rounding leaves of the largest
    if (!(e.values[1] > kLine * e.values[2])) return;
    const double variation = std::max(0.0, e.values[0]) / (e.values[0] + e.values[1] + e.values[2]);
    if (!(variation < least)) return;
    least = variation;
    normal = {e.vectors[0], radius_m, true};
  }
};

}  // namespace

CoreNormals::CoreNormals(const M3c2Settings& settings, const CloudPtr& source, const CloudPtr& core,
                         Task& task)
    : kind_(settings.normals),
      orientation_(settings.orientation),
      radii_m_(settings.radii_m()),
      direction_(vec_of(settings.orientation_direction)),
      viewpoint_(vec_of(settings.viewpoint)),
      source_(source),
      core_(core) {
  if (settings.normals == Kind::kGiven) given_ = require_given_normals(*core);
  if (settings.normals == Kind::kGiven || settings.normals == Kind::kVertical) return;
  using Orientation = M3c2Settings::Orientation;
  const uint64_t without_pose = first_without_pose(*source);
  if (settings.orientation == Orientation::kStation && without_pose < source->size())
    fail(Status::kInvalidArgument,
         "orientation = station: point %llu of the cloud that gives the normals has no station "
         "with a known pose",
         static_cast<unsigned long long>(without_pose));
  by_station_ = settings.orientation == Orientation::kStation ||
                (settings.orientation == Orientation::kAutomatic && without_pose == source->size());
  tree_ = source->octree(task);
  if (tree_->has_crowds()) sums_.emplace(*tree_, task);
}

CoreNormals::Work CoreNormals::work() const {
  Work work;
  if (tree_) work.search = std::make_unique<ShapeSearch>(*tree_);
  if (sums_)
    for (const double radius_m : radii_m_) work.balls.emplace_back(tree_->impl(), radius_m);
  return work;
}

CoreNormals::Normal CoreNormals::at(size_t core_point, Work& work) const {
  if (kind_ == Kind::kVertical) return {{0, 0, 1}, 0, true};
  if (kind_ == Kind::kGiven) {
    const Vec3 n = normalized(given(core_point));
    return {n, 0, is_finite(n) && n != Vec3{}};
  }
  const Vec3 centre = core_->point(core_point);
  Normal normal = plane_at(centre, work);
  if (!normal.known) return normal;
  if (kind_ == Kind::kHorizontal) {
    normal.direction = normalized({normal.direction.x, normal.direction.y, 0});
    if (normal.direction == Vec3{}) return {};
  }
  normal.direction = oriented(centre, normal.direction, work);
  return normal;
}

Vec3 CoreNormals::given(size_t core_point) const {
  return {given_->number(core_point, 0), given_->number(core_point, 1),
          given_->number(core_point, 2)};
}

// Does the largest ball hold so many points that they are not looked at one by one?
bool CoreNormals::are_many_at(const Vec3& centre, Work& work) const {
  if (!sums_) return false;
  work.balls.back().find(centre);
  return work.balls.back().points() > kManyInRanges;
}

CoreNormals::Normal CoreNormals::plane_of_ranges(const Vec3& centre, Work& work) const {
  FlattestBall best;
  for (size_t r = 0; r < radii_m_.size(); ++r)
    best.offer(scatter_of(sums_->over(work.balls[r].find(centre), centre)), radii_m_[r]);
  return best.normal;
}

// Of the radii given the one whose points have the least surface variation, the smallest on a tie.
CoreNormals::Normal CoreNormals::plane_at(const Vec3& centre, Work& work) const {
  if (are_many_at(centre, work)) return plane_of_ranges(centre, work);
  const auto offsets = work.search->ball(centre, radii_m_.back());
  work.squared_m2.resize(offsets.size());
  for (size_t i = 0; i < offsets.size(); ++i) work.squared_m2[i] = squared_norm(offsets[i]);
  FlattestBall best;
  for (const double radius_m : radii_m_)
    best.offer(scatter_within(offsets, work.squared_m2, radius_m * radius_m), radius_m);
  return best.normal;
}

uint32_t CoreNormals::nearest_position(const Vec3& centre, Work& work) const {
  if (are_many_at(centre, work))
    return tree_->impl().nearest_position(centre, radii_m_.back() * radii_m_.back());
  const auto nearest = std::min_element(work.squared_m2.begin(), work.squared_m2.end());
  return work.search->ball_positions()[static_cast<size_t>(nearest - work.squared_m2.begin())];
}

Vec3 CoreNormals::oriented(const Vec3& centre, Vec3 normal, Work& work) const {
  Vec3 toward = direction_;
  if (orientation_ == M3c2Settings::Orientation::kPoint) {
    toward = viewpoint_ - centre;
  } else if (by_station_) {
    const uint32_t position = nearest_position(centre, work);
    toward = station_of(*source_, tree_->order()[position])->pose.translation() - centre;
  }
  return dot(toward, normal) < 0 ? -normal : normal;
}

}  // namespace jalon
