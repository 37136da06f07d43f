// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/gradient.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/neighbourhoods.h"
#include "fieldtools/place_values.h"

namespace jalon {

namespace {

constexpr size_t kGradientGrain = 1 << 15;
constexpr double kSpacings = 4;  // automatic radius, of the 3 to 5 spacings that keep a ball full
constexpr double kLipschitzSlack = 1e-3;  // distances that went through single precision
constexpr size_t kFewestForSlopes = 4;    // a plane of the values has three unknowns
constexpr Vec3 kNoGradient{kNaN, kNaN, kNaN};

struct NoScratch {};

/// Whether a pair takes part: apart, and not beyond the slope 1 of a distance.
bool takes_part(double difference, double squared, bool lipschitz) {
  if (!(squared > 0)) return false;
  constexpr double kMost = (1 + kLipschitzSlack) * (1 + kLipschitzSlack);
  return !lipschitz || difference * difference <= kMost * squared;
}

/// (3.9).
Vec3 mean_slope(const ValuedPoints& valued, const Neighbourhood& around, bool lipschitz) {
  const Vec3 p = valued.tree->local(around.point);
  const double f = valued.values[around.point];
  Vec3 sum;
  size_t n = 0;
  for (const uint32_t j : around.neighbours) {
    const Vec3 d = valued.tree->local(j) - p;
    const double difference = valued.values[j] - f, squared = squared_norm(d);
    if (!takes_part(difference, squared, lipschitz)) continue;
    sum += d * (difference / squared);
    ++n;
  }
  return n > 0 ? sum / static_cast<double>(n) : kNoGradient;
}

/// The largest difference with which a pair at that distance takes part.
double most_difference(double squared, bool lipschitz) {
  return lipschitz ? (1 + kLipschitzSlack) * std::sqrt(squared)
                   : std::numeric_limits<double>::infinity();
}

/// (3.9) over places that many points share.
Vec3 mean_slope(const ValuedPoints& valued, const PlaceValues& places,
                const Octree::CrowdedBall& ball, bool lipschitz) {
  const Vec3 p = valued.tree->local(ball.point);
  const double f = valued.values[ball.point];
  Vec3 sum;
  size_t n = 0;
  for (const Octree::PlaceGroup& group : ball.groups) {
    const Vec3 d = valued.tree->local(group.first) - p;
    const double squared = squared_norm(d);
    if (!(squared > 0)) continue;
    const PlaceValues::Part part = places.within(group, f, most_difference(squared, lipschitz));
    sum += d * (part.sum / squared);
    n += part.count;
  }
  return n > 0 ? sum / static_cast<double>(n) : kNoGradient;
}

/// Sums over the points that take part in a fit of f.
struct SlopeSums {
  Moments moments;
  Vec3 products;  // of d and f_j - f
  double sum = 0;

  Vec3 slope(const Vec3& p) const {
    PrincipalFrame frame;
    if (moments.n < kFewestForSlopes || !principal_frame(moments, frame)) return kNoGradient;
    const auto n = static_cast<double>(moments.n);
    const Vec3 cross_moments = products / n - (frame.centre - p) * (sum / n);
    return frame.u * (dot(cross_moments, frame.u) / frame.eigenvalues[2]) +
           frame.v * (dot(cross_moments, frame.v) / frame.eigenvalues[1]);
  }
};

/// Least squares of f over the two axes of largest extent of the points.
Vec3 fitted_slope(const ValuedPoints& valued, const Neighbourhood& around, bool lipschitz) {
  const Vec3 p = valued.tree->local(around.point);
  const double f = valued.values[around.point];
  SlopeSums sums;
  sums.moments.reference = p;
  for (const uint32_t j : around.neighbours) {
    const Vec3 q = valued.tree->local(j), d = q - p;
    const double difference = valued.values[j] - f;
    if (j != around.point && !takes_part(difference, squared_norm(d), lipschitz)) continue;
    sums.moments.add(q);
    sums.products += d * difference;
    sums.sum += difference;
  }
  return sums.slope(p);
}

/// The same over places that many points share.
Vec3 fitted_slope(const ValuedPoints& valued, const PlaceValues& places,
                  const Octree::CrowdedBall& ball, bool lipschitz) {
  const Vec3 p = valued.tree->local(ball.point);
  const double f = valued.values[ball.point];
  SlopeSums sums;
  sums.moments.reference = p;
  sums.moments.add(p);
  for (const Octree::PlaceGroup& group : ball.groups) {
    const Vec3 q = valued.tree->local(group.first), d = q - p;
    const double squared = squared_norm(d);
    if (!(squared > 0)) continue;
    const PlaceValues::Part part = places.within(group, f, most_difference(squared, lipschitz));
    sums.moments.add(q, part.count);
    sums.products += d * part.sum;
    sums.sum += part.sum;
  }
  return sums.slope(p);
}

}  // namespace

std::span<const ParamRow> gradient_rows() {
  using S = GradientSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>(
          "method", "corrected|thesis|least_squares", "",
          "thesis: formula 3.9, half the slope on a surface; corrected: twice that; least_squares: "
          "slopes over the tangent plane, right at borders too"),
      number_row<&S::radius_m>("radius_m", 0, 1e6, "m", "",
                               "Radius of the ball around each point; 0 = 4 mean spacings"),
      bool_row<&S::distance_field>("distance_field", "",
                                   "The field is a distance: pairs of points that differ by more "
                                   "than their own distance are left out"),
      string_row<&S::name>("name", "", "Name of the field of norms"),
      string_row<&S::vector_name>("vector_name", "",
                                  "Name of the field of gradients (x 3); empty = none"));
  return kRows;
}

std::vector<Vec3> field_gradients(const ValuedPoints& valued, double radius_m,
                                  GradientMethod method, bool lipschitz, Task& task) {
  std::vector<Vec3> out(valued.size());
  const double factor = method == GradientMethod::kCorrected ? 2 : 1;
  const auto of_ball = [&](const Neighbourhood& around, NoScratch&) {
    out[around.point] = method == GradientMethod::kLeastSquares
                            ? fitted_slope(valued, around, lipschitz)
                            : mean_slope(valued, around, lipschitz) * factor;
  };
  if (!valued.tree->has_crowds()) {
    for_each_neighbourhood<NoScratch>(*valued.tree, 0, radius_m, task, of_ball);
    return out;
  }
  const PlaceValues places(valued, task);
  for_each_crowded_neighbourhood<NoScratch>(
      *valued.tree, radius_m, task, of_ball, [&](const Octree::CrowdedBall& ball, NoScratch&) {
        out[ball.point] = method == GradientMethod::kLeastSquares
                              ? fitted_slope(valued, places, ball, lipschitz)
                              : mean_slope(valued, places, ball, lipschitz) * factor;
      });
  return out;
}

Cloud with_gradient(const Cloud& cloud, std::string_view field, const GradientSettings& settings,
                    Task& task) {
  const std::string name = require_field_name(settings.name);
  const std::string& vector_name = settings.vector_name;
  ValuedPoints valued;
  {
    ProgressSpan span(task, 0, 0.3, "index");
    valued = valued_points(cloud, scalar_values(cloud, field, task), task);
  }
  ProgressSpan span(task, 0.3, 1, "gradient");
  const double radius_m = radius_or_spacings(settings.radius_m, kSpacings, cloud, valued);
  const std::vector<Vec3> gradients =
      field_gradients(valued, radius_m, settings.method, settings.distance_field, task);
  std::vector<float> norms(cloud.size(), kFloatNaN);
  std::vector<float> vectors(vector_name.empty() ? 0 : 3 * cloud.size(), kFloatNaN);
  parallel_for(task, valued.size(), kGradientGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3& g = gradients[i];
      const size_t point = valued.points[i];
      norms[point] = static_cast<float>(norm(g));
      if (vector_name.empty()) continue;
      for (int c = 0; c < 3; ++c)
        vectors[3 * point + static_cast<size_t>(c)] = static_cast<float>(g[c]);
    }
  });
  const std::string unit = unit_of(cloud, field) == "m" ? "1" : "";
  Cloud out =
      with_field<float>(cloud, name, unit.c_str(), "norm of the gradient along the surface", norms);
  if (!vector_name.empty())
    out.fields.set(make_column<float>(
        {vector_name, ElementType::kFloat32, 3, unit, "gradient along the surface"}, vectors));
  return out;
}

}  // namespace jalon
