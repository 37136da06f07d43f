// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/model_sample.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/setting_rows.h"
#include "compare/distance/model_surface.h"

namespace jalon {

namespace {

constexpr size_t kModelSampleGrain = 1 << 14;
constexpr double kMostPoints = 4294967294.0;

constexpr auto kModelSampleRows = setting_rows(
    integer_row<&ModelSampleSettings::points>("points", 0, kMostPoints, "points", "",
                                              "Number of points; 0 = by the spacing."),
    number_row<&ModelSampleSettings::spacing_m>(
        "spacing_m", 1e-5, 1e6, "m", "",
        "One point a square of this side on the average, unless the number of points is given."),
    number_row<&ModelSampleSettings::chord_error_m>(
        "chord_error_m", 1e-7, 1, "m", "",
        "Largest distance of chords from the arcs they stand for."),
    integer_row<&ModelSampleSettings::seed>("seed", 0, 9007199254740992.0, "", "",
                                            "The same seed gives the same bits."));

/// Running sums of the triangles' areas.
std::vector<double> cumulated_areas(const ModelSurface& surface) {
  std::vector<double> sums;
  sums.reserve(surface.triangles().size());
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles()) {
    const Vec3 &p = surface.vertices()[a], &q = surface.vertices()[b], &r = surface.vertices()[c];
    sum += norm(cross(q - p, r - p)) / 2;
    sums.push_back(sum);
  }
  return sums;
}

size_t point_count(const ModelSampleSettings& settings, double area_m2) {
  if (settings.points > 0) return settings.points;
  const double n = std::ceil(area_m2 / (settings.spacing_m * settings.spacing_m));
  if (!(n <= kMostPoints)) fail(Status::kLimit, "the spacing gives more than 2^32 - 2 points");
  return static_cast<size_t>(n);
}

/// The columns of the points and what is written to them.
class Sample {
 public:
  explicit Sample(size_t points)
      : xyz_(3 * points),
        normal_(column<float>("normal", 3, "unit normal of the face", points)),
        face_(column<uint32_t>(
            "face", 1, "row of the model's faces; 4294967295 = a triangle of its mesh", points)),
        triangle_(column<uint32_t>("triangle", 1,
                                   "row of the model's triangles; 4294967295 = a face", points)),
        part_(column<uint32_t>("part", 1, "row of the model's parts; 4294967295 = none", points)) {}

  void set(size_t i, const Vec3& point, const Vec3& normal, const ModelSurface::Source& source) {
    for (int a = 0; a < 3; ++a) {
      xyz_[3 * i + static_cast<size_t>(a)] = point[a];
      normal_->values<float>()[3 * i + static_cast<size_t>(a)] = static_cast<float>(normal[a]);
    }
    face_->values<uint32_t>()[i] = source.face;
    triangle_->values<uint32_t>()[i] = source.triangle;
    part_->values<uint32_t>()[i] = source.part;
  }
  Cloud take() {
    Cloud cloud = make_cloud(std::move(xyz_));
    for (const auto& made : {normal_, face_, triangle_, part_}) cloud.fields.set(made);
    return cloud;
  }

 private:
  template <class T>
  static std::shared_ptr<Column> column(const char* name, uint32_t components, const char* meaning,
                                        size_t points) {
    return std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), components, "", meaning},
                                    points);
  }
  Buffer<double> xyz_;
  std::shared_ptr<Column> normal_, face_, triangle_, part_;
};

}  // namespace

std::span<const ParamRow> model_sample_rows() { return kModelSampleRows; }

Cloud sample_model(const Model& model, const ModelSampleSettings& settings, Task& task) {
  const ModelSurface surface(model, settings.chord_error_m, task);
  const std::vector<double> sums = cumulated_areas(surface);
  if (!(sums.back() > 0)) fail(Status::kDegenerate, "the model's surfaces have no area");
  const size_t n = point_count(settings, sums.back());
  Sample sample(n);
  // The area is cut into as many equal parts as there are points, one drawn from each: every triangle gets its share to
  // within two points. Point i is a pure function of the seed and its number.
  parallel_for(task, n, kModelSampleGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      RandomStream random(settings.seed, i);
      const double at =
          (static_cast<double>(i) + random.uniform()) / static_cast<double>(n) * sums.back();
      const auto t =
          static_cast<uint32_t>(std::upper_bound(sums.begin(), sums.end() - 1, at) - sums.begin());
      const auto& [a, b, c] = surface.triangles()[t];
      const Vec3& corner = surface.vertices()[a];
      const Vec3 ab = surface.vertices()[b] - corner, ac = surface.vertices()[c] - corner;
      // Uniform in the triangle: the unit square folded along its diagonal.
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      sample.set(i, corner + (ab * u + ac * v), normalized(cross(ab, ac)), surface.source(t));
    }
  });
  Cloud cloud = sample.take();
  cloud.crs = model.crs;
  return cloud;
}

}  // namespace jalon
