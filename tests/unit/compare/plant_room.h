// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fieldtools/field_values.h"
#include "unit/cloud/clouds.h"

namespace jalon::test {

/// A plant room in a light form: a room of 12 x 8 x 5 m with pipes, beams and tanks, measured with noise of 2 mm, 4
/// mm in a third of it, against its model, in which round things have 8 to 12 facets, five pipes are missing and one
/// lies 30 mm beside its place. Distances are those of the nearest model surface, computed piece by piece.
struct PlantRoom {
  Cloud cloud;  ///< field "distance"
  std::vector<uint32_t>
      removed;  ///< a point: 1 ... 5 = on that missing pipe, 6 = on the shifted one, 0 = unchanged
  std::vector<double>
      truth;  ///< distance of the point without noise from the model: what facets are off
};

/// A straight piece with a round or a square section, along an axis.
struct Bar {
  Vec3 foot, along, u, v;  ///< u, v, along orthonormal
  double length = 1, radius = 0.1;
  int facets = 0;  ///< 0 = round; else a polygon with its corners on the circle
  /// Distance of a point from the mantle.
  double distance(const Vec3& p) const {
    const Vec3 d = p - foot;
    const double t = dot(d, along), beyond = std::max({0.0, -t, t - length});
    const double x = dot(d, u), y = dot(d, v), r = std::hypot(x, y);
    double across = r - radius;
    if (facets > 0) {
      // To the edge of the sector that the point lies in.
      const double sector = 2 * std::numbers::pi / facets, apothem = radius * std::cos(sector / 2);
      const double turn = std::atan2(y, x),
                   rest = turn - sector * std::floor(turn / sector) - sector / 2;
      const double height = r * std::cos(rest) - apothem, side = std::fabs(r * std::sin(rest));
      across = std::hypot(height, std::max(0.0, side - radius * std::sin(sector / 2)));
    }
    return std::hypot(across, beyond);
  }
};

class PlantRoomBuilder {
 public:
  PlantRoomBuilder(size_t points, uint64_t seed) : random_(seed, 0) {
    for (int i = 0; i < 60; ++i)
      pipes_.push_back(bar(0.03 + 0.27 * random_.uniform() * random_.uniform(), 8 + i % 5));
    for (int i = 0; i < 20; ++i) pipes_.push_back(bar(0.15, 4));
    for (int i = 0; i < 5; ++i) pipes_.push_back(tank(i));
    for (const Bar& b : pipes_) model_.push_back(b);
    const double area = total_area();
    for (size_t i = 0; i < points; ++i) add_point(random_.uniform() * area);
  }
  PlantRoom take() {
    out_.cloud = with_field<double>(cloud_of(points_), "distance", "m", "", distances_);
    return std::move(out_);
  }

 private:
  static constexpr double kX = 12, kY = 8, kZ = 5;
  static constexpr size_t kFirstRemoved = 10, kRemoved = 5, kShifted = 20;

  Bar bar(double radius, int facets) {
    Bar b;
    const int axis = static_cast<int>(random_.below(3));
    const double size[3] = {kX, kY, kZ};
    for (int c = 0; c < 3; ++c) b.foot[c] = 0.5 + (size[c] - 1) * random_.uniform();
    b.foot[axis] = 0.3;
    b.along[axis] = 1;
    b.u[(axis + 1) % 3] = 1;
    b.v[(axis + 2) % 3] = 1;
    b.length = size[axis] - 0.6;
    b.radius = radius;
    b.facets = facets;
    return b;
  }
  Bar tank(int i) {
    Bar b;
    b.foot = {1.5 + 2.2 * i, 1.2, 0};
    b.along = {0, 0, 1};
    b.u = {1, 0, 0};
    b.v = {0, 1, 0};
    b.length = 2;
    b.radius = 0.7;
    b.facets = 12;
    return b;
  }
  bool is_round(size_t i) const { return i < 60 || i >= 80; }
  bool is_missing(size_t i) const { return i >= kFirstRemoved && i < kFirstRemoved + kRemoved; }
  double total_area() const {
    double area = 2 * (kX * kY + kX * kZ + kY * kZ);
    for (const Bar& b : pipes_) area += 2 * std::numbers::pi * b.radius * b.length;
    return area;
  }

  void add_point(double at) {
    for (size_t i = 0; i < pipes_.size(); ++i) {
      const Bar& b = pipes_[i];
      at -= 2 * std::numbers::pi * b.radius * b.length;
      if (at >= 0) continue;
      const double turn = 2 * std::numbers::pi * random_.uniform(),
                   along = b.length * random_.uniform();
      Vec3 out = b.u * std::cos(turn) + b.v * std::sin(turn);
      double r = b.radius;
      if (!is_round(i)) {  // beams are as square as in the model
        const double sector = std::numbers::pi / 2,
                     rest = turn - sector * std::floor(turn / sector) - sector / 2;
        r = b.radius * std::cos(sector / 2) / std::cos(rest);
      }
      const uint32_t label = is_missing(i)   ? static_cast<uint32_t>(i - kFirstRemoved + 1)
                             : i == kShifted ? 6
                                             : 0;
      finish(b.foot + b.along * along + out * r, out, label);
      return;
    }
    const double size[3] = {kX, kY, kZ};
    Vec3 p{kX * random_.uniform(), kY * random_.uniform(), kZ * random_.uniform()}, n;
    const auto axis = static_cast<int>(random_.below(3));
    const bool far = random_.below(2) != 0;
    p[axis] = far ? size[axis] : 0;
    n[axis] = far ? -1 : 1;
    finish(p, n, 0);
  }

  void finish(const Vec3& clean, const Vec3& normal, uint32_t label) {
    const double sigma = clean.x > 8 ? 0.004 : 0.002;
    points_.push_back(clean + normal * (sigma * random_.normal()));
    distances_.push_back(distance(points_.back()));
    out_.truth.push_back(distance(clean));
    out_.removed.push_back(label);
  }

  double distance(const Vec3& p) const {
    double least = std::min({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), std::fabs(kX - p.x),
                             std::fabs(kY - p.y), std::fabs(kZ - p.z)});
    for (size_t i = 0; i < model_.size(); ++i) {
      if (is_missing(i)) continue;
      const Bar& b = model_[i];
      least = std::min(least, b.distance(i == kShifted ? p - b.u * 0.03 : p));
    }
    return least;
  }

  RandomStream random_;
  std::vector<Bar> pipes_, model_;
  std::vector<Vec3> points_;
  std::vector<double> distances_;
  PlantRoom out_;
};

}  // namespace jalon::test
