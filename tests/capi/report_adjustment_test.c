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

#include "drive.h"

/* The page says what the adjustment holds; it draws the drive as it was only where that is given. */
static void report__has_the_truth_where_it_is_given(void** state) {
  (void)state;
  Drive drive = drive_of(5);
  jalon_adjustment* made = NULL;
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, NULL, NULL, &made));
  const jalon_trajectory* truths[] = {NULL, drive.true_trajectory};
  for (int i = 0; i < 2; ++i) {
    const char* path = "adjustment_report.html";
    OK(jalon_report_write_adjustment(made, truths[i], "{\"title\": \"<Street>\"}", path, NULL,
                                     NULL));
    FILE* file = fopen(path, "rb");
    assert_non_null(file);
    char* page = calloc(1, 1 << 21);
    assert_non_null(page);
    assert_true(fread(page, 1, (1 << 21) - 1, file) > 1000);
    fclose(file);
    remove(path);
    assert_non_null(strstr(page, "&lt;Street&gt;"));
    assert_true((strstr(page, "east, true") != NULL) == (i == 1));
    free(page);
  }
  INVALID(jalon_report_write_adjustment(made, NULL, NULL, NULL, NULL, NULL));
  jalon_adjustment_release(made);
  release_drive(&drive);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(report__has_the_truth_where_it_is_given),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
