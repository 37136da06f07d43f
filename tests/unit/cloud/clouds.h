// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "cloud/cloud.h"
#include "cloud/operations.h"

namespace jalon::test {

inline Cloud cloud_of(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = points[i][c];
  return make_cloud(std::move(xyz));
}

/// The status that f ends in.
template <class F>
Status status_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

inline double snapped(double x) { return std::floor(x * 0x1p20) * 0x1p-20; }

/// A box of size^3 with points on a 2^-20 m grid: uniform inside when surface is false, else on
/// the floor z = 0 with a little noise.
inline std::vector<Vec3> random_points(size_t n, double size, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points(n);
  for (Vec3& p : points)
    p = {snapped(size * random.uniform()), snapped(size * random.uniform()),
         snapped(size * random.uniform())};
  return points;
}

inline std::vector<Vec3> shifted(std::vector<Vec3> points, const Vec3& by) {
  for (Vec3& p : points) p += by;
  return points;
}
/// National-grid coordinates in whole metres.
inline const Vec3 kFar{652000, 6861000, 120};

/// Points of a unit sphere, Fibonacci spiral: an analytic surface of even spacing sqrt(4 pi / n)
/// with normals p itself.
inline std::vector<Vec3> sphere(size_t n, double radius = 1) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double a = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0)),
                 r = std::sqrt(1 - z * z);
    points.push_back({radius * r * std::cos(a), radius * r * std::sin(a), radius * z});
  }
  return points;
}

inline ParamSet options(const char* name, std::span<const ParamRow> rows) { return {name, rows}; }

/// Settings with these choices, by the names that a user gives them.
template <class S>
S settings_by(std::span<const ParamRow> rows,
              std::initializer_list<std::pair<const char*, const char*>> choices) {
  ParamSet set("settings of a test", rows);
  for (const auto& [name, choice] : choices) set.set_text(name, choice);
  return settings_from<S>(set);
}

inline bool same_bits(const Cloud& a, const Cloud& b) {
  if (a.size() != b.size() || a.fields.size() != b.fields.size()) return false;
  for (const auto& column : a.fields) {
    const Column* other = b.fields.find(column->info().name);
    if (other == nullptr || other->bytes() != column->bytes()) return false;
    if (column->bytes() != 0 && std::memcmp(other->raw(), column->raw(), column->bytes()) != 0)
      return false;
  }
  return a.size() == 0 || std::memcmp(a.xyz().data(), b.xyz().data(), a.xyz().size_bytes()) == 0;
}
/// The fields only.
inline bool same_fields(const Cloud& a, Cloud b) {
  Cloud moved = a;
  moved.xyz_buffer = b.xyz_buffer;
  return same_bits(moved, b);
}

inline Task::Hooks threads(unsigned n) {
  Task::Hooks hooks;
  hooks.threads = n;
  return hooks;
}

}  // namespace jalon::test
