// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/task.h"
#include "registration/network/network_adjustment.h"

namespace jalon {

/// The page on a total-station network: whether it converged and its test, plan, points with their standard deviations
/// and ellipses, reliability, observations by falling size of Baarda's w, parameters.
std::string network_html(const NetworkAdjustment& network, std::string_view parameters_json,
                         std::string_view notes_json, Task& task);

}  // namespace jalon
