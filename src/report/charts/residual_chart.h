// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "segment/result/residuals.h"

namespace jalon {

/// Histogram as SVG: millimetres across, points upward, and the normal curve of the same mean, sigma and count.
std::string residual_chart(const Residuals& residuals);

}  // namespace jalon
