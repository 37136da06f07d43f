// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/numbers.h"
#include "base/setting_rows.h"
#include "cloud/neighbourhoods.h"
#include "cloud/operations.h"
#include "cloud/surface_classes.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

constexpr const char* kWhichHelp =
    "Fields to compute, separated by spaces or commas: density roughness mean_curvature "
    "gaussian_curvature surface_variation linearity planarity sphericity verticality "
    "surface_class, or all";

enum Feature : size_t {
  kDensity,
  kRoughness,
  kMeanCurvature,
  kGaussianCurvature,
  kSurfaceVariation,
  kLinearity,
  kPlanarity,
  kSphericity,
  kVerticality,
  kFeatures,                  // those with a number a point
  kSurfaceClass = kFeatures,  // which looks at the whole cloud's noise
  kNames
};

struct FeatureInfo {
  const char *name, *unit, *meaning;
};
constexpr const char* kSurfaceClassName = "surface_class";
constexpr FeatureInfo kInfos[kFeatures] = {
    {"density", "1/m^2", "points per square metre of surface"},
    {"roughness", "m", "distance to the least-squares plane of the neighbours"},
    {"mean_curvature", "1/m", "absolute mean curvature of the local quadric"},
    {"gaussian_curvature", "1/m^2", "Gaussian curvature of the local quadric"},
    {"surface_variation", "1", "least eigenvalue of the covariance over their sum"},
    {"linearity", "1", "(s1 - s2) / s1, s = square roots of the eigenvalues, s1 largest"},
    {"planarity", "1", "(s2 - s3) / s1"},
    {"sphericity", "1", "s3 / s1"},
    {"verticality", "1", "1 - |z component of the normal|"},
};

using Choice = std::array<bool, kNames>;

const char* name_of(size_t feature) {
  return feature == kSurfaceClass ? kSurfaceClassName : kInfos[feature].name;
}

bool any_number(const Choice& chosen) {
  return std::find(chosen.begin(), chosen.begin() + kFeatures, true) != chosen.begin() + kFeatures;
}

Choice parse_which(std::string_view text) {
  Choice chosen{};
  bool any = false;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of(" ,;\t\n"), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    any = true;
    if (word == "all") {
      chosen.fill(true);
      continue;
    }
    size_t i = 0;
    while (i < kNames && word != name_of(i)) ++i;
    if (i == kNames)
      fail(Status::kInvalidArgument, "no feature \"%.*s\"; %s",
           static_cast<int>(std::min<size_t>(word.size(), 100)), word.data(), kWhichHelp);
    chosen[i] = true;
  }
  if (!any) fail(Status::kInvalidArgument, "which names no feature; %s", kWhichHelp);
  return chosen;
}

using Values = std::array<double, kFeatures>;

struct FeaturesScratch {
  std::vector<Vec3> points, work;
  Values last{};
};

/// k / (pi d_k^2) with the k others, or n / (pi r^2): Girardeau-Montaut 2006, C.2. Duplicates only: NaN.
double density_in_ball(size_t count, double radius_m) {
  return static_cast<double>(count) / (std::numbers::pi * radius_m * radius_m);
}
double density(const Neighbourhood& around, double radius_m) {
  const auto n = static_cast<double>(around.neighbours.size());
  if (radius_m > 0) return density_in_ball(around.neighbours.size(), radius_m);
  double farthest = 0;
  for (const float d : around.squared) farthest = std::max(farthest, double{d});
  return farthest > 0 ? (n - 1) / (std::numbers::pi * farthest) : kNaN;
}

double distance_to_plane(const Moments& moments, const Vec3& p) {
  PrincipalFrame frame;
  return principal_frame(moments, frame) ? std::fabs(dot(frame.n, p - frame.centre)) : kNaN;
}

/// Distance of the point to the plane of its neighbours, which do not include it.
double roughness(const Octree& tree, const Neighbourhood& around) {
  const Vec3 p = tree.local(around.point);
  Moments moments;
  moments.reference = p;
  for (const uint32_t j : around.neighbours)
    if (j != around.point) moments.add(tree.local(j));
  return distance_to_plane(moments, p);
}

/// Demantke et al. 2011: dimensionality from the square roots of the eigenvalues, s1 >= s2 >= s3.
void shape(const PrincipalFrame& frame, Values& values) {
  const auto& e = frame.eigenvalues;
  const double s1 = std::sqrt(e[2]), s2 = std::sqrt(e[1]), s3 = std::sqrt(e[0]);
  values[kSurfaceVariation] = e[0] / (e[0] + e[1] + e[2]);
  values[kLinearity] = (s1 - s2) / s1;
  values[kPlanarity] = (s2 - s3) / s1;
  values[kSphericity] = s3 / s1;
  values[kVerticality] = 1 - std::fabs(frame.n.z);
}

bool with_curvatures(const Choice& chosen) {
  return chosen[kMeanCurvature] || chosen[kGaussianCurvature];
}

void curvatures(const LocalQuadric& fit, Values& values) {
  // The side of the normal is not known, so the sign of the mean curvature says nothing.
  values[kMeanCurvature] = std::fabs(fit.quadric.mean_curvature(fit.x, fit.y));
  values[kGaussianCurvature] = fit.quadric.gaussian_curvature(fit.x, fit.y);
}

Values features_at(const Octree& tree, const Neighbourhood& around, double radius_m,
                   const Choice& chosen, FeaturesScratch& s) {
  Values values;
  values.fill(kNaN);
  if (chosen[kDensity]) values[kDensity] = density(around, radius_m);
  if (chosen[kRoughness]) values[kRoughness] = roughness(tree, around);
  const Vec3 p = tree.local(around.point);
  Moments moments;
  moments.reference = p;
  s.points.clear();
  for (const uint32_t j : around.neighbours) {
    s.points.push_back(tree.local(j));
    moments.add(s.points.back());
  }
  PrincipalFrame frame;
  if (!principal_frame(moments, frame)) return values;
  shape(frame, values);
  LocalQuadric fit;
  if (with_curvatures(chosen) && local_quadric(frame, s.points, p, s.work, fit))
    curvatures(fit, values);
  return values;
}

Values features_of_sums(const SummedBalls& sums, const Octree::RangedBall& ball, double radius_m,
                        const Choice& chosen) {
  Values values;
  values.fill(kNaN);
  if (chosen[kDensity]) values[kDensity] = density_in_ball(ball.count, radius_m);
  const Moments moments = sums.moments(ball);
  if (chosen[kRoughness]) {
    Moments others = moments;  // about the point itself, which adds to their number only
    --others.n;
    values[kRoughness] = distance_to_plane(others, moments.reference);
  }
  PrincipalFrame frame;
  if (!principal_frame(moments, frame)) return values;
  shape(frame, values);
  LocalQuadric fit;
  if (with_curvatures(chosen) && sums.quadric(frame, ball, fit)) curvatures(fit, values);
  return values;
}

}  // namespace

std::span<const ParamRow> features_rows() {
  using S = FeaturesSettings;
  static constexpr auto kRows = setting_rows(
      string_row<&S::which>("which", "", kWhichHelp),
      integer_row<&S::k>("k", 3, 256, "points", "",
                         "Number of nearest neighbours, the point itself included; not read when "
                         "radius_m is above 0"),
      number_row<&S::radius_m>("radius_m", 0, 1e6, "m", "",
                               "Radius of the ball of neighbours; 0 = take the k nearest instead"));
  return kRows;
}

Cloud with_features(const Cloud& cloud, const FeaturesSettings& settings, Task& task) {
  const Choice chosen = parse_which(settings.which);
  const double radius_m = settings.radius_m;
  std::shared_ptr<const Octree> tree;
  {
    ProgressSpan span(task, 0, 0.2, "index");
    tree = cloud.octree(task);
  }
  // Behind the tree, whose making takes more than what stays of it and these columns.
  require_memory(cloud.size() * sizeof(float) *
                 static_cast<size_t>(std::count(chosen.begin(), chosen.begin() + kFeatures, true)));
  std::array<std::shared_ptr<Column>, kFeatures> columns;
  std::array<float*, kFeatures> out{};
  for (size_t f = 0; f < kFeatures; ++f) {
    if (!chosen[f]) continue;
    columns[f] = std::make_shared<Column>(
        FieldInfo{kInfos[f].name, ElementType::kFloat32, 1, kInfos[f].unit, kInfos[f].meaning},
        cloud.size());
    out[f] = columns[f]->values<float>().data();
    have_pages(out[f], cloud.size(), task);
  }
  Cloud result = cloud;
  ProgressSpan span(task, 0.2, 1, "features");
  if (chosen[kSurfaceClass]) {
    ProgressSpan classes(task, 0, any_number(chosen) ? 0.3 : 1);
    result.fields.set(surface_classes(*tree, settings.k, radius_m, task));
  }
  if (!any_number(chosen)) return result;
  ProgressSpan numbers(task, chosen[kSurfaceClass] ? 0.3 : 0, 1);
  const auto order = tree->order();
  const auto write = [&](size_t point, const Values& values) {
    for (size_t f = 0; f < kFeatures; ++f)
      if (out[f] != nullptr) out[f][order[point]] = static_cast<float>(values[f]);
  };
  for_each_summed_neighbourhood<FeaturesScratch>(
      *tree, settings.k, radius_m, with_curvatures(chosen), task,
      [&](const Neighbourhood& around, FeaturesScratch& scratch) {
        if (!around.repeats) scratch.last = features_at(*tree, around, radius_m, chosen, scratch);
        write(around.point, scratch.last);
      },
      [&](const SummedBalls& sums, const Octree::RangedBall& ball) {
        write(ball.point, features_of_sums(sums, ball, radius_m, chosen));
      });
  for (auto& column : columns)
    if (column) result.fields.set(std::move(column));
  return result;
}

}  // namespace jalon
