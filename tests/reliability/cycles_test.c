/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A host that runs for days: small jobs through the whole surface, over and over, and the process stays as large as it
 * was. The long run makes ten times as many. */
#include "allocation_scenarios.h"

#include "process_size.h"
#include "small_input.h"

/* Of malloc's own lists of free pieces, of a thread each; a handle that each turn keeps is several times as much. */
enum { kMostKeptBytes = 12 << 10 };

static int cycles(void) { return is_full_run() ? 1000 : is_sanitized() ? 3 : 60; }

static void run_all(int turn) {
  for (int job = 0; job < kScenarioCount; ++job)
    if (kScenarios[job].run() != JALON_OK)
      fail_msg("%s, turn %d: %s", kScenarios[job].name, turn, jalon_last_error_message());
}

static void cycles__of_the_whole_surface_keep_no_memory(void** state) {
  (void)state;
  const int warm = cycles() / 3;
  for (int i = 0; i < warm; ++i) run_all(i);
  const int descriptors = open_descriptors();
  const long before = resident_kib(), allocated = allocated_bytes();
  for (int i = 0; i < cycles(); ++i) run_all(warm + i);
  const long grown = resident_kib() - before;
  const long kept = allocated_bytes() - allocated;
  printf("FIGURE cycles: %d turns of %d jobs, %ld KiB more, %ld bytes of them allocated\n",
         cycles(), (int)kScenarioCount, grown, kept);
  assert_int_equal(open_descriptors(), descriptors);
  if (!is_sanitized()) assert_true(grown <= kMostGrowthKib);
  if (!is_sanitized()) assert_true(kept <= kMostKeptBytes);
}

static int make_input(void** state) {
  (void)state;
  return make_small_input("cycles");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(cycles__of_the_whole_surface_keep_no_memory),
  };
  return cmocka_run_group_tests(tests, make_input, drop_input);
}
