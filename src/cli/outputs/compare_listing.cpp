// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/compare_listing.h"

#include <cmath>

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

void say_summary(const Console& console, const char* name, const Table& summary,
                 const Lengths& lengths) {
  std::string line = std::string(name) + ": " + grouped(summary.count("points", 0)) + " points, " +
                     grouped(summary.count("compared", 0)) + " compared";
  for (const char* figure : {"mean", "rms", "sigma"})
    if (const double value = summary.number(figure, 0); std::isfinite(value))
      line += ", " + std::string(figure) + " " + lengths.fine(value, 2) + " " + lengths.fine();
  if (const double value = summary.number("maximum", 0); std::isfinite(value))
    line += ", maximum " + fixed(value, 3) + " " + lengths.length();
  console.say(line);
}

void say_landslide(const Console& console, const Table& summary, const Lengths& lengths) {
  const std::string cubic = lengths.is_known() ? " m3" : " cubic units",
                    square = lengths.is_known() ? " m2" : " square units";
  const auto number = [&](const char* name, int decimals) {
    return fixed(summary.number(name, 0), decimals);
  };
  const auto volume = [&](const char* name) {
    return std::string(name) + " " + number(name, 2) + " +- " +
           number((std::string(name) + "_sigma").c_str(), 2) + cubic;
  };
  console.say(volume("depletion") + ", " + volume("accumulation") + ", " + volume("net") +
              " (one sigma)");
  console.say("not measured: " + fixed(100 * summary.number("unmeasured_share", 0), 1) +
              " % of the area; " + number("unmeasured_reference", 1) + square +
              " in the reference, " + number("unmeasured_compared", 1) + square +
              " in the compared epoch, " + number("unmeasured_both", 1) + square +
              " in either; no volume holds them");
  if (summary.number("open_boundary", 0) > 0)
    console.say("of " + number("boundary", 1) + " " + lengths.length() + " of boundary " +
                number("open_boundary", 1) +
                " run along ground that was not measured: the slide may go on there");
}

void list_changes(const Console& console, const Table& changes, const Lengths& lengths) {
  console.say("change  class                       confidence" +
              lengths.heading("area before, after", "m2", 23) +
              lengths.heading("volume before, after", "m3", 25) +
              lengths.heading("displacement", "m", 16));
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

void list_regions(const Console& console, const Table& regions, const Lengths& lengths) {
  console.say("region     points " + lengths.heading("area", "m2", 10) +
              lengths.heading("volume", "m3", 11) + lengths.heading("mean", "mm", 11) +
              lengths.heading("extreme", "mm", 13) + "   centroid" +
              (lengths.is_known() ? " m" : ""));
  for (uint64_t i = 0; i < regions.rows(); ++i) {
    char line[200];
    std::snprintf(line, sizeof line, "%6u %10s %10s %10s %10s %12s   %s %s %s",
                  static_cast<unsigned>(i + 1), grouped(regions.count("points", i)).c_str(),
                  fixed(regions.number("area", i), 3).c_str(),
                  fixed(regions.number("volume", i), 3).c_str(),
                  lengths.fine(regions.number("mean", i), 1).c_str(),
                  lengths.fine(regions.number("extreme", i), 1).c_str(),
                  fixed(regions.number("centroid", i, 0), 2).c_str(),
                  fixed(regions.number("centroid", i, 1), 2).c_str(),
                  fixed(regions.number("centroid", i, 2), 2).c_str());
    console.say(line);
  }
}

}  // namespace jalon::cli
