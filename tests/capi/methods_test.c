/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The lists of methods of all workers, and what each listed method does with a scan. */
#include "support.h"
#include "wall_scene.h"

/* One row a kind of worker; handles as void*, since the calls are alike. */
typedef struct worker {
  const char* noun;
  jalon_status (*methods)(const char* const** names, uint64_t* count);
  jalon_status (*create)(const char* method, void** out);
  jalon_status (*params)(void* worker, jalon_params** out);
  void (*release)(void* worker);
} worker;

#define WORKER_CALLS(noun)                                            \
  static jalon_status noun##_create(const char* method, void** out) { \
    jalon_##noun* made = NULL;                                        \
    const jalon_status status = jalon_##noun##_create(method, &made); \
    *out = made;                                                      \
    return status;                                                    \
  }                                                                   \
  static jalon_status noun##_params(void* of, jalon_params** out) {   \
    return jalon_##noun##_params(of, out);                            \
  }                                                                   \
  static void noun##_release(void* gone) { jalon_##noun##_release(gone); }
#define WORKER_ROW(noun) \
  { #noun, jalon_##noun##_methods, noun##_create, noun##_params, noun##_release }

WORKER_CALLS(segmenter)
WORKER_CALLS(modeller)
WORKER_CALLS(comparer)
WORKER_CALLS(registrar)
WORKER_CALLS(scanner)

static const worker kWorkers[] = {WORKER_ROW(segmenter), WORKER_ROW(modeller), WORKER_ROW(comparer),
                                  WORKER_ROW(registrar), WORKER_ROW(scanner)};
enum { kWorkerCount = sizeof kWorkers / sizeof *kWorkers };

/* The rows of a worker's parameters with their defaults, as one text that the caller frees. */
static char* told_params(const worker* w, const char* method) {
  void* made = NULL;
  jalon_params* params = NULL;
  const char* json = NULL;
  MUST(w->create(method, &made));
  MUST(w->params(made, &params));
  MUST(jalon_params_to_json(params, &json));
  char* copy = malloc(strlen(json) + 1);
  strcpy(copy, json);
  jalon_params_release(params);
  w->release(made);
  return copy;
}

static void methods__are_those_that_can_be_created(void** state) {
  (void)state;
  for (const worker* w = kWorkers; w != kWorkers + kWorkerCount; ++w) {
    const char* const* names = NULL;
    uint64_t count = 0;
    MUST(w->methods(&names, &count));
    assert_true(count >= 2);
    char all[500] = "";
    for (uint64_t i = 0; i < count; ++i) {
      free(told_params(w, names[i]));
      for (uint64_t j = 0; j < i; ++j) assert_string_not_equal(names[i], names[j]);
      if (i > 0) strcat(all, ", ");
      strcat(all, names[i]);
    }
    void* none = NULL;
    REFUSED(JALON_ERROR_NOT_FOUND, w->create("no such method", &none));
    if (strstr(jalon_last_error_message(), all) == NULL)
      fail_msg("%s: \"%s\" does not name %s", w->noun, jalon_last_error_message(), all);
  }
}

static void methods__begin_with_the_default(void** state) {
  (void)state;
  for (const worker* w = kWorkers; w != kWorkers + kWorkerCount; ++w) {
    const char* const* names = NULL;
    uint64_t count = 0;
    MUST(w->methods(&names, &count));
    char *by_default = told_params(w, NULL), *by_name = told_params(w, names[0]);
    assert_string_equal(by_default, by_name);
    free(by_default);
    free(by_name);
  }
}

static void methods__are_the_same_static_texts_in_each_call(void** state) {
  (void)state;
  for (const worker* w = kWorkers; w != kWorkers + kWorkerCount; ++w) {
    const char *const *names = NULL, *const *again = NULL;
    uint64_t count = 0, more = 0;
    MUST(w->methods(&names, &count));
    MUST(w->methods(&again, &more));
    assert_ptr_equal(names, again);
    assert_int_equal(count, more);
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, w->methods(NULL, &more));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, w->methods(&again, NULL));
  }
}

static void every_segmenter__finds_wall_and_ground_of_a_street(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(20000, 3);
  const char* const* names = NULL;
  uint64_t count = 0;
  MUST(jalon_segmenter_methods(&names, &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_segmenter* segmenter = NULL;
    jalon_segmentation* segmentation = NULL;
    jalon_fields* segments = NULL;
    jalon_array_view labels;
    MUST(jalon_segmenter_create(names[i], &segmenter));
    if (strcmp(names[i], "scan_lines") == 0) { /* nobody scanned these points: they have no rows */
      REFUSED(JALON_ERROR_UNSUPPORTED, jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
      jalon_segmenter_release(segmenter);
      continue;
    }
    MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
    MUST(jalon_segmentation_segments(segmentation, &segments));
    MUST(jalon_fields_view(segments, "label", &labels));
    if (strstr(names[i], "_codes") != NULL) assert_int_equal(labels.count, 0); /* without a list */
    else assert_true(labels.count >= 2);
    jalon_fields_release(segments);
    jalon_segmentation_release(segmentation);
    jalon_segmenter_release(segmenter);
  }
  jalon_cloud_release(cloud);
}

static void every_modeller__makes_a_face_of_a_wall_with_a_window(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  const char* const* names = NULL;
  uint64_t count = 0;
  MUST(jalon_modeller_methods(&names, &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_modeller* modeller = NULL;
    jalon_params* params = NULL;
    jalon_model* model = NULL;
    jalon_fields* faces = NULL;
    jalon_array_view parts;
    MUST(jalon_modeller_create(names[i], &modeller));
    MUST(jalon_modeller_params(modeller, &params));
    /* Nothing tells how thick a wall is that was seen from one side only. */
    const jalon_status has_thickness = jalon_params_set_double(params, "thickness_m", 0.3);
    assert_true(has_thickness == JALON_OK || has_thickness == JALON_ERROR_NOT_FOUND);
    const jalon_status made =
        jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model);
    if (strcmp(names[i], "coded_objects") == 0) { /* planes have no codes */
      assert_int_equal(made, JALON_ERROR_INSUFFICIENT_DATA);
      assert_null(model);
    } else {
      MUST(made);
      MUST(jalon_model_faces(model, &faces));
      MUST(jalon_fields_view(faces, "part", &parts));
      assert_true(parts.count >= 1);
    }
    jalon_fields_release(faces);
    jalon_model_release(model);
    jalon_params_release(params);
    jalon_modeller_release(modeller);
  }
  release_scene(&scene);
}

static void every_comparer__compares_two_scans_of_a_street(void** state) {
  (void)state;
  jalon_cloud *before = street_cloud(20000, 5), *after = street_cloud(20000, 6);
  const char* const* names = NULL;
  uint64_t count = 0;
  MUST(jalon_comparer_methods(&names, &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_comparer* comparer = NULL;
    jalon_comparison* comparison = NULL;
    jalon_fields* points = NULL;
    jalon_array_view distances;
    MUST(jalon_comparer_create(names[i], &comparer));
    MUST(jalon_comparer_run(comparer, before, after, NULL, &comparison));
    MUST(jalon_comparison_points(comparison, &points));
    MUST(jalon_fields_view(points, "distance", &distances));
    assert_true(distances.count > 0);
    jalon_fields_release(points);
    jalon_comparison_release(comparison);
    jalon_comparer_release(comparer);
  }
  jalon_cloud_release(after);
  jalon_cloud_release(before);
}

static void every_registrar__registers_two_scans_or_says_what_it_wants(void** state) {
  (void)state;
  jalon_cloud *before = street_cloud(2000, 5), *after = street_cloud(2000, 6);
  const char* const* names = NULL;
  uint64_t count = 0;
  MUST(jalon_registrar_methods(&names, &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_registrar* registrar = NULL;
    jalon_registration* registration = NULL;
    jalon_transform pose;
    MUST(jalon_registrar_create(names[i], &registrar));
    const jalon_status status =
        jalon_registrar_run(registrar, before, after, NULL, NULL, &registration);
    if (strcmp(names[i], "targets") == 0) {
      assert_int_equal(status, JALON_ERROR_UNSUPPORTED);
    } else {
      MUST(status);
      MUST(jalon_registration_pose(registration, &pose));
      jalon_registration_release(registration);
    }
    jalon_registrar_release(registrar);
  }
  jalon_cloud_release(after);
  jalon_cloud_release(before);
}

static void every_scanner__scans_a_house(void** state) {
  (void)state;
  jalon_params* options = NULL;
  jalon_model* house = NULL;
  const char* const* names = NULL;
  uint64_t count = 0;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", "box"));
  MUST(jalon_scene_create(options, NULL, &house));
  MUST(jalon_scanner_methods(&names, &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_scanner* scanner = NULL;
    jalon_params* params = NULL;
    jalon_cloud* cloud = NULL;
    MUST(jalon_scanner_create(names[i], &scanner));
    MUST(jalon_scanner_params(scanner, &params));
    if (strcmp(names[i], "mobile") == 0) {  // it needs a trajectory, and a call of its own
      assert_int_equal(jalon_scanner_run(scanner, house, NULL, &cloud), JALON_ERROR_UNSUPPORTED);
    } else {
      MUST(jalon_params_from_json(params,
                                  strcmp(names[i], "static") == 0
                                      ? "{\"horizontal_step_rad\":0.01,\"vertical_step_rad\":0.01}"
                                      : "{\"spacing_m\":0.1}"));
      MUST(jalon_scanner_run(scanner, house, NULL, &cloud));
      assert_true(count_of(cloud) > 1000);
      jalon_cloud_release(cloud);
    }
    jalon_params_release(params);
    jalon_scanner_release(scanner);
  }
  jalon_model_release(house);
  jalon_params_release(options);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(methods__are_those_that_can_be_created),
      cmocka_unit_test(methods__begin_with_the_default),
      cmocka_unit_test(methods__are_the_same_static_texts_in_each_call),
      cmocka_unit_test(every_segmenter__finds_wall_and_ground_of_a_street),
      cmocka_unit_test(every_modeller__makes_a_face_of_a_wall_with_a_window),
      cmocka_unit_test(every_comparer__compares_two_scans_of_a_street),
      cmocka_unit_test(every_registrar__registers_two_scans_or_says_what_it_wants),
      cmocka_unit_test(every_scanner__scans_a_house),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
