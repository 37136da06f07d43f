// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/compare_listing.h"

namespace jalon::cli {

namespace {

constexpr const char* kClasses[] = {"",
                                    "appearance",
                                    "disappearance",
                                    "displacement",
                                    "displacement with overlap",
                                    "deformation",
                                    "deformation with overlap"};

}  // namespace

void say_summary(const Console& console, const char* name, const Table& summary) {
  char line[200];
  std::snprintf(line, sizeof line,
                "%s: %s points, %s compared, mean %s mm, rms %s mm, sigma %s mm, maximum %s m",
                name, grouped(summary.count("points", 0)).c_str(),
                grouped(summary.count("compared", 0)).c_str(),
                fixed(1000 * summary.number("mean", 0), 2).c_str(),
                fixed(1000 * summary.number("rms", 0), 2).c_str(),
                fixed(1000 * summary.number("sigma", 0), 2).c_str(),
                fixed(summary.number("maximum", 0), 3).c_str());
  console.say(line);
}

void list_changes(const Console& console, const Table& changes) {
  console.say(
      "change  class                       confidence  area before, after m2  volume before, after "
      "m3  displacement m");
  for (uint64_t i = 0; i < changes.rows(); ++i) {
    const double dx = changes.number("displacement", i, 0),
                 dy = changes.number("displacement", i, 1),
                 dz = changes.number("displacement", i, 2);
    const bool is_moved = dx == dx;
    char line[200];
    std::snprintf(line, sizeof line, "%6u  %-26s %11s %11s %8s %14s %8s  %s",
                  static_cast<unsigned>(i + 1), kClasses[changes.count("class", i)],
                  fixed(changes.number("confidence", i), 2).c_str(),
                  fixed(changes.number("area_before", i), 3).c_str(),
                  fixed(changes.number("area_after", i), 3).c_str(),
                  fixed(changes.number("volume_before", i), 3).c_str(),
                  fixed(changes.number("volume_after", i), 3).c_str(),
                  is_moved ? (fixed(dx, 3) + " " + fixed(dy, 3) + " " + fixed(dz, 3)).c_str() : "");
    console.say(line);
  }
}

void list_regions(const Console& console, const Table& regions) {
  console.say("region     points    area m2  volume m3    mean mm   extreme mm   centroid m");
  for (uint64_t i = 0; i < regions.rows(); ++i) {
    char line[200];
    std::snprintf(line, sizeof line, "%6u %10s %10s %10s %10s %12s   %s %s %s",
                  static_cast<unsigned>(i + 1), grouped(regions.count("points", i)).c_str(),
                  fixed(regions.number("area", i), 3).c_str(),
                  fixed(regions.number("volume", i), 3).c_str(),
                  fixed(1000 * regions.number("mean", i), 1).c_str(),
                  fixed(1000 * regions.number("extreme", i), 1).c_str(),
                  fixed(regions.number("centroid", i, 0), 2).c_str(),
                  fixed(regions.number("centroid", i, 1), 2).c_str(),
                  fixed(regions.number("centroid", i, 2), 2).c_str());
    console.say(line);
  }
}

}  // namespace jalon::cli
