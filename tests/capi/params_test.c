/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Parameter tables of all operations and workers: what they promise, row by row, and their way through JSON. */
#include "support.h"

#include <math.h>

/* Runs body for each row of each operation and each worker. */
typedef void (*row_visit)(const char* owner, jalon_params* params, const jalon_param_info* row);

static void visit_set(const char* owner, jalon_params* params, row_visit visit) {
  uint64_t rows;
  MUST(jalon_params_count(params, &rows));
  for (uint64_t r = 0; r < rows; ++r) {
    jalon_param_info info;
    info.struct_size = sizeof info;
    MUST(jalon_params_info(params, r, &info));
    visit(owner, params, &info);
  }
  jalon_params_release(params);
}

static void for_each_row(row_visit visit) {
  uint64_t count;
  MUST(jalon_params_operation_count(&count));
  assert_true(count > 0);
  for (uint64_t i = 0; i < count; ++i) {
    const char* operation;
    jalon_params* params;
    MUST(jalon_params_operation_name(i, &operation));
    MUST(jalon_params_create(operation, &params));
    visit_set(operation, params, visit);
  }
  jalon_params* params;
  jalon_segmenter* segmenter;
  jalon_modeller* modeller;
  jalon_scanner* scanner;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_scanner_create(NULL, &scanner));
  MUST(jalon_segmenter_params(segmenter, &params));
  visit_set("segmenter", params, visit);
  MUST(jalon_modeller_params(modeller, &params));
  visit_set("modeller", params, visit);
  jalon_modeller_release(modeller);
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  visit_set("modeller", params, visit);
  MUST(jalon_scanner_params(scanner, &params));
  visit_set("scanner", params, visit);
  jalon_segmenter_release(segmenter);
  jalon_modeller_release(modeller);
  jalon_scanner_release(scanner);
}

static void check_row(const char* owner, jalon_params* params, const jalon_param_info* row) {
  uint64_t rows, same = 0;
  if (row->type < 1 || row->type > 6) fail_msg("%s.%s has type %d", owner, row->name, row->type);
  if (strlen(row->help) < 8 || strchr(row->help, '\n') != NULL)
    fail_msg("%s.%s: help \"%s\"", owner, row->name, row->help);
  if ((row->type == JALON_PARAM_CHOICE) != (row->choices[0] != 0))
    fail_msg("%s.%s: choices", owner, row->name);
  if (!(row->minimum <= row->maximum)) fail_msg("%s.%s: empty range", owner, row->name);
  if (row->default_text[0] == 0) fail_msg("%s.%s: no default", owner, row->name);
  for (const char* c = row->name; *c; ++c)
    if (!((*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9') || *c == '_'))
      fail_msg("%s.%s: name", owner, row->name);
  MUST(jalon_params_count(params, &rows));
  for (uint64_t r = 0; r < rows; ++r) {
    jalon_param_info other;
    other.struct_size = sizeof other;
    MUST(jalon_params_info(params, r, &other));
    same += strcmp(other.name, row->name) == 0;
  }
  assert_int_equal(same, 1);
}

static void params__every_row_is_complete(void** state) {
  (void)state;
  for_each_row(check_row);
}

static void check_length(const char* owner, jalon_params* params, const jalon_param_info* row) {
  (void)params;
  static const char* const kinds[] = {
      "radius",   "diameter",   "half",      "edge",      "side",  "distance", "width",
      "height",   "length",     "depth",     "thickness", "size",  "spacing",  "shift",
      "offset",   "coordinate", "deviation", "sigma",     "step",  "scale",    "gap",
      "position", "range",      "viewpoint", "point",     "margin"};
  if (strcmp(row->unit, "m") != 0) return;
  char help[512] = "";
  for (size_t i = 0; i + 1 < sizeof help && row->help[i] != 0; ++i)
    help[i] = (char)(row->help[i] >= 'A' && row->help[i] <= 'Z' ? row->help[i] + 32 : row->help[i]);
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i)
    if (strstr(help, kinds[i]) != NULL) return;
  fail_msg("%s.%s is a length, but its help does not say of what: \"%s\"", owner, row->name,
           row->help);
}

static void params__every_length_says_what_it_measures(void** state) {
  (void)state;
  for_each_row(check_length);
}

/* A value outside the range is refused with the name in the message, and the old one stays; the ends are accepted. */
static void check_range(const char* owner, jalon_params* params, const jalon_param_info* row) {
  (void)owner;
  double before, after;
  int64_t whole_before, whole_after;
  if (row->type == JALON_PARAM_DOUBLE) {
    MUST(jalon_params_get_double(params, row->name, &before));
    assert_true(before >= row->minimum && before <= row->maximum);
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, row->name, NAN));
    assert_non_null(strstr(jalon_last_error_message(), row->name));
    if (isfinite(row->minimum))
      REFUSED(JALON_ERROR_INVALID_ARGUMENT,
              jalon_params_set_double(params, row->name, nextafter(row->minimum, -INFINITY)));
    if (isfinite(row->maximum))
      REFUSED(JALON_ERROR_INVALID_ARGUMENT,
              jalon_params_set_double(params, row->name, nextafter(row->maximum, INFINITY)));
    MUST(jalon_params_get_double(params, row->name, &after));
    assert_memory_equal(&before, &after, sizeof before);
    if (isfinite(row->minimum)) MUST(jalon_params_set_double(params, row->name, row->minimum));
    if (isfinite(row->maximum)) MUST(jalon_params_set_double(params, row->name, row->maximum));
  } else if (row->type == JALON_PARAM_INT64) {
    MUST(jalon_params_get_int64(params, row->name, &whole_before));
    assert_true((double)whole_before >= row->minimum && (double)whole_before <= row->maximum);
    if (row->minimum > -9e15)
      REFUSED(JALON_ERROR_INVALID_ARGUMENT,
              jalon_params_set_int64(params, row->name, (int64_t)row->minimum - 1));
    if (row->maximum < 9e15)
      REFUSED(JALON_ERROR_INVALID_ARGUMENT,
              jalon_params_set_int64(params, row->name, (int64_t)row->maximum + 1));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, row->name, 2.5));
    MUST(jalon_params_get_int64(params, row->name, &whole_after));
    assert_true(whole_before == whole_after);
  }
}

static void params__refuse_what_is_out_of_range_and_keep_the_old_value(void** state) {
  (void)state;
  for_each_row(check_range);
}

static void check_type(const char* owner, jalon_params* params, const jalon_param_info* row) {
  (void)owner;
  const double pair[2] = {1, 2};
  int32_t flag;
  if (row->type != JALON_PARAM_BOOL) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_bool(params, row->name, 1));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_get_bool(params, row->name, &flag));
  }
  if (row->type != JALON_PARAM_STRING && row->type != JALON_PARAM_CHOICE)
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(params, row->name, "text"));
  if (row->type != JALON_PARAM_DOUBLES)
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_doubles(params, row->name, pair, 2));
  if (row->type == JALON_PARAM_CHOICE) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT,
            jalon_params_set_string(params, row->name, "no such choice"));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(params, row->name, ""));
    char choices[512], *rest = choices;
    snprintf(choices, sizeof choices, "%s", row->choices);
    for (char* choice; (choice = strtok(rest, "|")) != NULL; rest = NULL) {
      const char* text;
      MUST(jalon_params_set_string(params, row->name, choice));
      MUST(jalon_params_get_string(params, row->name, &text));
      assert_string_equal(text, choice);
    }
  }
}

static void params__refuse_wrong_types_and_unknown_choices(void** state) {
  (void)state;
  for_each_row(check_type);
}

static void params__unknown_name_lists_the_names_there_are(void** state) {
  (void)state;
  jalon_params* params;
  jalon_param_info info;
  MUST(jalon_params_create("normals", &params));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(params, "radius_inches", 1));
  assert_non_null(strstr(jalon_last_error_message(), "radius_inches"));
  info.struct_size = sizeof info;
  MUST(jalon_params_info(params, 0, &info));
  assert_non_null(strstr(jalon_last_error_message(), info.name));
  jalon_params_release(params);
}

static void params__json_takes_all_values_there_and_back(void** state) {
  (void)state;
  uint64_t count;
  MUST(jalon_params_operation_count(&count));
  for (uint64_t i = 0; i < count; ++i) {
    const char *operation, *json;
    jalon_params *a, *b;
    MUST(jalon_params_operation_name(i, &operation));
    MUST(jalon_params_create(operation, &a));
    MUST(jalon_params_create(operation, &b));
    MUST(jalon_params_to_json(a, &json));
    char* kept = strcpy(malloc(strlen(json) + 1), json);
    assert_true(kept[0] == '{' && kept[strlen(kept) - 1] == '}');
    MUST(jalon_params_from_json(b, kept));
    MUST(jalon_params_to_json(b, &json));
    assert_string_equal(json, kept);
    free(kept);
    jalon_params_release(a);
    jalon_params_release(b);
  }
}

static void params__json_is_all_or_nothing(void** state) {
  (void)state;
  jalon_params* params;
  const char* json;
  char before[4096];
  MUST(jalon_params_create("normals", &params));
  MUST(jalon_params_set_int64(params, "k", 12));
  MUST(jalon_params_to_json(params, &json));
  snprintf(before, sizeof before, "%s", json);
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_from_json(params, "{\"k\": 20, \"no_such\": 1}"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_params_from_json(params, "{\"k\": 20, \"method\": \"magic\"}"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_from_json(params, "{\"k\": 20"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_from_json(params, "{\"k\": null}"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_from_json(params, "{\"k\": 1e30}"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_from_json(params, "[1]"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_from_json(params, ""));
  MUST(jalon_params_to_json(params, &json));
  assert_string_equal(json, before);
  MUST(jalon_params_from_json(params, "{\"k\": 20}"));
  int64_t k;
  MUST(jalon_params_get_int64(params, "k", &k));
  assert_int_equal(k, 20);
  MUST(jalon_params_reset(params));
  MUST(jalon_params_get_int64(params, "k", &k));
  assert_int_equal(k, 16);
  jalon_params_release(params);
}

static void params__info_serves_older_and_newer_callers(void** state) {
  (void)state;
  jalon_params* params;
  union {
    jalon_param_info info;
    unsigned char bytes[256];
  } u;
  MUST(jalon_params_create("normals", &params));
  memset(&u, 0x5A, sizeof u);
  u.info.struct_size =
      offsetof(jalon_param_info, unit); /* a caller from a release whose struct ended here */
  MUST(jalon_params_info(params, 0, &u.info));
  assert_true(u.info.name != NULL && u.info.type >= 1);
  for (size_t i = offsetof(jalon_param_info, unit); i < sizeof u; ++i)
    assert_int_equal(u.bytes[i], 0x5A);
  memset(&u, 0x5A, sizeof u);
  u.info.struct_size = sizeof u; /* a caller from a later release */
  MUST(jalon_params_info(params, 0, &u.info));
  for (size_t i = sizeof u.info; i < sizeof u; ++i) assert_int_equal(u.bytes[i], 0x5A);
  jalon_params_release(params);
}

static void params__of_a_worker_change_the_worker(void** state) {
  (void)state;
  jalon_segmenter* segmenter;
  jalon_params *first, *second;
  const char *a, *b;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &first));
  MUST(jalon_segmenter_params(segmenter, &second));
  jalon_segmenter_release(segmenter); /* the sets live on */
  jalon_param_info info;
  info.struct_size = sizeof info;
  uint64_t rows;
  int changed = 0;
  MUST(jalon_params_count(first, &rows));
  for (uint64_t r = 0; r < rows && !changed; ++r) {
    MUST(jalon_params_info(first, r, &info));
    if (info.type == JALON_PARAM_BOOL) {
      int32_t value, seen;
      MUST(jalon_params_get_bool(first, info.name, &value));
      MUST(jalon_params_set_bool(first, info.name, !value));
      MUST(jalon_params_get_bool(second, info.name, &seen));
      assert_int_equal(seen, !value);
      changed = 1;
    } else if (info.type == JALON_PARAM_DOUBLE && isfinite(info.maximum)) {
      double seen;
      MUST(jalon_params_set_double(first, info.name, info.maximum));
      MUST(jalon_params_get_double(second, info.name, &seen));
      assert_true(seen == info.maximum);
      changed = 1;
    }
  }
  assert_true(changed);
  MUST(jalon_params_to_json(first, &a));
  MUST(jalon_params_to_json(second, &b));
  assert_string_equal(a, b);
  jalon_params_release(first);
  jalon_params_release(second);
}

/* A survey of some thousand coded points is longer than the 64 KiB of other texts. */
static void params__hold_a_list_of_codes_of_a_megabyte(void** state) {
  (void)state;
  const size_t longest = (size_t)1 << 20;
  char* codes = malloc(longest + 2);
  const char* held;
  jalon_segmenter* segmenter;
  jalon_params* params;
  assert_non_null(codes);
  MUST(jalon_segmenter_create("survey_codes", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  memset(codes, '#', longest + 1);
  codes[longest] = 0;
  MUST(jalon_params_set_string(params, "codes", codes));
  MUST(jalon_params_get_string(params, "codes", &held));
  assert_int_equal(strlen(held), longest);
  codes[longest] = '#', codes[longest + 1] = 0;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(params, "codes", codes));
  assert_non_null(strstr(jalon_last_error_message(), "value is longer than 1048576 bytes"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_params_set_string(params, "codes", "1;0;0;0;360\n2;0;0;0;360 caf\xE9\n"));
  assert_non_null(strstr(jalon_last_error_message(), "value is not valid UTF-8 in line 2"));
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  free(codes);
}

static void params__of_one_operation_are_refused_by_another(void** state) {
  (void)state;
  jalon_params* params;
  jalon_cloud *cloud = street_cloud(200, 1), *out = (jalon_cloud*)&cloud;
  MUST(jalon_params_create("normals", &params));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_subsample(cloud, params, NULL, &out, NULL));
  assert_non_null(strstr(jalon_last_error_message(), "normals"));
  assert_ptr_equal(out, &cloud);
  jalon_params_release(params);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(params__every_row_is_complete),
      cmocka_unit_test(params__every_length_says_what_it_measures),
      cmocka_unit_test(params__refuse_what_is_out_of_range_and_keep_the_old_value),
      cmocka_unit_test(params__refuse_wrong_types_and_unknown_choices),
      cmocka_unit_test(params__unknown_name_lists_the_names_there_are),
      cmocka_unit_test(params__json_takes_all_values_there_and_back),
      cmocka_unit_test(params__json_is_all_or_nothing),
      cmocka_unit_test(params__info_serves_older_and_newer_callers),
      cmocka_unit_test(params__of_a_worker_change_the_worker),
      cmocka_unit_test(params__hold_a_list_of_codes_of_a_megabyte),
      cmocka_unit_test(params__of_one_operation_are_refused_by_another),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
