// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/trajectory.h"

#include "base/numbers.h"
#include "base/table_columns.h"
#include "capi/support/guard.h"
#include "capi/support/trajectory_handles.h"
#include "formats/trajectory/trajectory_files.h"
#include "model/trajectory/gauss_markov.h"
#include "model/trajectory/interpolation.h"
#include "model/trajectory/trajectory_settings.h"

using namespace jalon;
using namespace jalon::capi;

namespace jalon::capi {

jalon_trajectory* new_trajectory(Trajectory trajectory) {
  auto handle = std::make_unique<jalon_trajectory>();
  handle->trajectory = std::make_shared<const Trajectory>(std::move(trajectory));
  return handle.release();
}

namespace {

const Trajectory& trajectory_of(const jalon_trajectory* trajectory) {
  require(trajectory, "trajectory");
  return *trajectory->trajectory;
}

std::vector<Vec3> triples(const double* values, uint64_t count, const char* name) {
  require_array(values, JALON_FLOAT64, count, 3, 0, name);
  std::vector<Vec3> out;
  out.reserve(count);
  for (size_t i = 0; i < count; ++i)
    out.push_back({values[3 * i], values[3 * i + 1], values[3 * i + 2]});
  return out;
}

void add_triples(FieldTable& table, const std::vector<Vec3>& list, size_t epochs, const char* name,
                 const char* unit, const char* meaning) {
  auto column =
      std::make_shared<Column>(FieldInfo{name, ElementType::kFloat64, 3, unit, meaning}, epochs);
  const auto out = column->values<double>();
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = list.empty() ? kNaN : list[i / 3][static_cast<int>(i % 3)];
  table.set(std::move(column));
}

FieldTable epoch_table(const Trajectory& t) {
  FieldTable table;
  table.set(make_column<double>({"time", ElementType::kFloat64, 1, "s", "ascending"}, t.times_s));
  add_triples(table, t.positions, t.size(), "xyz", "m", "position");
  add_triples(table, t.attitudes_rad, t.size(), "attitude", "rad", "roll, pitch, yaw");
  add_triples(table, t.velocities_m_s, t.size(), "velocity", "m/s", "along x, y, z");
  add_triples(table, t.position_sigmas_m, t.size(), "position_sigma", "m",
              "standard deviations along x, y, z");
  add_triples(table, t.velocity_sigmas_m_s, t.size(), "velocity_sigma", "m/s",
              "standard deviations along x, y, z");
  add_triples(table, t.attitude_sigmas_rad, t.size(), "attitude_sigma", "rad",
              "standard deviations of roll, pitch, yaw");
  return table;
}

// x and y of lists of one value an epoch or an interval.
void add_pairs(FieldTable& table, const std::vector<double>& x, const std::vector<double>& y,
               size_t epochs, const char* name, const char* unit, const char* meaning) {
  std::vector<double> both(2 * epochs, kNaN);
  for (size_t i = 0; i < x.size(); ++i) both[2 * i] = x[i], both[2 * i + 1] = y[i];
  table.set(make_column<double>({name, ElementType::kFloat64, 2, unit, meaning}, both));
}

FieldTable prior_table(const Trajectory& t) {
  const GaussMarkov x = position_prior(t, 0), y = position_prior(t, 1);
  const TridiagonalInformation ix = information_of(x), iy = information_of(y);
  FieldTable table;
  table.set(
      make_column<double>({"time", ElementType::kFloat64, 1, "s", "of the epoch"}, t.times_s));
  add_pairs(table, x.sigmas_m, y.sigmas_m, t.size(), "sigma", "m", "of x and of y");
  add_pairs(table, ix.diagonal, iy.diagonal, t.size(), "information", "1/m2", "on the diagonal");
  add_pairs(table, ix.beside, iy.beside, t.size(), "beside", "1/m2", "beside the diagonal");
  add_pairs(table, x.factors, y.factors, t.size(), "factor", "1", "n: keeps the next sigma");
  add_pairs(table, x.innovations, y.innovations, t.size(), "innovation", "m2", "n^2 dt^2 v^2");
  return table;
}

}  // namespace
}  // namespace jalon::capi

jalon_status jalon_trajectory_create(const double* times_s, const double* positions_m,
                                     const double* attitudes_rad, const double* position_sigmas_m,
                                     const double* velocity_sigmas_m_s,
                                     const double* attitude_sigmas_rad, uint64_t count,
                                     const char* crs, const jalon_params* options,
                                     jalon_trajectory** out) {
  return guard([&] {
    require(out, "out");
    require_array(times_s, JALON_FLOAT64, count, 1, 0, "times_s");
    Trajectory made;
    made.axes = settings_from<TrajectorySettings>(options_or_default(options, "trajectory")).axes;
    made.positions = triples(positions_m, count, "positions_m");
    made.attitudes_rad = triples(attitudes_rad, count, "attitudes_rad");
    made.times_s.assign(times_s, times_s + count);
    const auto take = [&](const double* values, const char* name, std::vector<Vec3>& to) {
      if (values != nullptr) to = triples(values, count, name);
    };
    take(position_sigmas_m, "position_sigmas_m", made.position_sigmas_m);
    take(velocity_sigmas_m_s, "velocity_sigmas_m_s", made.velocity_sigmas_m_s);
    take(attitude_sigmas_rad, "attitude_sigmas_rad", made.attitude_sigmas_rad);
    if (crs != nullptr) made.crs = require_text(crs, "crs");
    validate(made);
    *out = new_trajectory(std::move(made));
  });
}

jalon_status jalon_trajectory_read(const char* path, const char* sigma_path,
                                   const jalon_params* options, jalon_task* task,
                                   jalon_trajectory** out) {
  return guard([&] {
    const std::string file = require_text(path, "path");
    const std::string sigmas = sigma_path != nullptr ? require_text(sigma_path, "sigma_path") : "";
    require(out, "out");
    const auto settings =
        settings_from<TrajectoryFileSettings>(options_or_default(options, "trajectory_file"));
    *out = with_task(task, [&](Task& t) {
             return own(new_trajectory(read_trajectory(file, sigmas, settings, t)));
           }).release();
  });
}

jalon_status jalon_trajectory_write(const jalon_trajectory* trajectory, const char* path,
                                    const char* sigma_path, const jalon_params* options,
                                    jalon_task* task) {
  return guard([&] {
    const Trajectory& written = trajectory_of(trajectory);
    const std::string file = require_text(path, "path");
    const std::string sigmas = sigma_path != nullptr ? require_text(sigma_path, "sigma_path") : "";
    const auto settings =
        settings_from<TrajectoryFileSettings>(options_or_default(options, "trajectory_file"));
    with_task(task, [&](Task& t) { write_trajectory(written, file, sigmas, settings, t); });
  });
}

jalon_trajectory* jalon_trajectory_retain(jalon_trajectory* trajectory) {
  return retain(trajectory);
}
void jalon_trajectory_release(jalon_trajectory* trajectory) { release(trajectory); }

jalon_status jalon_trajectory_count(const jalon_trajectory* trajectory, uint64_t* out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    *out = t.size();
  });
}

jalon_status jalon_trajectory_crs(const jalon_trajectory* trajectory, const char** out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    *out = t.crs.c_str();
  });
}

jalon_status jalon_trajectory_axes(const jalon_trajectory* trajectory, const char** out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    *out = t.axes == AxesConvention::kEnu ? "enu" : "ned";
  });
}

jalon_status jalon_trajectory_epochs(const jalon_trajectory* trajectory, jalon_fields** out) {
  return give_fields(trajectory, "trajectory", out,
                     [&] { return epoch_table(*trajectory->trajectory); });
}

jalon_status jalon_trajectory_interpolate(const jalon_trajectory* trajectory, const double* times_s,
                                          uint64_t count, jalon_trajectory** out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    require_array(times_s, JALON_FLOAT64, count, 1, 0, "times_s");
    *out = new_trajectory(interpolated(t, {times_s, static_cast<size_t>(count)}));
  });
}

jalon_status jalon_trajectory_control(const jalon_trajectory* trajectory, double spacing_s,
                                      jalon_trajectory** out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    *out = new_trajectory(interpolated(t, control_times(t, spacing_s)));
  });
}

jalon_status jalon_trajectory_prior(const jalon_trajectory* trajectory, jalon_fields** out) {
  return give_fields(trajectory, "trajectory", out,
                     [&] { return prior_table(*trajectory->trajectory); });
}

jalon_status jalon_trajectory_perturb(const jalon_trajectory* trajectory, uint64_t seed,
                                      jalon_trajectory** out) {
  return guard([&] {
    const Trajectory& t = trajectory_of(trajectory);
    require(out, "out");
    *out = new_trajectory(perturbed(t, seed));
  });
}
