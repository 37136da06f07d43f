// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/front/evidence.h"
#include "segment/front/wall_sheet.h"

namespace jalon {

/// Fills filling, hung and ground of the evidence. O(points).
void look_near(const Cloud& cloud, const Vec3& origin, std::span<const uint32_t> labels,
               const std::vector<Segment>& segments, const WallGroup& group, const WallSheet& sheet,
               FrontEvidence& evidence, Task& task);

}  // namespace jalon
