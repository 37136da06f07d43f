/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <jalon/jalon.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define OK(call) assert_int_equal((call), JALON_OK)
#define INVALID(call) assert_int_equal((call), JALON_ERROR_INVALID_ARGUMENT)

static const jalon_transform kIdentity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
static const jalon_transform kAhead = {{1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0}};

/* A report of a gauge of one piece of this kind: how often its page has an outline; < 0: refused. */
static int outlines_of(int32_t kind, uint64_t piece_count) {
  const double xyz[] = {5, 0.55, 0},
               hull[] = {-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0};
  const jalon_transform poses[] = {kIdentity, kAhead};
  jalon_gauge_piece piece = {kind, 0, kIdentity, {1, 1, 1}, 0, 4};
  if (kind == JALON_GAUGE_SPHERE || kind == JALON_GAUGE_CYLINDER) piece.size.x = 0.5;
  jalon_cloud* cloud = NULL;
  jalon_fields *places = NULL, *intervals = NULL;
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, 1, 0, 0, &cloud));
  OK(jalon_gauge_sweep(&piece, 1, hull, 4, poses, 2, cloud, NULL, NULL, NULL, &places, &intervals));
  const char* path = "gauge_pieces.html";
  OK(jalon_report_write_clearance(places, intervals, &piece, piece_count, hull, 4, NULL, poses, 2,
                                  cloud, NULL, NULL, path, NULL, NULL));
  FILE* file = fopen(path, "rb");
  assert_non_null(file);
  char* page = calloc(1, 1 << 20);
  assert_non_null(page);
  assert_true(fread(page, 1, (1 << 20) - 1, file) > 1000);
  fclose(file);
  remove(path);
  int count = 0;
  for (const char* at = page; (at = strstr(at, "fill-opacity=\"0.15\"")) != NULL; ++at) ++count;
  free(page);
  piece.kind = 9;
  INVALID(jalon_report_write_clearance(places, intervals, &piece, 1, hull, 4, NULL, poses, 2, cloud,
                                       NULL, NULL, path, NULL, NULL));
  INVALID(jalon_report_write_clearance(places, intervals, NULL, 0, NULL, 0, NULL, poses, 0, cloud,
                                       NULL, NULL, path, NULL, NULL));
  INVALID(jalon_report_write_clearance(NULL, intervals, NULL, 0, NULL, 0, NULL, poses, 2, cloud,
                                       NULL, NULL, path, NULL, NULL));
  jalon_fields_release(places);
  jalon_fields_release(intervals);
  jalon_cloud_release(cloud);
  return count;
}

static void gauge_pieces__each_kind_has_an_outline_in_the_report(void** state) {
  (void)state;
  for (int32_t kind = JALON_GAUGE_BOX; kind <= JALON_GAUGE_HULL; ++kind)
    assert_true(outlines_of(kind, 1) >= 1);
  assert_int_equal(outlines_of(JALON_GAUGE_BOX, 0), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(gauge_pieces__each_kind_has_an_outline_in_the_report),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
