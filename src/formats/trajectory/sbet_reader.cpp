// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "base/error.h"
#include "formats/trajectory/records.h"
#include "formats/trajectory/sbet.h"
#include "formats/trajectory/smrmsg.h"
#include "model/trajectory/interpolation.h"

namespace jalon {

namespace {

// The fields that are taken; the others may hold anything.
constexpr std::array<const char*, kSbetFields> kSbetNames = {
    "time",    "latitude",     "longitude", "altitude", nullptr, nullptr, nullptr, "roll", "pitch",
    "heading", "wander angle", nullptr,     nullptr,    nullptr, nullptr, nullptr, nullptr};

using SbetRecord = std::array<double, kSbetFields>;

// What no vehicle has: the sign of a file of another kind.
void require_possible(const ByteSource& source, uint64_t record, const SbetRecord& r,
                      double before) {
  const auto refuse = [&](size_t field, const char* why) {
    source.refuse(8 * (record * kSbetFields + field), "record %llu: %s is %s%s",
                  static_cast<unsigned long long>(record), kSbetNames[field],
                  text_of(r[field]).c_str(), why);
  };
  constexpr double kRight = std::numbers::pi / 2, kHighest_m = 1e5;
  if (record > 0 && !(r[kSbetTime] > before))
    refuse(kSbetTime, (", not after that of the record before, " + text_of(before)).c_str());
  if (std::fabs(r[kSbetLatitude]) > kRight) refuse(kSbetLatitude, ", beyond a right angle");
  if (std::fabs(r[kSbetLongitude]) > 4 * kRight) refuse(kSbetLongitude, ", beyond a full turn");
  if (std::fabs(r[kSbetAltitude]) > kHighest_m) refuse(kSbetAltitude, " m");
  if (std::fabs(r[kSbetRoll]) > 2 * kRight) refuse(kSbetRoll, ", beyond half a turn");
  if (std::fabs(r[kSbetPitch]) > kRight) refuse(kSbetPitch, ", beyond a right angle");
}

double true_heading(const SbetRecord& r, SbetHeading heading) {
  if (heading == SbetHeading::kTrue) return r[kSbetHeading];
  return heading == SbetHeading::kMinusWander ? r[kSbetHeading] - r[kSbetWanderAngle]
                                              : r[kSbetHeading] + r[kSbetWanderAngle];
}

}  // namespace

Trajectory read_sbet(const std::string& path, const std::string& sigma_path,
                     const TrajectoryFileSettings& settings, Task& task) {
  const ByteSource source(path);
  Trajectory made;
  made.axes = AxesConvention::kNed;
  MapProjection world;
  std::vector<Matrix3> turns;  // from east, north, up at each epoch to the world's axes
  ProgressSpan span(task, 0, 0.8, "reading the trajectory");
  for_each_record<kSbetFields>(source, kSbetNames, task, [&](uint64_t record, const SbetRecord& r) {
    require_possible(source, record, r, record > 0 ? made.times_s.back() : 0);
    const Geodetic place{r[kSbetLatitude], r[kSbetLongitude], r[kSbetAltitude]};
    if (record == 0) world = projection_of(settings, place);
    const MapPlace there = projected(world, place);
    const Matrix3 local = attitude_rotation(
        AxesConvention::kNed, {r[kSbetRoll], r[kSbetPitch], true_heading(r, settings.heading)});
    made.times_s.push_back(r[kSbetTime]);
    made.positions.push_back(there.position);
    made.attitudes_rad.push_back(
        attitude_angles(AxesConvention::kNed, there.T_world_local * local));
    turns.push_back(there.T_world_local);
  });
  if (made.size() < 2)
    fail(Status::kFormat, "%s: a trajectory of %zu records: two are needed", path.c_str(),
         made.size());
  made.crs = world.crs();
  if (!sigma_path.empty()) add_sigmas(made, turns, sigma_path, task);
  return made;
}

}  // namespace jalon
