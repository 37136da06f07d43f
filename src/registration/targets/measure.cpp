// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/measure.h"

#include <cmath>

#include "base/numbers.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "registration/targets/flat_target.h"
#include "registration/targets/recognition.h"
#include "registration/targets/sphere_target.h"

namespace jalon {

FieldTable measured_table(const std::vector<MeasuredTarget>& rows, std::span<const Vec3> places) {
  FieldTable table;
  using Row = const MeasuredTarget&;
  const auto found = [](Row r) { return r.status == Status::kOk; };
  add_column<int32_t>(table, rows, "status", "", "JALON_OK, or why there is none: JALON_ERROR_...",
                      [](Row r) { return static_cast<int32_t>(r.status); });
  add_column<uint8_t>(table, rows, "kind", "", "JALON_TARGET_...; 0: none",
                      [&](Row r) { return found(r) ? static_cast<uint8_t>(r.kind) : uint8_t{0}; });
  size_t i = 0;
  add_columns<double, 3>(table, rows, "centre", "m", "of the target", [&](Row r, double* out) {
    const Vec3 at = places[i++] + r.centre;
    for (int k = 0; k < 3; ++k) out[k] = found(r) ? at[k] : kNaN;
  });
  add_columns<double, 9>(table, rows, "covariance", "m2", "of the centre, row-major",
                         [&](Row r, double* out) {
                           for (size_t k = 0; k < 9; ++k)
                             out[k] = found(r) ? r.covariance[k] : kNaN;
                         });
  add_column<double>(table, rows, "radius", "m", "of a sphere or a disc",
                     [](Row r) { return r.radius_m; });
  add_column<double>(table, rows, "radius_sigma", "m", "its standard deviation; 0: given",
                     [](Row r) { return r.radius_sigma_m; });
  add_columns<double, 3>(table, rows, "normal", "", "of a flat target", [](Row r, double* out) {
    out[0] = r.normal.x, out[1] = r.normal.y, out[2] = r.normal.z;
  });
  add_column<double>(table, rows, "sigma", "m", "of the points from the surface",
                     [](Row r) { return r.sigma_m; });
  add_column<uint64_t>(table, rows, "points", "", "that carry it", [](Row r) { return r.points; });
  return table;
}

namespace {

constexpr auto kTargetRows = setting_rows(
    choice_row<&MeasuringSettings::kind>("kind", "sphere|flat", "",
                                         "Of the targets; flat: a disc, a checker, a plate."),
    number_row<&MeasuringSettings::radius_m>(
        "radius_m", 0, 100, "m", "", "Radius of the spheres where it is known; 0: measured."),
    number_row<&MeasuringSettings::size_m>(
        "size_m", 1e-3, 100, "m", "", "Edge or diameter of flat targets, of the pattern on them."),
    number_row<&MeasuringSettings::search_m>(
        "search_m", 0, 100, "m", "",
        "Radius around a place within which the target lies as a whole; 0: 2.5 times the "
        "radius of a sphere (0.25 m where it is free), 1.5 times the size of a flat target."),
    number_row<&MeasuringSettings::tolerance_m>(
        "tolerance_m", 1e-6, 10, "m", "",
        "Largest distance of a point from the surface: a half-thickness; what lies beyond is "
        "an outlier."),
    choice_row<&MeasuringSettings::pattern>(
        "pattern", "automatic|checker|disc|patch", "",
        "Of flat targets. checker: four quadrants, dark and bright by turns, meet in the "
        "centre; disc: of another brightness than what surrounds it; patch: a plate of its "
        "own without a pattern; automatic: by the intensities, else a patch."),
    string_row<&MeasuringSettings::intensity_field>("intensity_field", "",
                                                    "Field of the cloud that shows the pattern."),
    string_row<&MeasuringSettings::catalogue>(
        "catalogue", "",
        "Targets that were put up, as JSON: {\"targets\": [{\"code\": \"1\", \"kind\": "
        "\"checker\", \"size_m\": 0.15}, ...]}, kind checker or disc, optionally a \"name\" each, "
        "and "
        "\"size_sigma_m\" of all (0.001). With it no place is given: the whole cloud is searched."),
    number_row<&MeasuringSettings::confidence>(
        "confidence", 0.5, 0.999, "1", "",
        "With a catalogue: a target that is less surely one entry of it gets none."),
    integer_row<&MeasuringSettings::min_points>("min_points", 8, 1e9, "points", "",
                                                "Fewer points make no target."),
    integer_row<&MeasuringSettings::seed>(
        "seed", 0, 9e15, "1", "",
        "Seed of the random draws: the same seed gives the same result."));

}  // namespace

std::span<const ParamRow> target_rows() { return kTargetRows; }

Surroundings surroundings_of(const Cloud& cloud, const Octree& tree, const Vec3& place,
                             const Vec3& centre, double radius_m) {
  Surroundings out{place, {}, {}};
  std::vector<Neighbour> near;
  tree.radius(place + centre, radius_m, near);
  for (const Neighbour& n : near) {
    out.indices.push_back(n.index);
    out.points.push_back(cloud.point(n.index) - place);
  }
  return out;
}

FieldTable measure_targets(const Cloud& cloud, std::span<const Vec3> places,
                           const MeasuringSettings& settings, Task& task) {
  if (!settings.catalogue.empty()) {
    if (!places.empty())
      fail(Status::kInvalidArgument,
           "a catalogue is searched for in the whole cloud: give no places with it");
    return recognise_targets(cloud, settings, task);
  }
  const auto tree = cloud.octree(task);
  std::vector<MeasuredTarget> rows;
  for (size_t i = 0; i < places.size(); ++i) {
    task.checkpoint(static_cast<double>(i) / static_cast<double>(places.size()));
    rows.push_back(settings.kind == TargetShape::kFlat
                       ? measure_flat(cloud, *tree, places[i], settings, task)
                       : measure_sphere(cloud, *tree, places[i], settings, task));
  }
  return measured_table(rows, places);
}

}  // namespace jalon
