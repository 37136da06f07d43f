// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "modelling/plane/plane_frame.h"
#include "segment/segmentation.h"

namespace jalon {

/// The frame that a planar segment is drawn in: its plane, and the corner of its points' box in whole metres, which
/// moves with the cloud without rounding. Before: the segment has a plane; indices are those of its points, one at
/// least.
PlaneFrame segment_frame(const Segmentation& segmentation, const Segment& segment,
                         std::span<const uint32_t> indices);

}  // namespace jalon
