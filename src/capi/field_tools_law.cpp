// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

#include "base/numbers.h"
#include "capi/support/guard.h"
#include "capi/support/noise_law_handle.h"
#include "fieldtools/field_values.h"
#include "fieldtools/histogram.h"
#include "jalon/field_tools.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// Texts of empirical laws are long.
constexpr size_t kLongestLaw = size_t{1} << 20;

Owned<jalon_noise_law> handle_of(NoiseLaw law) {
  auto handle = std::make_unique<jalon_noise_law>();
  handle->json = to_json(law);
  handle->law = std::move(law);
  return own(handle.release());
}

std::span<const double> numbers_of_field_tools_law(const double* values, uint64_t count,
                                                   const char* name) {
  require_array(values, JALON_FLOAT64, count, 1, 0, name);
  return {values, static_cast<size_t>(count)};
}

}  // namespace

jalon_noise_law* jalon_noise_law_retain(jalon_noise_law* law) { return retain(law); }
void jalon_noise_law_release(jalon_noise_law* law) { release(law); }

jalon_status jalon_noise_law_fit(const jalon_cloud* cloud, const char* field,
                                 const jalon_params* options, jalon_task* task,
                                 jalon_noise_law** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const std::string name = require_text(field, "field");
    const auto chosen = settings_from<NoiseLawSettings>(options_or_default(options, "noise_law"));
    *out = with_task(task, [&](Task& t) {
             return handle_of(fit_noise_law(scalar_values(*cloud->cloud, name, t), chosen, t));
           }).release();
  });
}

jalon_status jalon_noise_law_from_json(const char* json, jalon_noise_law** out) {
  return guard([&] {
    require(out, "out");
    *out = handle_of(noise_law_from_json(require_text(json, "json", kLongestLaw))).release();
  });
}

jalon_status jalon_noise_law_json(const jalon_noise_law* law, const char** out) {
  return guard([&] {
    require(law, "law");
    require(out, "out");
    *out = law->json.c_str();
  });
}

jalon_status jalon_noise_law_table(const jalon_noise_law* law, jalon_fields** out) {
  return give_fields(law, "law", out, [&] { return noise_law_table(law->law); });
}

jalon_status jalon_noise_law_evaluate(const jalon_noise_law* law, const double* values,
                                      uint64_t count, double* density, double* cumulative) {
  return guard([&] {
    require(law, "law");
    const auto at = numbers_of_field_tools_law(values, count, "values");
    for (size_t i = 0; i < at.size(); ++i) {
      if (density != nullptr) density[i] = law->law.density(at[i]);
      if (cumulative != nullptr) cumulative[i] = law->law.cumulative(at[i]);
    }
  });
}

jalon_status jalon_noise_law_quantiles(const jalon_noise_law* law, const double* probabilities,
                                       uint64_t count, double* out) {
  return guard([&] {
    require(law, "law");
    const auto at = numbers_of_field_tools_law(probabilities, count, "probabilities");
    if (count != 0) require(out, "out");
    for (size_t i = 0; i < at.size(); ++i)
      out[i] = at[i] >= 0 && at[i] <= 1 ? law->law.quantile(at[i]) : kNaN;
  });
}

jalon_status jalon_cloud_field_histogram(const jalon_cloud* cloud, const char* field,
                                         const jalon_noise_law* law, const jalon_params* options,
                                         jalon_task* task, jalon_fields** bins,
                                         jalon_fields** summary) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string name = require_text(field, "field");
    const auto chosen = settings_from<HistogramSettings>(options_or_default(options, "histogram"));
    Owned<jalon_fields> made_bins = own<jalon_fields>(nullptr),
                        made_summary = own<jalon_fields>(nullptr);
    with_task(task, [&](Task& t) {
      const Histogram h = field_histogram(scalar_values(*cloud->cloud, name, t),
                                          law != nullptr ? &law->law : nullptr, chosen, t);
      const std::string unit = unit_of(*cloud->cloud, name);
      made_bins.reset(new_fields(histogram_bins(h, unit.c_str())));
      made_summary.reset(new_fields(histogram_summary(h, unit.c_str())));
    });
    if (bins != nullptr) *bins = made_bins.release();
    if (summary != nullptr) *summary = made_summary.release();
  });
}
