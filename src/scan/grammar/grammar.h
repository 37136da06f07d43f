// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/builder/builder.h"
#include "scan/scene.h"

namespace jalon {

/// The scene "grammar": a facade of the kind and the sizes asked for, the rest by the seed, with its ground, rooms and
/// what stands before it. The front lies about y = 0, from x = 0 on.
void build_grammar(const SceneSettings& settings, SceneBuilder& out);

}  // namespace jalon
