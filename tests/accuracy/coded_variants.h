// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "coded_yard.h"
#include "formats/formats.h"
#include "recipe.h"

namespace jalon::test {

/// A turn about the upright through a pivot, then a shift.
struct CodedMotion {
  double yaw_deg = 0;
  Vec3 pivot, shift;

  Vec3 of(const Vec3& p) const { return pivot + turned(p - pivot, 1) + shift; }
  Vec3 back(const Vec3& p) const { return pivot + turned(p - shift - pivot, -1); }

 private:
  Vec3 turned(const Vec3& d, double sign) const {
    const double c = std::cos(yaw_deg * std::numbers::pi / 180),
                 s = sign * std::sin(yaw_deg * std::numbers::pi / 180);
    return {c * d.x - s * d.y, s * d.x + c * d.y, d.z};
  }
};

/// A change of a coded scan that means nothing.
struct CodedVariant {
  std::string name = {};
  std::function<Vec3(size_t, const Vec3&)> place = {};  ///< of a point of this index
  CodedMotion motion = {};                              ///< of points and lists
  std::vector<size_t> points = {};                      ///< those taken, in this order; empty: all
  std::string file = {};                                ///< extension that it goes through; ""
  uint64_t seed = 1;                                    ///< of the draws
};

/// The points that a variant has, in its order.
inline std::vector<size_t> points_of(const CodedVariant& variant, size_t all) {
  if (!variant.points.empty()) return variant.points;
  std::vector<size_t> out(all);
  std::iota(out.begin(), out.end(), size_t{0});
  return out;
}

inline std::string moved_list(const std::string& list, const CodedMotion& motion) {
  std::string out;
  for (size_t at = 0; at < list.size();) {
    const size_t end = list.find('\n', at);
    std::vector<std::string> cells;
    for (size_t from = at; from <= end;) {
      const size_t to = std::min(list.find(';', from), end);
      cells.push_back(list.substr(from, to - from));
      from = to + 1;
    }
    const Vec3 p = motion.of({std::stod(cells[1]), std::stod(cells[2]), std::stod(cells[3])});
    constexpr int kDecimals = 4;  // as the scene writes them
    out += cells[0] + ";" + jalon::text_of(p.x, kDecimals) + ";" + jalon::text_of(p.y, kDecimals) +
           ";" + jalon::text_of(p.z, kDecimals) + ";" + cells[4] + "\n";
    at = end + 1;
  }
  return out;
}

inline CloudPtr cloud_of(const CodedYard& yard, const CodedVariant& variant) {
  const std::vector<size_t> order = points_of(variant, yard.truth.size());
  Buffer<double> xyz(3 * order.size());
  for (size_t k = 0; k < order.size(); ++k) {
    Vec3 p = yard.cloud->point(order[k]);
    if (variant.place) p = variant.place(order[k], p);
    p = variant.motion.of(p);
    for (int axis = 0; axis < 3; ++axis) xyz[3 * k + static_cast<size_t>(axis)] = p[axis];
  }
  Cloud cloud = make_cloud(std::move(xyz));
  if (!variant.file.empty()) {
    Task task;
    const auto path =
        std::filesystem::temp_directory_path() /
        ("jalon_coded_stability_" + std::to_string(cloud.size()) + "." + variant.file);
    write_cloud(cloud, path.string(), {}, task);
    cloud = read_cloud(path.string(), {}, task);
    std::filesystem::remove(path);
  }
  return std::make_shared<const Cloud>(std::move(cloud));
}

inline CodedVariant jittered(uint64_t seed) {
  constexpr double kJitter_m = 0.0002;  // a tenth of the noise
  constexpr uint64_t kJitterStream = 21;
  auto random = std::make_shared<RandomStream>(seed, kJitterStream);
  return {.name = "jitter of 0.2 mm", .place = [random](size_t, const Vec3& p) {
            const Vec3 by{random->normal(), random->normal(), random->normal()};
            return p + by * kJitter_m;
          }};
}

inline CodedVariant rounded(const std::string& name, double steps_per_m) {
  return {.name = name, .place = [steps_per_m](size_t, const Vec3& p) {
            const auto to_step = [&](double v) {
              return std::round(steps_per_m * v) / steps_per_m;
            };
            return Vec3{to_step(p.x), to_step(p.y), to_step(p.z)};
          }};
}

inline std::vector<size_t> shuffled(size_t points) {
  constexpr uint64_t kOrderStream = 23;
  RandomStream random(1, kOrderStream);
  std::vector<size_t> out(points);
  std::iota(out.begin(), out.end(), size_t{0});
  for (size_t k = out.size(); k > 1; --k) std::swap(out[k - 1], out[random.bits() % k]);
  return out;
}

/// All of them, or one of each kind in the short form.
inline std::vector<CodedVariant> coded_variants(const CodedYard& yard) {
  const Vec3 middle = yard.cloud->point(0);
  const Vec3 to_national_grid{652000 - 734500, 6862000 - 642100, -120};
  const size_t n = yard.truth.size();
  std::vector<size_t> reversed(n), half;
  for (size_t i = 0; i < n; ++i) reversed[i] = n - 1 - i;
  for (size_t i = 0; i < n; i += 2) half.push_back(i);
  std::vector<CodedVariant> out;
  for (uint64_t k = 1; k <= (is_full() ? 5 : 1); ++k) out.push_back(jittered(k));
  out.push_back(rounded("rounded to 1 um", 1e6));
  out.push_back(rounded("rounded to 1 mm", 1e3));
  out.push_back({.name = "reversed", .points = std::move(reversed)});
  out.push_back({.name = "another order", .points = shuffled(n)});
  out.push_back({.name = "half of the points", .points = std::move(half)});
  for (const double yaw_deg :
       is_full() ? std::vector<double>{15, 30, 45, 77, 90, 180, 270} : std::vector<double>{77})
    out.push_back(
        {.name = "turned by " + jalon::text_of(yaw_deg), .motion = {yaw_deg, middle, {}}});
  out.push_back({.name = "national grid", .motion = {0, middle, to_national_grid}});
  for (const char* file : {"las", "ply"}) out.push_back({.name = file, .file = file});
  for (uint64_t seed = 2; seed <= (is_full() ? 10 : 2); ++seed)
    out.push_back({.name = "seed of the draws", .seed = seed});
  return out;
}

}  // namespace jalon::test
