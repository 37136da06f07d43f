/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file task.h
 * How a long call runs: number of threads, log, progress, cancel.
 *
 * Every long call takes a task as its last input; NULL means: all processors, no callbacks. One
 * running call a task; a second call with the same task gets JALON_ERROR_BUSY. Callbacks are made on
 * the calling thread only, never concurrently, about every 50-100 ms, and must not call Jalon with the
 * same task. Setters are for the time between calls; jalon_task_cancel may be called by any thread at
 * any time, and the running call ends within 100 ms with JALON_ERROR_CANCELLED, its outputs untouched.
 */
#ifndef JALON_TASK_H
#define JALON_TASK_H

#include <jalon/status.h>

JALON_BEGIN_C

typedef struct jalon_task jalon_task;

/** Log levels. */
enum { JALON_LOG_DEBUG = 1, JALON_LOG_INFO = 2, JALON_LOG_WARNING = 3 };

/**
 * Progress: fraction grows monotonically in 0..1 and reaches 1 only on success; stage is a short English
 * phrase, valid during the call. Return 0 to go on, anything else to cancel.
 */
typedef int32_t (*jalon_progress_callback)(double fraction, const char* stage, void* user);

/** Log: one line of UTF-8 text without a line feed, valid during the call. */
typedef void (*jalon_log_callback)(int32_t level, const char* text, void* user);

/** Makes a task with the defaults of NULL. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_task_create(jalon_task** out);
/** One more owner; returns its argument; NULL gives NULL. Any thread. */
JALON_API jalon_task* jalon_task_retain(jalon_task* task);
/** One owner less; the last one frees it. NULL is fine. Any thread. */
JALON_API void jalon_task_release(jalon_task* task);

/** Threads of the next calls: 1..256, or 0 for all processors. The result never depends on it. */
JALON_API JALON_CHECK jalon_status jalon_task_set_threads(jalon_task* task, uint32_t threads);
/** callback may be NULL; user is handed through. */
JALON_API JALON_CHECK jalon_status jalon_task_set_progress(jalon_task* task,
                                                           jalon_progress_callback callback,
                                                           void* user);
/** callback may be NULL; user is handed through. */
JALON_API JALON_CHECK jalon_status jalon_task_set_log(jalon_task* task, jalon_log_callback callback,
                                                      void* user);

/**
 * Bytes that a call may have in use at once beyond what was in use before it, its result among them; 0, the default, is
 * no limit. What would exceed it is not taken: the call ends with JALON_ERROR_OUT_OF_MEMORY and a line that says what
 * it wanted, its outputs untouched; some calls do with less and take longer. Counted is what Jalon takes by itself, by
 * the bytes of its allocator's blocks; what FCL and SQLite take beside is not.
 * JALON_ERROR_UNSUPPORTED: memory is not counted in a static library, outside of Linux, and in a host whose operator
 * new is not malloc's.
 */
JALON_API JALON_CHECK jalon_status jalon_task_set_memory_limit(jalon_task* task, uint64_t bytes);
/**
 * The most bytes that the last call of this task had in use at once; 0 where it ran without a limit (with UINT64_MAX
 * for one, all is counted and nothing refused). With several threads it differs a little from run to run.
 */
JALON_API JALON_CHECK jalon_status jalon_task_memory_peak(const jalon_task* task, uint64_t* out);

/** Asks the running and all later calls of this task to stop, until reset. Any thread. */
JALON_API JALON_CHECK jalon_status jalon_task_cancel(jalon_task* task);
/** Takes a cancel back, so that the task can be used again. */
JALON_API JALON_CHECK jalon_status jalon_task_reset(jalon_task* task);
/** *out = 1 when cancelled and not reset, else 0. Any thread. */
JALON_API JALON_CHECK jalon_status jalon_task_is_cancelled(const jalon_task* task, int32_t* out);

JALON_END_C

#endif
