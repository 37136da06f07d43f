/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Text made and read under a locale with a decimal comma equals that under "C", byte by byte. comma_locale.sh makes the
 * locale; without it the test is skipped. */
#include "support.h"

#include <locale.h>

enum { kPoints = 500, kModels = 7, kTexts = 12, kJson = kTexts - 1 };
static const char* const kFiles[kJson] = {"out.xyz",       "out.csv",     "out.ply",     "out.las",
                                          "out.obj",       "out.svg",     "report.json", "out.dxf",
                                          "out.city.json", "out.geojson", "out.stl"};

static int use_comma(void) {
  static const char* const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"};
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
    if (setlocale(LC_ALL, names[i]) != NULL && localeconv()->decimal_point[0] == ',') return 1;
  return 0;
}

/* Everything that makes text, into the files and one JSON text. */
static char* make_texts(void) {
  jalon_cloud* cloud = street_cloud(kPoints, 11);
  jalon_segmenter* segmenter;
  jalon_segmentation* segmentation;
  jalon_modeller* modeller;
  jalon_model* model;
  jalon_params *params, *ascii;
  const char* json;
  float height[kPoints];
  for (int i = 0; i < kPoints; ++i) height[i] = (float)i / 7;
  MUST(jalon_cloud_set_field(cloud, "height", height, JALON_FLOAT32, 1, kPoints, 0, "m", ""));
  MUST(jalon_params_create("write", &ascii));
  MUST(jalon_cloud_write(cloud, temporary(kFiles[0]), NULL, NULL));
  MUST(jalon_cloud_write(cloud, temporary(kFiles[1]), NULL, NULL));
  MUST(jalon_params_from_json(ascii, "{\"ply_format\": \"ascii\"}"));
  MUST(jalon_cloud_write(cloud, temporary(kFiles[2]), ascii, NULL));
  MUST(jalon_cloud_write(cloud, temporary(kFiles[3]), NULL, NULL));
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_modeller_run(modeller, cloud, segmentation, NULL, &model));
  MUST(jalon_model_write(model, temporary(kFiles[4]), NULL, NULL));
  MUST(jalon_report_write_elevation(segmentation, model, temporary(kFiles[5]), NULL, NULL));
  MUST(jalon_report_write_json(segmentation, model,
                               "{\"title\": \"t\", \"times\": {\"read\": 1.5}}",
                               temporary(kFiles[6]), NULL, NULL));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_from_json(ascii, "{\"stl_format\": \"ascii\"}"));
  for (int f = kModels; f < kJson; ++f)
    MUST(jalon_model_write(model, temporary(kFiles[f]), ascii, NULL));
  MUST(jalon_params_from_json(params, "{\"distance_tolerance_m\": 0.0125}"));
  MUST(jalon_params_to_json(params, &json));
  char* copy = strcpy(malloc(strlen(json) + 1), json);
  jalon_params_release(params);
  jalon_params_release(ascii);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  return copy;
}

static void locale__text_is_the_same_with_a_decimal_comma(void** state) {
  (void)state;
  char *texts[2][kTexts] = {{NULL}}, probe[32];
  size_t sizes[2][kTexts] = {{0}};
  for (int turn = 0; turn < 2; ++turn) {
    if (turn == 0) setlocale(LC_ALL, "C");
    else assert_true(use_comma());
    snprintf(probe, sizeof probe, "%.1f", 1.5);
    assert_string_equal(probe, turn == 0 ? "1.5" : "1,5"); /* the host really is in that locale */
    texts[turn][kJson] = make_texts();
    sizes[turn][kJson] = strlen(texts[turn][kJson]);
    for (int f = 0; f < kJson; ++f) {
      texts[turn][f] = content_of(temporary(kFiles[f]), &sizes[turn][f]);
      assert_non_null(texts[turn][f]);
      assert_true(sizes[turn][f] > 20);
      remove(temporary(kFiles[f]));
    }
    snprintf(probe, sizeof probe, "%.1f", 1.5);
    assert_string_equal(probe, turn == 0 ? "1.5" : "1,5"); /* and Jalon left it alone */
  }
  for (int f = 0; f < kTexts; ++f) {
    if (sizes[0][f] != sizes[1][f] || memcmp(texts[0][f], texts[1][f], sizes[0][f]) != 0)
      fail_msg("%s depends on the locale", f < kJson ? kFiles[f] : "the JSON of the parameters");
    free(texts[0][f]);
    free(texts[1][f]);
  }
  setlocale(LC_ALL, "");
}

static void locale__text_is_read_with_a_decimal_comma_about(void** state) {
  (void)state;
  jalon_cloud* cloud;
  jalon_array_view xyz;
  assert_true(use_comma());
  write_text(temporary("in.xyz"), "1.25 2.5 3.75\n4.5 5.5 6.5\n7.125 8.0625 9.03125\n");
  MUST(jalon_cloud_read(temporary("in.xyz"), NULL, NULL, &cloud));
  MUST(jalon_cloud_points(cloud, &xyz));
  assert_int_equal(xyz.count, 3);
  const double expected[9] = {1.25, 2.5, 3.75, 4.5, 5.5, 6.5, 7.125, 8.0625, 9.03125};
  assert_memory_equal(xyz.data, expected, sizeof expected);
  jalon_cloud_release(cloud);
  write_text(temporary("in.ply"),
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
             "property double z\nend_header\n0.5 -1.25 1e-3\n");
  MUST(jalon_cloud_read(temporary("in.ply"), NULL, NULL, &cloud));
  MUST(jalon_cloud_points(cloud, &xyz));
  const double one[3] = {0.5, -1.25, 1e-3};
  assert_memory_equal(xyz.data, one, sizeof one);
  jalon_cloud_release(cloud);
  static const char* const models[] = {
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.5 0 0\nvertex 1.25 0 0\nvertex 0 2.75 "
      "0\nendloop\nendfacet\n",
      "{\"type\":\"CityJSON\",\"version\":\"1.0\",\"CityObjects\":{},\"vertices\":"
      "[[0.5,0,0],[1.25,0,0],[0,2.75,0]]}"};
  for (int f = 0; f < 2; ++f) {
    const char* path = temporary(f == 0 ? "in.stl" : "in.json");
    jalon_model* model;
    jalon_fields* vertices;
    double xyz[9];
    write_text(path, models[f]);
    MUST(jalon_model_read(path, NULL, NULL, &model));
    MUST(jalon_model_vertices(model, &vertices));
    MUST(jalon_fields_copy(vertices, "xyz", JALON_FLOAT64, xyz, 9));
    assert_true(xyz[0] == 0.5 && xyz[3] == 1.25 && xyz[7] == 2.75);
    jalon_fields_release(vertices);
    jalon_model_release(model);
    remove(path);
  }
  remove(temporary("in.xyz"));
  remove(temporary("in.ply"));
  setlocale(LC_ALL, "");
}

static void locale__messages_write_numbers_with_a_point(void** state) {
  (void)state;
  jalon_params* params;
  assert_true(use_comma());
  MUST(jalon_params_create("subsample", &params));
  jalon_param_info info;
  uint64_t rows, seen = 0;
  MUST(jalon_params_count(params, &rows));
  for (uint64_t r = 0; r < rows; ++r) {
    info.struct_size = sizeof info;
    MUST(jalon_params_info(params, r, &info));
    if (info.type != JALON_PARAM_DOUBLE || !(info.minimum >= 0)) continue;
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, info.name, -0.5));
    assert_non_null(strstr(jalon_last_error_message(), "-0.5"));
    ++seen;
  }
  assert_true(seen > 0);
  jalon_params_release(params);
  setlocale(LC_ALL, "");
}

int main(void) {
  if (!use_comma()) {
    printf("skipped: no locale with a decimal comma; tests/capi/comma_locale.sh makes one\n");
    return 77;
  }
  setlocale(LC_ALL, "");
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(locale__text_is_the_same_with_a_decimal_comma),
      cmocka_unit_test(locale__text_is_read_with_a_decimal_comma_about),
      cmocka_unit_test(locale__messages_write_numbers_with_a_point),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
