// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/georeference.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"
#include "geometry/polar_covariance.h"
#include "scan/mobile/georeference_rows.h"

namespace jalon {

namespace {

constexpr size_t kGeoreferenceGrain = 1 << 14;

Vec3 three_of(const std::vector<double>& values, const char* name) {
  if (values.size() != 3)
    fail(Status::kInvalidArgument, "%s needs three numbers, not %zu", name, values.size());
  return {values[0], values[1], values[2]};
}

void require_return(const LaserReturns& returns, size_t i) {
  const auto refuse = [&](const char* what, double value) {
    fail(Status::kInvalidArgument, "return %zu: %s is %s", i, what, text_of(value).c_str());
  };
  if (!(returns.ranges_m[i] > 0) || !std::isfinite(returns.ranges_m[i]))
    refuse("the range", returns.ranges_m[i]);
  if (!std::isfinite(returns.thetas_rad[i])) refuse("theta", returns.thetas_rad[i]);
  if (!std::isfinite(returns.phis_rad[i])) refuse("phi", returns.phis_rad[i]);
}

// The columns of the cloud to be.
struct GeoreferencedColumns {
  GeoreferencedColumns(size_t n, bool with_covariances)
      : xyz(3 * n),
        origin(std::make_shared<Column>(
            FieldInfo{"beam_origin", ElementType::kFloat64, 3, "m", "the laser's centre"}, n)),
        direction(std::make_shared<Column>(
            FieldInfo{"beam_direction", ElementType::kFloat32, 3, "1", "unit, away from the laser"},
            n)),
        origins_(origin->values<double>().data()),
        directions_(direction->values<float>().data()) {
    if (!with_covariances) return;
    covariance = std::make_shared<Column>(FieldInfo{"covariance", ElementType::kFloat32, 6, "m2",
                                                    "of the point: xx, xy, xz, yy, yz, zz"},
                                          n);
    sigma = std::make_shared<Column>(
        FieldInfo{"point_sigma", ElementType::kFloat32, 1, "m", "root of the sum of its variances"},
        n);
    covariances_ = covariance->values<float>().data();
    sigmas_ = sigma->values<float>().data();
  }

  void set(size_t i, const WorldBeam& beam) {
    double* o = origins_ + 3 * i;
    float* d = directions_ + 3 * i;
    for (int k = 0; k < 3; ++k) {
      xyz[3 * i + static_cast<size_t>(k)] = beam.point[k];
      o[k] = beam.origin[k];
      d[k] = static_cast<float>(beam.direction[k]);
    }
  }
  void set_covariance(size_t i, const Symmetric3& c) {
    float* out = covariances_ + 6 * i;
    for (size_t k = 0; k < 6; ++k) out[k] = static_cast<float>(c[k]);
    sigmas_[i] = static_cast<float>(point_sigma(c));
  }

  Buffer<double> xyz;
  std::shared_ptr<Column> origin, direction, covariance, sigma;

 private:
  // Of the columns: their type is asked for once.
  double* origins_;
  float *directions_, *covariances_ = nullptr, *sigmas_ = nullptr;
};

void require_pose_sigmas(const Trajectory& trajectory) {
  if (trajectory.position_sigmas_m.empty() || trajectory.attitude_sigmas_rad.empty())
    fail(Status::kInvalidArgument,
         "the trajectory has no sigmas of %s: covariances of points need them (or covariances = "
         "false)",
         trajectory.position_sigmas_m.empty() ? "position" : "attitude");
}

}  // namespace

std::span<const ParamRow> georeference_rows() { return kGeoreferenceRows; }

LaserMount mount_of(const GeoreferenceSettings& settings) {
  return {three_of(settings.mirror_offset_m, "mirror_offset_m"),
          three_of(settings.boresight_rad, "boresight_rad"), settings.boresight_order,
          three_of(settings.lever_arm_m, "lever_arm_m")};
}

LaserSigmas laser_sigmas(const GeoreferenceSettings& settings) {
  const Vec3 mirror = three_of(settings.sigma_mirror_m, "sigma_mirror_m"),
             boresight = three_of(settings.sigma_boresight_rad, "sigma_boresight_rad"),
             arm = three_of(settings.sigma_lever_arm_m, "sigma_lever_arm_m");
  return {settings.sigma_range_m,
          settings.sigma_theta_rad,
          settings.sigma_phi_rad,
          mirror.x,
          mirror.y,
          mirror.z,
          boresight.x,
          boresight.y,
          boresight.z,
          arm.x,
          arm.y,
          arm.z,
          0,
          0,
          0,
          0,
          0,
          0};
}

void set_pose_sigmas(LaserSigmas& sigmas, const Trajectory& trajectory, const TimePlace& place) {
  const Vec3 attitude = between(trajectory.attitude_sigmas_rad, place),
             position = between(trajectory.position_sigmas_m, place);
  for (int k = 0; k < 3; ++k) {
    sigmas[12 + static_cast<size_t>(k)] = attitude[k];
    sigmas[15 + static_cast<size_t>(k)] = position[k];
  }
}

Cloud georeferenced(const Trajectory& trajectory, const LaserReturns& returns,
                    const GeoreferenceSettings& settings, Task& task) {
  // 1. What stays the same for the whole drive.
  if (settings.covariances) require_pose_sigmas(trajectory);
  const BeamGeometry geometry(mount_of(settings));
  const LaserSigmas constant = laser_sigmas(settings);
  const PoseInterpolator poses(trajectory);
  const bool is_ned = trajectory.axes == AxesConvention::kNed;
  // 2. Each return at its time.
  const size_t n = returns.times_s.size();
  GeoreferencedColumns columns(n, settings.covariances);
  parallel_for(task, n, kGeoreferenceGrain, [&](size_t begin, size_t end) {
    LaserSigmas sigmas = constant;
    TimePlace at;
    for (size_t i = begin; i < end; ++i) {
      require_return(returns, i);
      at = time_place(trajectory.times_s, returns.times_s[i], i, at.epoch);
      const VehiclePose pose = vehicle_pose(poses.rotation(at), poses.position(at), is_ned);
      const LaserReturn from{returns.ranges_m[i], returns.thetas_rad[i], returns.phis_rad[i]};
      if (!settings.covariances) {
        columns.set(i, geometry.beam(from, pose));
        continue;
      }
      set_pose_sigmas(sigmas, trajectory, at);
      const BeamGeometry::SureBeam made = geometry.sure_beam(from, pose, sigmas);
      columns.set(i, made.beam);
      columns.set_covariance(i, made.covariance);
    }
  });
  // 3. The cloud.
  Cloud cloud = make_cloud(std::move(columns.xyz));
  cloud.crs = trajectory.crs;
  cloud.fields.set(make_column<double>({"time", ElementType::kFloat64, 1, "s", "of the return"},
                                       returns.times_s));
  cloud.fields.set(std::move(columns.origin));
  cloud.fields.set(std::move(columns.direction));
  if (settings.covariances) {
    cloud.fields.set(std::move(columns.covariance));
    cloud.fields.set(std::move(columns.sigma));
  }
  return cloud;
}

}  // namespace jalon
