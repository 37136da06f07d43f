// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/console.h"
#include "cli/options.h"
#include "cli/output_folder.h"

namespace jalon::cli {

/// A model worker by its name, with its parameters set.
Modeller make_modeller(const std::string& method, const Settings& settings);
/// The parameters of every method of a kind of worker that this library has, for --help; option: "--set" or the like.
std::string segmenter_tables(const std::string& option);
std::string modeller_tables(const std::string& option);

/// Model, drawings and reports, as "facade" and "model" write them.
struct ModelFiles {
  const Console& console;
  jalon_segmentation* segmentation;
  jalon_model* model;
  std::string title, source;

  /// Every vector format: model.obj, model.dxf, model.city.json, model.geojson, model.stl; only as asked. Formats of
  /// surfaces are left out when the model has none, and named in the return value.
  void write_model(OutputFolder& folder, const std::vector<std::string>& names) const;
  /// elevation.svg of the whole; elevation_1.svg ... of each facade where there are several. Their names.
  std::vector<std::string> write_elevations(OutputFolder& folder) const;
  /// report.html and, when wanted, report.json.
  void write_reports(OutputFolder& folder, const nlohmann::ordered_json& notes, bool with_json) const;
};

/// How many faces, and parts by class: for --json and the closing lines.
nlohmann::ordered_json summary_of(jalon_model* model);

}  // namespace jalon::cli
