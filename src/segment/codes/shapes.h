// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/codes/coded_object.h"

namespace jalon {

/// Gives the objects of a survey their shapes, and doors their hinge; sizes are as measured, without any margin.
/// Objects whose points contradict each other get none and a warning: an opening whose second measurement of a corner
/// lies more than 0.5 m from the first, an outline of fewer than three points.
void give_shapes(const CodeTable& table, CodedObjects& objects);

}  // namespace jalon
