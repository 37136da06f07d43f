// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/mobile_scan.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/table_columns.h"
#include "model/buildings/part_numbers.h"
#include "spatial/triangles/tree.h"

namespace jalon {

namespace {

// The pulses of a drive in time: pulse k of beam b of a revolution, all beams of a step at once.
class PulseTrain {
 public:
  PulseTrain(const Trajectory& trajectory, const MobileSettings& settings)
      : settings_(settings),
        first_s_(trajectory.times_s.front()),
        step_s_(1 / (settings.revolutions_per_s * static_cast<double>(settings.pulses))) {
    const double steps = std::floor((trajectory.times_s.back() - first_s_) / step_s_);
    constexpr double kMost = 1e11;  // a day of a million a second
    if (!(steps * static_cast<double>(settings.beams) < kMost))
      fail(Status::kLimit, "the drive has more than 1e11 pulses");
    steps_ = static_cast<size_t>(steps) + 1;
  }
  size_t size() const { return steps_ * static_cast<size_t>(settings_.beams); }
  double time_s(size_t i) const { return first_s_ + step_s_ * static_cast<double>(step(i)); }
  double theta_rad(size_t i) const {
    const auto within = static_cast<double>(step(i) % static_cast<size_t>(settings_.pulses));
    return 2 * std::numbers::pi * within / static_cast<double>(settings_.pulses);
  }
  double phi_rad(size_t i) const {
    if (settings_.beams == 1) return std::numbers::pi / 2;
    const auto beam = static_cast<double>(i % static_cast<size_t>(settings_.beams));
    return std::numbers::pi / 2 +
           settings_.fan_rad * (beam / static_cast<double>(settings_.beams - 1) - 0.5);
  }

 private:
  size_t step(size_t i) const { return i / static_cast<size_t>(settings_.beams); }
  const MobileSettings& settings_;
  double first_s_, step_s_;
  size_t steps_ = 0;
};

// What came back, of one chunk of pulses.
struct MobileReturns {
  std::vector<double> times_s, ranges_m, thetas_rad, phis_rad;
  std::vector<Vec3> ends;
  std::vector<uint32_t> triangles;

  void append(const MobileReturns& more) {
    const auto add = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    add(times_s, more.times_s);
    add(ranges_m, more.ranges_m);
    add(thetas_rad, more.thetas_rad);
    add(phis_rad, more.phis_rad);
    add(ends, more.ends);
    add(triangles, more.triangles);
  }
};

class MobileCaster {
 public:
  MobileCaster(const TriangleTree& tree, const Trajectory& trajectory,
               const MobileSettings& settings)
      : tree_(tree),
        settings_(settings),
        train_(trajectory, settings),
        geometry_(mount_of(settings.mount)),
        poses_(trajectory) {}

  size_t size() const { return train_.size(); }

  MobileReturns send(size_t begin, size_t end) const {
    MobileReturns made;
    TimePlace at;
    for (size_t i = begin; i < end; ++i) {
      const Trajectory& drive = poses_.trajectory();
      const double time = std::min(train_.time_s(i), drive.times_s.back());
      at = time_place(drive.times_s, time, i, at.epoch);
      const VehiclePose pose = vehicle_pose(poses_.rotation(at), poses_.position(at),
                                            drive.axes == AxesConvention::kNed);
      const WorldBeam beam = geometry_.beam({0, train_.theta_rad(i), train_.phi_rad(i)}, pose);
      RayHit hit;
      const Ray ray{beam.origin, beam.direction, settings_.min_range_m, settings_.max_range_m};
      if (!tree_.nearest(ray, hit)) continue;
      RandomStream noise(settings_.seed, i);
      const auto noisy = [&](double value, double sigma) {
        return sigma > 0 ? value + sigma * noise.normal() : value;
      };
      made.times_s.push_back(time);
      made.ranges_m.push_back(std::max(1e-3, noisy(hit.t, settings_.noise_range_m)));
      made.thetas_rad.push_back(noisy(train_.theta_rad(i), settings_.noise_angle_rad));
      made.phis_rad.push_back(noisy(train_.phi_rad(i), settings_.noise_angle_rad));
      made.ends.push_back(beam.origin + beam.direction * hit.t);
      made.triangles.push_back(hit.triangle);
    }
    return made;
  }

 private:
  const TriangleTree& tree_;
  const MobileSettings& settings_;
  PulseTrain train_;
  BeamGeometry geometry_;
  PoseInterpolator poses_;
};

MobileReturns drive_along(const MobileCaster& caster, Task& task) {
  constexpr size_t kMobileGrain = 1 << 13;
  std::vector<MobileReturns> chunks((caster.size() + kMobileGrain - 1) / kMobileGrain);
  parallel_for(task, caster.size(), kMobileGrain, [&](size_t begin, size_t end) {
    chunks[begin / kMobileGrain] = caster.send(begin, end);
  });
  MobileReturns all;
  for (MobileReturns& chunk : chunks) {
    all.append(chunk);
    chunk = {};
  }
  return all;
}

// Of each triangle, what stands above the first face with its id.
std::vector<PartNumbers> numbers_of_triangles(const Model& model) {
  const std::vector<PartNumbers> of_part = part_numbers(model);
  std::unordered_map<uint32_t, uint32_t> part_of_id;
  for (const Face& face : model.faces) part_of_id.try_emplace(face.id, face.part);
  constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
  std::vector<PartNumbers> made;
  for (const uint32_t id : model.triangle_faces) {
    const auto found = part_of_id.find(id);
    made.push_back(found == part_of_id.end() ? PartNumbers{kNone, kNone, kNone}
                                             : of_part[found->second]);
  }
  return made;
}

template <class F>
void add_ids(Cloud& cloud, const char* name, const char* meaning,
             const std::vector<uint32_t>& triangles, F&& id) {
  add_column<uint32_t>(cloud.fields, triangles, name, "", meaning, id);
}

}  // namespace

Cloud scan_mobile(const Model& model, const Trajectory& trajectory, const MobileSettings& settings,
                  Task& task) {
  // 1. Every pulse to the first triangle.
  const auto tree = TriangleTree::build(model.vertices, model.triangles, task);
  const MobileCaster caster(*tree, trajectory, settings);
  const MobileReturns all = drive_along(caster, task);
  // 2. Points as a user makes them of what was measured.
  Cloud cloud = georeferenced(trajectory, {all.times_s, all.ranges_m, all.thetas_rad, all.phis_rad},
                              settings.mount, task);
  // 3. What was measured, and the truth.
  const auto add = [&](const char* name, const char* unit, const char* meaning,
                       const std::vector<double>& values) {
    cloud.fields.set(make_column<double>({name, ElementType::kFloat64, 1, unit, meaning}, values));
  };
  add("range", "m", "as measured", all.ranges_m);
  add("theta", "rad", "as measured: about the scanner's z axis", all.thetas_rad);
  add("phi", "rad", "as measured: from the scanner's z axis", all.phis_rad);
  const std::vector<PartNumbers> numbers = numbers_of_triangles(model);
  add_ids(cloud, "face", "id of the face hit", all.triangles,
          [&](uint32_t t) { return model.triangle_faces[t]; });
  add_ids(cloud, "block", "number of the block hit", all.triangles,
          [&](uint32_t t) { return numbers[t].block; });
  add_ids(cloud, "facade", "number of the facade hit", all.triangles,
          [&](uint32_t t) { return numbers[t].facade; });
  add_ids(cloud, "strip", "number of the strip hit", all.triangles,
          [&](uint32_t t) { return numbers[t].strip; });
  auto truth = std::make_shared<Column>(
      FieldInfo{"true_xyz", ElementType::kFloat64, 3, "m", "where the beam ended"},
      all.ends.size());
  for (size_t i = 0; i < all.ends.size(); ++i)
    for (int k = 0; k < 3; ++k)
      truth->values<double>()[3 * i + static_cast<size_t>(k)] = all.ends[i][k];
  cloud.fields.set(std::move(truth));
  return cloud;
}

}  // namespace jalon
