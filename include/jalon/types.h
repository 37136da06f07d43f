/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file types.h
 * Plain value types. Their layout is frozen for ever. Lengths are metres, angles radians,
 * matrices row-major.
 */
#ifndef JALON_TYPES_H
#define JALON_TYPES_H

#include <jalon/export.h>

JALON_BEGIN_C

/** Element types of arrays. */
enum {
  JALON_INT8 = 1,
  JALON_UINT8 = 2,
  JALON_INT16 = 3,
  JALON_UINT16 = 4,
  JALON_INT32 = 5,
  JALON_UINT32 = 6,
  JALON_INT64 = 7,
  JALON_UINT64 = 8,
  JALON_FLOAT32 = 9,
  JALON_FLOAT64 = 10
};

typedef struct jalon_vec3 {
  double x, y, z;
} jalon_vec3;

/** Axis-parallel box; empty when min > max on an axis. */
typedef struct jalon_box {
  jalon_vec3 min, max;
} jalon_box;

/** Affine map p' = A p + t as the three rows [A | t]: m[4*i + j]. */
typedef struct jalon_transform {
  double m[12];
} jalon_transform;

/**
 * Read-only look at an array that a handle owns: element (i, c) lies at
 * (const char*)data + i * stride_bytes + c * size of type. It lives as long as the handle that gave it.
 */
typedef struct jalon_array_view {
  const void* data;
  uint64_t count;        /**< items, e.g. points */
  uint32_t components;   /**< elements an item, e.g. 3 for coordinates */
  int32_t type;          /**< JALON_INT8 ... JALON_FLOAT64 */
  uint64_t stride_bytes; /**< bytes from one item to the next */
} jalon_array_view;

/** What a reduction did: duplicates, outliers, sub-sampling. */
typedef struct jalon_reduction {
  uint64_t count_in, count_out, removed;
  double removed_percent; /**< 100 * removed / count_in; 0 for an empty input */
} jalon_reduction;

JALON_END_C

#endif
