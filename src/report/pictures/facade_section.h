// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "registration/joint/joint_adjustment.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

/// The facade that was farthest from its points as both were given (mean over its strips that points hold); of those
/// with three such strips and more, where there is one. None where no strip is held.
std::optional<uint32_t> farthest_facade(const StripScene& scene, const JointAdjustment& adjustment);

/// A level section through a facade, seen from above, as SVG in millimetres: strips and points as given (blue, red) and
/// below, to the same scale, as adjusted (black, green). Metres along the facade, and out of it by a stated factor.
std::string facade_section(const StripScene& scene, const JointAdjustment& adjustment,
                           uint32_t facade);

}  // namespace jalon
