// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes as triangles: things that appear, go, move and give way between two epochs.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/rigid_motion.h"
#include "model/model.h"
#include "scan/scanner.h"

namespace jalon::test {

/// Triangles of numbered objects; object 1 is what everything stands on.
class TriangleScene {
 public:
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c, uint32_t object) {
    const auto first = static_cast<uint32_t>(model_.vertices.size());
    for (const Vec3& p : {a, b, c}) model_.vertices.push_back(p);
    model_.triangles.push_back({first, first + 1, first + 2});
    model_.triangle_faces.push_back(object);
  }
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, uint32_t object) {
    triangle(a, b, c, object);
    triangle(a, c, d, object);
  }
  void ground(double half, uint32_t object = 1) {
    quad({-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}, object);
  }
  /// A box of this size that stands with the middle of its foot at the place's origin.
  void box(const Vec3& size, const Transform& place, uint32_t object) {
    Vec3 p[8];
    for (int k = 0; k < 8; ++k)
      p[k] =
          place.point({size.x * ((k & 1) - 0.5), size.y * ((k >> 1 & 1) - 0.5), size.z * (k >> 2)});
    constexpr int kSides[6][4] = {{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2},
                                  {1, 3, 7, 5}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    for (const auto& s : kSides) quad(p[s[0]], p[s[1]], p[s[2]], p[s[3]], object);
  }
  /// A grid of nu x nv quads over point(s, t), 0 <= s, t <= 1.
  template <class F>
  void surface(int nu, int nv, uint32_t object, F&& point) {
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j) {
        const auto at = [&](int a, int b) {
          return point(static_cast<double>(a) / nu, static_cast<double>(b) / nv);
        };
        quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), object);
      }
  }
  const Model& model() const { return model_; }

 private:
  Model model_;
};

inline Transform placed(double x, double y, double turn_deg, double z = 0) {
  Transform t = rotation_by({0, 0, turn_deg * std::numbers::pi / 180});
  t.m[3] = x;
  t.m[7] = y;
  t.m[11] = z;
  return t;
}

/// Tripods around the origin.
inline std::vector<ScanStation> stations_around(int count, double distance, double height,
                                                double first_deg = 20) {
  std::vector<ScanStation> out;
  for (int k = 0; k < count; ++k) {
    const double a = (first_deg + 360.0 * k / count) * std::numbers::pi / 180;
    ScanStation& s = out.emplace_back();
    s.name = "station " + std::to_string(k + 1);
    s.pose.m = {1, 0, 0, distance * std::cos(a), 0, 1, 0, distance * std::sin(a), 0, 0, 1, height};
  }
  return out;
}

struct ScanSetting {
  double step_rad = 0.004, noise_m = 0.003;
};

inline CloudPtr scanned(const TriangleScene& scene, const std::vector<ScanStation>& stations,
                        uint64_t seed, const ScanSetting& setting = {}) {
  Task task;
  const StaticSettings scanner{.horizontal_step_rad = setting.step_rad,
                               .vertical_step_rad = setting.step_rad,
                               .range_noise_m = setting.noise_m,
                               .seed = seed};
  return std::make_shared<const Cloud>(scan_static(scene.model(), stations, scanner, task));
}

}  // namespace jalon::test
