// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/version.h"

#include "base/simd.h"

const char* jalon_version(void) { return JALON_VERSION_STRING; }

int32_t jalon_version_number(void) { return JALON_VERSION_NUMBER; }

const char* jalon_instruction_set(void) { return jalon::use_avx2() ? "avx2" : "baseline"; }
