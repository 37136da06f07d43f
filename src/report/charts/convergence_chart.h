// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/field.h"

namespace jalon {

/// The log of an iteration as SVG: root mean square residual ("rms") and, where they are there, the limit of residuals
/// ("distance") and the shift of the step ("shift") of each row, in millimetres on a logarithmic axis. "" for a log
/// without "rms".
std::string convergence_chart(const FieldTable& log);

}  // namespace jalon
