/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A host may round otherwise, flush to zero, or trap: every long operation has the bits that it has elsewhere, with
 * threads of its own too, and the host finds its mode as it left it. */
#include "operations.h"

#include <fenv.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

static uint64_t points(void) { return is_sanitized() ? 1500 : 4000; }

typedef struct host_mode {
  const char* name;
  int rounding;
  int flushes, traps;
} host_mode;

static const host_mode kDefault = {"default", FE_TONEAREST, 0, 0};
static const host_mode kModes[] = {
    {"upward", FE_UPWARD, 0, 0},          {"downward", FE_DOWNWARD, 0, 0},
    {"toward zero", FE_TOWARDZERO, 0, 0}, {"flush to zero", FE_TONEAREST, 1, 0},
    {"traps", FE_TONEAREST, 0, 1},
};

static unsigned control_word(void) {
#ifdef __SSE__
  return _mm_getcsr() & ~0x3fu;
#else
  return (unsigned)fegetround();
#endif
}

static void set_mode(const host_mode* mode) {
  fesetround(mode->rounding);
#ifdef __SSE__
  const unsigned kFlush = 0x8040, kInvalidDivideOverflow = 0x0680;
  unsigned word = _mm_getcsr() & ~0x3fu;
  if (mode->flushes) word |= kFlush;
  if (mode->traps) word &= ~kInvalidDivideOverflow;
  _mm_setcsr(word);
#endif
}

static void default_mode(void) { fesetenv(FE_DFL_ENV); }

/* The hash of what an operation makes of a fresh cloud, and its status. The cloud is made as elsewhere: the scene's own
 * arithmetic is the test's. */
static uint64_t outcome_in(const host_mode* mode, int operation_index, uint32_t threads,
                           jalon_status* status) {
  jalon_cloud* const cloud = street_cloud(points(), 21);
  jalon_task* task = NULL;
  made m = {NULL, NULL, NULL};
  uint64_t hash = 0;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, threads));
  set_mode(mode);
  const unsigned before = control_word();
  *status = kOperations[operation_index].run(cloud, task, &m);
  const unsigned after = control_word();
  default_mode();
  if (before != after)
    fail_msg("%s, %s: the host's mode was %x and is %x", kOperations[operation_index].name,
             mode->name, before, after);
  if (*status == JALON_OK) hash = hash_made(&m);
  release_made(&m);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
  return hash;
}

static void arithmetic__of_the_host_changes_no_bit_and_comes_back(void** state) {
  (void)state;
  int checked = 0;
  for (int k = 0; k < kOperationCount; ++k) {
    jalon_status expected_status, status;
    const uint64_t expected = outcome_in(&kDefault, k, 2, &expected_status);
    for (size_t m = 0; m < sizeof kModes / sizeof *kModes; ++m) {
      if (!is_full_run() && (k + m) % 2 != 0) continue; /* every other pair */
      const uint64_t hash = outcome_in(&kModes[m], k, 1 + (uint32_t)m % 2, &status);
      if (status != expected_status || hash != expected)
        fail_msg("%s, host %s: status %d, bits %s", kOperations[k].name, kModes[m].name, status,
                 hash == expected ? "same" : "other");
      ++checked;
    }
  }
  printf("FIGURE host arithmetic: %d operations in other modes, same bits\n", checked);
  assert_true(checked >= 90);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(arithmetic__of_the_host_changes_no_bit_and_comes_back),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
