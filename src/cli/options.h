// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/console.h"
#include "cli/handles.h"

namespace jalon::cli {

/// Sets one parameter from "name=value" as people write it; what is wrong with it is told with the option as given.
void assign(jalon_params* params, const std::string& option, const std::string& assignment);

/// "--set name=value" and "--params FILE" of a command, applied to a parameter set.
struct Settings {
  std::vector<std::string> assignments, short_assignments;  ///< the latter by "--set" alone
  std::string json_file, short_json_file;
  std::string prefix;  ///< of the options' names, for messages

  /// name_prefix: "" or that of a stage, "segment-", "model-", "drawing-" ..., the same in all commands that have it.
  void add_to(Command& command, const std::string& name_prefix = "");
  /// "--set" and "--params" mean this stage too: the one that the command is about.
  void add_short_to(Command& command);
  void apply(jalon_params* params) const;
  bool is_given() const {
    return !assignments.empty() || !short_assignments.empty() || !json_file.empty() ||
           !short_json_file.empty();
  }
  /// Whether this parameter is among the assignments.
  bool sets(const std::string& name) const;
};

/// "--viewer-points N": most points of the view in three dimensions of the report.
struct ViewerOption {
  int64_t points = -1;  ///< -1: the operation's default

  void add_to(Command& command);
  /// The options of a report's operation, with it.
  Params params(const char* operation) const;
};

void add_common(Command& command, Common& common);

/// The parameter set of an operation.
Params make_params(const char* operation);

/// The table as text for --help: name, default, unit, range, help.
std::string describe(jalon_params* params);

/// Reads a cloud with the options of operation "read".
struct Input {
  std::string path;
  std::string columns;
  std::string unit;  ///< of its coordinates: m, cm, mm, ft, us-ft; "": as the file tells
  std::string unit_option = "--unit";  ///< that names it
  std::string station;  ///< "X,Y,Z" of the one scanner position; "": as the file tells
  bool drop_invalid = false;
  std::string box;           ///< "X,Y,Z,X,Y,Z" of the points wanted; "": all
  double spacing_m = 0;      ///< of the levels of a COPC file that are wanted; 0: all
  std::string only_station;  ///< name or number of the one whose points are wanted; "": all
  int64_t max_points = 0;    ///< 0: all
  std::string fields;        ///< names of those wanted; "": all

  void add_to(Command& command, bool required = true);
  /// All but the scan itself; a prefix, "reference-", for a command with two scans.
  void add_reading_to(Command& command, const std::string& prefix = "");
  /// The same without the scanner's place, where it moved or does not matter.
  void add_points_to(Command& command, const std::string& prefix = "");
  /// Only the option that names the unit, e.g. "--reference-unit" for a command with two scans.
  void add_unit_to(Command& command, const std::string& option = "--unit");
  /// Is anything of this told that a model does not have?
  bool is_told() const;
  /// The parameters of "read", or of "convert", that say so.
  Params reading(const char* operation) const;
  Cloud read(Console& console) const;
};

/// The folder that a command writes, which must be told.
void add_output_folder(Command& command, std::string& output);

/// The reading of two scans: what is of one stands behind its prefix.
void add_reading_of_two(Command& command, Input& first, const std::string& first_prefix,
                        Input& second, const std::string& second_prefix);

uint64_t count_of(const Cloud& cloud);
/// Whether it has points, and for all of them stations with poses.
bool has_all_stations(const Cloud& cloud);
/// "X,Y,Z" in metres as the pose of an upright scanner.
jalon_transform pose_at(const std::string& text);

// One function a command: declares it and what runs it.
void add_info(Command& app);
void add_convert(Command& app);
void add_formats(Command& app);
void add_clean(Command& app);
void add_cut(Command& app);
void add_sections(Command& app);
void add_normals(Command& app);
void add_facade(Command& app);
void add_segment(Command& app);
void add_code(Command& app);
void add_targets(Command& app);
void add_network(Command& app);
void add_model(Command& app);
void add_evaluate(Command& app);
void add_evaluate_model(Command& app);
void add_register(Command& app);
void add_adjust(Command& app);
void add_compare(Command& app);
void add_clearance(Command& app);
void add_scan(Command& app);

}  // namespace jalon::cli
