// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan/yard/plan.h"

namespace jalon::yard {

/// The coded total-station survey of the plan, a line a point, ID;X;Y;Z;code: buildings as linkages, doors of two and
/// three points, windows of three and four, gutters of centre, edge and top, by the survey's table of codes; noise and
/// the shift to the cloud by the seed.
std::vector<std::string> survey_lines(const Plan& plan, const YardSettings& settings, uint64_t seed,
                                      const Transform& T_world_scene);
/// The targets, which lie in the cloud itself.
std::vector<std::string> target_lines(const Plan& plan, const Transform& T_world_scene);

}  // namespace jalon::yard
