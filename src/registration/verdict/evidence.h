// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/verdict/agreement.h"
#include "registration/verdict/scale_test.h"

namespace jalon {

/// What two clouds say of a pose.
struct PoseEvidence {
  Agreement of_moving, of_reference;  ///< each held against the other
  ScaleTest scale;
  /// Where along an open direction they agree clearly better, m; 0: nowhere, or no direction is open.
  double better_m = 0;

  /// Of both clouds it is known where they were taken from.
  bool has_sights() const { return of_moving.has_sights && of_reference.has_sights; }
};

PoseEvidence evidence_of(const JudgedCloud& reference, const JudgedCloud& moving,
                         const Transform& T_reference_moving, Task& task);

}  // namespace jalon
