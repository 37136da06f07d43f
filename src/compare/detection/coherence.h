// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/detection/core_tests.h"

namespace jalon {

/// A change is larger than a core, whose neighbours overlap: 1. moved and new cores without two alike among those
/// next to them are taken back, a moved one as unchanged, a new one as not to be told; 2. next to moved ones a core
/// is moved that lies beyond its own level of detection to the same side (hysteresis, Canny 1986): a test among
/// very many misses what one alone would not; 3. pieces of moved cores that lie on fewer surfaces of the reference
/// than cores are asked for are taken back: fine cores on one wide surface err with it, however many they are. The
/// same order whatever the threads.
void settle_together(const SurfaceCores& reference, const SurfaceCores& compared, CoreTests& tests,
                     Task& task);

}  // namespace jalon
