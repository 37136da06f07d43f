// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/evidence.h"

#include "geometry/rigid_motion.h"

namespace jalon {

PoseEvidence evidence_of(const JudgedCloud& reference, const JudgedCloud& moving,
                         const Transform& T_reference_moving, Task& task) {
  return {agreement_of(moving, reference, T_reference_moving, task),
          agreement_of(reference, moving, inverse(T_reference_moving), task),
          scale_test(reference, moving, T_reference_moving), 0};
}

}  // namespace jalon
