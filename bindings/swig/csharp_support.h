/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the C# wrappers need: the failure and the text of the last call of a thread, until managed code has read them.
 */
#ifndef JALON_BINDINGS_CSHARP_SUPPORT_H
#define JALON_BINDINGS_CSHARP_SUPPORT_H

#include "jalon_calls.h"

#if defined(_WIN32)
#define JALON_CSHARP_EXPORT extern "C" __declspec(dllexport)
#else
#define JALON_CSHARP_EXPORT extern "C" __attribute__((visibility("default")))
#endif

namespace jalon_csharp {

using jalon_binding::ArrayIn;
using jalon_binding::Failure;

inline Failure& last_failure() {
  thread_local Failure failure{JALON_OK, std::string()};
  return failure;
}
inline void keep_failure(const Failure& failure) { last_failure() = failure; }

inline const char* keep_text(std::string text) {
  thread_local std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

}  // namespace jalon_csharp

/** The status of the failure of this thread's last call; 0 when it succeeded. */
JALON_CSHARP_EXPORT int32_t jalon_csharp_status() { return jalon_csharp::last_failure().status; }
/** Its message; the failure is forgotten. */
JALON_CSHARP_EXPORT const char* jalon_csharp_take_message() {
  jalon_csharp::last_failure().status = JALON_OK;
  return jalon_csharp::keep_text(jalon_csharp::last_failure().message);
}
/** A borrowed array as the wrappers take it; to be freed by jalon_csharp_array_free. */
JALON_CSHARP_EXPORT void* jalon_csharp_array(const void* data, int32_t type, uint64_t count) {
  return new (std::nothrow) jalon_binding::ArrayIn(data, type, count);
}
JALON_CSHARP_EXPORT void jalon_csharp_array_free(void* array) { delete static_cast<jalon_binding::ArrayIn*>(array); }

#endif
