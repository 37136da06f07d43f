/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Files of reports: what their names ask for, how long notes may be, and folders that stay clean after a failure. */
#include "lifted_square.h"

#include <dirent.h>

static char report_folder[] = "/tmp/jalon_report_files_XXXXXX";

static int make_report_folder(void** state) {
  (void)state;
  return mkdtemp(report_folder) == NULL;
}

static const char* in_report_folder(const char* name) {
  static char path[512];
  snprintf(path, sizeof path, "%s/%s", report_folder, name);
  return path;
}

/* Removes the files of the folder; gives how many there were. */
static int clear_folder(void) {
  DIR* folder = opendir(report_folder);
  assert_non_null(folder);
  int files = 0;
  for (struct dirent* entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
    if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
    files += remove(in_report_folder(entry->d_name)) == 0;
  }
  closedir(folder);
  return files;
}

static int remove_report_folder(void** state) {
  (void)state;
  clear_folder();
  return rmdir(report_folder);
}

static void picture__is_a_png_where_the_name_ends_so_in_any_case(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  const struct {
    const char* name;
    int is_png;
  } cases[] = {{"a.png", 1},     {"a.PNG", 1},  {"a.pNg", 1}, {".png", 1}, {"a.b.png", 1},
               {"a.png.svg", 0}, {"a.png ", 0}, {"apng", 0},  {"png", 0},  {"a", 0}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
    size_t bytes = 0;
    MUST(jalon_report_write_deviations(comparison, in_report_folder(cases[i].name), NULL, NULL));
    char* text = content_of(in_report_folder(cases[i].name), &bytes);
    assert_non_null(text);
    assert_true(bytes > 100);
    assert_int_equal(memcmp(text, "\x89PNG\r\n\x1a\n", 8) == 0, cases[i].is_png);
    assert_int_equal(strstr(text, "</svg>") != NULL, !cases[i].is_png);
    free(text);
  }
  assert_int_equal(clear_folder(), sizeof cases / sizeof *cases); /* and nothing beside them */
  jalon_comparison_release(comparison);
}

static void notes__of_a_mebibyte_are_taken_and_longer_ones_refused(void** state) {
  (void)state;
  enum { kMost = 1 << 20 };
  jalon_comparison* comparison = lifted_comparison();
  jalon_params* options = options_of("comparison_report", "{\"picture\": false}");
  char* notes = malloc(kMost + 2);
  assert_non_null(notes);
  memset(notes, ' ', kMost + 1);
  memcpy(notes, "{\"title\": \"Quay\"}", 17);
  notes[kMost + 1] = 0;
  const char* path = in_report_folder("n.html");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_report_write_comparison(comparison, NULL, NULL, notes, path, options, NULL));
  expect_message("notes_json is longer than 1048576 bytes");
  assert_int_equal(clear_folder(), 0);
  notes[kMost] = 0;
  path = in_report_folder("n.html");
  MUST(jalon_report_write_comparison(comparison, NULL, NULL, notes, path, options, NULL));
  char* page = content_of(path, NULL);
  assert_non_null(page);
  assert_non_null(strstr(page, "Quay"));
  free(page), free(notes);
  assert_int_equal(clear_folder(), 1);
  jalon_params_release(options);
  jalon_comparison_release(comparison);
}

static void failure__leaves_the_old_file_and_no_other(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_task* task = NULL;
  const char* path = in_report_folder("old.html");
  write_text(path, "old");
  MUST(jalon_task_create(&task));
  MUST(jalon_task_cancel(task));
  REFUSED(JALON_ERROR_CANCELLED,
          jalon_report_write_comparison(comparison, NULL, NULL, NULL, path, NULL, task));
  REFUSED(
      JALON_ERROR_INVALID_ARGUMENT,
      jalon_report_write_comparison(comparison, NULL, NULL, "{\"title\": 3}", path, NULL, NULL));
  char* text = content_of(path, NULL);
  assert_string_equal(text, "old");
  free(text);
  MUST(jalon_report_write_comparison(comparison, NULL, NULL, NULL, path, NULL, NULL));
  text = content_of(path, NULL);
  assert_non_null(strstr(text, "</html>"));
  free(text);
  assert_int_equal(clear_folder(), 1);
  REFUSED(JALON_ERROR_IO,
          jalon_report_write_histogram(comparison, in_report_folder("none/h.svg"), NULL, NULL));
  expect_message("none/h.svg");
  assert_int_equal(clear_folder(), 0);
  jalon_task_release(task);
  jalon_comparison_release(comparison);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(picture__is_a_png_where_the_name_ends_so_in_any_case),
      cmocka_unit_test(notes__of_a_mebibyte_are_taken_and_longer_ones_refused),
      cmocka_unit_test(failure__leaves_the_old_file_and_no_other),
  };
  return cmocka_run_group_tests(tests, make_report_folder, remove_report_folder);
}
