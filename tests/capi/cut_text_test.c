/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Text files of every form, cut after every byte: a whole cloud or a refusal, and nothing read beyond
 * the end (AddressSanitizer looks on). */
#include "support.h"

static const char* const kForms[] = {
    "1 2 3\n1 2 3\n",
    "1,2,3\n1,2,-3.5e+2\n",
    "1;2;3\n+1;+2;+3\n",
    "1\t2\t3\r\n4\t5\t6\r\n",
    "\"1\" \"2\" \"3\"\n1 2 \"3\"\n",
    "\"1\",\"2\",\"+3\"\n\"4\",\"5\",\"6\"\n",
    "1,5;2,5;3,5\n\"1,5\";+2,5;3,5\n",
    "x,y,z,intensity\n1,2,3,\n1,2,3,9007199254740993\n4,5,6,+18446744073709551615\n",
    "# x y z label\n1 2 3 -9223372036854775808\n4 5 6 +7\n",
    "//X Y Z nx ny nz\n1 2 3 0 0 +1\n",
    "2\n1 2 3\n4 5 6\n",
    "X Y Z Name\n1 2 3 \"a b\"\n",
};

/* Reads the first bytes of a form from a file of just that size. */
static jalon_status read_cut(const char* form, size_t bytes, const char* path, uint64_t* points) {
  FILE* file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(form, 1, bytes, file), bytes);
  assert_int_equal(fclose(file), 0);
  jalon_cloud* cloud = NULL;
  const jalon_status status = jalon_cloud_read(path, NULL, NULL, &cloud);
  *points = 0;
  if (status == JALON_OK) MUST(jalon_cloud_count(cloud, points));
  jalon_cloud_release(cloud);
  return status;
}

static void text__cut_at_any_byte_is_read_or_refused(void** state) {
  (void)state;
  static const char* const kNames[] = {"cut.csv", "cut.xyz", "cut.txt", "cut.pts", "cut.asc"};
  for (size_t f = 0; f < sizeof kForms / sizeof *kForms; ++f)
    for (size_t n = 0; n < sizeof kNames / sizeof *kNames; ++n)
      for (size_t bytes = 0; bytes <= strlen(kForms[f]); ++bytes) {
        uint64_t points, lines = 0;
        for (size_t i = 0; i < bytes; ++i) lines += kForms[f][i] == '\n';
        const jalon_status status = read_cut(kForms[f], bytes, kNames[n], &points);
        if (status == JALON_OK) assert_true(points <= lines + 1);
        else expect_one_line();
        assert_true(status == JALON_OK || status == JALON_ERROR_FORMAT ||
                    status == JALON_ERROR_INSUFFICIENT_DATA ||
                    status == JALON_ERROR_INVALID_ARGUMENT);
        remove(kNames[n]);
      }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(text__cut_at_any_byte_is_read_or_refused)};
  return cmocka_run_group_tests_name("cut_text", tests, NULL, NULL);
}
