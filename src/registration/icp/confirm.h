// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/judge.h"

namespace jalon {

/// Asks both clouds about the directions that the pairs leave open (registration/verdict/slide.h), and takes the last
/// steps again, in all directions, where they hold every one of them. Returns where along one of them the clouds agree
/// clearly better, m; 0: nowhere.
double icp_confirm(const IcpProblem& problem, const IcpJudged& judged, const IcpLevel& all,
                   IcpState& state, Task& task);

}  // namespace jalon
