// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/noise_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/distributions.h"
#include "base/error.h"
#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/numbers.h"
#include "base/table_columns.h"

namespace jalon {

namespace {

constexpr double kNoiseLawInfinity = std::numeric_limits<double>::infinity();

/// Quantiles at equal steps, straight lines between them.
double empirical_cumulative(const std::vector<double>& quantiles, double x) {
  if (!(x >= quantiles.front())) return 0;
  if (x >= quantiles.back()) return 1;
  const auto above = std::upper_bound(quantiles.begin(), quantiles.end(), x);
  const double low = *(above - 1), step = 1.0 / static_cast<double>(quantiles.size() - 1);
  return (static_cast<double>(above - quantiles.begin() - 1) + (x - low) / (*above - low)) * step;
}

double empirical_quantile(const std::vector<double>& quantiles, double p) {
  const double at = p * static_cast<double>(quantiles.size() - 1);
  const size_t i = std::min(static_cast<size_t>(at), quantiles.size() - 2);
  return quantiles[i] + (at - static_cast<double>(i)) * (quantiles[i + 1] - quantiles[i]);
}

/// Slope of the cumulative over 1 / 50 of the probability: a histogram of equal counts.
double empirical_density(const NoiseLaw& law, double x) {
  constexpr double kHalf = 0.01;
  const double p = law.cumulative(x);
  if (x < law.quantiles.front() || x > law.quantiles.back()) return 0;
  const double from = std::max(0.0, p - kHalf), to = std::min(1.0, p + kHalf);
  return (to - from) / (law.quantile(to) - law.quantile(from));
}

/// Mean of f(X), by trapezoids.
template <class F>
double mean_of_quantiles(const std::vector<double>& quantiles, F&& f) {
  double sum = 0;
  const size_t n = quantiles.size();
  for (size_t i = 0; i < n; ++i) sum += (i == 0 || i == n - 1 ? 0.5 : 1.0) * f(quantiles[i]);
  return sum / static_cast<double>(n - 1);
}

double number_of(const JsonValue& object, const char* name) {
  const JsonValue* member = find_member(object, name);
  if (member == nullptr || !member->is_number() || !std::isfinite(member->number))
    fail(Status::kInvalidArgument, "the noise law has no number \"%s\"", name);
  return member->number;
}

double optional_count(const JsonValue& object, const char* name) {
  const double value = find_member(object, name) == nullptr ? 0 : number_of(object, name);
  if (value < 0 || value > 0x1p53)
    fail(Status::kInvalidArgument, "\"%s\" of the noise law is out of range", name);
  return value;
}

double positive_number_of(const JsonValue& object, const char* name) {
  const double value = number_of(object, name);
  if (!(value > 0)) fail(Status::kInvalidArgument, "\"%s\" of the noise law is not positive", name);
  return value;
}

std::vector<double> quantiles_of(const JsonValue& object) {
  const JsonValue* member = find_member(object, "quantiles");
  if (member == nullptr || member->kind != JsonValue::Kind::kArray)
    fail(Status::kInvalidArgument, "the noise law has no array \"quantiles\"");
  std::vector<double> out;
  for (const JsonValue& element : JsonChildren(*member)) {
    if (!element.is_number() || !std::isfinite(element.number) ||
        (!out.empty() && element.number < out.back()))
      fail(Status::kInvalidArgument, "the quantiles of the noise law are no ascending numbers");
    out.push_back(element.number);
  }
  if (out.size() < 2 || !(out.front() < out.back()))
    fail(Status::kInvalidArgument, "the noise law needs two different quantiles");
  return out;
}

}  // namespace

double NoiseLaw::density(double x) const {
  if (kind == LawKind::kEmpirical) return empirical_density(*this, x);
  if (kind == LawKind::kGauss) {
    const double z = (x - gauss_mean) / gauss_sigma;
    return std::exp(-0.5 * z * z) / (gauss_sigma * std::sqrt(2 * std::numbers::pi));
  }
  const double t = (x - shift) / scale;
  return t > 0 ? shape / scale * std::pow(t, shape - 1) * std::exp(-std::pow(t, shape)) : 0;
}

double NoiseLaw::cumulative(double x) const {
  if (kind == LawKind::kEmpirical) return empirical_cumulative(quantiles, x);
  if (kind == LawKind::kGauss) return normal_cdf((x - gauss_mean) / gauss_sigma);
  const double t = (x - shift) / scale;
  return t > 0 ? -std::expm1(-std::pow(t, shape)) : 0;
}

double NoiseLaw::quantile(double p) const {
  if (kind == LawKind::kEmpirical) return empirical_quantile(quantiles, p);
  if (kind == LawKind::kGauss)
    return p <= 0   ? -kNoiseLawInfinity
           : p >= 1 ? kNoiseLawInfinity
                    : gauss_mean + gauss_sigma * normal_quantile(p);
  return p >= 1 ? kNoiseLawInfinity : shift + scale * std::pow(-std::log1p(-p), 1 / shape);
}

double NoiseLaw::mean() const {
  if (kind == LawKind::kGauss) return gauss_mean;
  if (kind == LawKind::kEmpirical) return mean_of_quantiles(quantiles, [](double x) { return x; });
  return shift + scale * std::tgamma(1 + 1 / shape);  // (3.5)
}

double NoiseLaw::standard_deviation() const {
  if (kind == LawKind::kGauss) return gauss_sigma;
  if (kind == LawKind::kEmpirical) {
    const double m = mean();
    const double square = mean_of_quantiles(quantiles, [](double x) { return x * x; });
    return std::sqrt(std::max(0.0, square - m * m));
  }
  const double m = std::tgamma(1 + 1 / shape);
  return scale * std::sqrt(std::max(0.0, std::tgamma(1 + 2 / shape) - m * m));  // (3.6)
}

bool NoiseLaw::is_signed() const {
  return kind == LawKind::kGauss || (kind == LawKind::kEmpirical && quantiles.front() < 0);
}

ExpectedDeviation expected_deviation(const NoiseLaw& law) {
  ExpectedDeviation out{law.is_signed(), law.mean(), 0};
  if (law.kind == LawKind::kGauss) {
    out.mean = law.gauss_sigma * std::sqrt(2 / std::numbers::pi);  // of the folded Gaussian
  } else {
    out.mean = out.two_sided ? mean_of_quantiles(law.quantiles, [&](double x) { return out.of(x); })
                             : law.mean();
  }
  return out;
}

const char* name_of(LawKind kind) {
  return kind == LawKind::kGauss ? "gauss" : kind == LawKind::kWeibull ? "weibull" : "empirical";
}

std::string to_json(const NoiseLaw& law) {
  JsonWriter json;
  json.begin_object().name("law").value(name_of(law.kind));
  if (law.kind == LawKind::kGauss)
    json.name("mean").value(law.gauss_mean).name("sigma").value(law.gauss_sigma);
  if (law.kind == LawKind::kWeibull)
    json.name("shape").value(law.shape).name("scale").value(law.scale).name("shift").value(
        law.shift);
  if (law.kind == LawKind::kEmpirical) {
    json.name("quantiles").begin_array();
    for (const double q : law.quantiles) json.value(q);
    json.end_array();
  }
  json.name("samples").value(law.samples).name("chi_square").value(law.sample_chi_square);
  json.name("classes").value(law.sample_classes);
  return json.end_object().take();
}

NoiseLaw noise_law_from_json(std::string_view text) {
  const std::vector<JsonValue> json = read_json(text);
  const JsonValue& object = json.front();
  const JsonValue* kind =
      object.kind == JsonValue::Kind::kObject ? find_member(object, "law") : nullptr;
  if (kind == nullptr || kind->kind != JsonValue::Kind::kText)
    fail(Status::kInvalidArgument, "the text is no noise law: an object with \"law\" is needed");
  NoiseLaw law;
  if (kind->text == "gauss") {
    law.gauss_mean = number_of(object, "mean");
    law.gauss_sigma = positive_number_of(object, "sigma");
  } else if (kind->text == "weibull") {
    law.kind = LawKind::kWeibull;
    law.shape = positive_number_of(object, "shape");
    law.scale = positive_number_of(object, "scale");
    law.shift = find_member(object, "shift") == nullptr ? 0 : number_of(object, "shift");
  } else if (kind->text == "empirical") {
    law.kind = LawKind::kEmpirical;
    law.quantiles = quantiles_of(object);
  } else {
    fail(Status::kInvalidArgument, "no noise law \"%.100s\"; there are: gauss, weibull, empirical",
         kind->text.c_str());
  }
  law.samples = static_cast<uint64_t>(optional_count(object, "samples"));
  law.sample_chi_square = optional_count(object, "chi_square");
  law.sample_classes = static_cast<uint32_t>(std::min(optional_count(object, "classes"), 1e9));
  return law;
}

FieldTable noise_law_table(const NoiseLaw& law) {
  const bool gauss = law.kind == LawKind::kGauss, weibull = law.kind == LawKind::kWeibull;
  const double n = law.samples > 0 ? static_cast<double>(law.samples) : kNaN;
  // Inverse Fisher information of the Weibull law, x0 known: 0.6079 a^2 / n and 1.1087 (b / a)^2 / n.
  constexpr double kShapeVariance = 6 / (std::numbers::pi * std::numbers::pi);
  constexpr double kOneLessEuler = 1 - std::numbers::egamma;
  constexpr double kScaleVariance = 1 + kShapeVariance * kOneLessEuler * kOneLessEuler;
  FieldTable t;
  add_value<uint8_t>(t, "kind", "", "0 Gauss, 1 Weibull, 2 empirical",
                     static_cast<uint8_t>(law.kind));
  add_value<double>(t, "mean", "", "of the law", law.mean());
  add_value<double>(t, "standard_deviation", "", "of the law", law.standard_deviation());
  add_value<double>(t, "shape", "1", "a of the Weibull law", weibull ? law.shape : kNaN);
  add_value<double>(t, "scale", "", "b of the Weibull law, sigma of the Gaussian",
                    weibull ? law.scale
                    : gauss ? law.gauss_sigma
                            : kNaN);
  add_value<double>(t, "shift", "", "x0 of the Weibull law", weibull ? law.shift : kNaN);
  add_value<double>(t, "shape_sigma", "1", "standard deviation of the shape",
                    weibull ? law.shape * std::sqrt(kShapeVariance / n) : kNaN);
  add_value<double>(t, "scale_sigma", "", "standard deviation of the scale",
                    weibull ? law.scale / law.shape * std::sqrt(kScaleVariance / n)
                    : gauss ? law.gauss_sigma / std::sqrt(2 * n)
                            : kNaN);
  add_value<uint64_t>(t, "samples", "", "values that it was fitted to", law.samples);
  add_value<double>(t, "chi_square", "1", "distance to its own sample", law.sample_chi_square);
  add_value<uint32_t>(t, "classes", "", "of that distance", law.sample_classes);
  return t;
}

}  // namespace jalon
