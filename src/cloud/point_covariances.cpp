// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "cloud/precision.h"

namespace jalon {

namespace {

constexpr size_t kPointCovariancesGrain = 1 << 14;
constexpr size_t kCovarianceNumbers = 6;  // of a symmetric matrix

void require_poses(const Cloud& cloud) {
  for (uint64_t i = 0; i < cloud.size();) {
    const Station* station = station_of(cloud, i);
    if (station == nullptr || !station->has_pose)
      fail(Status::kInvalidArgument,
           "point %llu has no station with a known pose: where it was scanned from decides its "
           "covariance",
           static_cast<unsigned long long>(i));
    i = station->first + station->count;
  }
}

// Incidence angles by the field "normal" where there is one.
class Incidence {
 public:
  explicit Incidence(const Cloud& cloud) : normal_(cloud.fields.find("normal")) {
    if (normal_ != nullptr &&
        (normal_->info().components != 3 || normal_->info().type != ElementType::kFloat32))
      normal_ = nullptr;
  }
  double of(uint64_t i, const Vec3& ray) const {
    if (normal_ == nullptr) return 0;
    const float* n = normal_->values<float>().data() + 3 * i;
    const Vec3 normal{n[0], n[1], n[2]};
    const double angle = std::atan2(norm(cross(normal, ray)), std::fabs(dot(normal, ray)));
    return std::isfinite(angle) ? angle : 0;
  }

 private:
  const Column* normal_;
};

}  // namespace

Cloud with_point_covariances(const Cloud& cloud, const ScannerPrecision& precision, Task& task) {
  require_poses(cloud);
  require_memory(cloud.size() * (kCovarianceNumbers + 1) * sizeof(float));
  auto covariance =
      std::make_shared<Column>(FieldInfo{"covariance", ElementType::kFloat32, kCovarianceNumbers,
                                         "m2", "of the point: xx, xy, xz, yy, yz, zz"},
                               cloud.size());
  auto sigma = std::make_shared<Column>(
      FieldInfo{"point_sigma", ElementType::kFloat32, 1, "m", "root of the sum of its variances"},
      cloud.size());
  const Incidence incidence(cloud);
  const auto out = covariance->values<float>();
  const auto sigmas = sigma->values<float>();
  parallel_for(task, cloud.size(), kPointCovariancesGrain, [&](size_t begin, size_t end) {
    const Station* station = nullptr;
    for (size_t i = begin; i < end; ++i) {
      if (station == nullptr || i - station->first >= station->count)
        station = station_of(cloud, i);
      const Vec3 ray = cloud.point(i) - station->pose.translation();
      const Vec3 up = normalized(station->pose.direction({0, 0, 1}));
      if (ray == Vec3{})
        fail(Status::kInvalidArgument, "point %llu lies on its station",
             static_cast<unsigned long long>(i));
      const PointBudget budget = point_budget(precision, ray, up, incidence.of(i, ray));
      for (size_t k = 0; k < kCovarianceNumbers; ++k)
        out[kCovarianceNumbers * i + k] = static_cast<float>(budget.covariance[k]);
      sigmas[i] = static_cast<float>(budget.point_m());
    }
  });
  Cloud changed = cloud;
  changed.fields.set(std::move(covariance));
  changed.fields.set(std::move(sigma));
  return changed;
}

}  // namespace jalon
