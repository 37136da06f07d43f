// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/methods.h"

#include "base/names_of.h"
#include "scan/mobile/mobile_scan.h"

namespace jalon {

namespace {

template <class Settings, auto Scan>
Cloud scan_by(const Model& model, std::span<const ScanStation> stations, const ParamSet& params,
              Task& task) {
  return Scan(model, stations, settings_from<Settings>(params), task);
}

template <class Settings>
FieldTable truth_by(const Model& model, const Cloud* cloud, const ParamSet& params, Task& task) {
  const auto settings = settings_from<Settings>(params);
  return true_planes(model, cloud, settings.surfaces.truth_min_area_m2, settings.offset_m, task);
}

Cloud drive_by(const Model& model, const Trajectory& trajectory, const ParamSet& params,
               Task& task) {
  return scan_mobile(model, trajectory, settings_from<MobileSettings>(params), task);
}

constexpr ScannerMethod kMethods[] = {
    {"static", "scanner static", static_scanner_rows, scan_by<StaticSettings, scan_static>,
     truth_by<StaticSettings>, nullptr},
    {"sample", "scanner sample", sample_scanner_rows, scan_by<SampleSettings, scan_sample>,
     truth_by<SampleSettings>, nullptr},
    {"mobile", "scanner mobile", mobile_scanner_rows, nullptr, nullptr, drive_by},
};

}  // namespace

std::span<const ScannerMethod> scanner_methods() { return kMethods; }
std::span<const char* const> scanner_method_names() { return kNamesOf<kMethods>; }

}  // namespace jalon
