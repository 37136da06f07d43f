// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

/// True when the vector loops run their AVX2 form: the processor has it and the environment variable JALON_SIMD is not
/// "baseline". Decided once a process. Both forms give the same bits (no fused multiply-add, same order of operations).
bool use_avx2();

}  // namespace jalon
