// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"

namespace jalon {

/// The cloud with "beam_origin", "beam_direction" and "covariance" as one field each where a file keeps them as
/// "beam_origin_0", "beam_origin_1" ... (PLY, LAS).
Cloud with_whole_beams(const Cloud& cloud);

}  // namespace jalon
