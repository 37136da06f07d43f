// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/lengths.h"
#include "cli/options.h"
#include "cli/output_folder.h"

namespace jalon::cli {

/// A worker by its method, and its own parameter set.
Segmenter make_segmenter(const std::string& method, Params& params);
Modeller make_modeller(const std::string& method, Params& params);
/// The parameters of every method that this library has, for --help; option: how they are set.
std::string segmenter_tables(const std::string& option);
std::string modeller_tables(const std::string& option);

/// Orthoimages of the facades of a model: orthoimage.png with its world file, orthoimage.tif; orthoimage_1.png ...
/// where there are several facades.
struct Orthoimages {
  Settings settings;         ///< of operation "orthoimage"
  std::string kind = "png";  ///< "png", "tif", "both" or "none"

  void add_to(Command& command);
  /// Refuses wrong parameters, before a long read.
  void check() const;
  /// Facades without a front or points are passed over. Returns the names of the files.
  std::vector<std::string> write(const Console& console, jalon_segmentation* segmentation,
                                 jalon_model* model, uint64_t facades, OutputFolder& folder) const;
};

/// Files of a model: what "facade" and "model" both write.
struct ModelFiles {
  Settings drawing;  ///< of operation "elevation"
  Settings scanner;  ///< of operation "precision"; none: not told
  Orthoimages orthoimages;
  std::string relations;  ///< "parts", "faces" or "solids": relations.csv too; "": not asked for

  void add_to(Command& command);
  /// Refuses wrong parameters of the drawing and the scanner, before a long read.
  void check() const;
  /// The notes of a report with what was told of the scanner. Refuses it for a cloud without stations.
  void note_scanner(jalon_cloud* cloud, nlohmann::ordered_json& notes) const;
  /// model.obj, model.dxf ...: each vector format that the library writes; elevation.svg of the whole, elevation_1.svg
  /// ... of each facade where there are several; orthoimages, which model.dxf shows; relations.csv where asked for.
  /// Returns their names.
  std::vector<std::string> write(const Console& console, jalon_segmentation* segmentation,
                                 jalon_model* model, const std::string& source,
                                 OutputFolder& folder) const;
};

/// The tolerance that planes were found with.
double used_tolerance_m(jalon_segmentation* segmentation);
/// One line where a scan is so noisy that its planes were found with a wider tolerance than set; "" elsewhere.
std::string noise_note(jalon_segmenter* segmenter, jalon_segmentation* segmentation,
                       const Lengths& lengths);

/// "faces", "openings" and the number of parts of each class.
nlohmann::ordered_json summary_of(jalon_model* model);
/// A line where walls' viewing side is a guess and --station would tell it; "" where it is sure or known.
std::string front_note(jalon_segmentation* segmentation);
/// "12 faces; 1 facade, 3 wall, 21 window"
std::string summary_line(const nlohmann::ordered_json& summary);
/// Names for the closing line: "a, b, c".
std::string joined(const std::vector<std::string>& names);

}  // namespace jalon::cli
