// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/ground/ground_rises.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/parallel.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"
#include "model/trajectory/interpolation.h"

namespace jalon {

namespace {

constexpr double kHalfCarriageway_m = 3.5;  // of two lanes: beside it cars are parked
// No ground is flat to less, and no model of it as exact.
constexpr double kLeastSigma_m = 1e-4;
constexpr double kMedianDeviationToSigma = 1.4826;

double middle_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// From the point straight up or down to the ground, whichever is nearer; NaN where there is none within reach.
double rise_to(const TriangleTree& ground, const Vec3& p, double reach_m) {
  double best = kNaN;
  for (const double way : {1.0, -1.0}) {
    RayHit hit;
    if (!ground.nearest({p, {0, 0, way}, 0, reach_m}, hit)) continue;
    if (!(std::fabs(best) <= hit.t)) best = way * hit.t;
  }
  return best;
}

struct Seen {
  std::vector<double> rises;
  double shares = 0;
};

GroundRise rise_of(uint32_t interval, Seen& seen, double noise_m) {
  GroundRise made;
  const auto n = static_cast<double>(seen.rises.size());
  made.interval = interval;
  made.points = seen.rises.size();
  made.share = seen.shares / n;
  made.rise_m = middle_of(seen.rises);
  for (double& r : seen.rises) r = std::fabs(r - made.rise_m);
  const double scatter = std::max(noise_m, kMedianDeviationToSigma * middle_of(seen.rises));
  // Of a median of normal values.
  made.variance_m2 = std::numbers::pi / 2 * scatter * scatter / n + kLeastSigma_m * kLeastSigma_m;
  return made;
}

}  // namespace

std::shared_ptr<const TriangleTree> ground_of(const Model& model, Task& task) {
  std::vector<Vec3> corners;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (const Face& face : model.faces) {
    if (face.part >= model.parts.size() || model.parts[face.part].part_class != part_class::kGround)
      continue;
    for (const auto& triangle : triangles_of_face(model, face)) {
      const auto first = static_cast<uint32_t>(corners.size());
      for (const uint32_t v : triangle) corners.push_back(model.vertices[v]);
      triangles.push_back({first, first + 1, first + 2});
    }
  }
  return triangles.empty() ? nullptr : TriangleTree::build(corners, triangles, task);
}

std::vector<GroundRise> ground_rises(const Cloud& cloud, const Trajectory& drive,
                                     std::span<const double> control_times_s,
                                     const TriangleTree& ground, const GroundSearch& search,
                                     Task& task) {
  const auto times = cloud.fields.require("time").values<double>();
  // 1. How far each point under the vehicle is below the ground.
  std::vector<double> rises(cloud.size(), kNaN);
  std::vector<TimePlace> places(cloud.size());
  const PoseInterpolator poses(drive);
  constexpr size_t kRiseGrain = 1 << 12;
  parallel_for(task, cloud.size(), kRiseGrain, [&](size_t begin, size_t end) {
    TimePlace pose, control;
    for (size_t i = begin; i < end; ++i) {
      if (times[i] < control_times_s.front() || times[i] > control_times_s.back()) continue;
      pose = time_place(drive.times_s, times[i], i, pose.epoch);
      const Vec3 p = cloud.point(static_cast<uint32_t>(i)), off = p - poses.position(pose);
      if (std::hypot(off.x, off.y) > kHalfCarriageway_m) continue;
      places[i] = control = time_place(control_times_s, times[i], i, control.epoch);
      const size_t c = control.epoch;
      rises[i] = rise_to(ground, p, std::max(search.greatest_m[c], search.greatest_m[c + 1]));
    }
  });
  // 2. Interval by interval.
  std::vector<Seen> seen(control_times_s.size() - 1);
  for (size_t i = 0; i < rises.size(); ++i) {
    if (std::isnan(rises[i])) continue;
    seen[places[i].epoch].rises.push_back(rises[i]);
    seen[places[i].epoch].shares += places[i].share;
  }
  std::vector<GroundRise> made;
  for (uint32_t c = 0; c < seen.size(); ++c)
    if (!seen[c].rises.empty() && seen[c].rises.size() >= search.least_points)
      made.push_back(rise_of(c, seen[c], search.noise_m));
  return made;
}

}  // namespace jalon
