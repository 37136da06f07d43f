/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file status.h
 * Status codes and the message of the last failure.
 *
 * Every function that can fail returns a jalon_status. On failure its outputs are untouched, every
 * handle stays usable, and one line of text says what was wrong. A result such as "not converged"
 * is a success whose result object says so. The numbers never change; new ones are appended.
 */
#ifndef JALON_STATUS_H
#define JALON_STATUS_H

#include <jalon/export.h>

JALON_BEGIN_C

typedef int32_t jalon_status;

enum {
  JALON_OK = 0,
  JALON_ERROR_INVALID_ARGUMENT = -1,  /**< NULL, out of range, unknown name, wrong size */
  JALON_ERROR_OUT_OF_MEMORY = -2,     /**< an allocation failed; nothing was changed */
  JALON_ERROR_CANCELLED = -3,         /**< by jalon_task_cancel or by the progress callback */
  JALON_ERROR_NOT_FOUND = -4,         /**< no such file, field, parameter, station */
  JALON_ERROR_INSUFFICIENT_DATA = -5, /**< too few points for the work */
  JALON_ERROR_DEGENERATE = -6,  /**< collinear, all equal, no plane: geometry without a solution */
  JALON_ERROR_IO = -7,          /**< the system refused to open, read, write or rename */
  JALON_ERROR_FORMAT = -8,      /**< a file's content is malformed or truncated */
  JALON_ERROR_UNSUPPORTED = -9, /**< valid, but not handled by this build */
  JALON_ERROR_CALLBACK = -10,   /**< a host callback threw an exception */
  JALON_ERROR_BUSY = -11,       /**< the task already runs a call */
  JALON_ERROR_LIMIT = -12,      /**< more than the library can index or hold */
  JALON_ERROR_INTERNAL = -99    /**< a defect of Jalon; please report it */
};

/** Name of a status, e.g. "invalid argument". Static text; "unknown status" for other numbers. */
JALON_API const char* jalon_status_name(jalon_status status);

/**
 * One line about the last failure on the calling thread; "" when none happened yet. Valid until
 * the next failing call on this thread. A success does not clear it.
 */
JALON_API const char* jalon_last_error_message(void);

JALON_END_C

#endif
