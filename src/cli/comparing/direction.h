// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "cli/options.h"
#include "cli/outputs/beside.h"
#include "cli/table.h"

namespace jalon::cli {

/// Where a file of this name is to be written, in the folder of the results.
using PathOf = std::function<std::string(const std::string& name)>;

/// Adds the columns of a table as fields.
inline void add_columns(const Cloud& to, const Fields& table) {
  uint64_t columns = 0;
  must(jalon_fields_count(table.get(), &columns));
  for (uint64_t i = 0; i < columns; ++i) {
    jalon_field_info info{};
    info.struct_size = sizeof info;
    must(jalon_fields_info(table.get(), i, &info));
    jalon_array_view view;
    must(jalon_fields_view(table.get(), info.name, &view));
    must(jalon_cloud_set_field(to.get(), info.name, view.data, view.type, view.components,
                               view.count, view.stride_bytes, info.unit, info.meaning));
  }
}

/// What comparing one way gave.
struct Direction {
  Comparison comparison;
  Fields points;  ///< "changed", "region" and, both ways, "change"
  std::unique_ptr<Table> summary;

  static Direction of(Comparison made) {
    Direction out;
    out.comparison = std::move(made);
    Fields summary;
    must(jalon_comparison_summary(out.comparison.get(), Out(summary)));
    out.summary = std::make_unique<Table>(std::move(summary));
    return out;
  }

  /// The points with their distances and what else is known of each.
  Cloud cloud() const {
    Cloud out;
    must(jalon_comparison_cloud(comparison.get(), Out(out)));
    add_columns(out, points);
    return out;
  }
};

/// Distances of nothing are no result.
inline void require_compared(const std::string& reference, const std::string& compared,
                             const Direction& forward, const Direction& reverse) {
  uint64_t points = forward.summary->count("compared", 0);
  if (reverse.summary != nullptr) points += reverse.summary->count("compared", 0);
  if (points == 0)
    throw Failure{JALON_ERROR_DEGENERATE,
                  "no point of " + compared + " has a distance from " + reference +
                      ": they may lie apart or have other units; nothing is written"};
}

/// As NAME.las and NAME.ply, both at once.
inline void write_both(Beside& beside, const PathOf& path_of, Cloud cloud,
                       const std::string& name) {
  const std::shared_ptr<jalon_cloud> shared = std::move(cloud);
  for (const char* extension : {".las", ".ply"})
    beside.run([shared, path = path_of(name + extension)](jalon_task* task) {
      must(jalon_cloud_write(shared.get(), path.c_str(), nullptr, task));
    });
}

}  // namespace jalon::cli
