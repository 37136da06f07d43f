// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"
#include "segment/codes/coded_object.h"
#include "segment/codes_settings.h"

namespace jalon {

/// Moves surveyed openings and pipes to where the cloud has them, and shares their points out anew (form "improved"):
/// the front of an opening is found among the points about its measured plane, and what lies before it is its wall's
/// reveal; an upright pipe is the circle about which its points lie. object_of_point: as the spaces of the survey had
/// it.
void refine_survey(const Cloud& cloud, const CodeTable& table, const CodedObjects& objects,
                   const SurveyCodeSettings& settings, std::vector<uint32_t>& object_of_point,
                   Task& task);

/// Warns of upright pipes whose points lie about another place than the surveyed one, by more than 1.5 cm.
void warn_of_shifted_pipes(const Cloud& cloud, CodedObjects& objects, Task& task);

}  // namespace jalon
