// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/table_columns.h"
#include "capi/support/guard.h"
#include "fieldtools/field_normality.h"
#include "fieldtools/field_values.h"
#include "jalon/field_tools.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

FieldTable normality_table(const NormalityReport& report) {
  const SampleStatistics& s = report.statistics;
  FieldTable t;
  add_value<uint64_t>(t, "values", "values", "finite ones", s.count);
  add_value<double>(t, "mean", "", "of all values", s.mean);
  add_value<double>(t, "median", "", "half of the values are not above it", s.median);
  add_value<double>(t, "standard_deviation", "", "about the mean, divided by n - 1", s.deviation);
  add_value<double>(t, "variance", "", "its square", s.variance);
  add_value<double>(t, "range", "", "largest less least", s.range);
  add_value<double>(t, "quartile_range", "", "third quartile less first", s.quartile_range);
  add_value<double>(t, "skewness", "1", "G1", s.skewness);
  add_value<double>(t, "kurtosis", "1", "G2, in excess of the normal law's", s.kurtosis);
  add_value<uint64_t>(t, "tested", "values", "in the test", report.tested);
  add_value<double>(t, "W", "1", "Shapiro and Wilk's", report.test.W);
  add_value<double>(t, "p", "1", "of such a W or a lesser one for a normal sample", report.test.p);
  add_value<uint8_t>(t, "is_normal", "", "1: p is above alpha", report.is_normal ? 1 : 0);
  return t;
}

}  // namespace

jalon_status jalon_normality(const double* values, uint64_t count, const jalon_params* options,
                             jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    require_array(values, JALON_FLOAT64, count, 1, 0, "values");
    const auto settings =
        settings_from<NormalitySettings>(options_or_default(options, "normality"));
    *out =
        new_fields(normality_table(test_normality({values, static_cast<size_t>(count)}, settings)));
  });
}

jalon_status jalon_cloud_field_normality(const jalon_cloud* cloud, const char* field,
                                         const jalon_params* options, jalon_task* task,
                                         jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string name = require_text(field, "field");
    require(out, "out");
    const auto settings =
        settings_from<NormalitySettings>(options_or_default(options, "normality"));
    *out = with_task(task, [&](Task& t) {
             const std::vector<double> values = scalar_values(*cloud->cloud, name, t);
             return own(new_fields(normality_table(test_normality(values, settings))));
           }).release();
  });
}
