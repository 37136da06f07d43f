// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.h"
#include "modelling/outlines.h"

namespace walls {

using namespace jalon;

struct Rectangle {
  double left, bottom, right, top;
  bool contains(double u, double v) const { return u > left && u < right && v > bottom && v < top; }
  double area() const { return (right - left) * (top - bottom); }
};

/// Coordinates on a grid of 2^-20 m, so that shifts by whole metres are exact.
inline double snapped(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

/// Jittered grid of points where solid(u, v) holds, drawn on the wall plane y = 0 turned by azimuth about Z, with noise
/// along the normal.
struct WallScan {
  double width = 12, height = 9, spacing = 0.015, noise = 0.004, azimuth = 0.3;
  double jitter = 0.5;  ///< of the spacing; 1 = one point anywhere in each cell
  double dropout = 0;   ///< share of points missing at random
  Vec3 shift;           ///< whole metres
  uint64_t seed = 1;
  std::function<bool(double, double)> solid = [](double, double) { return true; };

  std::vector<Vec3> points() const {
    RandomStream random(seed, 7);
    std::vector<Vec3> out;
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    for (double u = 0; u < width; u += spacing)
      for (double v = 0; v < height; v += spacing) {
        const double pu = u + spacing * (0.5 + jitter * (random.uniform() - 0.5));
        const double pv = v + spacing * (0.5 + jitter * (random.uniform() - 0.5));
        const double w = noise * random.normal();
        if (random.uniform() < dropout || pu > width || pv > height || !solid(pu, pv)) continue;
        out.push_back({snapped(pu * c - w * s) + shift.x, snapped(pu * s + w * c) + shift.y,
                       snapped(pv) + shift.z});
      }
    return out;
  }
};

/// A segmentation whose segment s holds the points of part s, fitted by least squares (normal toward -Y as from the
/// street).
inline Segmentation segmentation_of(const std::vector<std::vector<Vec3>>& parts,
                                    Orientation orientation = Orientation::kParallel) {
  size_t n = 0;
  for (const auto& part : parts) n += part.size();
  Buffer<double> xyz(3 * n);
  auto labels = std::make_shared<Column>(FieldInfo{"label", ElementType::kUint32, 1, "", ""}, n);
  auto residuals =
      std::make_shared<Column>(FieldInfo{"residual", ElementType::kFloat32, 1, "m", ""}, n);
  auto orientations =
      std::make_shared<Column>(FieldInfo{"orientation", ElementType::kUint8, 1, "", ""}, n);
  Segmentation out;
  size_t at = 0;
  for (const auto& part : parts) {
    Segment segment;
    segment.label = static_cast<uint32_t>(out.segments.size() + 1);
    segment.orientation = orientation;
    if (part.size() >= 3) {
      Moments moments;
      moments.reference = {std::floor(part[0].x), std::floor(part[0].y), std::floor(part[0].z)};
      for (const Vec3& p : part) moments.add(p);
      fit_plane(moments, segment.fit);
      PlaneFit& fit = segment.fit;
      if (fit.plane.normal.y > 0) fit.plane = {-fit.plane.normal, -fit.plane.offset};
    }
    for (const Vec3& p : part) {
      for (int k = 0; k < 3; ++k) xyz[3 * at + static_cast<size_t>(k)] = p[k];
      labels->values<uint32_t>()[at] = segment.label;
      residuals->values<float>()[at] = static_cast<float>(segment.fit.plane.distance(p));
      orientations->values<uint8_t>()[at] = static_cast<uint8_t>(orientation);
      ++at;
    }
    out.segments.push_back(segment);
  }
  Cloud cloud;
  cloud.xyz_buffer = std::make_shared<Buffer<double>>(std::move(xyz));
  out.cloud = std::make_shared<Cloud>(cloud);
  out.labels = labels;
  out.residuals = residuals;
  out.orientations = orientations;
  out.parameters_json = "{\"distance_tolerance\":0.02}";
  return out;
}

inline Model outlines_of(const Segmentation& segmentation, const char* json = "{}",
                         unsigned threads = 1) {
  ParamSet params("modeller outlines", outlines_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return model_outlines(segmentation, settings_from<VectoriseSetting>(params), task);
}

/// Ring k of a face in wall coordinates (u along the wall, v up), the wall's shift and turn taken off.
inline std::vector<Vec2> ring_on_wall(const Model& model, const Face& face, size_t k,
                                      const WallScan& wall) {
  const Ring& ring = model.rings[face.first_ring + k];
  const double c = std::cos(wall.azimuth), s = std::sin(wall.azimuth);
  std::vector<Vec2> out;
  for (size_t i = 0; i < ring.count; ++i) {
    const Vec3 p = model.vertices[model.corners[ring.first + i]] - wall.shift;
    out.push_back({p.x * c + p.y * s, p.z});
  }
  return out;
}

}  // namespace walls
