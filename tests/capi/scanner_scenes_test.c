/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Scenes that bring their own scanner and tell their walls and openings. */
#include "support.h"

#include <string.h>

static jalon_params* grammar(const char* kind, int64_t seed) {
  jalon_params* options;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", "grammar"));
  MUST(jalon_params_set_string(options, "kind", kind));
  MUST(jalon_params_set_int64(options, "seed", seed));
  MUST(jalon_params_set_double(options, "spacing_m", 0.1));
  MUST(jalon_params_set_int64(options, "stations", 2));
  return options;
}

static char* text_of_file(const char* path) {
  FILE* file = fopen(path, "rb");
  assert_non_null(file);
  fseek(file, 0, SEEK_END);
  const long size = ftell(file);
  rewind(file);
  char* text = malloc((size_t)size + 1);
  assert_int_equal(fread(text, 1, (size_t)size, file), size);
  text[size] = 0;
  fclose(file);
  return text;
}

static void scene_scanner__has_the_stations_and_the_noise_of_the_scene(void** state) {
  (void)state;
  jalon_params *options = grammar("shops", 3), *params;
  MUST(jalon_params_set_double(options, "noise_m", 0.0125));
  jalon_scanner* scanner;
  MUST(jalon_scene_scanner(options, &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  double noise_m, step_rad;
  MUST(jalon_params_get_double(params, "range_noise_m", &noise_m));
  MUST(jalon_params_get_double(params, "horizontal_step_rad", &step_rad));
  assert_true(noise_m == 0.0125);
  assert_true(step_rad > 0.1 / 60 && step_rad < 0.1 / 4);
  jalon_model* model;
  MUST(jalon_scene_create(options, NULL, &model));
  jalon_cloud* cloud;
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  uint64_t stations;
  MUST(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 2);
  jalon_cloud_release(cloud);
  jalon_model_release(model);
  jalon_params_release(params);
  jalon_params_release(options);
  jalon_scanner_release(scanner);
}

static void scene_scanner__of_other_scenes_is_the_default_one(void** state) {
  (void)state;
  jalon_scanner *own, *plain;
  jalon_params *own_params, *plain_params;
  const char *own_text, *plain_text;
  MUST(jalon_scene_scanner(NULL, &own));
  MUST(jalon_scanner_create("static", &plain));
  MUST(jalon_scanner_params(own, &own_params));
  MUST(jalon_scanner_params(plain, &plain_params));
  MUST(jalon_params_to_json(own_params, &own_text));
  MUST(jalon_params_to_json(plain_params, &plain_text));
  assert_string_equal(own_text, plain_text);
  jalon_params_release(own_params);
  jalon_params_release(plain_params);
  jalon_scanner_release(own);
  jalon_scanner_release(plain);
}

static void scene_truth__is_that_of_the_scanner_told_or_of_the_scenes_own(void** state) {
  (void)state;
  jalon_params *options = grammar("town_house", 5), *other = grammar("town_house", 5);
  MUST(jalon_params_set_int64(other, "stations", 1));
  jalon_scanner *own, *single;
  MUST(jalon_scene_scanner(options, &own));
  MUST(jalon_scene_scanner(other, &single));
  MUST(jalon_scene_write_truth("truth_plain.json", NULL, options, NULL));
  MUST(jalon_scene_write_truth("truth_own.json", own, options, NULL));
  MUST(jalon_scene_write_truth("truth_single.json", single, options, NULL));
  char *plain_text = text_of_file("truth_plain.json"), *own_text = text_of_file("truth_own.json"),
       *single_text = text_of_file("truth_single.json");
  assert_string_equal(plain_text, own_text);
  assert_string_not_equal(plain_text, single_text);
  assert_non_null(strstr(plain_text, "\"shape\":\"jalon facade truth 1\""));
  assert_non_null(strstr(plain_text, "\"class\":\"door\""));
  free(plain_text);
  free(own_text);
  free(single_text);
  remove("truth_plain.json");
  remove("truth_own.json");
  remove("truth_single.json");
  jalon_scanner_release(own);
  jalon_scanner_release(single);
  jalon_params_release(options);
  jalon_params_release(other);
}

static void scene_truth__without_options_is_that_of_the_default_grammar(void** state) {
  (void)state;
  jalon_params* options;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", "grammar"));
  MUST(jalon_scene_write_truth("truth_told.json", NULL, options, NULL));
  MUST(jalon_scene_write_truth("truth_null.json", NULL, NULL, NULL));
  char *told = text_of_file("truth_told.json"), *null = text_of_file("truth_null.json");
  assert_string_equal(told, null);
  free(told);
  free(null);
  remove("truth_told.json");
  remove("truth_null.json");
  jalon_params_release(options);
}

static void scene_truth__refuses_other_scenes_and_scanners_without_stations(void** state) {
  (void)state;
  jalon_params* options = grammar("church", 1);
  jalon_scanner* sample;
  MUST(jalon_scanner_create("sample", &sample));
  jalon_params* facade;
  MUST(jalon_params_create("scene", &facade));
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_scene_write_truth("truth_no.json", NULL, facade, NULL));
  jalon_params_release(facade);
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_scene_write_truth("truth_no.json", sample, options, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scene_write_truth(NULL, NULL, options, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scene_scanner(options, NULL));
  MUST(jalon_params_set_double(options, "front_m", 1));
  jalon_scanner* none = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scene_scanner(options, &none));
  assert_null(none);
  assert_null(fopen("truth_no.json", "rb"));
  jalon_scanner_release(sample);
  jalon_params_release(options);
}

static void yard_truth__has_code_lists_and_a_class_for_each_face(void** state) {
  (void)state;
  jalon_params* options;
  jalon_model* model;
  jalon_fields* faces;
  jalon_array_view ids;
  uint64_t commas = 0;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", "yard"));
  MUST(jalon_scene_write_truth("truth_yard.json", NULL, options, NULL));
  char* text = text_of_file("truth_yard.json");
  assert_non_null(strstr(text, "\"shape\":\"jalon coded truth 1\""));
  assert_non_null(strstr(text, ";300.2\""));
  assert_non_null(strstr(text, "\"targets\":[\""));
  for (const char* c = strstr(text, "\"face_classes\":["); *c != 0 && *c != ']'; ++c)
    commas += *c == ',';
  MUST(jalon_scene_create(options, NULL, &model));
  MUST(jalon_model_faces(model, &faces));
  MUST(jalon_fields_view(faces, "id", &ids));
  assert_true(commas + 1 >= ids.count);
  jalon_fields_release(faces);
  jalon_model_release(model);
  jalon_params_release(options);
  free(text);
  remove("truth_yard.json");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(scene_scanner__has_the_stations_and_the_noise_of_the_scene),
      cmocka_unit_test(scene_scanner__of_other_scenes_is_the_default_one),
      cmocka_unit_test(scene_truth__is_that_of_the_scanner_told_or_of_the_scenes_own),
      cmocka_unit_test(scene_truth__without_options_is_that_of_the_default_grammar),
      cmocka_unit_test(scene_truth__refuses_other_scenes_and_scanners_without_stations),
      cmocka_unit_test(yard_truth__has_code_lists_and_a_class_for_each_face),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
