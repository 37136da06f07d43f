// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "segment/segmentation.h"

namespace jalon {

/// The column "label" of n points, to be filled.
std::shared_ptr<Column> make_label_column(size_t n);

/// "residual" and "orientation" of every point, from its label and segment; the segments' surfaces are relative to the
/// origin.
void add_point_columns(Segmentation& segmentation, const Vec3& origin, Task& task);

}  // namespace jalon
