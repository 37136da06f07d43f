// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/comparing/direction.h"

namespace jalon::cli {

/// report.html, histogram.svg and distances.svg of a comparison, at once. notes: of the report, as its function wants
/// them; options: its parameters.
inline void write_report_files(const Console& console, const PathOf& path_of,
                               const Direction& forward, const Direction& reverse,
                               const Fields& changes, const Params& options,
                               const std::string& notes) {
  Beside beside(console);
  beside.run([&, path = path_of("histogram.svg")](jalon_task* task) {
    must(jalon_report_write_histogram(forward.comparison.get(), path.c_str(), options.get(), task));
  });
  beside.run([&, path = path_of("distances.svg")](jalon_task* task) {
    must(jalon_report_write_deviations(forward.comparison.get(), path.c_str(), nullptr, task));
  });
  must(jalon_report_write_comparison(forward.comparison.get(), reverse.comparison.get(),
                                     changes.get(), notes.c_str(), path_of("report.html").c_str(),
                                     options.get(), console.task()));
  beside.wait();
}

}  // namespace jalon::cli
