// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/setting_rows.h"
#include "scan/densities.h"
#include "scan/scan_output.h"
#include "scan/scanner.h"
#include "scan/surfaces.h"

namespace jalon {

namespace {

constexpr size_t kPointGrain = 16384;  // points a chunk: about 2 ms
constexpr double kMostPoints = 4294967295.0;

/// Corner and two sides of each triangle relative to the origin, and the running sum of their weights.
struct Triangles {
  Vec3 origin;
  Box3 box;  ///< relative to the origin
  std::vector<double> areas, cumulated;
  double area = 0, weight = 0;
};

Triangles measure(const Model& model) {
  Triangles out;
  for (const auto& t : model.triangles)
    for (const uint32_t v : t) out.box.add(model.vertices[v]);
  if (out.box.empty()) return out;
  out.origin = {std::floor(out.box.min.x), std::floor(out.box.min.y), std::floor(out.box.min.z)};
  out.box = {out.box.min - out.origin, out.box.max - out.origin};
  for (const auto& [a, b, c] : model.triangles)
    out.areas.push_back(
        norm(cross(model.vertices[b] - model.vertices[a], model.vertices[c] - model.vertices[a])) /
        2);
  return out;
}

/// The share of all points that each triangle gets: by its area, or by its part of its face's; glass gets less.
void weigh(Triangles& triangles, const Surfaces& surfaces, const std::vector<double>& densities,
           bool equal_counts) {
  std::unordered_map<uint32_t, double> area_of_face;
  const auto n = static_cast<uint32_t>(triangles.areas.size());
  for (uint32_t t = 0; t < n; ++t) area_of_face[surfaces.face(t)] += triangles.areas[t];
  for (uint32_t t = 0; t < n; ++t) {
    const double returned = triangles.areas[t] * surfaces.returned(t) * densities[t],
                 face = area_of_face[surfaces.face(t)];
    triangles.area += returned;
    triangles.weight += equal_counts ? (face > 0 ? returned / face : 0) : returned;
    triangles.cumulated.push_back(triangles.weight);
  }
}

size_t point_count(const SampleSettings& s, double area_m2) {
  if (s.points > 0) return s.points;
  const double n = std::round(area_m2 / (s.spacing_m * s.spacing_m));
  if (!(n <= kMostPoints)) fail(Status::kLimit, "the spacing gives more than 2^32 - 1 points");
  return static_cast<size_t>(n);
}

/// Uniform in the triangle: the unit square folded along its diagonal.
Vec3 point_in(const Model& model, uint32_t triangle, const Vec3& origin, RandomStream& random) {
  const auto& [a, b, c] = model.triangles[triangle];
  double s = random.uniform(), t = random.uniform();
  if (s + t > 1) s = 1 - s, t = 1 - t;
  const Vec3 corner = model.vertices[a] - origin;
  return corner + (model.vertices[b] - model.vertices[a]) * s +
         (model.vertices[c] - model.vertices[a]) * t;
}

/// Point i is a pure function of the seed and its number. The weights are cut into as many equal parts as there are
/// points, one drawn from each: every triangle gets its share to within two points.
void sample_one(const Model& model, const Triangles& triangles, const Surfaces& surfaces,
                const SampleSettings& s, const Vec3& offset, size_t i, size_t n, ScanOutput& out) {
  RandomStream random(s.seed, i);
  const double at =
      (static_cast<double>(i) + random.uniform()) / static_cast<double>(n) * triangles.weight;
  const auto found =
      std::upper_bound(triangles.cumulated.begin(), triangles.cumulated.end() - 1, at);
  const auto triangle = static_cast<uint32_t>(found - triangles.cumulated.begin());
  Vec3 exact = point_in(model, triangle, triangles.origin, random);
  const bool is_outlier = random.uniform() < s.outliers;
  Vec3 measured = exact;
  if (is_outlier) {
    for (int a = 0; a < 3; ++a)
      exact[a] =
          triangles.box.min[a] + (triangles.box.max[a] - triangles.box.min[a]) * random.uniform();
    measured = exact;
  } else {
    if (s.noise_m > 0) measured += surfaces.normal(triangle) * (s.noise_m * random.normal());
    if (s.point_noise_m > 0)
      for (int a = 0; a < 3; ++a) measured[a] += s.point_noise_m * random.normal();
  }
  out.set_point(i, stepped(measured, s.coordinate_step_m) + triangles.origin + offset,
                exact + triangles.origin + offset, is_outlier ? kNoFace : surfaces.face(triangle),
                is_outlier ? kNoSegment : surfaces.segment(triangle));
}

}  // namespace

std::span<const ParamRow> sample_scanner_rows() {
  using S = SampleSettings;
  static constexpr auto kRows = setting_rows(
      integer_row<&S::points>("points", 0, kMostPoints, "points", "",
                              "number of points; 0: by the spacing"),
      number_row<&S::spacing_m>(
          "spacing_m", 1e-4, 1e3, "m", "",
          "mean spacing: one point a square of this side, unless the number of points is given"),
      bool_row<&S::equal_counts>("equal_counts", "",
                                 "every face gets the same number of points, whatever its area"),
      string_row<&S::densities>("densities", "",
                                "factors of the density on parts of some classes, as "
                                "\"gutter=4,ground=0.25\"; 1 on all others"),
      number_row<&S::noise_m>("noise_m", 0, 100, "m", "",
                              "standard deviation along the face's normal"),
      number_row<&S::point_noise_m>("point_noise_m", 0, 100, "m", "",
                                    "standard deviation added to each coordinate"),
      nested_rows<&S::surfaces, kGlassRows>(),
      number_row<&S::outliers>("outliers", 0, 1, "1", "",
                               "share of the points that lie anywhere in the model's box"),
      number_row<&S::coordinate_step_m>("coordinate_step_m", 0, 1, "m", "",
                                        "coordinates are recorded as whole metres and multiples of "
                                        "this, before the offset; 0: as they are"),
      doubles_row<&S::offset_m>(
          "offset_m", -1e9, 1e9, "m", "",
          "three numbers added to all coordinates at the end, e.g. a national grid"),
      nested_rows<&S::surfaces, kTruthRows>(),
      integer_row<&S::seed>("seed", 0, 9007199254740992.0, "1", "",
                            "of places and noise; the same seed gives the same bits"));
  return kRows;
}

Cloud scan_sample(const Model& model, std::span<const ScanStation> stations,
                  const SampleSettings& settings, Task& task) {
  if (!stations.empty())
    fail(Status::kInvalidArgument, "scanner sample takes points from everywhere: no stations");
  const Vec3 offset = offset_of(settings.offset_m);
  validate(model);
  Triangles triangles = measure(model);
  const Surfaces surfaces(model, settings.surfaces, settings.seed, task);
  weigh(triangles, surfaces, triangle_densities(model, settings.densities), settings.equal_counts);
  const size_t n = triangles.weight > 0 ? point_count(settings, triangles.area) : 0;
  ScanOutput out(n);
  parallel_for(task, n, kPointGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      sample_one(model, triangles, surfaces, settings, offset, i, n, out);
  });
  return out.take();
}

}  // namespace jalon
