// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/coarse/settings.h"
#include "registration/icp/settings.h"
#include "registration/registration.h"

namespace jalon {

/// The parameters of method "automatic": those of its two steps, one after the other.
struct AutomaticSettings {
  CoarseSettings coarse;
  IcpSettings icp;
};
std::span<const ParamRow> automatic_rows();

/// Method "automatic": method "coarse", then "icp" from its best poses in turn, with the settings of both. The result
/// is that of ICP from the first pose that is accepted, with the scores of coarse in the summary. Where coarse is not
/// sure of its best pose the others are tried too, and two different ones that are accepted make the result
/// ambiguous. With none accepted it is that of ICP from the best pose where coarse is sure of it, else that of
/// coarse. T_start: a T_reference_moving of the caller's coordinates, which coarse takes as one candidate more.
Registration register_automatic(const CloudPtr& reference, const CloudPtr& moving,
                                const Transform& T_start, const AutomaticSettings& settings,
                                Task& task);

}  // namespace jalon
