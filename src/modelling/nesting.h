// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "modelling/straighten.h"

namespace jalon {

/// Outline first, then its openings.
using Polygons = std::vector<Polygon>;

/// Forms of one ring, the most wanted first, the chain it came from last.
struct RingForms {
  std::vector<Polygon> forms;
  void add(Polygon form) {
    if (form.size() >= 3) forms.push_back(std::move(form));
  }
};

/// A form for each ring so that openings lie inside the outline and apart from each other: each ring takes its most
/// wanted form, and rings in conflict step down to the next until none is left. The chains themselves never conflict.
/// rings[0] is the outline.
Polygons nested(std::span<const RingForms> rings);

}  // namespace jalon
