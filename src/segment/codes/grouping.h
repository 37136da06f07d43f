// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "segment/codes/coded_object.h"

namespace jalon {

/// Whether two targets of windows stick on one facade.
using ArePaired = std::function<bool(const CodedPoint&, const CodedPoint&)>;

/// The points of a list joined to objects, without their shapes: linkages per sequence from one start to the next,
/// openings by twos, threes or fours of one sequence, cylinders of centre, edge and top, each target by itself.
/// Sequences may be interleaved. What is incomplete gives a warning that names line and object, and no object; so does
/// a point less than 1 cm from the one before it with the same code, which was measured twice and is used once.
/// Where an opening of a sequence lacks a point, or has one too many, it is found by which points make no opening
/// together, so that those behind it keep theirs; are_paired tells it of windows' targets, and is asked only then.
CodedObjects grouped_objects(const CodeList& list, const CodeTable& table,
                             const ArePaired& are_paired = {});

}  // namespace jalon
