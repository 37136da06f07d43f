/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Helpers of the C tests: checked calls, small scenes, files. */
#ifndef JALON_TEST_SUPPORT_H
#define JALON_TEST_SUPPORT_H

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <setjmp.h>
#ifndef JALON_TEST_PLAIN_PROGRAM
#include <cmocka.h>
#endif

#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef JALON_TEST_PLAIN_PROGRAM /* no CMocka: the first surprise ends the program */
#define fail_msg(...) (printf("not ok - "), printf(__VA_ARGS__), printf("\n"), exit(1))
#define assert_true(x) ((x) ? (void)0 : (void)fail_msg("%s", #x))
#define assert_non_null(x) assert_true((x) != NULL)
#define assert_int_equal(x, y) assert_true((x) == (y))
#endif

/* The call must succeed. */
#define MUST(call)                                                                           \
  do {                                                                                       \
    const jalon_status status_ = (call);                                                     \
    if (status_ != JALON_OK)                                                                 \
      fail_msg("%s: %s: %s", #call, jalon_status_name(status_), jalon_last_error_message()); \
  } while (0)

/* The call must fail in this way. */
#define REFUSED(expected, call)                                                      \
  do {                                                                               \
    const jalon_status status_ = (call);                                             \
    if (status_ != (expected))                                                       \
      fail_msg("%s gave \"%s\", not \"%s\" (%s)", #call, jalon_status_name(status_), \
               jalon_status_name(expected), jalon_last_error_message());             \
    expect_one_line();                                                               \
  } while (0)

/* The last failure has a message of one line. */
static inline void expect_one_line(void) {
  const char* message = jalon_last_error_message();
  assert_true(message[0] != 0);
  for (const char* c = message; *c != 0; ++c) assert_true((unsigned char)*c >= 0x20);
}

/* A random number in [0, 1) that depends on its arguments only. */
static inline double uniform(uint64_t seed, uint64_t i) {
  uint64_t z = (seed * 0x9E3779B97F4A7C15u) ^ (i + 1) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  z ^= z >> 31;
  return (double)(z >> 11) * 0x1p-53;
}

static inline double on_grid(double x) { return (double)(int64_t)(x * 1048576.0) / 1048576.0; }

/* A facade of 20 x 10 m with a recess, and the ground before it: 3 mm of noise, coordinates on a 2^-20 m grid, shifted
 * by whole metres. */
static inline void street_points(double* xyz, uint64_t n, uint64_t seed, double east_m,
                                 double north_m) {
  for (uint64_t i = 0; i < n; ++i) {
    const double u = 20 * uniform(seed, 4 * i), v = 10 * uniform(seed, 4 * i + 1);
    const double noise = 0.006 * (uniform(seed, 4 * i + 2) - 0.5);
    const int recess = u > 8 && u < 11 && v > 2 && v < 6;
    const int ground = uniform(seed, 4 * i + 3) < 0.3;
    xyz[3 * i] = on_grid(u) + east_m;
    xyz[3 * i + 1] = on_grid(ground ? -v : recess ? 0.25 + noise : noise) + north_m;
    xyz[3 * i + 2] = on_grid(ground ? noise : v);
  }
}

static inline jalon_cloud* street_cloud(uint64_t n, uint64_t seed) {
  double* xyz = malloc((size_t)n * 24 + 24);
  jalon_cloud* cloud = NULL;
  street_points(xyz, n, seed, 0, 0);
  const jalon_status status = jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &cloud);
  free(xyz);
  if (status != JALON_OK) fail_msg("no cloud: %s", jalon_last_error_message());
  return cloud;
}

static inline jalon_cloud* cloud_of(const double* xyz, uint64_t n) {
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &cloud));
  return cloud;
}

static inline uint64_t count_of(const jalon_cloud* cloud) {
  uint64_t n = 0;
  MUST(jalon_cloud_count(cloud, &n));
  return n;
}

/* FNV-1a. */
static inline uint64_t hash_bytes(uint64_t hash, const void* data, size_t bytes) {
  const unsigned char* p = data;
  for (size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211u;
  return hash;
}

/* A path in the folder for temporary files, told apart by the process. */
static inline const char* temporary(const char* name) {
  static char path[4][512];
  static int turn;
  const char* folder = getenv("TMPDIR");
  turn = (turn + 1) % 4;
  snprintf(path[turn], sizeof path[turn], "%s/jalon_test_%d_%s", folder ? folder : "/tmp",
           (int)getpid(), name);
  return path[turn];
}

/* The whole content of a file, with a 0 behind it; NULL when it cannot be read. The caller frees it. */
static inline char* content_of(const char* path, size_t* bytes) {
  FILE* f = fopen(path, "rb");
  if (f == NULL) return NULL;
  fseek(f, 0, SEEK_END);
  const long size = ftell(f);
  rewind(f);
  char* text = malloc((size_t)size + 1);
  const size_t got = fread(text, 1, (size_t)size, f);
  text[got] = 0;
  fclose(f);
  if (bytes != NULL) *bytes = got;
  return text;
}

static inline void write_text(const char* path, const char* text) {
  FILE* f = fopen(path, "wb");
  assert_non_null(f);
  fputs(text, f);
  assert_int_equal(fclose(f), 0);
}

static inline int is_full_run(void) { return getenv("JALON_FULL") != NULL; }
static inline int is_sanitized(void) { return getenv("JALON_SANITIZED") != NULL; }

#endif
