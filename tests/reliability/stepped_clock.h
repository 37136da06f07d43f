/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A clock on which more time passes between two looks than between two reports of progress: the host is called at each
 * place where an operation asks whether to go on. */
#ifndef JALON_TEST_STEPPED_CLOCK_H
#define JALON_TEST_STEPPED_CLOCK_H

#include "support.h"

#include <sys/syscall.h>
#include <time.h>

enum { kStep_ns = 101000000 }; /* task.h: reports come every 50 to 100 ms */
enum { kSecond_ns = 1000000000 };

static int64_t stepped_ns;

/* The library's steady clock goes through here; no operation's result hangs on it. */
#pragma GCC visibility push(default)
int clock_gettime(clockid_t which, struct timespec* now) {
  if (which != CLOCK_MONOTONIC) return (int)syscall(SYS_clock_gettime, which, now);
  const int64_t at = __atomic_add_fetch(&stepped_ns, kStep_ns, __ATOMIC_RELAXED);
  now->tv_sec = (time_t)(at / kSecond_ns);
  now->tv_nsec = (long)(at % kSecond_ns);
  return 0;
}
#pragma GCC visibility pop

/* What the processor did for this thread, whatever else runs on the machine. */
static inline double thread_s(void) {
  struct timespec now;
  syscall(SYS_clock_gettime, CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
