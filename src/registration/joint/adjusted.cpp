// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/adjusted.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/rigid_motion.h"
#include "registration/joint/attitude_bias.h"
#include "registration/joint/beam_fields.h"

namespace jalon {

namespace {

// Of the position; heights that were not adjusted keep what they were given.
Vec3 sigmas_at(const JointAdjustment& adjustment, const TimePlace& at, double height_before_m) {
  const auto& s = adjustment.trajectory_sigmas;
  const Vec2 plan = s[at.epoch] * (1 - at.share) + s[at.epoch + 1] * at.share;
  return {plan.u, plan.v,
          adjustment.ground.empty() ? height_before_m : adjustment.height_sigma_at(at)};
}

template <class T>
std::shared_ptr<Column> copy_of(const Column& column) {
  auto made = std::make_shared<Column>(column.info(), column.count());
  std::ranges::copy(column.values<T>(), made->template values<T>().begin());
  return made;
}

// A field of this type and width, as a column of its own that may be changed; nullptr without.
template <class T>
std::shared_ptr<Column> own_column(const Cloud& cloud, const char* name, uint32_t components) {
  const Column* column = cloud.fields.find(name);
  const bool is_it = column != nullptr && column->info().type == element_type_of<T>() &&
                     column->info().components == components;
  return is_it ? copy_of<T>(*column) : nullptr;
}

// What moves with the points of a drive.
struct MovedColumns {
  Buffer<double> xyz;
  std::shared_ptr<Column> origin, direction, covariance, sigma;

  MovedColumns(const Cloud& cloud)
      : xyz(3 * cloud.size()),
        origin(own_column<double>(cloud, "beam_origin", 3)),
        direction(own_column<float>(cloud, "beam_direction", 3)),
        covariance(own_column<float>(cloud, "covariance", 6)),
        sigma(own_column<float>(cloud, "point_sigma", 1)) {
    std::ranges::copy(cloud.xyz(), xyz.data());
  }
  // About where the inertial unit was, before anything is moved.
  void turn(size_t i, const Vec3& centre, const Transform& by) {
    const auto about = [&](double* p) {
      const Vec3 to = centre + by.direction(Vec3{p[0], p[1], p[2]} - centre);
      p[0] = to.x, p[1] = to.y, p[2] = to.z;
    };
    about(xyz.data() + 3 * i);
    if (origin != nullptr) about(origin->values<double>().data() + 3 * i);
    if (direction == nullptr) return;
    float* d = direction->values<float>().data() + 3 * i;
    const Vec3 to = by.direction({double{d[0]}, double{d[1]}, double{d[2]}});
    for (int k = 0; k < 3; ++k) d[k] = static_cast<float>(to[k]);
  }
  void move(size_t i, const Vec3& by) {
    for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] += by[static_cast<int>(k)];
    if (origin == nullptr) return;
    double* o = origin->values<double>().data() + 3 * i;
    for (int k = 0; k < 3; ++k) o[k] += by[k];
  }
  // Takes the trajectory's variances out and puts others in; what else a point has stays, 0 at least.
  void exchange(size_t i, const Vec3& before, const Vec3& now) {
    if (covariance == nullptr) return;
    float* c = covariance->values<float>().data() + 6 * i;
    const auto other = [](float all, double was, double is) {
      return static_cast<float>(std::max(0.0, double{all} - was * was) + is * is);
    };
    c[0] = other(c[0], before.x, now.x);
    c[3] = other(c[3], before.y, now.y);
    if (now.z != before.z) c[5] = other(c[5], before.z, now.z);
    if (sigma != nullptr) sigma->values<float>()[i] = std::sqrt(c[0] + c[3] + c[5]);
  }
};

}  // namespace

Trajectory adjusted_trajectory(const JointAdjustment& adjustment, const Trajectory& given) {
  Trajectory made = turned(corrected(given, adjustment.trajectory), adjustment.attitude_bias_rad);
  TimePlace at;
  for (size_t i = 0; i < made.size(); ++i) {
    at = time_place(adjustment.trajectory.times_s, made.times_s[i], i, at.epoch);
    made.position_sigmas_m[i] = sigmas_at(adjustment, at, made.position_sigmas_m[i].z);
    if (!adjustment.ground.empty()) made.positions[i].z += adjustment.height_at(at);
  }
  return made;
}

std::vector<Vec3> adjusted_points(const JointAdjustment& adjustment) {
  const JointPoints points = turned(adjustment.points, adjustment.attitude_bias_rad);
  std::vector<Vec3> made = points.at;
  for (size_t i = 0; i < made.size(); ++i) {
    const Vec2 by = adjustment.trajectory.at(points.places[i]);
    made[i] += {by.u, by.v, adjustment.ground.empty() ? 0 : adjustment.height_at(points.places[i])};
  }
  return made;
}

Cloud adjusted_cloud(const JointAdjustment& adjustment, const Trajectory& given, const Cloud& split,
                     Task& task) {
  const Cloud cloud = with_whole_beams(split);
  const Column* time = cloud.fields.find("time");
  if (time == nullptr || time->info().type != ElementType::kFloat64 || time->info().components != 1)
    fail(Status::kInvalidArgument,
         "the cloud has no field \"time\" (float64): where the drive was at a point is not known");
  const auto times = time->values<double>();
  MovedColumns columns(cloud);
  const auto& controls = adjustment.trajectory.times_s;
  const Vec3& bias = adjustment.attitude_bias_rad;
  const bool turns = !(bias == Vec3{});
  const PoseInterpolator poses(given);
  constexpr size_t kMoveGrain = 1 << 14;
  parallel_for(task, cloud.size(), kMoveGrain, [&](size_t begin, size_t end) {
    TimePlace at, pose;
    for (size_t i = begin; i < end; ++i) {
      if (!std::isfinite(times[i]))
        fail(Status::kInvalidArgument, "the time of point %zu is not finite", i);
      const double t = std::clamp(times[i], controls.front(), controls.back());
      at = time_place(controls, t, i, at.epoch);
      pose = time_place(given.times_s, t, i, pose.epoch);
      if (turns) columns.turn(i, poses.position(pose), rotation_by(poses.rotation(pose) * bias));
      const Vec2 by = adjustment.trajectory.at(at);
      columns.move(i, {by.u, by.v, adjustment.ground.empty() ? 0 : adjustment.height_at(at)});
      const Vec3 before = between(given.position_sigmas_m, pose);
      columns.exchange(i, before, sigmas_at(adjustment, at, before.z));
    }
  });
  Cloud made = make_cloud(std::move(columns.xyz));
  made.fields = cloud.fields;
  made.stations = cloud.stations;
  made.crs = cloud.crs;
  made.attachments = cloud.attachments;
  for (auto& column : {columns.origin, columns.direction, columns.covariance, columns.sigma})
    if (column != nullptr) made.fields.set(column);
  return made;
}

}  // namespace jalon
