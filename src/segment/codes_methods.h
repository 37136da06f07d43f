// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/codes_settings.h"
#include "segment/segmentation.h"

namespace jalon {

/// Parameter table of method "survey_codes".
std::span<const ParamRow> survey_code_rows();
/// Objects that a coded total-station survey describes (see survey_codes.cpp for the steps).
Segmentation segment_by_survey_codes(const CloudPtr& cloud, const SurveyCodeSettings& settings,
                                     Task& task);

/// Parameter table of method "target_codes".
std::span<const ParamRow> target_code_rows();
/// Objects about coded targets (see target_codes.cpp for the steps).
Segmentation segment_by_target_codes(const CloudPtr& cloud, const TargetCodeSettings& settings,
                                     Task& task);

}  // namespace jalon
