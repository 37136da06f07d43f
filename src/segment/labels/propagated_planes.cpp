// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/propagated_planes.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "geometry/cholesky.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

constexpr size_t kPropagatedPlanesPointsPerChunk = 1 << 14;

// Sums of the weighted normal equations of w = alpha u + beta v + gamma, and what the residuals need.
struct NormalEquations {
  Symmetric3 matrix{};  ///< of a a^T / s^2, a = (u, v, 1)
  Coefficients<3> right{};
  double weighted_squares = 0, variances = 0;

  void add(const Vec3& local, double variance) {
    const double a[3] = {local.x, local.y, 1}, weight = 1 / variance;
    size_t at = 0;
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = i; j < 3; ++j) matrix[at++] += weight * a[i] * a[j];
      right[i] += weight * a[i] * local.z;
    }
    weighted_squares += weight * local.z * local.z;
    variances += variance;
  }
  NormalEquations& operator+=(const NormalEquations& b) {
    for (size_t i = 0; i < 6; ++i) matrix[i] += b.matrix[i];
    for (size_t i = 0; i < 3; ++i) right[i] += b.right[i];
    weighted_squares += b.weighted_squares;
    variances += b.variances;
    return *this;
  }
  Square<3> square() const {
    return {matrix[0], matrix[1], matrix[2], matrix[1], matrix[3],
            matrix[4], matrix[2], matrix[4], matrix[5]};
  }
};

// Errors that all points of a station share are not noise of its planes.
ScannerPrecision without_common_errors(ScannerPrecision p) {
  p.sigma_station_m = p.sigma_station_z_m = p.sigma_instrument_height_m = 0;
  p.backsight_distance_m = p.level_sensitivity_rad = 0;
  return p;
}

class Adjustment {
 public:
  Adjustment(const Cloud& cloud, const ScannerPrecision& precision)
      : cloud_(cloud), precision_(precision) {}

  NormalEquations sums(std::span<const uint32_t> points, const PlaneFit& start, Task& task) const {
    return parallel_reduce(
        task, points.size(), kPropagatedPlanesPointsPerChunk, NormalEquations{},
        [&](size_t begin, size_t end) {
          NormalEquations part;
          for (size_t i = begin; i < end; ++i) {
            const Vec3 p = cloud_.point(points[i]), d = p - start.centroid;
            part.add({dot(d, start.axis_u), dot(d, start.axis_v), dot(d, start.plane.normal)},
                     variance_of(points[i], p, start.plane.normal));
          }
          return part;
        });
  }

 private:
  double variance_of(uint32_t i, const Vec3& p, const Vec3& normal) const {
    const Station* station = station_of(cloud_, i);
    if (station == nullptr || !station->has_pose)
      fail(Status::kInvalidArgument, "point %u has no station with a known pose", i);
    const Vec3 ray = p - station->pose.translation();
    if (ray == Vec3{}) fail(Status::kInvalidArgument, "point %u lies on its station", i);
    const double incidence = std::atan2(norm(cross(normal, ray)), std::fabs(dot(normal, ray)));
    const PointBudget budget =
        point_budget(precision_, ray, normalized(station->pose.direction({0, 0, 1})), incidence);
    const double variance = variance_along(budget.covariance, normal);
    if (!(variance > 0))
      fail(Status::kDegenerate, "point %u has no uncertainty: give the scanner one", i);
    return variance;
  }

  const Cloud& cloud_;
  ScannerPrecision precision_;
};

PropagatedPlane solved(const NormalEquations& sums, const PlaneFit& start) {
  PropagatedPlane out;
  Cholesky<3> factor;
  if (start.n < 3 || !factor.factor(sums.square())) return out;
  const Coefficients<3> x = factor.solve(sums.right);
  const Square<3> inverse = factor.inverse();
  PlaneFit fit = start;
  fit.plane.normal = normalized(start.plane.normal - start.axis_u * x[0] - start.axis_v * x[1]);
  fit.axis_u = normalized(start.axis_u - fit.plane.normal * dot(fit.plane.normal, start.axis_u));
  fit.axis_v = cross(fit.plane.normal, fit.axis_u);
  fit.centroid = start.centroid + start.plane.normal * x[2];
  fit.plane.offset = dot(fit.plane.normal, fit.centroid);
  fit.local_covariance = {inverse[0], inverse[1], inverse[2], inverse[4], inverse[5], inverse[8]};
  update_covariance(fit);
  out.plane = fit.plane;
  out.covariance = fit.covariance;
  const double n = static_cast<double>(start.n);
  out.sigma_prior_m = std::sqrt(sums.variances / n);
  if (start.n > 3) {
    double squares = sums.weighted_squares;
    for (size_t i = 0; i < 3; ++i) squares -= x[i] * sums.right[i];
    out.variance_factor = std::max(0.0, squares) / (n - 3);
    out.sigma_m = start.sigma;
  }
  return out;
}

}  // namespace

std::vector<PropagatedPlane> propagate_planes(const Segmentation& segmentation,
                                              const ScannerPrecision& precision, Task& task) {
  std::vector<PropagatedPlane> out(segmentation.segments.size());
  for (size_t s = 0; s < out.size(); ++s) out[s].label = segmentation.segments[s].label;
  const Adjustment adjustment(*segmentation.cloud, without_common_errors(precision));
  const LabelGroups groups = [&] {
    ProgressSpan span(task, 0, 0.3);
    return LabelGroups(segmentation.labels->values<uint32_t>(), segmentation.segments.size(), task);
  }();
  ProgressSpan span(task, 0.3, 1, "adjusting planes");
  groups.for_each(task, [&](uint32_t label) {
    const Segment& segment = segmentation.segments[label - 1];
    if (!segment.has_plane()) return;
    PlaneFit start = segment.fit;
    const auto points = groups.of(label);
    start.n = points.size();
    out[label - 1] = solved(adjustment.sums(points, start, task), start);
    out[label - 1].label = segment.label;
  });
  return out;
}

FieldTable propagated_plane_table(const std::vector<PropagatedPlane>& planes) {
  using P = PropagatedPlane;
  FieldTable t;
  add_column<uint32_t>(t, planes, "label", "", "of the segment",
                       [](const P& p) { return p.label; });
  add_columns<double, 3>(t, planes, "normal", "1", "unit normal", [](const P& p, double* o) {
    o[0] = p.plane.normal.x, o[1] = p.plane.normal.y, o[2] = p.plane.normal.z;
  });
  add_column<double>(t, planes, "offset", "m", "normal . p = offset",
                     [](const P& p) { return p.plane.offset; });
  add_columns<double, 16>(
      t, planes, "covariance", "", "of normal and offset, row-major",
      [](const P& p, double* o) { std::copy(p.covariance.begin(), p.covariance.end(), o); });
  add_column<double>(t, planes, "sigma_prior", "m",
                     "of the points along the normal, from the scanner",
                     [](const P& p) { return p.sigma_prior_m; });
  add_column<double>(t, planes, "sigma", "m", "of the points from the plane, as measured",
                     [](const P& p) { return p.sigma_m; });
  add_column<double>(t, planes, "variance_factor", "1",
                     "of the residuals against the scanner's sigmas",
                     [](const P& p) { return p.variance_factor; });
  return t;
}

}  // namespace jalon
