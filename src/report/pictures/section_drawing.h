// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cloud/sections/sections.h"

namespace jalon {

/// Sections as an SVG in millimetres, to a usual scale that it tells: level ones one over the other as a plan, in
/// colours with a key; all others side by side, each with its axes, at one scale.
std::string section_drawing(const Sections& sections);

/// Writes it, beside the target first.
void write_section_drawing(const Sections& sections, const std::string& path, Task& task);

}  // namespace jalon
