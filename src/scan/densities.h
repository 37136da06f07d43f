// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace jalon {

/// How much denser than the rest each triangle is sampled: text as "gutter=4,ground=0.25", a factor for all faces of
/// parts of a class; 1 for all others. Error(kInvalidArgument) for a text that is none and for classes that no part
/// has.
std::vector<double> triangle_densities(const Model& model, const std::string& text);

}  // namespace jalon
