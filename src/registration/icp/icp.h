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

/// Iterative closest points (Besl & McKay 1992; Chen & Medioni 1992) from a start pose. Legend:
/// clouds.h.
/// 1. Local planes of both clouds, thinned where they lie in lines.
/// 2. On few points, those of the octree's cells, and then on all: neighbours, pairs within a
///    distance that shrinks (Girardeau-Montaut 2006, 2.1), robust weights, one step of the
///    adjustment in the directions that the pairs fix.
/// 3. The last steps on patches of both clouds.
/// 4. Covariance and directions.
/// T_start: T_reference_moving to begin from, finite (else kInvalidArgument). kInsufficientData for
/// fewer than 20 points in a cloud. Same bits for any number of threads.
Registration register_icp(const CloudPtr& reference, const CloudPtr& moving,
                          const Transform& T_start, const IcpSettings& settings, Task& task);

}  // namespace jalon
