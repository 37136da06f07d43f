/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A host that runs for days: small jobs through the whole surface, over and over, and the process stays as large as it
 * was. The long run makes ten times as many. */
#include "allocation_scenarios.h"

#include "process_size.h"
#include "small_input.h"

/* Of malloc's own lists of free pieces, of a thread each; a handle that each turn keeps is several times as much. */
enum { kMostKeptBytes = 16 << 10 };

static int cycles(void) { return is_full_run() ? 1000 : is_sanitized() ? 3 : 60; }

/* What the jobs have not: a cloud and a segmenter through their bytes. */
static void through_bytes(void) {
  jalon_cloud* const cloud = street_cloud(40, 3);
  jalon_cloud* cloud_back = NULL;
  jalon_segmenter *segmenter = NULL, *segmenter_back = NULL;
  jalon_bytes* bytes = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_to_bytes(cloud, NULL, &bytes));
  MUST(jalon_bytes_view(bytes, &view));
  MUST(jalon_cloud_from_bytes(view.data, view.count, NULL, &cloud_back));
  jalon_bytes_release(bytes);
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_to_bytes(segmenter, &bytes));
  MUST(jalon_bytes_view(bytes, &view));
  MUST(jalon_segmenter_from_bytes(view.data, view.count, &segmenter_back));
  jalon_bytes_release(bytes);
  jalon_segmenter_release(segmenter);
  jalon_segmenter_release(segmenter_back);
  jalon_cloud_release(cloud);
  jalon_cloud_release(cloud_back);
}

static void run_all(int turn) {
  through_bytes();
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
