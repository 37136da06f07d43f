// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/smoothing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/neighbourhoods.h"
#include "fieldtools/range_ranks.h"
#include "fieldtools/range_values.h"

namespace jalon {

namespace {

using Method = FieldFilterSettings::Method;

constexpr ParamRow kSmoothingMethodRow =
    choice_row<&FieldFilterSettings::method>("method", "gaussian|mean|median|minimum|maximum", "",
                                             "What the neighbourhood makes of the values");

constexpr double kSigmaSpacings = 2;  // R / 2 of the gradient's automatic radius
constexpr double kRadiusSpacings = 4;
constexpr size_t kPlacedAtOnce = size_t{1} << 16;  // values that go to their points

struct SmoothingScratch {
  std::vector<double> work;
  std::vector<RangeRanks::Range> ranges;
};

/// Middle value, or the mean of the two middle ones.
double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double reduced(Method method, std::vector<double>& values) {
  if (method == Method::kMedian) return median_of(values);
  if (method == Method::kMinimum) return *std::min_element(values.begin(), values.end());
  if (method == Method::kMaximum) return *std::max_element(values.begin(), values.end());
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// The ranges of positions that the ball's groups make.
void ranges_of(const Octree::CrowdedBall& ball, std::vector<RangeRanks::Range>& out) {
  out.clear();
  for (const Octree::PlaceGroup& group : ball.groups) {
    if (!out.empty() && out.back().last == group.first) out.back().last = group.last;
    else out.push_back({group.first, group.last});
  }
}

/// reduced() of balls of very many points: of whole ranges, in the place of each value.
class CrowdedReduction {
 public:
  CrowdedReduction(const ValuedPoints& valued, Method method, Task& task)
      : method_(method),
        sums_(valued.values, std::plus<>()),
        least_(valued.values, [](double a, double b) { return std::min(a, b); }),
        greatest_(valued.values, [](double a, double b) { return std::max(a, b); }) {
    if (method == Method::kMedian) ranks_.emplace(valued.values, task);
  }

  double of(std::vector<RangeRanks::Range>& ranges) const {
    if (method_ == Method::kMedian) return median(ranges);
    if (method_ == Method::kMinimum) return join(least_, ranges, kInfinite);
    if (method_ == Method::kMaximum) return join(greatest_, ranges, -kInfinite);
    return join(sums_, ranges, 0) / static_cast<double>(count(ranges));
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static size_t count(const std::vector<RangeRanks::Range>& ranges) {
    size_t n = 0;
    for (const auto& range : ranges) n += range.last - range.first;
    return n;
  }
  template <class Values>
  static double join(const Values& values, const std::vector<RangeRanks::Range>& ranges,
                     double start) {
    for (const auto& range : ranges) start = values.over(range.first, range.last, start);
    return start;
  }
  double median(const std::vector<RangeRanks::Range>& ranges) const {
    const size_t n = count(ranges);
    std::vector<RangeRanks::Range> work = ranges;
    const double middle = ranks_->least(work, n / 2);
    if (n % 2 == 1) return middle;
    work = ranges;
    return 0.5 * (middle + ranks_->least(work, n / 2 - 1));
  }

  using Pick = double (*)(double, double);
  Method method_;
  RangeValues<std::plus<>> sums_;
  RangeValues<Pick> least_, greatest_;
  std::optional<RangeRanks> ranks_;
};

std::vector<double> reduced_neighbourhoods(const Cloud& cloud, const ValuedPoints& valued,
                                           const FieldFilterSettings& settings, Task& task) {
  const uint32_t k = settings.k;
  const double radius_m =
      k > 0 ? 0 : radius_or_spacings(settings.radius_m, kRadiusSpacings, cloud, valued);
  std::vector<double> out(valued.size());
  const auto of_ball = [&](const Neighbourhood& around, SmoothingScratch& scratch) {
    scratch.work.clear();
    for (const uint32_t j : around.neighbours) scratch.work.push_back(valued.values[j]);
    out[around.point] = reduced(settings.method, scratch.work);
  };
  if (k > 0 || !valued.tree->has_crowds()) {
    for_each_neighbourhood<SmoothingScratch>(*valued.tree, k, radius_m, task, of_ball);
    return out;
  }
  const CrowdedReduction crowded(valued, settings.method, task);
  for_each_crowded_neighbourhood<SmoothingScratch>(
      *valued.tree, radius_m, task, of_ball,
      [&](const Octree::CrowdedBall& ball, SmoothingScratch& scratch) {
        ranges_of(ball, scratch.ranges);
        out[ball.point] = crowded.of(scratch.ranges);
      });
  return out;
}

}  // namespace

std::span<const ParamRow> field_filter_rows() {
  using S = FieldFilterSettings;
  static constexpr auto kRows = setting_rows(
      kSmoothingMethodRow,
      number_row<&S::sigma_m>("sigma_m", 0, 1e6, "m", "gaussian",
                              "Standard deviation of the weights; 0 = 2 mean spacings"),
      number_row<&S::cut_sigmas>("cut_sigmas", 0.5, 6, "1", "gaussian",
                                 "Weights end at this many sigma (2 to 3 are usual)"),
      number_row<&S::radius_m>(
          "radius_m", 0, 1e6, "m", "mean,median,minimum,maximum",
          "Radius of the ball around each point; 0 = 4 mean spacings, or k points"),
      integer_row<&S::k>(
          "k", 0, 256, "points", "mean,median,minimum,maximum",
          "Above 0: the k nearest points, the point itself included, in place of a ball"),
      string_row<&S::name>("name", "",
                           "Name of the new field; that of the field itself replaces it"));
  return kRows;
}

std::vector<double> gaussian_means(const ValuedPoints& valued, double sigma_m, double cut_sigmas,
                                   Task& task) {
  std::vector<double> out(valued.size());
  const double factor = -0.5 / (sigma_m * sigma_m);
  const auto of_ball = [&](const Neighbourhood& around, SmoothingScratch&) {
    double weights = 0, sum = 0;
    for (size_t j = 0; j < around.neighbours.size(); ++j) {
      const double w = std::exp(factor * double{around.squared[j]});
      weights += w;
      sum += w * valued.values[around.neighbours[j]];
    }
    out[around.point] = sum / weights;  // the point itself weighs 1
  };
  if (!valued.tree->has_crowds()) {
    for_each_neighbourhood<SmoothingScratch>(*valued.tree, 0, cut_sigmas * sigma_m, task, of_ball);
    return out;
  }
  // The points of a place weigh the same.
  const RangeValues<std::plus<>> values(valued.values, std::plus<>());
  for_each_crowded_neighbourhood<SmoothingScratch>(
      *valued.tree, cut_sigmas * sigma_m, task, of_ball,
      [&](const Octree::CrowdedBall& ball, SmoothingScratch&) {
        double weights = 0, sum = 0;
        for (const Octree::PlaceGroup& group : ball.groups) {
          const double w = std::exp(factor * double{group.squared});
          weights += w * (group.last - group.first);
          sum += w * values.over(group.first, group.last, 0);
        }
        out[ball.point] = sum / weights;
      });
  return out;
}

Cloud with_filtered_field(const Cloud& cloud, std::string_view field,
                          const FieldFilterSettings& settings, Task& task) {
  const std::string name = require_field_name(settings.name);
  ValuedPoints valued;
  {
    ProgressSpan span(task, 0, 0.3, "index");
    valued = valued_points(cloud, scalar_values(cloud, field, task), task);
  }
  ProgressSpan span(task, 0.3, 1, "filtering");
  const std::vector<double> found =
      settings.method == Method::kGaussian
          ? gaussian_means(valued,
                           radius_or_spacings(settings.sigma_m, kSigmaSpacings, cloud, valued),
                           settings.cut_sigmas, task)
          : reduced_neighbourhoods(cloud, valued, settings, task);
  std::vector<double> values(cloud.size(), kNaN);
  parallel_for(task, found.size(), kPlacedAtOnce, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) values[valued.points[i]] = found[i];
  });
  const std::string meaning = choice_at(kSmoothingMethodRow, static_cast<size_t>(settings.method)) +
                              " of " + std::string(field) + " around the point";
  return with_field<double>(cloud, name, unit_of(cloud, field).c_str(), meaning.c_str(), values);
}

}  // namespace jalon
