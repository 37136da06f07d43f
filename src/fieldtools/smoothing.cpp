// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/smoothing.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "cloud/neighbourhoods.h"

namespace jalon {

namespace {

constexpr double kSigmaSpacings = 2;   // R / 2 of the gradient's automatic radius
constexpr double kRadiusSpacings = 4;

constexpr ParamRow kRows[] = {
    choice_row("method", "gaussian", "gaussian|mean|median|minimum|maximum", "",
               "What the neighbourhood makes of the values"),
    number_row("sigma_m", 0, 0, 1e6, "m", "gaussian", "Standard deviation of the weights; 0 = 2 mean spacings"),
    number_row("cut_sigmas", 3, 0.5, 6, "1", "gaussian", "Weights end at this many sigma (2 to 3 are usual)"),
    number_row("radius_m", 0, 0, 1e6, "m", "mean,median,minimum,maximum",
               "Radius of the ball around each point; 0 = 4 mean spacings, or k points"),
    integer_row("k", 0, 0, 256, "points", "mean,median,minimum,maximum",
                "Above 0: the k nearest points, the point itself included, in place of a ball"),
    string_row("name", "filtered", "", "Name of the new field; that of the field itself replaces it"),
};

struct Scratch {
  std::vector<double> work;
};

/// Middle value, or the mean of the two middle ones.
double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double reduced(const std::string& method, std::vector<double>& values) {
  if (method == "median") return median_of(values);
  if (method == "minimum") return *std::min_element(values.begin(), values.end());
  if (method == "maximum") return *std::max_element(values.begin(), values.end());
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::vector<double> reduced_neighbourhoods(const Cloud& cloud, const ValuedPoints& valued, const ParamSet& options,
                                           Task& task) {
  const auto k = static_cast<uint32_t>(options.integer("k"));
  const double radius_m =
      k > 0 ? 0 : radius_or_spacings(options.number("radius_m"), kRadiusSpacings, cloud, valued);
  const std::string& method = options.text("method");
  std::vector<double> out(valued.size());
  for_each_neighbourhood<Scratch>(*valued.tree, k, radius_m, task, [&](const Neighbourhood& around, Scratch& scratch) {
    scratch.work.clear();
    for (const uint32_t j : around.neighbours) scratch.work.push_back(valued.values[j]);
    out[around.point] = reduced(method, scratch.work);
  });
  return out;
}

}  // namespace

std::span<const ParamRow> field_filter_rows() { return kRows; }

std::vector<double> gaussian_means(const ValuedPoints& valued, double sigma_m, double cut_sigmas, Task& task) {
  std::vector<double> out(valued.size());
  const double factor = -0.5 / (sigma_m * sigma_m);
  for_each_neighbourhood<Scratch>(*valued.tree, 0, cut_sigmas * sigma_m, task,
                                  [&](const Neighbourhood& around, Scratch&) {
                                    double weights = 0, sum = 0;
                                    for (size_t j = 0; j < around.neighbours.size(); ++j) {
                                      const double w = std::exp(factor * double{around.squared[j]});
                                      weights += w;
                                      sum += w * valued.values[around.neighbours[j]];
                                    }
                                    out[around.point] = sum / weights;  // the point itself weighs 1
                                  });
  return out;
}

Cloud with_filtered_field(const Cloud& cloud, std::string_view field, const ParamSet& options, Task& task) {
  const std::string name = require_field_name(options.text("name"));
  ValuedPoints valued;
  {
    Span span(task, 0, 0.3, "index");
    valued = valued_points(cloud, scalar_values(cloud, field, task), task);
  }
  Span span(task, 0.3, 1, "filtering");
  const std::vector<double> found =
      options.text("method") == "gaussian"
          ? gaussian_means(valued, radius_or_spacings(options.number("sigma_m"), kSigmaSpacings, cloud, valued),
                           options.number("cut_sigmas"), task)
          : reduced_neighbourhoods(cloud, valued, options, task);
  std::vector<double> values(cloud.size(), kNoValue);
  for (size_t i = 0; i < found.size(); ++i) values[valued.points[i]] = found[i];
  const std::string meaning = options.text("method") + " of " + std::string(field) + " around the point";
  return with_field<double>(cloud, name, unit_of(cloud, field).c_str(), meaning.c_str(), values);
}

}  // namespace jalon
