// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/methods.h"

#include "base/names_of.h"
#include "compare/distance/distance.h"
#include "compare/distance/model_distance.h"
#include "compare/landslide/landslide.h"
#include "compare/m3c2/file.h"
#include "compare/m3c2/m3c2.h"
#include "compare/preview/preview.h"

namespace jalon {

namespace {

Comparison run_distance(const CloudPtr& reference, const CloudPtr& compared, const ParamSet& params,
                        Task& task) {
  return compare_distance(reference, compared, settings_from<DistanceSettings>(params), task);
}

Comparison run_model_distance(const ModelPtr& reference, const CloudPtr& compared,
                              const ParamSet& params, Task& task) {
  return compare_with_model(reference, compared, settings_from<DistanceSettings>(params), task);
}

Comparison run_m3c2(const CloudPtr& reference, const CloudPtr& compared, const ParamSet& params,
                    Task& task) {
  return compare_m3c2(reference, compared, settings_from<M3c2Settings>(params), task);
}

Comparison run_m3c2_core(const CloudPtr& reference, const CloudPtr& compared, const CloudPtr& core,
                         const ParamSet& params, Task& task) {
  return compare_m3c2_core(reference, compared, core, settings_from<M3c2Settings>(params), task);
}

Comparison run_preview(const CloudPtr& reference, const CloudPtr& compared, const ParamSet& params,
                       Task& task) {
  return compare_preview(reference, compared, settings_from<PreviewSettings>(params), task);
}

Comparison run_landslide(const CloudPtr& reference, const CloudPtr& compared,
                         const ParamSet& params, Task& task) {
  return compare_landslide(reference, compared, settings_from<LandslideSettings>(params), task);
}

constexpr CompareMethod kMethods[] = {
    {.name = "distance",
     .owner = "comparer distance",
     .rows = distance_rows,
     .run = run_distance,
     .run_model = run_model_distance},
    {.name = "m3c2",
     .owner = "comparer m3c2",
     .rows = m3c2_rows,
     .run = run_m3c2,
     .run_core = run_m3c2_core,
     .read_file = read_cloudcompare_m3c2,
     .use_registration = use_registration_in_m3c2},
    {.name = "preview", .owner = "comparer preview", .rows = preview_rows, .run = run_preview},
    {.name = "landslide",
     .owner = "comparer landslide",
     .rows = landslide_rows,
     .run = run_landslide},
};

}  // namespace

std::span<const CompareMethod> compare_methods() { return kMethods; }
std::span<const char* const> compare_method_names() { return kNamesOf<kMethods>; }

}  // namespace jalon
