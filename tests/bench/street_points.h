// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The street of the measurements: a laser scan of 60 m, six facades with recessed windows, ground,
// columns, gutters, boxes and a sphere; 3 mm noise on each axis, 5 % uniform outliers, point
// density between 1 and 1/10 by the distance to the two scanners, stored in scan order, the street
// turned by 17 degrees. Same arguments, same points.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace bench {

struct Vec {
  double x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kStreetTurn = 17.0 * std::numbers::pi / 180.0;
constexpr double kNoise_m = 0.003;
constexpr size_t kOutlierOneIn = 20;
// Full density within 6 m of a scanner, then falling with the square of the distance, to a tenth at
// the least.
constexpr double kFullDensity_m2 = 36.0;
constexpr double kLeastDensity = 0.1;
constexpr std::array<Vec, 2> kScanners = {{{15, 0, 1.7}, {45, 0, 1.7}}};
constexpr double kColumnStep_rad = 0.002;

/// splitmix64, with normal deviates by Box and Muller: no library distribution, the same numbers
/// everywhere.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed * 7919 + 17) {}
  double uniform() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double normal() {
    const double a = std::max(uniform(), 1e-300);
    const double b = uniform();
    return std::sqrt(-2 * std::log(a)) * std::cos(kTwoPi * b);
  }

 private:
  uint64_t state_;
};

enum class Shape { rectangle, cylinder, sphere };

/// A rectangle spans u and v from its corner; a cylinder stands on origin; a sphere lies round it.
/// Rectangles of one true plane share its number.
struct Surface {
  Shape shape;
  uint32_t plane;  // 0 = curved
  Vec origin, u, v;
  double length_u = 0, length_v = 0, radius = 0;
  double area() const {
    return shape == Shape::sphere ? 2 * kTwoPi * radius * radius : length_u * length_v;
  }
  Vec at(double a, double b) const {
    const double angle = kTwoPi * a;
    switch (shape) {
      case Shape::rectangle:
        return origin + u * (a * length_u) + v * (b * length_v);
      case Shape::cylinder:
        return origin + Vec{radius * std::cos(angle), radius * std::sin(angle), b * length_v};
      case Shape::sphere:
        break;
    }
    const double z = 2 * b - 1;
    const double w = std::sqrt(1 - z * z);
    return origin + Vec{radius * w * std::cos(angle), radius * w * std::sin(angle), radius * z};
  }
};

class Street {
 public:
  std::vector<Surface> surfaces;

  Street() {
    constexpr std::array<double, 6> heights = {12, 15, 18, 14, 12, 16};
    constexpr std::array<double, 6> setbacks = {0, 0.35, -0.25, 0.2, 0, -0.3};
    constexpr std::array<double, 6> depths = {0.18, 0.25, 0.12, 0.2, 0.15, 0.22};
    rectangle(new_plane(), {0, -8, 0}, {1, 0, 0}, 60, {0, 1, 0}, 16);
    for (size_t i = 0; i < 3; ++i) {
      const double x = 20.0 * static_cast<double>(i);
      facade({x, 8 + setbacks[i], 0}, {1, 0, 0}, heights[i], 6, 1.2, 1.6, depths[i]);
      facade({x + 20, -8 - setbacks[3 + i], 0}, {-1, 0, 0}, heights[3 + i], 7, 1.1, 1.7,
             depths[3 + i]);
    }
    for (int i = 0; i < 6; ++i) {
      cylinder({3.0 + 10 * i, 7.0, 0}, 0.25, 4.0);
      cylinder({3.0 + 10 * i, -6.8, 0}, 0.20, 3.5);
    }
    for (int i = 0; i < 4; ++i) {
      cylinder({20.0 * i, 7.6, 0}, 0.06, 11.5);
      cylinder({20.0 * i, -7.55, 0}, 0.05, 11.5);
    }
    box({10, 2.5, 0}, 4.2, 1.8, 1.5);
    box({32, -4.5, 0}, 4.4, 1.8, 1.4);
    box({48, 3, 0}, 4.0, 1.7, 1.6);
    surfaces.push_back({Shape::sphere, 0, {54, -2, 0.9}, {}, {}, 0, 0, 0.9});
  }

 private:
  uint32_t planes_ = 0;
  uint32_t new_plane() { return ++planes_; }

  void rectangle(uint32_t plane, Vec corner, Vec u, double length_u, Vec v, double length_v) {
    if (length_u > 1e-9 && length_v > 1e-9)
      surfaces.push_back({Shape::rectangle, plane, corner, u, v, length_u, length_v, 0});
  }
  void cylinder(Vec foot, double radius, double height) {
    surfaces.push_back({Shape::cylinder, 0, foot, {}, {}, kTwoPi * radius, height, radius});
  }
  void box(Vec o, double lx, double ly, double lz) {
    const Vec x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    rectangle(new_plane(), o + z * lz, x, lx, y, ly);
    rectangle(new_plane(), o, x, lx, z, lz);
    rectangle(new_plane(), o + y * ly, x, lx, z, lz);
    rectangle(new_plane(), o, y, ly, z, lz);
    rectangle(new_plane(), o + x * lx, y, ly, z, lz);
  }

  /// A wall of 20 m along the direction a with rows of windows set back by depth: panes, reveals,
  /// sills and lintels.
  void facade(Vec o, Vec a, double height, int columns, double width_w, double height_w,
              double depth) {
    constexpr double wall_width = 20, first_sill = 1.2;
    const Vec up = {0, 0, 1}, out = cross(a, up);
    const int rows = height < 13 ? 3 : 4;
    const double gap_x = (wall_width - columns * width_w) / (columns + 1);
    const double gap_z = (height - first_sill - rows * height_w) / rows;
    const uint32_t wall = new_plane(), glass = new_plane();
    const auto at = [&](double x, double z, double c) { return o + a * x + up * z + out * c; };
    double top = 0;
    for (int row = 0; row < rows; ++row) {
      const double sill = first_sill + row * (height_w + gap_z);
      rectangle(wall, at(0, top, 0), a, wall_width, up, sill - top);
      for (int i = 0; i <= columns; ++i)
        rectangle(wall, at(i * (gap_x + width_w), sill, 0), a, gap_x, up, height_w);
      for (int i = 0; i < columns; ++i) {
        const double x = gap_x + i * (gap_x + width_w);
        rectangle(glass, at(x, sill, -depth), a, width_w, up, height_w);
        rectangle(new_plane(), at(x, sill, 0), out * -1.0, depth, up, height_w);
        rectangle(new_plane(), at(x + width_w, sill, 0), out * -1.0, depth, up, height_w);
        rectangle(new_plane(), at(x, sill, 0), a, width_w, out * -1.0, depth);
        rectangle(new_plane(), at(x, sill + height_w, 0), a, width_w, out * -1.0, depth);
      }
      top = sill + height_w;
    }
    rectangle(wall, at(0, top, 0), a, wall_width, up, height - top);
  }
};

inline double density_at(Vec p) {
  double nearest_m2 = 1e30;
  for (const Vec& s : kScanners) nearest_m2 = std::min(nearest_m2, dot(p - s, p - s));
  return std::clamp(kFullDensity_m2 / nearest_m2, kLeastDensity, 1.0);
}

struct Sample {
  Vec point;
  uint32_t surface;  // kOutlier, or an index into Street::surfaces
};
constexpr uint32_t kOutlier = 0xffffffffu;

inline std::vector<Sample> sample(const Street& street, size_t count, Random& random) {
  std::vector<double> cumulative_area;
  double total = 0;
  for (const Surface& s : street.surfaces) cumulative_area.push_back(total += s.area());
  std::vector<Sample> points;
  points.reserve(count);
  const size_t outliers = count / kOutlierOneIn;
  while (points.size() < count - outliers) {
    const auto it =
        std::lower_bound(cumulative_area.begin(), cumulative_area.end(), random.uniform() * total);
    const Surface& s = street.surfaces[static_cast<size_t>(it - cumulative_area.begin())];
    const double a = random.uniform(), b = random.uniform();
    const Vec p = s.at(a, b);
    if (random.uniform() > density_at(p)) continue;
    const double nx = random.normal(), ny = random.normal(), nz = random.normal();
    points.push_back(
        {p + Vec{nx, ny, nz} * kNoise_m, static_cast<uint32_t>(&s - street.surfaces.data())});
  }
  while (points.size() < count) {
    const double a = random.uniform(), b = random.uniform(), c = random.uniform();
    points.push_back({{a * 62 - 1, b * 19 - 9.5, c * 19 - 0.5}, kOutlier});
  }
  return points;
}

/// Scan order: the nearer scanner, then its columns of azimuth, then the elevation.
inline void sort_in_scan_order(std::vector<Sample>& points) {
  std::vector<std::pair<uint64_t, uint32_t>> order(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec p = points[i].point;
    const uint64_t scanner =
        dot(p - kScanners[0], p - kScanners[0]) <= dot(p - kScanners[1], p - kScanners[1]) ? 0 : 1;
    const Vec w = p - kScanners[scanner];
    const auto column =
        static_cast<uint64_t>((std::atan2(w.y, w.x) + std::numbers::pi) / kColumnStep_rad);
    const auto rise =
        static_cast<uint64_t>((std::atan2(w.z, std::hypot(w.x, w.y)) + std::numbers::pi / 2) * 1e9);
    order[i] = {(scanner << 60) | (column << 40) | rise, static_cast<uint32_t>(i)};
  }
  std::sort(order.begin(), order.end());
  std::vector<Sample> sorted;
  sorted.reserve(points.size());
  for (const auto& entry : order) sorted.push_back(points[entry.second]);
  points = std::move(sorted);
}

/// The scan: samples in scan order, the street not yet turned.
inline std::vector<Sample> scan_street(const Street& street, size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Sample> points = sample(street, count, random);
  sort_in_scan_order(points);
  return points;
}

inline Vec turned(Vec p) {
  const double c = std::cos(kStreetTurn), s = std::sin(kStreetTurn);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// Coordinates of the turned street that floats hold exactly, so that all libraries see the same.
inline std::vector<double> coordinates(const std::vector<Sample>& points) {
  std::vector<double> xyz;
  xyz.reserve(3 * points.size());
  for (const Sample& sample : points) {
    const Vec p = turned(sample.point);
    for (const double value : {p.x, p.y, p.z}) xyz.push_back(static_cast<float>(value));
  }
  return xyz;
}

}  // namespace bench
