// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/handles.h"

namespace jalon::cli {

/// Whether surfaces bent about an axis may be behind the planes: many of their points have none, or upright planes look
/// in many directions.
bool may_be_bent(const Segmentation& segmentation);

/// What is bent among the surfaces of a segmentation with cylinders and large enough to be a wall, in one line; "":
/// nothing.
std::string told_of_bent_walls(const Segmentation& segmentation);

/// Why the surfaces of this cloud are those of no facade, and what to do with it, in one line; "" where they may be:
/// - hardly any point is on an upright surface: measured from the air, or open land;
/// - walls on three sides and more with floor and ceiling, the cloud between them: a room seen from inside.
std::string why_no_facade(const Cloud& cloud, const Segmentation& segmentation);

}  // namespace jalon::cli
