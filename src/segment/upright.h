// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

/// |nz| of a plane within 10 degrees of the vertical: walls lean.
constexpr double kWallSine = 0.1736;

}  // namespace jalon
