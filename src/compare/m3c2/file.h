// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"

namespace jalon {

/// Sets the parameters of method "m3c2" from the text of a parameter file of CloudCompare's M3C2 plug-in (sections,
/// key=value). Its scales are diameters, halved here; its search depth is a half-length already. What it computes is
/// asked for too: all points of a cylinder are one surface. Keys that are absent leave their parameters as they are.
///
/// Returns a line for every key that is not known. All or nothing: Error(kFormat) for what is no such file or has a
/// value that is no number, Error(kUnsupported) for a setting that would change results and has no counterpart.
std::vector<std::string> read_cloudcompare_m3c2(std::string_view text, ParamSet& params);

}  // namespace jalon
