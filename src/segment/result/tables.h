// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/segmentation.h"

namespace jalon {

/// The tables of jalon/segmenter.h: one row a point, and one row a segment.
FieldTable point_table(const Segmentation& segmentation);
FieldTable segment_table(const Segmentation& segmentation);

}  // namespace jalon
