// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/interpolation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

TimePlace time_place(std::span<const double> times_s, double time_s, size_t item, size_t hint) {
  const size_t last = times_s.size() - 1;
  if (!(time_s >= times_s.front() && time_s <= times_s[last]))
    fail(Status::kInvalidArgument,
         "time %s of item %zu is outside of the trajectory, which lasts from %s to %s",
         text_of(time_s).c_str(), item, text_of(times_s.front()).c_str(),
         text_of(times_s[last]).c_str());
  size_t epoch = std::min(hint, last - 1);
  constexpr size_t kNear = 4;  // epochs to walk before the list is searched
  for (size_t step = 0; step < kNear && epoch + 1 < last && times_s[epoch + 1] <= time_s; ++step)
    ++epoch;
  if (times_s[epoch] > time_s || (epoch + 1 < last && times_s[epoch + 1] <= time_s)) {
    const auto after = std::upper_bound(times_s.begin(), times_s.end() - 1, time_s);
    epoch = static_cast<size_t>(after - times_s.begin()) - 1;
    epoch = std::min(epoch, last - 1);
  }
  return {epoch, (time_s - times_s[epoch]) / (times_s[epoch + 1] - times_s[epoch])};
}

PoseInterpolator::PoseInterpolator(const Trajectory& trajectory) : trajectory_(trajectory) {
  std::vector<Quaternion> turns;
  for (const Vec3& angles : trajectory.attitudes_rad)
    turns.push_back(quaternion_of(attitude_rotation(trajectory.axes, angles)));
  for (size_t i = 0; i + 1 < turns.size(); ++i) {
    // a^-1 b, of the two signs that are the same rotation the shorter turn.
    const Quaternion &a = turns[i], &b = turns[i + 1];
    const double w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
    const double sign = w < 0 ? -1 : 1;
    const Vec3 v = Vec3{a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y,
                        a.w * b.y + a.x * b.z - a.y * b.w - a.z * b.x,
                        a.w * b.z - a.x * b.y + a.y * b.x - a.z * b.w} *
                   sign;
    arcs_.push_back({a, normalized(v), std::atan2(norm(v), sign * w)});
  }
}

Trajectory interpolated(const Trajectory& trajectory, std::span<const double> times_s) {
  const PoseInterpolator poses(trajectory);
  Trajectory out;
  out.axes = trajectory.axes;
  out.crs = trajectory.crs;
  size_t hint = 0;
  const auto add = [](std::vector<Vec3>& to, const std::vector<Vec3>& from, const TimePlace& at) {
    if (!from.empty()) to.push_back(between(from, at));
  };
  for (size_t i = 0; i < times_s.size(); ++i) {
    const TimePlace at = time_place(trajectory.times_s, times_s[i], i, hint);
    hint = at.epoch;
    out.times_s.push_back(times_s[i]);
    out.positions.push_back(poses.position(at));
    out.attitudes_rad.push_back(attitude_angles(trajectory.axes, poses.rotation(at)));
    add(out.velocities_m_s, trajectory.velocities_m_s, at);
    add(out.position_sigmas_m, trajectory.position_sigmas_m, at);
    add(out.velocity_sigmas_m_s, trajectory.velocity_sigmas_m_s, at);
    add(out.attitude_sigmas_rad, trajectory.attitude_sigmas_rad, at);
  }
  validate(out);
  return out;
}

std::vector<double> control_times(const Trajectory& trajectory, double spacing_s) {
  if (!(spacing_s > 0) || !std::isfinite(spacing_s))
    fail(Status::kInvalidArgument, "a spacing of control times of %s s is not positive",
         text_of(spacing_s).c_str());
  const double first = trajectory.times_s.front(), last = trajectory.times_s.back();
  const double intervals = std::max(1.0, std::round((last - first) / spacing_s));
  constexpr double kMostIntervals = 1e8;  // as many as memory may hold
  if (intervals > kMostIntervals)
    fail(Status::kLimit, "a spacing of %s s makes more than %s control times",
         text_of(spacing_s).c_str(), text_of(kMostIntervals).c_str());
  std::vector<double> times;
  for (double i = 0; i < intervals; ++i) times.push_back(first + i * spacing_s);
  times.push_back(last);
  return times;
}

}  // namespace jalon
