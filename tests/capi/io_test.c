/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#define N 500

/* Points with two fields, as a facade far from the origin has them. */
static jalon_cloud* survey(void) {
  double xyz[3 * N];
  uint16_t intensity[N];
  int32_t label[N];
  street_points(xyz, N, 11, 652000, 6861000);
  for (int i = 0; i < N; ++i) {
    intensity[i] = (uint16_t)(uniform(5, (uint64_t)i) * 65535);
    label[i] = i % 7 - 1;
  }
  jalon_cloud* cloud = cloud_of(xyz, N);
  MUST(jalon_cloud_set_field(cloud, "intensity", intensity, JALON_UINT16, 1, N, 0, NULL, NULL));
  MUST(jalon_cloud_set_field(cloud, "label", label, JALON_INT32, 1, N, 0, NULL, NULL));
  return cloud;
}

static jalon_cloud* read_back(const char* path) {
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_read(path, NULL, NULL, &cloud));
  return cloud;
}

static double coordinate(const jalon_cloud* cloud, uint64_t i, int axis) {
  jalon_array_view view;
  MUST(jalon_cloud_points(cloud, &view));
  assert_true(i < view.count);
  return ((const double*)((const char*)view.data + i * view.stride_bytes))[axis];
}

static double value(const jalon_cloud* cloud, const char* field, uint64_t i) {
  jalon_fields* fields = NULL;
  double values[N];
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_copy(fields, field, JALON_FLOAT64, values, N));
  jalon_fields_release(fields);
  assert_true(i < N);
  return values[i];
}

static void expect_same(const jalon_cloud* a, const jalon_cloud* b, double tolerance_m) {
  assert_int_equal(count_of(a), count_of(b));
  for (uint64_t i = 0; i < N; i += 13) {
    for (int k = 0; k < 3; ++k)
      assert_true(fabs(coordinate(a, i, k) - coordinate(b, i, k)) <= tolerance_m);
    assert_true(value(a, "intensity", i) == value(b, "intensity", i));
    assert_true(value(a, "label", i) == value(b, "label", i));
  }
}

static void expect_message(const char* a, const char* b) {
  if (strstr(jalon_last_error_message(), a) == NULL ||
      strstr(jalon_last_error_message(), b) == NULL)
    fail_msg("\"%s\" names not both \"%s\" and \"%s\"", jalon_last_error_message(), a, b);
}

static jalon_params* options_of(const char* operation, const char* name, const char* text) {
  jalon_params* options = NULL;
  MUST(jalon_params_create(operation, &options));
  MUST(jalon_params_set_string(options, name, text));
  return options;
}

static void cloud__comes_back_from_every_format(void** state) {
  (void)state;
  const struct {
    const char* name;
    double tolerance_m;
  } formats[] = {{"a.las", 0.00005 + 1e-9}, {"a.ply", 0}, {"a.xyz", 0}, {"a.txt", 0}, {"a.csv", 0}};
  jalon_cloud* cloud = survey();
  for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i) {
    const char* path = temporary(formats[i].name);
    MUST(jalon_cloud_write(cloud, path, NULL, NULL));
    jalon_cloud* back = read_back(path);
    expect_same(cloud, back, formats[i].tolerance_m);
    jalon_cloud_release(back);
    assert_int_equal(remove(path), 0);
  }
  jalon_cloud_release(cloud);
}

static void write__does_what_the_options_say(void** state) {
  (void)state;
  const struct {
    const char *file, *option, *text;
    size_t at;
    const char* bytes;
    size_t count;
  } cases[] = {{"o.las", "las_version", "1.4", 24, "\1\4", 2},
               {"o.las", "las_version", "1.2", 24, "\1\2", 2},
               {"o.ply", "ply_format", "ascii", 4, "format ascii 1.0", 16},
               {"o.ply", "ply_format", "binary_big_endian", 4, "format binary_big_endian 1.0", 28},
               {"o.unknown", "format", "las", 0, "LASF", 4}};
  jalon_cloud* cloud = survey();
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
    const char* path = temporary(cases[i].file);
    jalon_params* options = options_of("write", cases[i].option, cases[i].text);
    MUST(jalon_cloud_write(cloud, path, options, NULL));
    size_t bytes = 0;
    char* content = content_of(path, &bytes);
    assert_non_null(content);
    assert_true(bytes > cases[i].at + cases[i].count);
    assert_memory_equal(content + cases[i].at, cases[i].bytes, cases[i].count);
    free(content);
    jalon_cloud* back = read_back(path);
    expect_same(cloud, back, 0.00005 + 1e-9);
    jalon_cloud_release(back);
    jalon_params_release(options);
    assert_int_equal(remove(path), 0);
  }
  jalon_params* options = options_of("write", "format", "text");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(options, "las_version", "1.5"));
  MUST(jalon_params_set_int64(options, "decimals", 2));
  const char* path = temporary("decimals.xyz");
  MUST(jalon_cloud_write(cloud, path, options, NULL));
  jalon_cloud* back = read_back(path);
  expect_same(cloud, back, 0.005 + 1e-9);
  jalon_cloud_release(back);
  remove(path);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

static void read__takes_the_columns_that_are_named(void** state) {
  (void)state;
  const char* path = temporary("columns.txt");
  jalon_cloud* cloud = NULL;
  write_text(path, "7 1 2 3 9\n8 4 5 6 9\n");
  jalon_params* options = options_of("read", "columns", "class x y z -");
  MUST(jalon_cloud_read(path, options, NULL, &cloud));
  assert_int_equal(count_of(cloud), 2);
  assert_true(coordinate(cloud, 1, 0) == 4 && coordinate(cloud, 1, 2) == 6);
  jalon_fields* fields = NULL;
  uint64_t columns = 0;
  int32_t classes[2];
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_count(fields, &columns));
  MUST(jalon_fields_copy(fields, "class", JALON_INT32, classes, 2));
  assert_int_equal(columns, 1);
  assert_true(classes[0] == 7 && classes[1] == 8);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  const char* const wrong[] = {"x y", "x y z x", "a b c d e"};
  for (int i = 0; i < 3; ++i) {
    jalon_cloud* none = NULL;
    MUST(jalon_params_set_string(options, "columns", wrong[i]));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_read(path, options, NULL, &none));
    expect_message("columns", wrong[i]);
    assert_null(none);
  }
  jalon_params_release(options);
  remove(path);
}

static void read__refuses_coordinates_that_are_not_finite_or_drops_them(void** state) {
  (void)state;
  const char* path = temporary("nan.xyz");
  jalon_cloud* cloud = NULL;
  write_text(path, "1 2 3\n4 nan 6\n7 8 9\n");
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(path, NULL, NULL, &cloud));
  expect_message(path, "point 1 ");
  jalon_params* options = NULL;
  MUST(jalon_params_create("read", &options));
  MUST(jalon_params_set_bool(options, "drop_invalid", 1));
  MUST(jalon_cloud_read(path, options, NULL, &cloud));
  assert_int_equal(count_of(cloud), 2);
  assert_true(coordinate(cloud, 1, 0) == 7);
  jalon_cloud_release(cloud);
  jalon_params_release(options);
  remove(path);
}

static void read__tells_what_is_wrong_with_a_file(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  jalon_model* model = NULL;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_read("/no/such/file.las", NULL, NULL, &cloud));
  expect_message("/no/such/file.las", "no such file");
  REFUSED(JALON_ERROR_IO, jalon_cloud_read("/", NULL, NULL, &cloud));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_model_read("/no/such/file.obj", NULL, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_read("", NULL, NULL, &cloud));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_read(NULL, NULL, NULL, &cloud));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_read("/", NULL, NULL, NULL));
  const char* path = temporary("broken.las");
  jalon_cloud* good = survey();
  MUST(jalon_cloud_write(good, path, NULL, NULL));
  jalon_cloud_release(good);
  struct stat info;
  assert_int_equal(stat(path, &info), 0);
  assert_int_equal(truncate(path, info.st_size - 1), 0);
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(path, NULL, NULL, &cloud));
  expect_message(path, "offset ");
  expect_message("500 points", "499 whole ones");
  assert_int_equal(truncate(path, 100), 0);
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(path, NULL, NULL, &cloud));
  expect_message("offset 100", "header");
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_model_read(path, NULL, NULL, &model));
  write_text(path, "");
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(path, NULL, NULL, &cloud));
  expect_message(path, "empty");
  assert_null(cloud);
  assert_null(model);
  remove(path);
}

static void write__refuses_what_no_format_holds(void** state) {
  (void)state;
  jalon_cloud* cloud = survey();
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_cloud_write(cloud, "/tmp/a.xlsx", NULL, NULL));
  expect_message("/tmp/a.xlsx", "las");
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_cloud_write(cloud, "/tmp/a.obj", NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_write(NULL, "/tmp/a.las", NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_write(cloud, NULL, NULL, NULL));
  const jalon_status status = jalon_cloud_write(cloud, "/no/such/folder/a.las", NULL, NULL);
  assert_true(status == JALON_ERROR_IO || status == JALON_ERROR_NOT_FOUND);
  expect_message("/no/such/folder/a.las", "no such file");
  jalon_params* wrong = NULL;
  MUST(jalon_params_create("read", &wrong));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_write(cloud, "/tmp/a.las", wrong, NULL));
  jalon_params_release(wrong);
  jalon_cloud_release(cloud);
}

static void write__that_fails_keeps_the_old_file(void** state) {
  (void)state;
  const char* path = temporary("kept.las");
  jalon_cloud* cloud = survey();
  MUST(jalon_cloud_write(cloud, path, NULL, NULL));
  size_t bytes = 0, bytes_after = 0;
  char* before = content_of(path, &bytes);
  jalon_params* options = NULL;
  MUST(jalon_params_create("write", &options));
  MUST(
      jalon_params_set_double(options, "scale", 1e-12)); /* a street does not fit 32 bits with it */
  REFUSED(JALON_ERROR_LIMIT, jalon_cloud_write(cloud, path, options, NULL));
  /* A file system that takes no more: the limit on the file's size. */
  struct rlimit old, small;
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &old), 0);
  small = old;
  small.rlim_cur = 4096;
  signal(SIGXFSZ, SIG_IGN);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
  const jalon_status status = jalon_cloud_write(cloud, path, NULL, NULL);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &old), 0);
  signal(SIGXFSZ, SIG_DFL);
  assert_int_equal(status, JALON_ERROR_IO);
  expect_one_line();
  char* after = content_of(path, &bytes_after);
  assert_int_equal(bytes, bytes_after);
  assert_memory_equal(before, after, bytes);
  free(before);
  free(after);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
  remove(path);
}

static void paths__are_utf_8(void** state) {
  (void)state;
  const char* path = temporary(
      "Fassade Stra\xC3\x9F"
      "e H\xC3\xB6he \xE6\xB8\xAC.las");
  jalon_cloud* cloud = survey();
  MUST(jalon_cloud_write(cloud, path, NULL, NULL));
  struct stat info;
  assert_int_equal(stat(path, &info), 0);
  jalon_cloud* back = read_back(path);
  expect_same(cloud, back, 0.00005 + 1e-9);
  jalon_cloud_release(back);
  assert_int_equal(truncate(path, 300), 0);
  REFUSED(JALON_ERROR_FORMAT, jalon_cloud_read(path, NULL, NULL, &back));
  expect_message(path, "offset");
  jalon_cloud_release(cloud);
  remove(path);
}

static void model__comes_back_from_every_format(void** state) {
  (void)state;
  const double vertices[] = {652000.1, 6861000.2, 0.3,       652001.1, 6861000.2,
                             0.3,      652001.1,  6861001.2, 0.3};
  const uint32_t triangles[] = {0, 1, 2};
  const char* const names[] = {"m.obj", "m.ply"};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(vertices, JALON_FLOAT64, 3, 0, triangles, 1, NULL, &model));
  for (int i = 0; i < 2; ++i) {
    const char* path = temporary(names[i]);
    jalon_model* back = NULL;
    jalon_fields* fields = NULL;
    double xyz[9];
    uint32_t corners[3];
    MUST(jalon_model_write(model, path, NULL, NULL));
    MUST(jalon_model_read(path, NULL, NULL, &back));
    MUST(jalon_model_vertices(back, &fields));
    MUST(jalon_fields_copy(fields, "xyz", JALON_FLOAT64, xyz, 9));
    jalon_fields_release(fields);
    assert_memory_equal(xyz, vertices, sizeof vertices);
    MUST(jalon_model_triangles(back, &fields));
    MUST(jalon_fields_copy(fields, "vertices", JALON_UINT32, corners, 3));
    jalon_fields_release(fields);
    assert_memory_equal(corners, triangles, sizeof triangles);
    jalon_model_release(back);
    remove(path);
  }
  const char* const others[] = {"m.stl", "m.city.json", "m.dxf", "m.geojson", "m.ifc"};
  for (int i = 0; i < 5; ++i) {
    const char* path = temporary(others[i]);
    jalon_model* back = NULL;
    jalon_fields* fields = NULL;
    double xyz[9];
    MUST(jalon_model_write(model, path, NULL, NULL));
    if (i >= 3) { /* these are written only */
      REFUSED(JALON_ERROR_UNSUPPORTED, jalon_model_read(path, NULL, NULL, &back));
    } else {
      MUST(jalon_model_read(path, NULL, NULL, &back));
      MUST(jalon_model_vertices(back, &fields));
      MUST(jalon_fields_copy(fields, "xyz", JALON_FLOAT64, xyz, 9));
      for (int k = 0; k < 9; ++k) assert_true(fabs(xyz[k] - vertices[k]) < 5.1e-5);
      jalon_fields_release(fields);
      jalon_model_release(back);
    }
    remove(path);
  }
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_model_write(model, "/tmp/m.las", NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_write(NULL, "/tmp/m.obj", NULL, NULL));
  jalon_model_release(model);
}

static void formats__are_listed(void** state) {
  (void)state;
  uint64_t count = 0;
  int las = 0, obj = 0;
  MUST(jalon_format_count(&count));
  for (uint64_t i = 0; i < count; ++i) {
    const char *name = NULL, *extensions = NULL, *abilities = NULL;
    MUST(jalon_format_info(i, &name, &extensions, &abilities));
    assert_true(name[0] != 0 && extensions[0] != 0 && abilities[0] != 0);
    if (strcmp(name, "LAS") == 0)
      las = strstr(abilities, "cloud read write") != NULL && strcmp(extensions, "las") == 0;
    if (strcmp(name, "OBJ") == 0) obj = strstr(abilities, "model read write") != NULL;
  }
  assert_true(las && obj);
  MUST(jalon_format_info(0, NULL, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_format_info(count, NULL, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_format_count(NULL));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(cloud__comes_back_from_every_format),
      cmocka_unit_test(write__does_what_the_options_say),
      cmocka_unit_test(read__takes_the_columns_that_are_named),
      cmocka_unit_test(read__refuses_coordinates_that_are_not_finite_or_drops_them),
      cmocka_unit_test(read__tells_what_is_wrong_with_a_file),
      cmocka_unit_test(write__refuses_what_no_format_holds),
      cmocka_unit_test(write__that_fails_keeps_the_old_file),
      cmocka_unit_test(paths__are_utf_8),
      cmocka_unit_test(model__comes_back_from_every_format),
      cmocka_unit_test(formats__are_listed),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
