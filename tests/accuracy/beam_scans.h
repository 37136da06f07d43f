// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What spinning heads of several beams measure: lines of points, far apart from each other and dense along them.

#include "accuracy/registration_pairs.h"

namespace jalon::test {

/// A head of several beams, evenly spread over its field of view, as vehicles and robots carry them.
struct BeamHead {
  const char* name;
  int beams;
  double lowest_deg, highest_deg;
  double turn_step_deg;  ///< between two pulses of a beam
  double noise_m;
  double
      beam_bias_m;  ///< standard deviation of the beams' zero errors (Glennie & Lichti 2010: some centimetres)
  double drift_m;  ///< that the head moves within a turn, as it is carried on
};
inline constexpr BeamHead kDevelopedHeads[] = {
    {"32 beams", 32, -30.67, 10.67, 0.16, 0.01, 0.01, 0.04},
    {"64 beams", 64, -24.8, 2, 0.18, 0.015, 0.008, 0}};
inline constexpr BeamHead kReportedHeads[] = {
    {"16 beams", 16, -15, 15, 0.2, 0.02, 0.008, 0},
    {"40 beams", 40, -25, 15, 0.2, 0.012, 0.01, 0.05},
    {"128 beams", 128, -22.5, 22.5, 0.35, 0.008, 0.004, 0.02}};

/// One turn of a head. A pulse that meets nothing is a point at the head itself where has_empty, as many drivers
/// write it.
inline StandScan turn_of(const BeamHead& head, const PairScene& scene, size_t standpoint,
                         uint64_t seed, bool has_empty = false) {
  constexpr double kDegree = std::numbers::pi / 180;
  Task task;
  const auto tree = TriangleTree::build(scene.vertices, scene.triangles, task);
  RandomStream random(seed, 300 + standpoint);
  const Vec3 from = scene.standpoints[standpoint];
  const double heading = between(random, -3.1, 3.1), sideways = between(random, -9, 9);
  const Transform T_scan_world =
      has_empty ? motion_about(from, {0, 0, heading}, Vec3{} - from)
                : motion_about(from, {0, 0, heading}, Vec3{sideways, sideways / 2, 0} - from);
  RandomStream of_beams(static_cast<uint64_t>(head.beams),
                        301);  // of one head: the same in all its turns
  std::vector<double> bias(static_cast<size_t>(head.beams));
  for (double& b : bias) b = head.beam_bias_m * of_beams.normal();
  const Vec3 drift = normalized({random.normal(), random.normal(), 0}) * head.drift_m;
  std::vector<Vec3> points;
  const int pulses = static_cast<int>(360 / head.turn_step_deg);
  const double first = 360 * random.uniform();
  for (int pulse = 0; pulse < pulses; ++pulse)
    for (int beam = 0; beam < head.beams; ++beam) {
      const double turn = (first + pulse * head.turn_step_deg) * kDegree;
      const double up =
          (head.lowest_deg + beam * (head.highest_deg - head.lowest_deg) / (head.beams - 1)) *
          kDegree;
      const Vec3 d{std::cos(turn) * std::cos(up), std::sin(turn) * std::cos(up), std::sin(up)};
      const Vec3 at = from + drift * (static_cast<double>(pulse) / pulses - 0.5);
      RayHit hit;
      if (tree->nearest({at, d, 0.5, scene.range_m}, hit))
        points.push_back(T_scan_world.point(
            from + d * (hit.t + bias[static_cast<size_t>(beam)] + head.noise_m * random.normal())));
      else if (has_empty) points.push_back(T_scan_world.point(from));
    }
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = points[i][c];
  return {std::make_shared<const Cloud>(make_cloud(std::move(xyz))), inverse(T_scan_world)};
}

}  // namespace jalon::test
