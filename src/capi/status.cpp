// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/status.h"

#include "capi/support/operations.h"
#include "jalon/version.h"

const char* jalon_status_name(jalon_status status) {
  switch (status) {
    case JALON_OK:
      return "ok";
    case JALON_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case JALON_ERROR_OUT_OF_MEMORY:
      return "out of memory";
    case JALON_ERROR_CANCELLED:
      return "cancelled";
    case JALON_ERROR_NOT_FOUND:
      return "not found";
    case JALON_ERROR_INSUFFICIENT_DATA:
      return "insufficient data";
    case JALON_ERROR_DEGENERATE:
      return "degenerate geometry";
    case JALON_ERROR_IO:
      return "input/output error";
    case JALON_ERROR_FORMAT:
      return "malformed file";
    case JALON_ERROR_UNSUPPORTED:
      return "unsupported";
    case JALON_ERROR_CALLBACK:
      return "callback failed";
    case JALON_ERROR_BUSY:
      return "busy";
    case JALON_ERROR_LIMIT:
      return "limit exceeded";
    case JALON_ERROR_INTERNAL:
      return "internal error";
    default:
      return "unknown status";
  }
}

const char* jalon_last_error_message(void) { return jalon::capi::last_error_text(); }
