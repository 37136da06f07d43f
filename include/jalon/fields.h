/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file fields.h
 * The field table that clouds, models and results share: named columns of equal length.
 *
 * A jalon_fields is an immutable snapshot: it stays as it is, and its views stay valid until it is released,
 * whatever happens to the handle it came from. It may be read by many threads at once.
 */
#ifndef JALON_FIELDS_H
#define JALON_FIELDS_H

#include <jalon/status.h>
#include <jalon/types.h>

JALON_BEGIN_C

typedef struct jalon_fields jalon_fields;

/** One column. The caller sets struct_size = sizeof(jalon_field_info); texts live as long as the snapshot. */
typedef struct jalon_field_info {
  uint32_t struct_size;
  int32_t type;        /**< JALON_INT8 ... JALON_FLOAT64 */
  uint32_t components; /**< elements an item */
  uint32_t reserved;   /**< 0 */
  uint64_t count;      /**< items */
  const char* name;
  const char* unit;    /**< "m", "rad", "" ... */
  const char* meaning; /**< one line, or "" */
} jalon_field_info;

JALON_API jalon_fields* jalon_fields_retain(jalon_fields* fields);
JALON_API void jalon_fields_release(jalon_fields* fields);
/** Number of columns. */
JALON_API JALON_CHECK jalon_status jalon_fields_count(const jalon_fields* fields, uint64_t* out);
/** Column i: its name, type, components, number of items, unit and meaning. */
JALON_API JALON_CHECK jalon_status jalon_fields_info(const jalon_fields* fields, uint64_t i,
                                                     jalon_field_info* out);
/** View of the column of that name; JALON_ERROR_NOT_FOUND lists the names there are. No copy. */
JALON_API JALON_CHECK jalon_status jalon_fields_view(const jalon_fields* fields, const char* name,
                                                     jalon_array_view* out);
/**
 * Copies a column into the caller's packed array of capacity_elements elements of the given type (count * components
 * are needed); values are converted, and one that does not fit is JALON_ERROR_INVALID_ARGUMENT with nothing written.
 */
JALON_API JALON_CHECK jalon_status jalon_fields_copy(const jalon_fields* fields, const char* name,
                                                     int32_t type, void* out,
                                                     uint64_t capacity_elements);

JALON_END_C

#endif
