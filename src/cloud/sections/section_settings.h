// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/params.h"

namespace jalon {

/// The settings of operation "sections"; the rows stand in sections.cpp.
struct SectionSettings {
  std::vector<double> direction{0, 0, 1};
  std::vector<double> at_m;
  double step_m = 0;  ///< 0: at_m alone, each metre without them
  double thickness_m = 0.05;
  double tolerance_m = 0.02;  ///< of Douglas-Peucker
  double gap_m = 0.15;        ///< where a line breaks off
  double reach_m = 0;         ///< to both sides of an alignment; 0: no end
  double min_length_m = 0.2;
};

}  // namespace jalon
