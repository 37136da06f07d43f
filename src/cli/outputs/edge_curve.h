// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/options.h"

namespace jalon::cli {

/// The sorted edge lengths of one segment and its contour points by long edges: "--edge-curve LABEL".
struct EdgeCurveFiles {
  int64_t label = 0;       ///< 0: not asked for
  double threshold_m = 0;  ///< 0: at the knee of the curve

  void add_to(Command& command);
  void check() const;
  /// edge_lengths.csv and contour_points.csv, where path_of a name says; their names, none where nothing was asked for.
  std::vector<std::string> write(const Console& console, const Segmentation& segmentation,
                                 const std::function<std::string(const char*)>& path_of) const;
};

}  // namespace jalon::cli
