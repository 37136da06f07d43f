/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file version.h
 * The release number. This is the only place that states it: the build system, pkg-config and the
 * CMake package read it from here.
 */
#ifndef JALON_VERSION_H
#define JALON_VERSION_H

#include <jalon/export.h>

#define JALON_VERSION_MAJOR 0
#define JALON_VERSION_MINOR 1
#define JALON_VERSION_PATCH 0
#define JALON_VERSION_STRING "0.1.0"

/** Release as one number, for comparisons: major * 1 000 000 + minor * 1 000 + patch. */
#define JALON_VERSION_NUMBER \
  (JALON_VERSION_MAJOR * 1000000 + JALON_VERSION_MINOR * 1000 + JALON_VERSION_PATCH)

/** True when the headers are at least of the given release. */
#define JALON_VERSION_AT_LEAST(major, minor, patch) \
  (JALON_VERSION_NUMBER >= (major)*1000000 + (minor)*1000 + (patch))

JALON_BEGIN_C

/** Release of the library that runs, e.g. "0.1.0". Static text, never NULL. Any thread. */
JALON_API const char* jalon_version(void);

/** Release of the library that runs, in the form of JALON_VERSION_NUMBER. Any thread. */
JALON_API int32_t jalon_version_number(void);

/**
 * Instruction set that the vector loops of this process use: "avx2" or "baseline". Results are the
 * same bits with either; the environment variable JALON_SIMD=baseline, read once a process, switches AVX2 off.
 */
JALON_API const char* jalon_instruction_set(void);

JALON_END_C

#endif
