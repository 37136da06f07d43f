/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Parameters and workers as bytes and back, and copied. */
#include "bytes_support.h"

/* The values as one text that the caller frees. */
static char* told(jalon_params* params) {
  const char* json = NULL;
  MUST(jalon_params_to_json(params, &json));
  char* copy = malloc(strlen(json) + 1);
  strcpy(copy, json);
  return copy;
}

static void* made_options(void) {
  jalon_params* params = NULL;
  MUST(jalon_params_create("read", &params));
  MUST(jalon_params_set_string(params, "columns", "x y z intensit\xC3\xA9"));
  MUST(jalon_params_set_bool(params, "drop_invalid", 1));
  return params;
}

KIND_CALLS(params, NO_TASK, NO_TASK)
KIND_CALLS(segmenter, NO_TASK, NO_TASK)
KIND_CALLS(modeller, NO_TASK, NO_TASK)
KIND_CALLS(comparer, NO_TASK, NO_TASK)
KIND_CALLS(registrar, NO_TASK, NO_TASK)
KIND_CALLS(scanner, NO_TASK, NO_TASK)

static void* made_segmenter(void) {
  jalon_segmenter* made = NULL;
  jalon_params* params = NULL;
  MUST(jalon_segmenter_create("region_growing", &made));
  MUST(jalon_segmenter_params(made, &params));
  MUST(jalon_params_set_int64(params, "min_points", 321));
  jalon_params_release(params);
  return made;
}
static void* made_modeller(void) {
  jalon_modeller* made = NULL;
  MUST(jalon_modeller_create("facade", &made));
  return made;
}
static void* made_comparer(void) {
  jalon_comparer* made = NULL;
  jalon_params* params = NULL;
  double covariance[36];
  MUST(jalon_comparer_create("m3c2", &made));
  MUST(jalon_comparer_params(made, &params));
  for (int i = 0; i < 36; ++i) covariance[i] = i % 7 == 0 ? 1e-7 / 3 : 0;
  MUST(jalon_params_set_doubles(params, "registration_covariance", covariance, 36));
  jalon_params_release(params);
  return made;
}
static void* made_registrar(void) {
  jalon_registrar* made = NULL;
  MUST(jalon_registrar_create(NULL, &made));
  return made;
}
static void* made_scanner(void) {
  jalon_scanner* made = NULL;
  const jalon_transform pose = {{0, -1, 0, 2.5, 1, 0, 0, -7, 0, 0, 1, 1.7}};
  MUST(jalon_scanner_create("static", &made));
  MUST(jalon_scanner_add_station(made, "S1", &pose));
  MUST(jalon_scanner_add_station(made, NULL, &pose));
  return made;
}

#define WORKER(noun) \
  { #noun, made_##noun, noun##_write, noun##_read, NULL, noun##_release }
static const object_kind kParams = {"params",    made_options, params_write,
                                    params_read, NULL,         params_release};
static const object_kind kKinds[] = {
    {"params", made_options, params_write, params_read, NULL, params_release},
    WORKER(segmenter),
    WORKER(modeller),
    WORKER(comparer),
    WORKER(registrar),
    WORKER(scanner)};
enum { kKindCount = sizeof kKinds / sizeof *kKinds };

static void params__come_back_with_every_operation(void** state) {
  (void)state;
  uint64_t operations = 0;
  MUST(jalon_params_operation_count(&operations));
  for (uint64_t i = 0; i < operations; ++i) {
    const char* name = NULL;
    jalon_params *params = NULL, *back = NULL;
    size_t count = 0;
    MUST(jalon_params_operation_name(i, &name));
    MUST(jalon_params_create(name, &params));
    uint8_t* bytes = bytes_of(&kParams, params, &count);
    MUST(jalon_params_from_bytes(bytes, count, &back));
    char *before = told(params), *after = told(back);
    assert_string_equal(before, after);
    free(before);
    free(after);
    free(bytes);
    jalon_params_release(back);
    jalon_params_release(params);
  }
  jalon_params *options = made_options(), *back = NULL;
  size_t count = 0;
  uint8_t* bytes = bytes_of(&kParams, options, &count);
  const char* columns = NULL;
  int32_t drop = 0;
  MUST(jalon_params_from_bytes(bytes, count, &back));
  MUST(jalon_params_get_string(back, "columns", &columns));
  assert_string_equal(columns, "x y z intensit\xC3\xA9");
  MUST(jalon_params_get_bool(back, "drop_invalid", &drop));
  assert_int_equal(drop, 1);
  jalon_cloud* cloud = NULL; /* it is a set of that operation, and no other's */
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_read("/no/such/file.las", back, NULL, &cloud));
  free(bytes);
  jalon_params_release(back);
  jalon_params_release(options);
}

static void params_of_a_worker__come_back_as_a_set_of_their_own(void** state) {
  (void)state;
  jalon_comparer* comparer = made_comparer();
  jalon_params *params = NULL, *back = NULL, *copy = NULL;
  size_t count = 0;
  const double *values = NULL, *others = NULL;
  uint64_t n = 0, m = 0;
  MUST(jalon_comparer_params(comparer, &params));
  uint8_t* bytes = bytes_of(&kParams, params, &count);
  MUST(jalon_params_from_bytes(bytes, count, &back));
  MUST(jalon_params_copy(params, &copy));
  MUST(jalon_params_get_doubles(params, "registration_covariance", &values, &n));
  MUST(jalon_params_get_doubles(back, "registration_covariance", &others, &m));
  assert_true(n == 36 && m == 36);
  assert_memory_equal(values, others, 36 * sizeof(double));
  MUST(jalon_params_reset(back));
  MUST(jalon_params_reset(copy));
  MUST(jalon_params_get_doubles(params, "registration_covariance", &values, &n));
  assert_int_equal(n, 36); /* the comparer keeps its own */
  free(bytes);
  jalon_params_release(copy);
  jalon_params_release(back);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
}

static void workers__come_back_with_method_values_and_stations(void** state) {
  (void)state;
  for (int k = 0; k < kKindCount; ++k) comes_back(&kKinds[k]);
  jalon_scanner *scanner = made_scanner(), *back = NULL;
  size_t count = 0;
  uint8_t* bytes = bytes_of(&kKinds[5], scanner, &count);
  MUST(jalon_scanner_from_bytes(bytes, count, &back));
  jalon_params* options = NULL;
  jalon_model* box = NULL;
  jalon_cloud* clouds[2] = {NULL, NULL};
  jalon_array_view views[2];
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", "box"));
  MUST(jalon_scene_create(options, NULL, &box));
  MUST(jalon_scanner_run(scanner, box, NULL, &clouds[0]));
  MUST(jalon_scanner_run(back, box, NULL, &clouds[1]));
  for (int i = 0; i < 2; ++i) MUST(jalon_cloud_points(clouds[i], &views[i]));
  assert_true(views[0].count > 1000 && views[0].count == views[1].count);
  assert_memory_equal(views[0].data, views[1].data, (size_t)views[0].count * 24);
  for (int i = 0; i < 2; ++i) jalon_cloud_release(clouds[i]);
  jalon_model_release(box);
  jalon_params_release(options);
  jalon_scanner_release(back);
  jalon_scanner_release(scanner);
  free(bytes);
}

#define COPIES(noun)                                                                        \
  do {                                                                                      \
    jalon_##noun *made = made_##noun(), *copy = NULL;                                       \
    jalon_params *params = NULL, *others = NULL;                                            \
    size_t count = 0, again = 0;                                                            \
    MUST(jalon_##noun##_copy(made, &copy));                                                 \
    const object_kind kind = WORKER(noun);                                                  \
    uint8_t *bytes = bytes_of(&kind, made, &count), *more = bytes_of(&kind, copy, &again);  \
    assert_int_equal(count, again);                                                         \
    assert_memory_equal(bytes, more, count);                                                \
    free(bytes);                                                                            \
    free(more);                                                                             \
    MUST(jalon_##noun##_params(made, &params));                                             \
    MUST(jalon_##noun##_params(copy, &others));                                             \
    jalon_param_info info = {sizeof info, 0, 0, 0, 0, 0, 0, 0, 0, 0};                       \
    uint64_t row = 0;                                                                       \
    do MUST(jalon_params_info(params, row++, &info));                                       \
    while (info.type != JALON_PARAM_DOUBLE);                                                \
    double before = 0, after = 0;                                                           \
    MUST(jalon_params_get_double(params, info.name, &before));                              \
    MUST(jalon_params_set_double(others, info.name, before / 2 + info.minimum / 2 + 1e-9)); \
    MUST(jalon_params_get_double(params, info.name, &after));                               \
    assert_true(before == after);                                                           \
    jalon_params_release(params);                                                           \
    jalon_params_release(others);                                                           \
    jalon_##noun##_release(made);                                                           \
    jalon_##noun##_release(copy);                                                           \
    copy = NULL;                                                                            \
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_##noun##_copy(NULL, &copy));                \
  } while (0)

static void worker_copies__are_workers_of_their_own(void** state) {
  (void)state;
  COPIES(segmenter);
  COPIES(modeller);
  COPIES(comparer);
  COPIES(registrar);
  COPIES(scanner);
}

static void damaged_bytes__are_refused(void** state) {
  (void)state;
  for (int k = 0; k < kKindCount; ++k) damage_is_told(&kKinds[k]);
}

static void made_up_bytes__are_refused_or_whole(void** state) {
  (void)state;
  const int tries = is_full_run() ? 20000 : is_sanitized() ? 500 : 2000;
  for (int k = 0; k < kKindCount; ++k)
    assert_true(made_up_is_survived(&kKinds[k], (uint64_t)k, tries) > tries / 4);
}

static void bytes_of_others__are_told_apart(void** state) {
  (void)state;
  for (int k = 0; k < kKindCount; ++k)
    strangers_are_told(&kKinds[k], &kKinds[(k + 1) % kKindCount]);
}

/* A value that a later release would know, and one out of its range. */
static void params__that_are_not_known_here_are_named(void** state) {
  (void)state;
  jalon_params *params = made_options(), *back = NULL;
  size_t count = 0;
  uint8_t* bytes = bytes_of(&kParams, params, &count);
  for (size_t i = 0; i + 7 < count; ++i)
    if (memcmp(bytes + i, "columns", 7) == 0) {
      memcpy(bytes + i, "colours", 7);
      break;
    }
  seal_anew(bytes, count);
  REFUSED(JALON_ERROR_FORMAT, jalon_params_from_bytes(bytes, count, &back));
  assert_non_null(strstr(jalon_last_error_message(), "no parameter \"colours\""));
  assert_null(back);
  free(bytes);
  jalon_params_release(params);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(params__come_back_with_every_operation),
      cmocka_unit_test(params_of_a_worker__come_back_as_a_set_of_their_own),
      cmocka_unit_test(workers__come_back_with_method_values_and_stations),
      cmocka_unit_test(worker_copies__are_workers_of_their_own),
      cmocka_unit_test(damaged_bytes__are_refused),
      cmocka_unit_test(made_up_bytes__are_refused_or_whole),
      cmocka_unit_test(bytes_of_others__are_told_apart),
      cmocka_unit_test(params__that_are_not_known_here_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
