// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/facade_plan.h"

namespace jalon {

/// Faces, vertices and the tree of parts from a plan: [building ->] facade -> wall -> opening (window, door) -> reveal,
/// joinery; no_data under its wall; elements under their facade. The building stands above when there are several
/// facades. Names: class and number; openings by row from below and place from the left ("window 2.3"), other parts
/// from left to right and from below.
Model assemble_facades(const Segmentation& segmentation, const FacadePlan& plan, Task& task);

}  // namespace jalon
