// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/smrmsg.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "formats/files/atomic_file.h"
#include "formats/trajectory/records.h"
#include "formats/trajectory/sbet.h"
#include "model/trajectory/interpolation.h"

namespace jalon {

namespace {

constexpr std::array<const char*, kSmrmsgFields> kSmrmsgNames = {"time",
                                                                 "north position sigma",
                                                                 "east position sigma",
                                                                 "down position sigma",
                                                                 "north velocity sigma",
                                                                 "east velocity sigma",
                                                                 "down velocity sigma",
                                                                 "roll sigma",
                                                                 "pitch sigma",
                                                                 "heading sigma"};
constexpr double kMinuteOfArc_rad = std::numbers::pi / (180 * 60);

struct SigmaRecords {
  std::vector<double> times_s;
  std::vector<Vec3> position_m, velocity_m_s,
      attitude_rad;  ///< along east, north, up; of the angles
  double longest_step_s = 0;
};

SigmaRecords read_sigma_records(const ByteSource& source, Task& task) {
  SigmaRecords made;
  using Record = std::array<double, kSmrmsgFields>;
  for_each_record<kSmrmsgFields>(source, kSmrmsgNames, task, [&](uint64_t record, const Record& r) {
    const auto refuse = [&](size_t field, const std::string& why) {
      source.refuse(8 * (record * kSmrmsgFields + field), "record %llu: %s is %s%s",
                    static_cast<unsigned long long>(record), kSmrmsgNames[field],
                    text_of(r[field]).c_str(), why.c_str());
    };
    if (record > 0) {
      const double before = made.times_s.back();
      if (!(r[kSmrmsgTime] > before))
        refuse(kSmrmsgTime, ", not after that of the record before, " + text_of(before));
      made.longest_step_s = std::max(made.longest_step_s, r[kSmrmsgTime] - before);
    }
    for (size_t field = kSmrmsgNorth; field < kSmrmsgFields; ++field)
      if (!(r[field] > 0)) refuse(field, "; a standard deviation must be positive");
    made.times_s.push_back(r[kSmrmsgTime]);
    made.position_m.push_back({r[kSmrmsgEast], r[kSmrmsgNorth], r[kSmrmsgDown]});
    made.velocity_m_s.push_back(
        {r[kSmrmsgVelocityEast], r[kSmrmsgVelocityNorth], r[kSmrmsgVelocityDown]});
    made.attitude_rad.push_back(Vec3{r[kSmrmsgRoll], r[kSmrmsgPitch], r[kSmrmsgHeading]} *
                                kMinuteOfArc_rad);
  });
  if (made.times_s.size() < 2)
    fail(Status::kFormat, "%s: a file of sigmas with %zu records: two are needed",
         source.path().c_str(), made.times_s.size());
  return made;
}

// Standard deviations along other axes, of errors that are independent along these.
Vec3 turned_sigmas(const Matrix3& turn, const Vec3& sigmas) {
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const double* row = turn.m.data() + 3 * i;
    out[i] =
        std::sqrt(row[0] * row[0] * sigmas.x * sigmas.x + row[1] * row[1] * sigmas.y * sigmas.y +
                  row[2] * row[2] * sigmas.z * sigmas.z);
  }
  return out;
}

}  // namespace

void add_sigmas(Trajectory& trajectory, std::span<const Matrix3> T_world_local,
                const std::string& path, Task& task) {
  const ByteSource source(path);
  const SigmaRecords records = read_sigma_records(source, task);
  const double first = records.times_s.front(), last = records.times_s.back();
  const auto covers = [&](double time) {
    return time >= first - records.longest_step_s && time <= last + records.longest_step_s;
  };
  for (const double time : {trajectory.times_s.front(), trajectory.times_s.back()})
    if (!covers(time))
      fail(Status::kFormat, "%s: the sigmas last from %s to %s; the trajectory has time %s",
           path.c_str(), text_of(first).c_str(), text_of(last).c_str(), text_of(time).c_str());
  size_t hint = 0;
  for (size_t i = 0; i < trajectory.size(); ++i) {
    const TimePlace at =
        time_place(records.times_s, std::clamp(trajectory.times_s[i], first, last), i, hint);
    hint = at.epoch;
    trajectory.position_sigmas_m.push_back(
        turned_sigmas(T_world_local[i], between(records.position_m, at)));
    trajectory.velocity_sigmas_m_s.push_back(
        turned_sigmas(T_world_local[i], between(records.velocity_m_s, at)));
    trajectory.attitude_sigmas_rad.push_back(between(records.attitude_rad, at));
  }
}

void write_smrmsg(const Trajectory& trajectory, std::span<const Matrix3> T_world_local,
                  const std::string& path, Task& task) {
  if (trajectory.position_sigmas_m.empty() || trajectory.velocity_sigmas_m_s.empty() ||
      trajectory.attitude_sigmas_rad.empty())
    fail(Status::kInvalidArgument,
         "a file of sigmas needs those of position, velocity and attitude; the trajectory lacks "
         "some");
  AtomicFile file(path);
  constexpr size_t kTogether = 4096;
  for (size_t i = 0; i < trajectory.size(); ++i) {
    if (i % kTogether == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(trajectory.size()));
    const Matrix3 back = transposed(T_world_local[i]);
    const Vec3 p = turned_sigmas(back, trajectory.position_sigmas_m[i]),
               v = turned_sigmas(back, trajectory.velocity_sigmas_m_s[i]),
               a = trajectory.attitude_sigmas_rad[i] / kMinuteOfArc_rad;
    const double record[kSmrmsgFields] = {
        trajectory.times_s[i], p.y, p.x, p.z, v.y, v.x, v.z, a.x, a.y, a.z};
    std::array<std::byte, 8 * kSmrmsgFields> bytes;
    for (size_t k = 0; k < kSmrmsgFields; ++k) store(bytes.data() + 8 * k, record[k]);
    file.write(bytes.data(), bytes.size());
  }
  file.commit();
}

}  // namespace jalon
