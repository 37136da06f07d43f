// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A slope before and after a slide, from one scanner or two at its foot, with truth: what went down and came, and what
// no scanner could see.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "unit/scan/fixture.h"
#include "base/random.h"
#include "scan/builder/builder.h"
#include "spatial/triangles/tree.h"

namespace jalon::test {

/// Shapes of what moved.
enum class SlideKind { kBowl, kSlump, kFlow, kLobes, kSteps, kWedge };

struct SlideScene {
  static constexpr double kWidth_m = 60, kDepth_m = 48, kMesh_m = 0.25;

  SlideKind kind = SlideKind::kBowl;
  uint64_t seed = 1;
  double slope = 0.6;  ///< tangent
  Vec2 scar, toe;
  double scar_m = 2, toe_m = 1.4;  ///< deepest and highest
  Vec2 scar_size, toe_size;        ///< half axes
  struct Wave {
    double u, v, phase, height_m;
  };
  std::vector<Wave> relief, rough_before, rough_after;
  Vec2 spur;  ///< a knoll that hides what is behind it
  double spur_m = 3;
  std::vector<Vec2> boulders, bushes;
  std::vector<Vec3> eyes;
  Vec3 misfit_m;  ///< of the compared cloud, as of a registration

  explicit SlideScene(SlideKind of_kind, uint64_t with_seed) : kind(of_kind), seed(with_seed) {
    RandomStream random(seed, 7001 + static_cast<uint64_t>(kind));
    const auto between = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    slope = between(0.45, 0.75);
    scar = {between(24, 36), between(30, 35)};
    toe = {scar.u + between(-4, 4), scar.v - between(15, 18)};
    scar_size = {between(7, 11), between(5, 7)};
    toe_size = {between(7, 10), between(4, 6)};
    scar_m = between(0.8, 2.5);
    toe_m = between(0.6, 1.6);
    const auto waves = [&](int n, double low_m, double high_m, double height_m) {
      std::vector<Wave> out;
      for (int i = 0; i < n; ++i) {
        const double length = between(low_m, high_m), turn = between(0, 2 * std::numbers::pi);
        const double k = 2 * std::numbers::pi / length;
        out.push_back({k * std::cos(turn), k * std::sin(turn), between(0, 2 * std::numbers::pi),
                       height_m * length / high_m});
      }
      return out;
    };
    relief = waves(4, 12, 30, 0.5);
    rough_before = waves(12, 1.5, 5, 0.05);
    rough_after = waves(12, 1.5, 5, 0.05);
    spur = {between(10, 50), between(6, 12)};
    spur_m = between(2, 3.5);
    for (int i = 0; i < 6; ++i) boulders.push_back({between(3, 57), between(3, 45)});
    while (bushes.size() < 5) {  // what grew on the moved ground would count as ground that went
      const Vec2 at{between(3, 57), between(3, 45)};
      if (moved_m(at.u, at.v) == 0) bushes.push_back(at);
    }
    eyes.push_back({between(22, 38), -18, 2});
    if (seed % 2 == 0) eyes.push_back({eyes[0].x < 30 ? 58.0 : 2.0, -14, 2});
    misfit_m = Vec3{random.normal(), random.normal(), random.normal()} * 0.004;
  }

  // 0 outside, 1 inside, with an edge of the kind's own.
  static double bowl(double q) { return q < 1 ? 0.5 + 0.5 * std::cos(std::numbers::pi * q) : 0; }
  static double slab(double q) { return std::clamp((1 - q) * 6, 0.0, 1.0); }
  /// What moved there: negative where it is gone.
  double moved_m(double x, double y) const {
    const double su = (x - scar.u) / scar_size.u, sv = (y - scar.v) / scar_size.v;
    const double tu = (x - toe.u) / toe_size.u, tv = (y - toe.v) / toe_size.v;
    double s = std::hypot(su, sv), t = std::hypot(tu, tv);
    switch (kind) {
      case SlideKind::kBowl:
        return -scar_m * bowl(s) + toe_m * bowl(t);
      case SlideKind::kSlump:  // a steep head scarp, rounded below, and a rectangular tongue
        s = sv > 0 ? std::max(std::abs(su), sv) : s;
        t = std::pow(std::pow(std::abs(tu), 4) + std::pow(std::abs(tv), 4), 0.25);
        return -scar_m * slab(s) * (0.6 + 0.4 * std::clamp(sv, -1.0, 1.0)) + toe_m * slab(t);
      case SlideKind::kFlow: {  // a narrow channel down to a fan
        const double along = (scar.v - y) / (scar.v - toe.v);
        const double middle = scar.u + (toe.u - scar.u) * along + std::sin(4 * along);
        const double width = 2.2 + 0.8 * std::sin(3 * along + scar.u);
        const double channel = along > -0.4 && along < 0.7 ? slab(std::abs(x - middle) / width) : 0;
        const double fan = y < toe.v + toe_size.v ? slab(std::hypot(tu, tv * 0.9)) : 0;
        return -0.6 * scar_m * channel + toe_m * fan * (channel > 0 ? 0 : 1);
      }
      case SlideKind::kLobes: {  // outlines with five and three lobes
        s *= 1 + 0.25 * std::sin(5 * std::atan2(sv, su) + scar.u);
        t *= 1 + 0.3 * std::sin(3 * std::atan2(tv, tu) + toe.u);
        return -scar_m * std::sqrt(bowl(s)) + toe_m * std::sqrt(bowl(t));
      }
      case SlideKind::
          kSteps: {  // three blocks, each sunk deeper than the one above, and their rubble
        const double block =
            std::abs(su) < 1 && std::abs(sv) < 1 ? std::floor((1 - sv) * 1.5) + 1 : 0;
        return -scar_m * block / 3 + toe_m * bowl(std::max(std::abs(tu), std::abs(tv)));
      }
      case SlideKind::kWedge: {  // a wedge out of the slope, deepest on its axis, and a cone below
        const double inside = std::min(1 - std::abs(su) - 0.5 * (1 + sv), 1 + sv) / 1.5;
        return -scar_m * std::clamp(inside * 1.5, 0.0, 1.0) + toe_m * std::max(0.0, 1 - t);
      }
    }
    return 0;
  }
  static double sum_of(const std::vector<Wave>& waves, double x, double y) {
    double h = 0;
    for (const Wave& w : waves) h += w.height_m * std::sin(w.u * x + w.v * y + w.phase);
    return h;
  }
  double ground_m(double x, double y, bool after) const {
    const double d = std::hypot(x - spur.u, y - spur.v) / 4;
    double h = slope * y + sum_of(relief, x, y) + spur_m * bowl(d) + sum_of(rough_before, x, y);
    if (!after) return h;
    const double moved = moved_m(x, y);
    const double fresh = std::clamp(std::abs(moved) / 0.3, 0.0, 1.0);  // broken ground
    return h + moved + fresh * (sum_of(rough_after, x, y) - sum_of(rough_before, x, y));
  }

  static constexpr double kBoulder_m = 0.6;
  bool has_boulder(const Vec2& at, bool after) const { return !after || moved_m(at.u, at.v) == 0; }
  Vec3 boulder_middle(const Vec2& at, bool after) const {
    return {at.u, at.v, ground_m(at.u, at.v, after) + 0.2};
  }
  /// How far a boulder rises over the ground, for boulders are ground too: those on what moved went away with it.
  double boulder_over_m(double x, double y, double ground, bool after) const {
    double out = 0;
    for (const Vec2& at : boulders) {
      const double rest =
          kBoulder_m * kBoulder_m - (x - at.u) * (x - at.u) - (y - at.v) * (y - at.v);
      if (rest > 0 && has_boulder(at, after))
        out = std::max(out, boulder_middle(at, after).z + std::sqrt(rest) - ground);
    }
    return out;
  }

  Model model(bool after) const {
    SceneBuilder out{Transform{}};
    const uint32_t ground = out.new_id();
    out.relief(
        static_cast<uint32_t>(kWidth_m / kMesh_m), static_cast<uint32_t>(kDepth_m / kMesh_m),
        [&](uint32_t i, uint32_t j) {
          const double x = i * kMesh_m, y = j * kMesh_m;
          return Vec3{x, y, ground_m(x, y, after)};
        },
        [&](uint32_t, uint32_t) { return ground; });
    for (const Vec2& at : boulders)
      if (has_boulder(at, after)) out.sphere(boulder_middle(at, after), kBoulder_m, 24);
    for (size_t i = 0; i < bushes.size(); ++i)  // the wind has moved their leaves
      out.crown({bushes[i].u, bushes[i].v, ground_m(bushes[i].u, bushes[i].v, after) + 0.5}, 1, 300,
                0.12, RandomStream(seed, 40 + i + (after ? 100 : 0)));
    return out.take();
  }

  Cloud scan(bool after) const {
    std::vector<ScanStation> stations;
    for (const Vec3& eye : eyes) stations.push_back(station_at(eye));
    StaticSettings s;
    s.horizontal_step_rad = s.vertical_step_rad = 0.0025;
    s.horizontal_from_rad = -1.3;
    s.horizontal_to_rad = 1.3;
    s.vertical_from_rad = -0.3;
    s.vertical_to_rad = 0.9;
    s.range_noise_m = 0.005;
    s.seed = 2 * seed + (after ? 1 : 0);
    Cloud cloud = scanned(model(after), s, stations);
    if (!after) return cloud;
    Transform shift;
    shift.m[3] = misfit_m.x;
    shift.m[7] = misfit_m.y;
    shift.m[11] = misfit_m.z;
    return transformed(cloud, shift);
  }
  static Cloud transformed(const Cloud& cloud, const Transform& by) {
    Cloud out = cloud;
    Buffer<double> xyz(3 * cloud.size());
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Vec3 p = by.point(cloud.point(i));
      for (int a = 0; a < 3; ++a) xyz[3 * i + static_cast<size_t>(a)] = p[a];
    }
    Cloud made = make_cloud(std::move(xyz));
    made.stations = cloud.stations;
    for (Station& station : made.stations) station.pose = by * station.pose;
    made.crs = cloud.crs;
    return made;
  }

  /// The rectangle that was to be surveyed.
  std::vector<double> outline() const {
    std::vector<double> out;
    for (const Vec2& c : {Vec2{1, 1}, Vec2{kWidth_m - 1, 1}, Vec2{kWidth_m - 1, kDepth_m - 1},
                          Vec2{1, kDepth_m - 1}})
      for (const double value : {c.u, c.v, slope * c.v}) out.push_back(value);
    return out;
  }
};

}  // namespace jalon::test
