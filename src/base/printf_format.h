// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

// Lets the compiler hold the arguments of a function against its format, counted from 1, `this` included. On Windows
// the functions of MinGW know the formats of C99 (%llu, %zu), which "printf" does not stand for there.
#if defined(__MINGW_PRINTF_FORMAT)
#define JALON_PRINTF(format_at, first_at) \
  __attribute__((format(__MINGW_PRINTF_FORMAT, format_at, first_at)))
#else
#define JALON_PRINTF(format_at, first_at) __attribute__((format(printf, format_at, first_at)))
#endif
