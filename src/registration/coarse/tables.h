// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/coarse/search.h"
#include "registration/registration.h"

namespace jalon {

/// Fills pairs, rms_m, the covariance and the columns of method "coarse" (jalon/registrar.h).
///
/// Before: registration has its pose, stopped, centre and extent_m; found: poses between the
/// caller's coordinates. After:
/// - summary has the best pose's overlap and the second's score, then the common columns;
/// - iteration_log has a row a pose of found, the best first; residuals stay empty;
/// - the covariance is NaN: a start pose has none worth the name; directions say what holds the
/// pose.
void fill_coarse_tables(Registration& registration, const CoarseSearch& found, double cell_m,
                        size_t candidates);

}  // namespace jalon
