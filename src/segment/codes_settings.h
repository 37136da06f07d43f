// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace jalon {

/// The numbers that the field "classification" holds.
enum class ClassScheme { kTable, kAsprs };

/// As the codes' source has it, or with what Jalon knows better.
enum class CodeForm { kSource, kImproved };

/// In which X, Y and Z of a list are; clouds are in metres whatever their files are in.
enum class CodeUnit { kMetre, kCentimetre, kMillimetre, kFoot, kUsFoot };
inline double metres_of(CodeUnit unit) {
  constexpr double kMetres[] = {1, 0.01, 0.001, 0.3048, 1200.0 / 3937.0};
  return kMetres[static_cast<size_t>(unit)];
}

/// What every method by codes is given.
struct CodeInput {
  std::string codes;  ///< the list as text
  CodeUnit codes_unit = CodeUnit::kMetre;
  std::string table;  ///< JSON; "" = the method's ready-made one
  ClassScheme classes = ClassScheme::kTable;
  CodeForm form = CodeForm::kSource;
};

/// The parameters of method "survey_codes"; the rows stand in survey_codes_params.cpp.
struct SurveyCodeSettings {
  CodeInput input;
  double pipe_margin_m = 0.02;
  double outward_m = 0.04, inward_m = 0.24;  ///< of a building's outline
  double height_margin_m = 0.02;             ///< of a building, at both ends
  double opening_margin_m = 0.02;
};

/// The parameters of method "target_codes"; the rows stand in target_codes_params.cpp.
struct TargetCodeSettings {
  CodeInput input;
  double patch_m = 0.05;
  double slab_m = 1;
  int64_t wall_draws = 30;
  double wall_angle_rad = 0.157079632679;  // pi / 20
  double wall_distance_m = 0.06;
  int64_t height_bins = 50;
  double wall_cell_m = 0.05, least_wall_height_m = 2;
  double door_radius_m = 2;
  double window_margin_m = 1;
  double gutter_reach_m = 0.20, gutter_normal_radius_m = 0.03, growing_radius_m = 0.02;
  double growing_angle_rad = 0.314159265359;  // pi / 10
  double most_normal_z = 0.1;
  uint64_t seed = 1;
};

}  // namespace jalon
