// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"

namespace jalon {

/// Names of the columns that the extension "nor" of E57 gives the parts of a normal.
inline constexpr const char* kNormalParts[] = {"normalX", "normalY", "normalZ"};

/// The three columns as the one field "normal" of everybody else, turned by the poses of their
/// scans. Does nothing where one of them is missing.
void join_normals(Cloud& cloud);

}  // namespace jalon
