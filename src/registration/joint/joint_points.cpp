// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/joint_points.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/text_number.h"
#include "cloud/facade_scores.h"
#include "cloud/subsample_cells.h"
#include "model/trajectory/time_scales.h"
#include "registration/joint/attitude_bias.h"

namespace jalon {

namespace {

const Column& column_of(const Cloud& cloud, const char* name, ElementType type,
                        uint32_t components) {
  const Column* column = cloud.fields.find(name);
  if (column == nullptr)
    fail(Status::kInvalidArgument,
         "the cloud has no field \"%s\": the adjustment needs the time of every point", name);
  if (column->info().type != type || column->info().components != components)
    fail(Status::kInvalidArgument, "the field \"%s\" is %s x %u, not %s x %u", name,
         name_of(column->info().type), column->info().components, name_of(type), components);
  return *column;
}
const Column* optional_column(const Cloud& cloud, const char* name, ElementType type,
                              uint32_t components) {
  return cloud.fields.find(name) == nullptr ? nullptr : &column_of(cloud, name, type, components);
}

[[noreturn]] void refuse_other_times(std::span<const double> times,
                                     std::span<const double> control_times_s) {
  const auto [first, last] = std::ranges::minmax(times);
  const TimeSpan drive{control_times_s.front(), control_times_s.back()};
  const std::optional<double> shift = shift_between_scales({first, last}, drive);
  const std::string hint = shift ? "they meet where the drive's are later by " + text_of(*shift) +
                                       " s (time_shift_s of its file): other scales of time"
                                 : "is it another drive?";
  fail(Status::kInvalidArgument,
       "no point of the cloud is within the trajectory's time: %s to %s, the trajectory %s to %s; "
       "%s",
       text_of(first).c_str(), text_of(last).c_str(), text_of(drive.first_s).c_str(),
       text_of(drive.last_s).c_str(), hint.c_str());
}

// A laser stands some metres from the inertial unit, and a drive may be known worse than that.
void require_one_drive(const JointPoints& points, const std::vector<Vec3>& vehicle,
                       double sigma_m) {
  constexpr double kMostArm_m = 10, kMostSigmas = 3;
  std::vector<double> arms;
  for (size_t i = 0; i < vehicle.size(); ++i) arms.push_back(norm(points.origin[i] - vehicle[i]));
  const auto middle = arms.begin() + static_cast<std::ptrdiff_t>(arms.size() / 2);
  std::ranges::nth_element(arms, middle);
  if (*middle > kMostArm_m + kMostSigmas * sigma_m)
    fail(Status::kInvalidArgument,
         "the beams of the cloud begin %s m from the trajectory at their times (median): are both "
         "of one drive and by one clock?",
         text_of(*middle, 1).c_str());
}

// Those within the trajectory's time.
std::vector<uint32_t> points_in_time(std::span<const double> times,
                                     std::span<const double> control_times_s) {
  std::vector<uint32_t> made;
  for (size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]))
      fail(Status::kInvalidArgument, "the time of point %zu is %s", i, text_of(times[i]).c_str());
    if (times[i] >= control_times_s.front() && times[i] <= control_times_s.back())
      made.push_back(static_cast<uint32_t>(i));
  }
  if (made.empty() && !times.empty()) refuse_other_times(times, control_times_s);
  return made;
}

// The points of these indices alone, with their numbers.
Cloud bare_cloud(const Cloud& cloud, const std::vector<uint32_t>& index) {
  Buffer<double> xyz(3 * index.size());
  for (size_t i = 0; i < index.size(); ++i)
    for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] = cloud.xyz()[3 * size_t{index[i]} + k];
  Cloud made = make_cloud(std::move(xyz));
  made.fields.set(make_column<uint32_t>({"point", ElementType::kUint32, 1, "", ""}, index));
  return made;
}

// Keeps the point's pose; what the attitudes may be off by makes the point less sure.
void add_pose(const Vec3& vehicle, const Matrix3& axes, const JointSettings& settings,
              JointPoints& made) {
  const std::array<double, 3> sigmas = settings.sigma_attitude_rad();
  const auto by = turn_derivatives(axes, made.at.back() - vehicle);
  auto& covariance = made.plan_covariance_m2.back();
  for (size_t k = 0; k < 3; ++k) {
    const double x = sigmas[k] * by[k].x, y = sigmas[k] * by[k].y;
    covariance[0] += x * x, covariance[1] += x * y, covariance[2] += y * y;
  }
  made.vehicle.push_back(vehicle);
  made.axes.push_back(axes);
}

// Fills index and normal.
void choose_points(const Cloud& cloud, std::vector<uint32_t> index, const JointSettings& settings,
                   JointPoints& made, Task& task) {
  if (!(settings.thin_m > 0) && !(settings.least_score > 0)) {
    made.index = std::move(index);
    return;
  }
  Cloud bare = bare_cloud(cloud, index);
  if (settings.thin_m > 0) bare = one_per_voxel(bare, settings.thin_m, Keep::kNearest, task);
  const auto kept = bare.fields.require("point").values<uint32_t>();
  if (!(settings.least_score > 0)) {
    made.index.assign(kept.begin(), kept.end());
    return;
  }
  const std::vector<FacadeScore> scores = facade_scores(bare, task);
  for (size_t i = 0; i < kept.size(); ++i)
    if (double{scores[i].score} > settings.least_score) {
      made.index.push_back(kept[i]);
      made.normal.push_back(scores[i].normal);
    }
}

}  // namespace

double JointPoints::mean_plan_variance_m2() const {
  double sum = 0;
  for (const auto& c : plan_covariance_m2) sum += (c[0] + c[2]) / 2;
  return sum / static_cast<double>(size());
}

JointPoints joint_points(const Cloud& cloud, const Trajectory& trajectory,
                         std::span<const double> control_times_s, const JointSettings& settings,
                         Task& task) {
  // 1. What the cloud has.
  const auto times = column_of(cloud, "time", ElementType::kFloat64, 1).values<double>();
  const Column* origins = optional_column(cloud, "beam_origin", ElementType::kFloat64, 3);
  const Column* directions = optional_column(cloud, "beam_direction", ElementType::kFloat32, 3);
  const Column* covariances = optional_column(cloud, "covariance", ElementType::kFloat32, 6);
  const Column* ids = settings.matches == JointSettings::Matches::kIds
                          ? &column_of(cloud, "strip", ElementType::kUint32, 1)
                          : optional_column(cloud, "strip", ElementType::kUint32, 1);
  if (settings.lever_arm_m.size() != 3)
    fail(Status::kInvalidArgument, "lever_arm_m needs three numbers, not %zu",
         settings.lever_arm_m.size());
  // 2. Which points.
  JointPoints made;
  std::vector<uint32_t> in_time = points_in_time(times, control_times_s);
  made.outside = times.size() - in_time.size();
  choose_points(cloud, std::move(in_time), settings, made, task);
  if (made.index.empty())
    fail(Status::kInsufficientData,
         "no point of the cloud looks like one of a vertical wall (least_score)");
  // 3. Their rays and sigmas.
  const PoseInterpolator poses(trajectory);
  const Vec3 arm{settings.lever_arm_m[0], settings.lever_arm_m[1], settings.lever_arm_m[2]};
  std::vector<Vec3> vehicle;
  TimePlace pose, control;
  for (const uint32_t i : made.index) {
    const size_t first = 3 * size_t{i};
    const Vec3 p = cloud.point(i);
    pose = time_place(trajectory.times_s, times[i], i, pose.epoch);
    control = time_place(control_times_s, times[i], i, control.epoch);
    const auto three = [&](const auto& v) {
      return Vec3{double{v[first]}, double{v[first + 1]}, double{v[first + 2]}};
    };
    const Vec3 origin = origins != nullptr ? three(origins->values<double>())
                                           : poses.position(pose) + poses.rotation(pose) * arm;
    const Vec3 way = directions != nullptr ? three(directions->values<float>()) : p - origin;
    made.at.push_back(p);
    made.origin.push_back(origin);
    made.direction.push_back(normalized(way));
    made.times_s.push_back(times[i]);
    made.places.push_back(control);
    if (covariances != nullptr) {
      const float* c = covariances->values<float>().data() + 6 * size_t{i};
      made.plan_covariance_m2.push_back({double{c[0]}, double{c[1]}, double{c[3]}});
    } else {
      const Vec3 s = between(trajectory.position_sigmas_m, pose);
      const double noise = settings.sigma_point_m * settings.sigma_point_m;
      made.plan_covariance_m2.push_back({s.x * s.x + noise, 0, s.y * s.y + noise});
    }
    if (settings.has_attitude())
      add_pose(poses.position(pose), poses.rotation(pose), settings, made);
    if (origins != nullptr) vehicle.push_back(poses.position(pose));
    if (ids != nullptr) made.id.push_back(ids->values<uint32_t>()[i]);
  }
  if (origins != nullptr) {
    double most_m = 0;
    for (const Vec3& s : trajectory.position_sigmas_m) most_m = std::max({most_m, s.x, s.y, s.z});
    require_one_drive(made, vehicle, most_m);
  }
  return made;
}

}  // namespace jalon
