// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/comparing/direction.h"

namespace jalon::cli {

/// What a report is of.
struct Compared {
  const Direction &forward, &reverse;
  const Fields& changes;
  bool is_diagnosed = false;  ///< changes with classes, else regions
};

/// regions.geojson and regions.dxf.
inline void write_outlines(const Compared& of, const std::vector<std::string>& paths,
                           jalon_task* task) {
  Model outlines;
  must(jalon_comparison_outlines(of.forward.comparison.get(), of.forward.points.get(),
                                 of.reverse.comparison.get(), of.reverse.points.get(),
                                 of.is_diagnosed ? of.changes.get() : nullptr, nullptr, task,
                                 Out(outlines)));
  for (const std::string& path : paths)
    must(jalon_model_write(outlines.get(), path.c_str(), nullptr, task));
}

/// report.html, histogram.svg, distances.svg and the outlines of a comparison, at once. notes: of the report, as its
/// function wants them; options: its parameters.
inline void write_report_files(const Console& console, const PathOf& path_of, const Compared& of,
                               const Params& options, const std::string& notes) {
  Beside beside(console);
  beside.run(
      [&, paths = std::vector<std::string>{path_of("regions.geojson"), path_of("regions.dxf")}](
          jalon_task* task) { write_outlines(of, paths, task); });
  beside.run([&, path = path_of("histogram.svg")](jalon_task* task) {
    must(jalon_report_write_histogram(of.forward.comparison.get(), path.c_str(), options.get(),
                                      task));
  });
  beside.run([&, path = path_of("distances.svg")](jalon_task* task) {
    must(jalon_report_write_deviations(of.forward.comparison.get(), path.c_str(), nullptr, task));
  });
  must(jalon_report_write_comparison(
      of.forward.comparison.get(), of.reverse.comparison.get(), of.changes.get(), notes.c_str(),
      path_of("report.html").c_str(), options.get(), console.task()));
  beside.wait();
}

}  // namespace jalon::cli
