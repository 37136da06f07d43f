// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/icp/settings.h"
#include "registration/registration.h"

namespace jalon {

/// Parameter table of method "icp".
std::span<const ParamRow> icp_rows();

/// Iterative closest points (Besl & McKay 1992; Chen & Medioni 1992) from a start pose:
/// 1. local planes of both clouds; 2. on few points, those of the octree's cells, and then on all: neighbours, pairs
/// within a distance that shrinks (Girardeau-Montaut 2006, 2.1), robust weights, one step of the adjustment in the
/// directions that the pairs fix; 3. covariance and directions.
Registration register_icp(const CloudPtr& reference, const CloudPtr& moving, const Transform& start,
                          const IcpSettings& settings, Task& task);

}  // namespace jalon
