/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The allocator of the whole process: the k-th allocation while armed fails, once or with all after it, and the living
 * blocks are counted. */
#ifndef JALON_TEST_ALLOCATION_FAULTS_H
#define JALON_TEST_ALLOCATION_FAULTS_H

#include <errno.h>
#include <stddef.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define CANNOT_REPLACE_MALLOC 1
#endif

#ifndef CANNOT_REPLACE_MALLOC

/* The allocator of the whole process, libstdc++ and thread creation included, goes through here. */
extern void* __libc_malloc(size_t bytes);
extern void* __libc_calloc(size_t count, size_t bytes);
extern void* __libc_realloc(void* old, size_t bytes);
extern void* __libc_memalign(size_t alignment, size_t bytes);
extern void __libc_free(void* block);

static int armed, sticky;
static long attempts, fail_at, failures, live;

static int must_fail(void) {
  if (!__atomic_load_n(&armed, __ATOMIC_ACQUIRE)) return 0;
  const long attempt = __atomic_add_fetch(&attempts, 1, __ATOMIC_RELAXED);
  if (fail_at == 0 || (sticky ? attempt < fail_at : attempt != fail_at)) return 0;
  __atomic_add_fetch(&failures, 1, __ATOMIC_RELAXED);
  errno = ENOMEM;
  return 1;
}

static void* counted(void* block) {
  if (block != NULL) __atomic_add_fetch(&live, 1, __ATOMIC_RELAXED);
  return block;
}

#pragma GCC visibility push( \
    default) /* the build hides everything, but these must be seen by the libraries */
void* malloc(size_t bytes) { return must_fail() ? NULL : counted(__libc_malloc(bytes)); }
void* calloc(size_t count, size_t bytes) {
  return must_fail() ? NULL : counted(__libc_calloc(count, bytes));
}
void* memalign(size_t alignment, size_t bytes) {
  return must_fail() ? NULL : counted(__libc_memalign(alignment, bytes));
}
void* aligned_alloc(size_t alignment, size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** out, size_t alignment, size_t bytes) {
  void* block = memalign(alignment, bytes);
  if (block == NULL) return ENOMEM;
  *out = block;
  return 0;
}
void* realloc(void* old, size_t bytes) {
  if (old == NULL) return malloc(bytes);
  if (must_fail()) return NULL;
  void* block = __libc_realloc(old, bytes);
  if (block == NULL && bytes == 0) __atomic_sub_fetch(&live, 1, __ATOMIC_RELAXED);
  return block;
}
void free(void* block) {
  if (block != NULL) __atomic_sub_fetch(&live, 1, __ATOMIC_RELAXED);
  __libc_free(block);
}
#pragma GCC visibility pop

static inline void arm_allocations(long k, int from_then_on) {
  attempts = failures = 0;
  fail_at = k;
  sticky = from_then_on;
  __atomic_store_n(&armed, 1, __ATOMIC_RELEASE);
}
static inline void disarm_allocations(void) { __atomic_store_n(&armed, 0, __ATOMIC_RELEASE); }
static long live_blocks(void) { return __atomic_load_n(&live, __ATOMIC_ACQUIRE); }

#endif

#endif
