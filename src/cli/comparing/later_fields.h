// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <string>
#include <utility>

#include "cli/comparing/direction.h"
#include "cli/options.h"

namespace jalon::cli {

/// A scan. What its fields hold, most of what a LAS file tells of a point, may be left in the file while it is
/// compared, and read when its points are written.
struct ReadScan {
  Cloud cloud;
  bool is_partial = false;  ///< of the fields the cloud has those that reports show
};

/// Is it of a file that is quickly read twice?
inline bool may_read_later(const Input& input) {
  const std::string& path = input.path;
  const std::string end = path.size() > 4 ? path.substr(path.size() - 4) : "";
  return (end == ".las" || end == ".LAS") && input.fields.empty() && input.max_points == 0 &&
         input.box.empty() && input.only_station.empty();
}

/// Fields that reports show, where a scan has them, as an Input names them.
inline constexpr const char* kShownFields = "intensity? red? green? blue?";

inline Cloud read_again(Console& console, const Input& input) {
  console.pass_over_warnings(true);
  Cloud out = input.read(console);
  console.pass_over_warnings(false);
  return out;
}

/// The scan, partial where the rest can be read later.
inline ReadScan read_to_compare(Console& console, const Input& input) {
  if (!may_read_later(input)) return {input.read(console)};
  Input lean = input;
  lean.fields = kShownFields;
  ReadScan out{lean.read(console), true};
  // Without the poses of all its points the comparison looks for stations, and its cloud has others than the file.
  if (!has_all_stations(out.cloud)) out = {read_again(console, input)};
  return out;
}

/// The points with all their fields, and what was found out of each behind them.
inline Cloud read_whole(Console& console, const Input& input, const ReadScan& scan,
                        const Direction& found) {
  if (!scan.is_partial) return found.cloud();
  Cloud out = read_again(console, input);
  jalon_array_view a, b;
  must(jalon_cloud_points(scan.cloud.get(), &a));
  must(jalon_cloud_points(out.get(), &b));
  if (a.count != b.count || std::memcmp(a.data, b.data, a.count * 3 * sizeof(double)) != 0)
    throw Failure{JALON_ERROR_NOT_FOUND, input.path + " was changed while it was compared"};
  Fields points;
  must(jalon_comparison_points(found.comparison.get(), Out(points)));
  add_columns(out, points);
  add_columns(out, found.points);
  return out;
}

/// As NAME.las and NAME.ply; "points" of what was found is given up, of which the files have a copy by then.
inline void write_points(Console& console, Beside& beside, const PathOf& path_of, const char* name,
                         const Input& input, const ReadScan& scan, Direction& found) {
  Cloud whole = read_whole(console, input, scan, found);
  found.points.reset();
  write_both(beside, path_of, std::move(whole), name);
}

}  // namespace jalon::cli
