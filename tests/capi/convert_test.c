/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Files that become others without ever being whole in memory. */
#include "support.h"

#define N 500

/* A file of 2 million points takes 72 MiB of coordinates and fields to read; its pieces of half a million take less. */
static void convert__needs_memory_for_pieces_of_a_file(void** state) {
  (void)state;
  const uint64_t n = is_sanitized() ? 600000 : 2000000, limit = is_sanitized() ? 0 : 64u << 20;
  jalon_cloud* cloud = street_cloud(n, 3);
  const char *from = temporary("from.las"), *to = temporary("to.csv");
  MUST(jalon_cloud_write(cloud, from, NULL, NULL));
  jalon_cloud_release(cloud);
  jalon_task* task = NULL;
  MUST(jalon_task_create(&task));
  const jalon_status limited = jalon_task_set_memory_limit(task, limit);
  assert_true(limited == JALON_OK || limited == JALON_ERROR_UNSUPPORTED);
  if (limited == JALON_OK && limit != 0)
    REFUSED(JALON_ERROR_OUT_OF_MEMORY, jalon_cloud_read(from, NULL, task, &cloud));
  uint64_t count = 0;
  MUST(jalon_cloud_convert(from, to, NULL, task, &count));
  assert_int_equal(count, n);
  jalon_task_release(task);
  MUST(jalon_cloud_read(to, NULL, NULL, &cloud));
  assert_int_equal(count_of(cloud), n);
  jalon_cloud_release(cloud);
  remove(from);
  remove(to);
}

static void convert__does_what_the_options_say(void** state) {
  (void)state;
  double xyz[3 * N];
  street_points(xyz, N, 11, 652000, 6861000);
  jalon_cloud* cloud = cloud_of(xyz, N);
  const char *from = temporary("from.las"), *to = temporary("to.xyz");
  MUST(jalon_cloud_write(cloud, from, NULL, NULL));
  jalon_params* options = NULL;
  MUST(jalon_params_create("convert", &options));
  MUST(jalon_params_set_doubles(options, "box",
                                (const double[]){652000, 6860000, -100, 652010, 6862000, 100}, 6));
  MUST(jalon_params_set_string(options, "format", "csv"));
  uint64_t count = 0, inside = 0;
  for (uint64_t i = 0; i < N; ++i) inside += xyz[3 * i] <= 652010;
  MUST(jalon_cloud_convert(from, to, options, NULL, &count));
  assert_true(inside > 0 && inside < N);
  assert_int_equal(count, inside);
  char* text = content_of(to, NULL);
  assert_true(strncmp(text, "x,y,z,", 6) == 0);
  free(text);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_convert(from, to, options, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_convert(NULL, to, NULL, NULL, &count));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_convert(from, "", NULL, NULL, &count));
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_cloud_convert(from, "/tmp/a.nothing", NULL, NULL, &count));
  jalon_params_release(options);
  jalon_cloud_release(cloud);
  remove(from);
  remove(to);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(convert__needs_memory_for_pieces_of_a_file),
      cmocka_unit_test(convert__does_what_the_options_say),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
