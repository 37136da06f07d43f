/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A host loads and unloads plug-ins: a thousand times, and two copies of the library at once, without a trace in the
 * process: threads, descriptors, signal handlers, floating-point mode, locale, environment. The program is not linked
 * with the library. */
#include <dlfcn.h>
#include <fenv.h>
#include <locale.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "process_size.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

enum { kPoints = 300, kWarm = 100 };

static int is_sanitized(void) { return getenv("JALON_SANITIZED") != NULL; }
static int loads(void) { return is_sanitized() ? 20 : 1000; }

typedef struct process_state {
  int descriptors, threads, rounding;
  unsigned floating_point;
  uint64_t handlers, environment;
  char locale[256];
} process_state;

static uint64_t mixed(uint64_t hash, const void* data, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i)
    hash = (hash ^ ((const unsigned char*)data)[i]) * 1099511628211u;
  return hash;
}

extern char** environ;

static process_state state_now(void) {
  process_state s;
  memset(&s, 0, sizeof s);
  s.descriptors = open_descriptors();
  s.threads = entries_of("/proc/self/task");
  s.rounding = fegetround();
#ifdef __SSE__
  s.floating_point = _mm_getcsr() & ~0x3fu; /* without the flags of what happened */
#endif
  for (int k = 1; k < 65; ++k) {
    struct sigaction action;
    if (sigaction(k, NULL, &action) != 0) continue;
    s.handlers = mixed(s.handlers, &action.sa_handler, sizeof action.sa_handler);
    s.handlers = mixed(s.handlers, &action.sa_flags, sizeof action.sa_flags);
  }
  for (char** e = environ; *e != NULL; ++e) s.environment = mixed(s.environment, *e, strlen(*e));
  snprintf(s.locale, sizeof s.locale, "%s", setlocale(LC_ALL, NULL));
  return s;
}

static void expect_same(const process_state* a, const process_state* b, const char* when) {
  if (memcmp(a, b, sizeof *a) != 0)
    fail_msg(
        "%s: descriptors %d %d, threads %d %d, rounding %d %d, mode %x %x, handlers or "
        "environment %d, locale %s %s",
        when, a->descriptors, b->descriptors, a->threads, b->threads, a->rounding, b->rounding,
        a->floating_point, b->floating_point,
        a->handlers != b->handlers || a->environment != b->environment, a->locale, b->locale);
}

static void* symbol(void* library, const char* name) {
  void* const found = dlsym(library, name);
  if (found == NULL) fail_msg("no %s", name);
  return found;
}

/* Creates a cloud, computes its normals on all threads, fails to read a file, gives everything back. */
static void use(void* library) {
  int32_t (*create)(const void*, int32_t, uint64_t, uint64_t, uint32_t, void**);
  int32_t (*normals)(void*, const void*, void*);
  int32_t (*read)(const char*, const void*, void*, void**);
  void (*release)(void*);
  *(void**)&create = symbol(library, "jalon_cloud_create");
  *(void**)&normals = symbol(library, "jalon_cloud_compute_normals");
  *(void**)&read = symbol(library, "jalon_cloud_read");
  *(void**)&release = symbol(library, "jalon_cloud_release");
  double xyz[3 * kPoints];
  for (int i = 0; i < 3 * kPoints; ++i) xyz[i] = i * 7919 % 101;
  void *cloud = NULL, *none = NULL;
  const int kFloat64 = 10; /* JALON_FLOAT64 */
  assert_int_equal(create(xyz, kFloat64, kPoints, 0, 0, &cloud), 0);
  assert_int_equal(normals(cloud, NULL, NULL), 0);
  assert_int_not_equal(read("no such file.las", NULL, NULL, &none), 0);
  release(cloud);
}

static void* loaded(const char* path) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fail_msg("%s", dlerror());
  return library;
}

static void load__a_thousand_times_leaves_the_process_as_it_was(void** state) {
  (void)state;
  const process_state before = state_now();
  long warm_kib = 0;
  for (int i = 0; i < loads(); ++i) {
    void* const library = loaded(JALON_LIBRARY);
    if (i == 0) {
      const process_state after = state_now();
      expect_same(&before, &after, "loaded");
    }
    use(library);
    assert_int_equal(dlclose(library), 0);
    if (i == kWarm) warm_kib = resident_kib();
  }
  const process_state after = state_now();
  expect_same(&before, &after, "unloaded");
  const long grown = warm_kib > 0 ? resident_kib() - warm_kib : 0;
  printf("FIGURE %d loads: %ld KiB more after the first %d\n", loads(), grown, kWarm);
  if (!is_sanitized()) assert_true(grown <= kMostGrowthKib);
}

static void copy_file(const char* from, const char* to) {
  char buffer[65536];
  FILE *const in = fopen(from, "rb"), *const out = fopen(to, "wb");
  assert_true(in != NULL && out != NULL);
  for (size_t n; (n = fread(buffer, 1, sizeof buffer, in)) > 0;)
    assert_int_equal(fwrite(buffer, 1, n, out), n);
  fclose(in);
  assert_int_equal(fclose(out), 0);
}

static void load__two_copies_work_side_by_side(void** state) {
  (void)state;
  char copy[512];
  const char* const folder = getenv("TMPDIR");
  snprintf(copy, sizeof copy, "%s/libjalon_copy_%d.so", folder ? folder : "/tmp", (int)getpid());
  copy_file(JALON_LIBRARY, copy);
  const process_state before = state_now();
  void *const one = loaded(JALON_LIBRARY), *const other = loaded(copy);
  unlink(copy);
  const char* (*message)(void), *(*other_message)(void);
  *(void**)&message = symbol(one, "jalon_last_error_message");
  *(void**)&other_message = symbol(other, "jalon_last_error_message");
  assert_true((void*)message != (void*)other_message);
  use(one);
  assert_true(message()[0] != 0);
  assert_int_equal(other_message()[0], 0); /* nothing is shared */
  use(other);
  assert_int_equal(dlclose(one), 0);
  use(other);
  assert_int_equal(dlclose(other), 0);
  const process_state after = state_now();
  expect_same(&before, &after, "both unloaded");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(load__a_thousand_times_leaves_the_process_as_it_was),
      cmocka_unit_test(load__two_copies_work_side_by_side),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
