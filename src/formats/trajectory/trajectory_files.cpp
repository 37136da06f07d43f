// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/trajectory_files.h"

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/setting_rows.h"
#include "formats/trajectory/sbet.h"
#include "formats/trajectory/trajectory_text.h"

namespace jalon {

namespace {

constexpr auto kTrajectoryFileRows = setting_rows(
    choice_row<&TrajectoryFileSettings::format>(
        "format", "auto|text|sbet", "",
        "Format of the file; auto: SBET by the extension out or sbet, else text."),
    choice_row<&TrajectoryFileSettings::axes>(
        "axes", "enu|ned", "",
        "What roll, pitch and yaw of a text mean that does not say it: yaw anticlockwise from east "
        "(enu) or clockwise from north (ned). SBET is always ned."),
    choice_row<&TrajectoryFileSettings::projection>(
        "projection", "utm|lambert93|enu", "",
        "World of an SBET file: UTM on WGS 84, Lambert-93, or east, north, up at the origin. "
        "Headings lose the meridian convergence; the datum stays that of the file."),
    integer_row<&TrajectoryFileSettings::utm_zone>("utm_zone", 0, 60, "", "",
                                                   "Zone of UTM; 0: that of the first record."),
    bool_row<&TrajectoryFileSettings::utm_south>(
        "utm_south", "",
        "The zone is that of the southern hemisphere; with utm_zone 0 the first record tells."),
    doubles_row<&TrajectoryFileSettings::origin>(
        "origin", -1e5, 1e5, "", "",
        "Of enu: latitude (rad), longitude (rad), height above the ellipsoid (m); none: the first "
        "record."),
    choice_row<&TrajectoryFileSettings::heading>("heading", "minus_wander|plus_wander|true", "",
                                                 "True heading of an SBET file: its heading less "
                                                 "its wander angle (Applanix), plus it, or as "
                                                 "it stands."),
    number_row<&TrajectoryFileSettings::time_shift_s>(
        "time_shift_s", -1e10, 1e10, "s", "",
        "Added to the times of a file that is read, taken from those of one that is written: from "
        "its scale of time to that of a cloud."));

void shift_times(Trajectory& trajectory, double by_s) {
  if (by_s == 0) return;
  for (double& t : trajectory.times_s) t += by_s;
  validate(trajectory);  // far from 0 two epochs may have become one
}

bool is_sbet(const std::string& path, TrajectoryFormat format) {
  if (format != TrajectoryFormat::kAuto) return format == TrajectoryFormat::kSbet;
  return path.ends_with(".out") || path.ends_with(".sbet") || path.ends_with(".OUT") ||
         path.ends_with(".SBET");
}

void refuse_sigmas_of_text(const std::string& sigma_path) {
  if (!sigma_path.empty())
    fail(Status::kInvalidArgument,
         "a trajectory as text has its sigmas in columns of its own: a file of sigmas goes with "
         "SBET alone");
}

}  // namespace

std::span<const ParamRow> trajectory_file_rows() { return kTrajectoryFileRows; }

MapProjection projection_of(const TrajectoryFileSettings& settings, const Geodetic& first) {
  MapProjection made;
  made.system = settings.projection;
  made.zone = static_cast<int>(settings.utm_zone);
  made.is_south = settings.utm_south;
  if (settings.utm_zone == 0) {
    made.zone = utm_zone(first.longitude_rad);
    made.is_south = settings.utm_south || first.latitude_rad < 0;
  }
  made.origin = first;
  if (settings.origin.empty()) return made;
  if (settings.origin.size() != 3)
    fail(Status::kInvalidArgument,
         "the origin is latitude (rad), longitude (rad) and height (m), not %zu numbers",
         settings.origin.size());
  made.origin = {settings.origin[0], settings.origin[1], settings.origin[2]};
  if (!(std::fabs(made.origin.latitude_rad) <= std::numbers::pi / 2))
    fail(Status::kInvalidArgument, "the latitude of the origin is beyond a right angle: radians?");
  return made;
}

Trajectory read_trajectory(const std::string& path, const std::string& sigma_path,
                           const TrajectoryFileSettings& settings, Task& task) {
  Trajectory made;
  if (is_sbet(path, settings.format)) {
    made = read_sbet(path, sigma_path, settings, task);
  } else {
    refuse_sigmas_of_text(sigma_path);
    made = read_trajectory_text(path, settings.axes, task);
  }
  shift_times(made, settings.time_shift_s);
  return made;
}

void write_trajectory(const Trajectory& given, const std::string& path,
                      const std::string& sigma_path, const TrajectoryFileSettings& settings,
                      Task& task) {
  Trajectory trajectory = given;
  shift_times(trajectory, -settings.time_shift_s);
  if (is_sbet(path, settings.format))
    return write_sbet(trajectory, path, sigma_path, settings, task);
  refuse_sigmas_of_text(sigma_path);
  write_trajectory_text(trajectory, path, task);
}

}  // namespace jalon
