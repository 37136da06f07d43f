// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/registration.h"

namespace jalon {

/// Method "automatic": method "coarse", then "icp" from the pose it gives, with the parameters of both. What comes of
/// coarse without a pose, or with more than one, is the result as it is; else it is that of ICP, with the scores of
/// coarse in the summary.
Registration register_automatic(const CloudPtr& reference, const CloudPtr& moving, const Transform& start,
                                const ParamSet& params, Task& task);

}  // namespace jalon
