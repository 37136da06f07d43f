// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// What speaks for a candidate; the numbers of jalon/registrar.h.
enum class PoseSource : uint8_t {
  kFeatures = 1,  ///< matches of local features that fit together
  kPlanes = 2,    ///< planes laid on each other
  kSlide = 3,     ///< another pose, moved the way that least holds it
  kStart = 4,     ///< the start as given
};

struct PoseCandidate {
  Transform T_reference_moving;  ///< between the surfaces' own frames
  PoseSource source = PoseSource::kFeatures;
};

/// Possible poses from local features and from planes, in no order of worth.
///
/// Before: features are described; level says that both clouds stand upright (z is the same), so
/// that a plane and the vertical already fix a rotation. After: rigid poses, some of them alike; as
/// many as 60 of features, 8 of the largest planes and 256 of the others.
std::vector<PoseCandidate> coarse_candidates(const CoarseSurface& reference,
                                             const CoarseSurface& moving, bool level, Task& task);

}  // namespace jalon
