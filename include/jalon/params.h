/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file params.h
 * The one parameter mechanism of all workers and operations.
 *
 * A parameter set is a table of rows (name, type, unit, default, range, the methods it applies to,
 * one line of help) with a value each. It can be enumerated, set, read, and written to and read from
 * JSON; a dialog or a keyword-argument list can be generated from it. An unknown name, a wrong type or
 * a value out of range is an error when set, never later. A new parameter is a new row, never a new symbol.
 * Every length says in its help whether it is a radius, a diameter or a half-thickness.
 *
 * One set is used by one thread at a time. Texts that a function hands out live as long as the set, those of
 * values until the value is set again.
 */
#ifndef JALON_PARAMS_H
#define JALON_PARAMS_H

#include <jalon/status.h>

JALON_BEGIN_C

typedef struct jalon_params jalon_params;

/** Types of a parameter. */
enum {
  JALON_PARAM_DOUBLE = 1,
  JALON_PARAM_INT64 = 2,
  JALON_PARAM_BOOL = 3,
  JALON_PARAM_STRING = 4,
  JALON_PARAM_CHOICE = 5, /**< a text among the row's choices */
  JALON_PARAM_DOUBLES = 6 /**< an array of doubles */
};

/** One row. The caller sets struct_size = sizeof(jalon_param_info) before the call; fields are only ever appended. */
typedef struct jalon_param_info {
  uint32_t struct_size;
  int32_t type;
  const char* name;
  const char* unit;         /**< "m", "rad", "1", "points", ... ; "" where none applies */
  const char* methods;      /**< comma-separated methods that read it; "" = all */
  const char* help;         /**< one line */
  const char* choices;      /**< separated by '|'; "" unless the type is JALON_PARAM_CHOICE */
  const char* default_text; /**< the default as JSON text */
  double minimum, maximum;  /**< of numbers and of each array element; -inf/inf where free */
} jalon_param_info;

/**
 * Makes the parameter set of an operation that is no worker, e.g. "normals" or "read"; the function that
 * takes it names it. JALON_ERROR_NOT_FOUND when there is none of that name.
 */
JALON_API JALON_CHECK jalon_status jalon_params_create(const char* operation, jalon_params** out);
/** Number of operations that jalon_params_create knows. */
JALON_API JALON_CHECK jalon_status jalon_params_operation_count(uint64_t* out);
/** Name of operation i. Static text. */
JALON_API JALON_CHECK jalon_status jalon_params_operation_name(uint64_t i, const char** out);
/** A set of its own with the same values; of a worker's set one that changes no worker. */
JALON_API JALON_CHECK jalon_status jalon_params_copy(const jalon_params* params,
                                                     jalon_params** out);
JALON_API jalon_params* jalon_params_retain(jalon_params* params);
JALON_API void jalon_params_release(jalon_params* params);

/** Number of rows. */
JALON_API JALON_CHECK jalon_status jalon_params_count(const jalon_params* params, uint64_t* out);
/** Row i: its name, type, unit, range, default and help. */
JALON_API JALON_CHECK jalon_status jalon_params_info(const jalon_params* params, uint64_t i,
                                                     jalon_param_info* out);

/** Set one value. JALON_ERROR_NOT_FOUND for an unknown name, JALON_ERROR_INVALID_ARGUMENT for a wrong type or range. */
JALON_API JALON_CHECK jalon_status jalon_params_set_double(jalon_params* params, const char* name,
                                                           double value);
/** The same for whole numbers; a row of doubles takes them too. */
JALON_API JALON_CHECK jalon_status jalon_params_set_int64(jalon_params* params, const char* name,
                                                          int64_t value);
/** Any value other than 0 is true. */
JALON_API JALON_CHECK jalon_status jalon_params_set_bool(jalon_params* params, const char* name,
                                                         int32_t value);
/** Also sets choices. value: UTF-8, at most 1 MiB. */
JALON_API JALON_CHECK jalon_status jalon_params_set_string(jalon_params* params, const char* name,
                                                           const char* value);
/** Each value must lie in the row's range. They are copied. */
JALON_API JALON_CHECK jalon_status jalon_params_set_doubles(jalon_params* params, const char* name,
                                                            const double* values, uint64_t count);

/** Read one value; the type must be the row's. */
JALON_API JALON_CHECK jalon_status jalon_params_get_double(const jalon_params* params,
                                                           const char* name, double* out);
/** A whole number. */
JALON_API JALON_CHECK jalon_status jalon_params_get_int64(const jalon_params* params,
                                                          const char* name, int64_t* out);
/** 1 or 0. */
JALON_API JALON_CHECK jalon_status jalon_params_get_bool(const jalon_params* params,
                                                         const char* name, int32_t* out);
/** A text or a choice; it lives until the row is set again or the set is released. */
JALON_API JALON_CHECK jalon_status jalon_params_get_string(const jalon_params* params,
                                                           const char* name, const char** out);
/** The values in their order. */
JALON_API JALON_CHECK jalon_status jalon_params_get_doubles(const jalon_params* params,
                                                            const char* name, const double** values,
                                                            uint64_t* count);

/** All values back to their defaults. */
JALON_API JALON_CHECK jalon_status jalon_params_reset(jalon_params* params);
/** The values as one JSON object. *out lives until the next call with this set or its release. */
JALON_API JALON_CHECK jalon_status jalon_params_to_json(jalon_params* params, const char** out);
/** Sets the values that a JSON object names; all or, on an error, none of them. */
JALON_API JALON_CHECK jalon_status jalon_params_from_json(jalon_params* params, const char* json);

JALON_END_C

#endif
