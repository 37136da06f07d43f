// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/handles.h"

namespace jalon::cli {

/// A pose as text: the 16 numbers of a 4 x 4 matrix (last row 0 0 0 1) or the 12 of its first three rows, row by row;
/// blanks, commas and line ends between, lines from # on left out.
jalon_transform read_pose(const std::string& path);
/// The 4 x 4 matrix as four lines, with all digits.
std::string pose_text(const jalon_transform& pose);

}  // namespace jalon::cli
