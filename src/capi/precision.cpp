// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/precision.h"

#include <numbers>

#include "base/table_columns.h"
#include "capi/support/guard.h"
#include "capi/support/worker_handles.h"
#include "cloud/precision.h"
#include "cloud/range_sample.h"
#include "geometry/ranging.h"
#include "segment/labels/propagated_planes.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

std::span<const double> numbers_of_precision(const double* values, uint64_t count,
                                             const char* name) {
  require_array(values, JALON_FLOAT64, count, 1, 0, name);
  return {values, static_cast<size_t>(count)};
}

double right_angle_at_most(const double* angles, uint64_t i, const char* name) {
  if (angles == nullptr) return 0;
  if (!(std::fabs(angles[i]) <= std::numbers::pi / 2))
    fail(Status::kInvalidArgument, "%s of point %llu is not between -pi/2 and pi/2", name,
         static_cast<unsigned long long>(i));
  return angles[i];
}

void require_positive(std::span<const double> ranges) {
  for (size_t i = 0; i < ranges.size(); ++i)
    if (!(ranges[i] > 0) || !std::isfinite(ranges[i]))
      fail(Status::kInvalidArgument, "range %zu is not a positive number", i);
}

FieldTable budget_table(const std::vector<PointBudget>& rows) {
  using B = PointBudget;
  FieldTable t;
  const auto add = [&](const char* name, const char* unit, const char* meaning, auto value) {
    add_column<double>(t, rows, name, unit, meaning, value);
  };
  add("range", "m", "of the range", [](const B& b) { return b.range_m; });
  add("horizontal", "m", "of the horizontal angle", [](const B& b) { return b.horizontal_m; });
  add("vertical", "m", "of the vertical angle", [](const B& b) { return b.vertical_m; });
  add("instrument", "m", "of these three", [](const B& b) { return b.instrument_m(); });
  add("pulse", "m", "pulse noise", [](const B& b) { return b.pulse_m; });
  add("beam", "m", "beam width, in each direction across the ray",
      [](const B& b) { return b.beam_m; });
  add("azimuth", "m", "of the back-sight", [](const B& b) { return b.azimuth_m; });
  add("levelling", "m", "of the vertical axis", [](const B& b) { return b.levelling_m; });
  add("station", "m", "of the scanner's position", [](const B& b) { return b.station_m; });
  add("point", "m", "all together", [](const B& b) { return b.point_m(); });
  add_columns<double, 9>(t, rows, "covariance", "m2", "of the point at h = 0, row-major",
                         [](const B& b, double* o) {
                           constexpr size_t kUpper[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
                           for (size_t i = 0; i < 9; ++i) o[i] = b.covariance[kUpper[i]];
                         });
  add("range_bias", "m", "time walk and temperature", [](const B& b) { return b.range_bias_m; });
  add("intensity", "1/m2", "returned, relative", [](const B& b) { return b.intensity; });
  return t;
}

FieldTable sample_table(const RangeSample& sample) {
  FieldTable t;
  add_value<uint64_t>(t, "points", "points", "of the sample", sample.fit.n);
  add_value<double>(t, "range_precision", "m", "s_d, divided by n - 1", sample.range_precision_m);
  add_value<double>(t, "sigma", "m", "divided by n - 3", sample.fit.sigma);
  const Vec3& n = sample.fit.plane.normal;
  const double normal[] = {n.x, n.y, n.z};
  t.set(make_column<double>({"normal", ElementType::kFloat64, 3, "1", "unit normal"}, normal));
  add_value<double>(t, "offset", "m", "normal . p = offset", sample.fit.plane.offset);
  add_value<double>(t, "mean_intensity", "", "of its points", sample.mean_intensity);
  add_value<double>(t, "std_intensity", "", "divided by n - 1", sample.std_intensity);
  return t;
}

}  // namespace

jalon_status jalon_precision_budget(const double* ranges_m, const double* vertical_rad,
                                    const double* incidence_rad, uint64_t count,
                                    const jalon_params* options, jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    const auto ranges = numbers_of_precision(ranges_m, count, "ranges_m");
    require_positive(ranges);
    const auto precision =
        settings_from<ScannerPrecision>(options_or_default(options, "precision"));
    std::vector<PointBudget> rows;
    for (size_t i = 0; i < ranges.size(); ++i) {
      const double v = right_angle_at_most(vertical_rad, i, "the vertical angle");
      const Vec3 ray = Vec3{0, std::cos(v), std::sin(v)} * ranges[i];
      rows.push_back(point_budget(precision, ray, {0, 0, 1},
                                  right_angle_at_most(incidence_rad, i, "the incidence angle")));
    }
    *out = new_fields(budget_table(rows));
  });
}

jalon_status jalon_cloud_compute_covariances(jalon_cloud* cloud, const jalon_params* options,
                                             jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const auto chosen = settings_from<ScannerPrecision>(options_or_default(options, "precision"));
    auto changed = with_task(task, [&](Task& t) {
      return std::make_shared<const Cloud>(with_point_covariances(*cloud->cloud, chosen, t));
    });
    cloud->cloud = std::move(changed);
  });
}

jalon_status jalon_segmentation_plane_covariances(const jalon_segmentation* segmentation,
                                                  const jalon_params* options, jalon_task* task,
                                                  jalon_fields** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    const auto chosen = settings_from<ScannerPrecision>(options_or_default(options, "precision"));
    *out = with_task(task, [&](Task& t) {
             const auto planes = propagate_planes(*segmentation->segmentation, chosen, t);
             return own(new_fields(propagated_plane_table(planes)));
           }).release();
  });
}

jalon_status jalon_cloud_range_precision(const jalon_cloud* cloud, const uint64_t* indices,
                                         uint64_t count, jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    std::span<const uint64_t> list;
    if (count > 0) {
      require_array(indices, JALON_UINT64, count, 1, 0, "indices");
      list = {indices, static_cast<size_t>(count)};
    }
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(sample_table(range_sample(*cloud->cloud, list, t))));
           }).release();
  });
}

jalon_status jalon_baseline_constant(const double* measured_m, const double* known_m,
                                     uint64_t count, jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    const BaselineConstant found =
        baseline_constant(numbers_of_precision(measured_m, count, "measured_m"),
                          numbers_of_precision(known_m, count, "known_m"));
    FieldTable t;
    add_value<uint64_t>(t, "distances", "", "of the baseline", found.count);
    add_value<double>(t, "constant", "m", "k: measured ranges are too long by it",
                      found.constant_m);
    add_value<double>(t, "sigma", "m", "precision of one range, divided by n - 1", found.sigma_m);
    add_value<double>(t, "sigma_constant", "m", "sigma / sqrt(n)", found.sigma_constant_m);
    add_value<double>(t, "rms", "m", "accuracy of one range before the correction", found.rms_m);
    *out = new_fields(std::move(t));
  });
}

jalon_status jalon_angular_precision(const double* measured_m, const double* known_m,
                                     const double* ranges_m, uint64_t count, jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    const auto measured = numbers_of_precision(measured_m, count, "measured_m"),
               known = numbers_of_precision(known_m, count, "known_m"),
               ranges = numbers_of_precision(ranges_m, count, "ranges_m");
    require_positive(ranges);
    // An angular error is a baseline's error over the range.
    std::vector<double> found, truth;
    for (size_t i = 0; i < ranges.size(); ++i) {
      found.push_back(measured[i] / ranges[i]);
      truth.push_back(known[i] / ranges[i]);
    }
    const BaselineConstant errors = baseline_constant(found, truth);
    FieldTable t;
    add_value<uint64_t>(t, "pairs", "", "of spheres", errors.count);
    add_value<double>(t, "mean", "rad", "of the angular errors", errors.constant_m);
    add_value<double>(t, "std", "rad", "about the mean, divided by n - 1", errors.sigma_m);
    add_value<double>(t, "rms", "rad", "about 0", errors.rms_m);
    *out = new_fields(std::move(t));
  });
}

jalon_status jalon_phase_range(const double* wavelengths_m, const double* remainders_m,
                               uint64_t count, double* out) {
  return guard([&] {
    require(out, "out");
    *out = phase_range_m(numbers_of_precision(wavelengths_m, count, "wavelengths_m"),
                         numbers_of_precision(remainders_m, count, "remainders_m"));
  });
}
