/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Bad input ends in one line with the cause, and what was there before stays as it was. */
#include "support.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#define UNTOUCHED ((void*)(uintptr_t)0x5A5A5A5A)

static void expect_word(const char* word) {
  if (strstr(jalon_last_error_message(), word) == NULL)
    fail_msg("the message does not name \"%s\": %s", word, jalon_last_error_message());
}

/* ---- points ---- */

static void no_points__are_a_cloud_that_workers_refuse(void** state) {
  (void)state;
  jalon_cloud* cloud;
  jalon_segmenter* segmenter;
  jalon_segmentation* segmentation = UNTOUCHED;
  jalon_box box = {{1, 2, 3}, {4, 5, 6}};
  MUST(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &cloud));
  MUST(jalon_segmenter_create(NULL, &segmenter));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  assert_ptr_equal(segmentation, UNTOUCHED);
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_cloud_bounds(cloud, &box));
  assert_true(box.min.x == 1 && box.max.z == 6);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
}

static void nan__is_refused_with_its_index_or_dropped(void** state) {
  (void)state;
  double xyz[300];
  jalon_cloud* cloud = UNTOUCHED;
  for (int i = 0; i < 300; ++i) xyz[i] = uniform(1, (uint64_t)i);
  xyz[3 * 42 + 1] = NAN;
  xyz[3 * 77] = -INFINITY;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_create(xyz, JALON_FLOAT64, 100, 0, 0, &cloud));
  expect_word("42");
  assert_ptr_equal(cloud, UNTOUCHED);
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 100, 0, JALON_CLOUD_DROP_INVALID, &cloud));
  assert_int_equal(count_of(cloud), 98);
  jalon_cloud_release(cloud);
}

static void run_degenerate(const double* xyz, uint64_t n, jalon_status expected) {
  jalon_cloud* cloud = cloud_of(xyz, n);
  jalon_segmenter* segmenter;
  jalon_segmentation* segmentation = UNTOUCHED;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  REFUSED(expected, jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  assert_ptr_equal(segmentation, UNTOUCHED);
  /* The cloud stays usable. */
  jalon_box box;
  MUST(jalon_cloud_bounds(cloud, &box));
  MUST(jalon_cloud_compute_normals(cloud, NULL, NULL)); /* points without a normal get NaN */
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
}

static void degenerate_points__have_no_planes(void** state) {
  (void)state;
  double equal[900], line[900], grid_line[900];
  for (int i = 0; i < 300; ++i) {
    for (int c = 0; c < 3; ++c) {
      equal[3 * i + c] = 652000.25 + c;
      line[3 * i + c] = 0.01 * (c + 1) * i;
      grid_line[3 * i + c] = c == 0 ? 652000 + 0.25 * i : c == 1 ? 6861000 : 40;
    }
  }
  run_degenerate(equal, 1, JALON_ERROR_INSUFFICIENT_DATA);
  run_degenerate(line, 2, JALON_ERROR_INSUFFICIENT_DATA);
  run_degenerate(equal, 300, JALON_ERROR_DEGENERATE);
  run_degenerate(line, 300, JALON_ERROR_DEGENERATE);
  run_degenerate(grid_line, 300, JALON_ERROR_DEGENERATE);
}

static void wrong_field__lists_the_fields_there_are(void** state) {
  (void)state;
  jalon_cloud *cloud = street_cloud(50, 3), *equal = UNTOUCHED, *others = UNTOUCHED;
  float value[50] = {0};
  jalon_fields* fields;
  jalon_array_view view;
  MUST(jalon_cloud_set_field(cloud, "reflectance", value, JALON_FLOAT32, 1, 50, 0, NULL, NULL));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_split(cloud, "intensity", 1, NULL, &equal, &others));
  expect_word("intensity");
  assert_true(equal == UNTOUCHED && others == UNTOUCHED);
  MUST(jalon_cloud_fields(cloud, &fields));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_fields_view(fields, "intensity", &view));
  expect_word("reflectance");
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_remove_field(cloud, "intensity"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_set_field(cloud, "short", value, JALON_FLOAT32, 1, 49, 0, NULL, NULL));
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

static void values_that_do_not_fit__are_refused_and_nothing_is_written(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(4, 3);
  const double value[4] = {1, 255, 256, 3};
  uint8_t bytes[4] = {9, 9, 9, 9};
  double back[4];
  jalon_fields* fields;
  MUST(jalon_cloud_set_field(cloud, "v", value, JALON_FLOAT64, 1, 4, 0, NULL, NULL));
  MUST(jalon_cloud_fields(cloud, &fields));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_copy(fields, "v", JALON_UINT8, bytes, 4));
  for (int i = 0; i < 4; ++i) assert_int_equal(bytes[i], 9);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_copy(fields, "v", JALON_FLOAT64, back, 3));
  MUST(jalon_fields_copy(fields, "v", JALON_FLOAT64, back, 4));
  assert_memory_equal(value, back, sizeof value);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

/* ---- files ---- */

static void missing_file__is_named(void** state) {
  (void)state;
  jalon_cloud* cloud = UNTOUCHED;
  jalon_model* model = UNTOUCHED;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_read(temporary("absent.las"), NULL, NULL, &cloud));
  expect_word("absent.las");
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_model_read(temporary("absent.obj"), NULL, NULL, &model));
  expect_word("absent.obj");
  assert_true(cloud == UNTOUCHED && model == UNTOUCHED);
}

static void wrong_column__is_refused_with_the_cause(void** state) {
  (void)state;
  jalon_cloud* cloud = UNTOUCHED;
  jalon_params* options;
  write_text(temporary("t.xyz"), "1 2 3 4\n5 6 7 8\n9 10 eleven 12\n");
  MUST(jalon_params_create("read", &options));
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(temporary("t.xyz"), NULL, NULL, &cloud));
  expect_word("t.xyz");
  expect_word("3");
  MUST(jalon_params_set_string(options, "columns", "x y intensity"));
  assert_true(jalon_cloud_read(temporary("t.xyz"), options, NULL, &cloud) < 0);
  expect_one_line();
  expect_word("z");
  write_text(temporary("t.xyz"), "1 2 3\n5 6 7\n");
  MUST(jalon_params_set_string(options, "columns", "x y z intensity class"));
  assert_true(jalon_cloud_read(temporary("t.xyz"), options, NULL, &cloud) < 0);
  expect_one_line();
  assert_ptr_equal(cloud, UNTOUCHED);
  jalon_params_release(options);
  remove(temporary("t.xyz"));
}

static void empty_and_foreign_files__are_refused(void** state) {
  (void)state;
  static const char* const names[] = {"e.las", "e.ply", "e.obj"};
  jalon_cloud* cloud = UNTOUCHED;
  for (int i = 0; i < 3; ++i) {
    write_text(temporary(names[i]), "");
    assert_true(jalon_cloud_read(temporary(names[i]), NULL, NULL, &cloud) < 0);
    expect_one_line();
    write_text(temporary(names[i]), "<html>not a scan</html>\n");
    assert_true(jalon_cloud_read(temporary(names[i]), NULL, NULL, &cloud) < 0);
    expect_one_line();
    assert_ptr_equal(cloud, UNTOUCHED);
    remove(temporary(names[i]));
  }
  REFUSED(JALON_ERROR_IO, jalon_cloud_read("/", NULL, NULL, &cloud));
}

/* All writers, one call each: what is no cloud's and no report's business is in jobs. */
enum { kWriters = 7 };
static const char* const kWritten[kWriters] = {"w.las", "w.ply",  "w.xyz", "w.obj",
                                               "w.svg", "w.html", "w.json"};

struct written {
  jalon_cloud* cloud;
  jalon_segmentation* segmentation;
  jalon_model* model;
};

static jalon_status write_one(const struct written* w, int i, const char* path) {
  if (i < 3) return jalon_cloud_write(w->cloud, path, NULL, NULL);
  if (i == 3) return jalon_model_write(w->model, path, NULL, NULL);
  if (i == 4) return jalon_report_write_elevation(w->segmentation, w->model, path, NULL, NULL);
  if (i == 5) return jalon_report_write_html(w->segmentation, w->model, NULL, path, NULL, NULL);
  return jalon_report_write_json(w->segmentation, w->model, NULL, path, NULL, NULL);
}

static struct written make_written(void) {
  struct written w = {street_cloud(4000, 4), NULL, NULL};
  jalon_segmenter* segmenter;
  jalon_modeller* modeller;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_run(segmenter, w.cloud, NULL, &w.segmentation));
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_modeller_run(modeller, w.cloud, w.segmentation, NULL, &w.model));
  jalon_segmenter_release(segmenter);
  jalon_modeller_release(modeller);
  return w;
}

static void release_written(struct written* w) {
  jalon_model_release(w->model);
  jalon_segmentation_release(w->segmentation);
  jalon_cloud_release(w->cloud);
}

static void no_folder__is_named(void** state) {
  (void)state;
  struct written w = make_written();
  char path[600];
  for (int i = 0; i < kWriters; ++i) {
    snprintf(path, sizeof path, "%s/none/%s", temporary("no"), kWritten[i]);
    const jalon_status status = write_one(&w, i, path);
    if (status != JALON_ERROR_IO && status != JALON_ERROR_NOT_FOUND)
      fail_msg("%s: status %d", kWritten[i], (int)status);
    expect_one_line();
    expect_word(kWritten[i]);
  }
  release_written(&w);
}

/* RLIMIT_FSIZE stands for the full disk: write() ends early, whatever the user's rights. */
static void full_disk__leaves_the_old_file_and_no_new_one(void** state) {
  (void)state;
  struct written w = make_written();
  struct rlimit before, small = {512, 0};
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
  small.rlim_max = before.rlim_max;
  signal(SIGXFSZ, SIG_IGN);
  char folder[512], path[600];
  snprintf(folder, sizeof folder, "%s", temporary("disk"));
  assert_int_equal(mkdir(folder, 0700), 0);
  for (int i = 0; i < kWriters; ++i) {
    snprintf(path, sizeof path, "%s/%s", folder, kWritten[i]);
    write_text(path, "what was there before");
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    const jalon_status status = write_one(&w, i, path);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    if (status != JALON_ERROR_IO)
      fail_msg("%s: \"%s\" on a full disk", kWritten[i], jalon_status_name(status));
    expect_one_line();
    expect_word(kWritten[i]);
    char* content = content_of(path, NULL);
    assert_string_equal(content, "what was there before");
    free(content);
    MUST(write_one(&w, i, path)); /* with room again it is replaced */
    content = content_of(path, NULL);
    assert_string_not_equal(content, "what was there before");
    free(content);
    remove(path);
  }
  if (rmdir(folder) != 0) fail_msg("files were left beside the targets: %s", strerror(errno));
  signal(SIGXFSZ, SIG_DFL);
  release_written(&w);
}

/* Root may write everywhere: then it is done as another user. */
static void read_only_folder__leaves_the_old_file(void** state) {
  (void)state;
  const int as_root = geteuid() == 0;
  const uid_t nobody = 65534;
  struct written w = make_written();
  char folder[512], path[600];
  snprintf(folder, sizeof folder, "%s", temporary("locked"));
  assert_int_equal(mkdir(folder, 0700), 0);
  for (int i = 0; i < kWriters; ++i) {
    snprintf(path, sizeof path, "%s/%s", folder, kWritten[i]);
    write_text(path, "what was there before");
    chmod(folder, 0555);
    if (as_root) assert_int_equal(seteuid(nobody), 0);
    const jalon_status status = write_one(&w, i, path);
    if (as_root) assert_int_equal(seteuid(0), 0);
    if (status != JALON_ERROR_IO)
      fail_msg("%s: \"%s\" in a locked folder", kWritten[i], jalon_status_name(status));
    expect_one_line();
    expect_word("permission");
    chmod(folder, 0700);
    char* content = content_of(path, NULL);
    assert_string_equal(content, "what was there before");
    free(content);
    remove(path);
  }
  if (rmdir(folder) != 0) fail_msg("files were left beside the targets: %s", strerror(errno));
  release_written(&w);
}

static void unknown_extension__names_those_there_are(void** state) {
  (void)state;
  struct written w = make_written();
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_cloud_write(w.cloud, temporary("scan.docx"), NULL, NULL));
  expect_word("las");
  assert_null(content_of(temporary("scan.docx"), NULL));
  release_written(&w);
}

static void segmentation_of_another_cloud__is_refused(void** state) {
  (void)state;
  struct written w = make_written();
  jalon_cloud* other = street_cloud(4000, 5);
  jalon_modeller* modeller;
  jalon_model* model = UNTOUCHED;
  MUST(jalon_modeller_create(NULL, &modeller));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, other, w.segmentation, NULL, &model));
  assert_ptr_equal(model, UNTOUCHED);
  jalon_modeller_release(modeller);
  jalon_cloud_release(other);
  release_written(&w);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(no_points__are_a_cloud_that_workers_refuse),
      cmocka_unit_test(nan__is_refused_with_its_index_or_dropped),
      cmocka_unit_test(degenerate_points__have_no_planes),
      cmocka_unit_test(wrong_field__lists_the_fields_there_are),
      cmocka_unit_test(values_that_do_not_fit__are_refused_and_nothing_is_written),
      cmocka_unit_test(missing_file__is_named),
      cmocka_unit_test(wrong_column__is_refused_with_the_cause),
      cmocka_unit_test(empty_and_foreign_files__are_refused),
      cmocka_unit_test(no_folder__is_named),
      cmocka_unit_test(full_disk__leaves_the_old_file_and_no_new_one),
      cmocka_unit_test(read_only_folder__leaves_the_old_file),
      cmocka_unit_test(unknown_extension__names_those_there_are),
      cmocka_unit_test(segmentation_of_another_cloud__is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
