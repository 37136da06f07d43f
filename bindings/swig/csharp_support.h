/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the C# wrappers need: the failure and the text of the last call of a thread, until managed code has read them;
 * borrowed arrays; the callbacks of a task. */
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
using jalon_binding::Handle;

inline Failure& last_failure() {
  thread_local Failure failure{JALON_OK, std::string()};
  return failure;
}
inline void keep_failure(const Failure& failure) {
  last_failure() = failure;
  jalon_binding::host_failed() = false;
}

inline const char* keep_text(std::string text) {
  thread_local std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

/** What managed callbacks answer; an exception is kept there and thrown after the call. */
enum { kGoOn = 0, kCancel = 1, kThrew = 2 };
typedef int32_t (*ManagedProgress)(double fraction, const char* stage, void* user);
typedef int32_t (*ManagedLog)(int32_t level, const char* text, void* user);

/** The callbacks of a task. user: a handle of managed code, freed there after the task. */
struct Callbacks {
  ManagedProgress progress;
  ManagedLog log;
  void* user;
};

inline int32_t on_progress(double fraction, const char* stage, void* user) {
  const Callbacks* callbacks = static_cast<Callbacks*>(user);
  const int32_t answer = callbacks->progress(fraction, stage, callbacks->user);
  if (answer == kThrew) jalon_binding::host_failed() = true;
  return answer == kGoOn ? 0 : 1;
}

inline void on_log(int32_t level, const char* text, void* user) {
  const Callbacks* callbacks = static_cast<Callbacks*>(user);
  if (callbacks->log(level, text, callbacks->user) == kThrew) jalon_binding::host_failed() = true;
}

inline void set_callbacks(Handle<jalon_task>* box, const Callbacks& given) {
  auto callbacks = std::make_shared<Callbacks>(given);
  const jalon_binding::Use<jalon_task> task(box);
  jalon_binding::check(jalon_task_set_progress(
      task, given.progress == nullptr ? nullptr : on_progress, callbacks.get()));
  jalon_binding::check(
      jalon_task_set_log(task, given.log == nullptr ? nullptr : on_log, callbacks.get()));
  box->host = callbacks;
}

}  // namespace jalon_csharp

/** The status of the failure of this thread's last call; 0 when it succeeded. */
JALON_CSHARP_EXPORT int32_t jalon_csharp_status() { return jalon_csharp::last_failure().status; }
/** Its message; the failure is forgotten. */
JALON_CSHARP_EXPORT const char* jalon_csharp_take_message() {
  jalon_csharp::last_failure().status = JALON_OK;
  return jalon_csharp::keep_text(jalon_csharp::last_failure().message);
}
/** A borrowed array as the wrappers take it, freed by jalon_csharp_array_free. components 0: no notion of rows. */
JALON_CSHARP_EXPORT void* jalon_csharp_array(const void* data, int32_t type, uint64_t count,
                                             uint32_t components, uint64_t stride_bytes) {
  auto* array = new (std::nothrow) jalon_binding::ArrayIn(data, type, count);
  if (array != nullptr && components != 0) {
    array->components = components;
    array->stride_bytes = stride_bytes;
    array->flat = false;
  }
  return array;
}
JALON_CSHARP_EXPORT void jalon_csharp_array_free(void* array) {
  delete static_cast<jalon_binding::ArrayIn*>(array);
}
/** The callbacks of a task (nullptr: none); a failure as of any call. */
JALON_CSHARP_EXPORT void jalon_csharp_callbacks(jalon_binding::Handle<jalon_task>* task,
                                                jalon_csharp::ManagedProgress progress,
                                                jalon_csharp::ManagedLog log, void* user) {
  try {
    jalon_csharp::set_callbacks(task, jalon_csharp::Callbacks{progress, log, user});
  } catch (...) {
    jalon_csharp::keep_failure(jalon_binding::current_failure());
  }
}

#endif
