/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Parameter files of CloudCompare's plug-in: what a file sets, and that a file which fails sets nothing. */
#include "lifted_square.h"

static jalon_params* params_of(jalon_comparer* comparer) {
  jalon_params* params = NULL;
  MUST(jalon_comparer_params(comparer, &params));
  return params;
}

static const char* file_with(const char* text) {
  static char path[512];
  snprintf(path, sizeof path, "%s", temporary("m3c2.txt"));
  write_text(path, text);
  return path;
}

static void m3c2_file__sets_what_it_tells_and_leaves_the_rest(void** state) {
  (void)state;
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("m3c2", &comparer));
  jalon_params* params = params_of(comparer);
  MUST(jalon_params_set_double(params, "cylinder_radius_m", 0.777));
  MUST(jalon_comparer_read_m3c2_file(
      comparer,
      file_with("\xef\xbb\xbf[General]\r\nM3C2VER=1\r\n ; a remark\r\n NormalMode = 2\r\n"
                "NormalMinScale=0.5\r\nNormalStep=0.25\r\nNormalMaxScale=1\r\n"
                "NormalPreferedOri=5\r\nUseMedian=true\r\nSearchDepth=9\r\nSearchDepth=2.5"),
      NULL));
  double value = 0;
  MUST(jalon_params_get_double(params, "cylinder_radius_m", &value));
  assert_true(value == 0.777); /* not in the file */
  MUST(jalon_params_get_double(params, "max_depth_m", &value));
  assert_true(value == 2.5); /* the last line of a key counts */
  const double* numbers = NULL;
  uint64_t count = 0;
  MUST(jalon_params_get_doubles(params, "normal_radii_m", &numbers, &count));
  assert_int_equal(count, 3); /* diameters 0.5, 0.75 and 1 */
  for (int i = 0; i < 3; ++i) assert_true(fabs(numbers[i] - 0.125 * (i + 2)) < 1e-15);
  MUST(jalon_params_get_doubles(params, "orientation_direction", &numbers, &count));
  assert_true(count == 3 && numbers[0] == 0 && numbers[1] == 0 && numbers[2] == -1);
  const char* text = NULL;
  MUST(jalon_params_get_string(params, "position", &text));
  assert_string_equal(text, "median");
  remove(file_with(""));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
}

static void m3c2_file__that_fails_changes_no_parameter(void** state) {
  (void)state;
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("m3c2", &comparer));
  jalon_params* params = params_of(comparer);
  char before[8192];
  const char* json = NULL;
  MUST(jalon_params_to_json(params, &json));
  snprintf(before, sizeof before, "%s", json);
  const struct {
    const char* text;
    jalon_status status;
    const char* told;
  } cases[] = {
      {"NormalScale=0.5\n", JALON_ERROR_FORMAT, "M3C2VER"},
      {"M3C2VER=1\nNormalScale=0.5\nSearchScale=wide\n", JALON_ERROR_FORMAT, "SearchScale=wide"},
      {"M3C2VER=1\nNormalScale=0.5\nSearchDepth=inf\n", JALON_ERROR_FORMAT, "SearchDepth"},
      {"M3C2VER=1\nNormalScale=0.5\nUseMedian=perhaps\n", JALON_ERROR_FORMAT, "UseMedian"},
      {"M3C2VER=1\nNormalScale=0.5\nno equal sign\n", JALON_ERROR_FORMAT, "line 3"},
      {"M3C2VER=1\nNormalScale=0.5\nNormalMode=2\n", JALON_ERROR_FORMAT, "NormalMinScale"},
      {"M3C2VER=1\nNormalScale=0.5\nPositiveSearchOnly=true\n", JALON_ERROR_UNSUPPORTED,
       "PositiveSearchOnly"},
      {"M3C2VER=1\nNormalScale=0.5\nNormalPreferedOri=6\n", JALON_ERROR_UNSUPPORTED,
       "NormalPreferedOri"},
      {"M3C2VER=1\nNormalScale=0.5\nUsePrecisionMaps=1\n", JALON_ERROR_UNSUPPORTED, "covariances"},
      {"", JALON_ERROR_FORMAT, "M3C2VER"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
    REFUSED(cases[i].status,
            jalon_comparer_read_m3c2_file(comparer, file_with(cases[i].text), NULL));
    expect_message(cases[i].told);
    MUST(jalon_params_to_json(params, &json));
    assert_string_equal(json, before);
  }
  /* More than any such file has. */
  char* large = malloc((1 << 20) + 64);
  assert_non_null(large);
  memset(large, '\n', (1 << 20) + 63);
  memcpy(large, "M3C2VER=1", 9);
  large[(1 << 20) + 1] = 0;
  REFUSED(JALON_ERROR_FORMAT, jalon_comparer_read_m3c2_file(comparer, file_with(large), NULL));
  expect_message("too large");
  large[1 << 20] = 0;
  MUST(jalon_comparer_read_m3c2_file(comparer, file_with(large), NULL));
  free(large);
  const char* path = file_with("");
  remove(path);
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_comparer_read_m3c2_file(comparer, path, NULL));
  expect_message(path);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_comparer_read_m3c2_file(comparer, NULL, NULL));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
}

static void collect(int32_t level, const char* text, void* user) {
  char* all = user;
  if (level == JALON_LOG_WARNING) snprintf(all + strlen(all), 2000 - strlen(all), "%s|", text);
}

static void m3c2_file__warns_of_each_key_that_it_does_not_know(void** state) {
  (void)state;
  jalon_comparer* comparer = NULL;
  jalon_task* task = NULL;
  char all[2000] = "";
  MUST(jalon_comparer_create("m3c2", &comparer));
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_log(task, collect, all));
  MUST(jalon_comparer_read_m3c2_file(
      comparer, file_with("M3C2VER=1\nMaxThreadCount=8\nBeauty=1\nTruth=2\nSearchScale=1\n"),
      task));
  int lines = 0;
  for (const char* c = all; *c != 0; ++c) lines += *c == '|';
  assert_int_equal(lines, 2); /* keys without effect here are no news */
  assert_non_null(strstr(all, "Beauty=1"));
  assert_non_null(strstr(all, "Truth=2"));
  jalon_comparer_release(comparer);
  MUST(jalon_comparer_create("preview", &comparer));
  REFUSED(JALON_ERROR_UNSUPPORTED,
          jalon_comparer_read_m3c2_file(comparer, file_with("M3C2VER=1\n"), task));
  expect_message("preview");
  expect_message("m3c2"); /* the method that has such files */
  remove(file_with(""));
  jalon_task_release(task);
  jalon_comparer_release(comparer);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(m3c2_file__sets_what_it_tells_and_leaves_the_rest),
      cmocka_unit_test(m3c2_file__that_fails_changes_no_parameter),
      cmocka_unit_test(m3c2_file__warns_of_each_key_that_it_does_not_know),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
