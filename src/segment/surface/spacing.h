// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/surface/scene.h"

namespace jalon {

/// Median of the local spacing of the free points, m, from an even sample; points on one place of the index count once.
/// 0 where no point is free.
double median_spacing_m(const SegmentScene& scene);

}  // namespace jalon
