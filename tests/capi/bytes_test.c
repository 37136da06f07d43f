/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Clouds and tables as bytes and back. */
#include "bytes_support.h"

#include <math.h>

static const int32_t kTypes[] = {JALON_INT8,    JALON_UINT8,  JALON_INT16, JALON_UINT16,
                                 JALON_INT32,   JALON_UINT32, JALON_INT64, JALON_UINT64,
                                 JALON_FLOAT32, JALON_FLOAT64};
enum { kTypeCount = 10, kPoints = 7 };

/* All element types, any bits in them (NaNs with payloads too), texts, two stations. */
static void* rich_cloud(void) {
  double xyz[3 * kPoints];
  uint8_t bits[kPoints * 3 * 8];
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  const jalon_transform pose = {{0, -1, 0, 652000.25, 1, 0, 0, 6861000.5, 0, 0, 1, -0.0}};
  for (int i = 0; i < 3 * kPoints; ++i) xyz[i] = 1e6 * uniform(3, (uint64_t)i);
  xyz[4] = -0.0;
  xyz[5] = 5e-324;
  MUST(jalon_cloud_builder_create(0, &builder));
  MUST(jalon_cloud_builder_set_crs(builder, "EPSG:2154, \xC3\xA0 peu pr\xC3\xA8s"));
  MUST(jalon_cloud_builder_begin_station(builder, "first", &pose));
  MUST(jalon_cloud_builder_append_points(builder, xyz, JALON_FLOAT64, 4, 0));
  MUST(jalon_cloud_builder_begin_station(builder, "", NULL));
  MUST(jalon_cloud_builder_append_points(builder, xyz + 12, JALON_FLOAT64, kPoints - 4, 0));
  MUST(jalon_cloud_builder_seal(builder, &cloud));
  jalon_cloud_builder_release(builder);
  for (int t = 0; t < kTypeCount; ++t) {
    char name[32], unit[8];
    for (size_t i = 0; i < sizeof bits; ++i)
      bits[i] = i % 8 > 5 ? 0xff : (uint8_t)(256 * uniform((uint64_t)t, i));
    snprintf(name, sizeof name, "field %d \xC2\xB5", t);
    snprintf(unit, sizeof unit, "%s", t % 2 ? "m" : "");
    MUST(jalon_cloud_set_field(cloud, name, bits, kTypes[t], t % 3 + 1, kPoints, 0, unit,
                               t % 2 ? NULL : "what it means"));
  }
  return cloud;
}

static void same_fields(const jalon_fields* a, const jalon_fields* b) {
  uint64_t count = 0, other = 0;
  MUST(jalon_fields_count(a, &count));
  MUST(jalon_fields_count(b, &other));
  assert_int_equal(count, other);
  for (uint64_t i = 0; i < count; ++i) {
    jalon_field_info x = {sizeof x, 0, 0, 0, 0, 0, 0, 0}, y = x;
    jalon_array_view v, w;
    MUST(jalon_fields_info(a, i, &x));
    MUST(jalon_fields_info(b, i, &y));
    assert_string_equal(x.name, y.name);
    assert_string_equal(x.unit, y.unit);
    assert_string_equal(x.meaning, y.meaning);
    assert_true(x.type == y.type && x.components == y.components && x.count == y.count);
    MUST(jalon_fields_view(a, x.name, &v));
    MUST(jalon_fields_view(b, x.name, &w));
    assert_memory_equal(v.data, w.data, (size_t)(v.count * v.stride_bytes));
  }
}

static void* fields_of(const jalon_cloud* cloud) {
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_fields(cloud, &fields));
  return fields;
}

static void* rich_fields(void) {
  jalon_cloud* cloud = rich_cloud();
  jalon_fields* fields = fields_of(cloud);
  jalon_cloud_release(cloud);
  return fields;
}

static void same_clouds(const jalon_cloud* a, const jalon_cloud* b) {
  jalon_array_view v, w;
  const char *crs = NULL, *other_crs = NULL;
  uint64_t stations = 0, other_stations = 0;
  MUST(jalon_cloud_points(a, &v));
  MUST(jalon_cloud_points(b, &w));
  assert_int_equal(v.count, w.count);
  assert_memory_equal(v.data, w.data, (size_t)v.count * 24);
  MUST(jalon_cloud_crs(a, &crs));
  MUST(jalon_cloud_crs(b, &other_crs));
  assert_string_equal(crs, other_crs);
  MUST(jalon_cloud_station_count(a, &stations));
  MUST(jalon_cloud_station_count(b, &other_stations));
  assert_int_equal(stations, other_stations);
  for (uint64_t i = 0; i < stations; ++i) {
    const char *name = NULL, *other = NULL;
    int32_t has = -1, other_has = -1;
    jalon_transform pose, other_pose;
    uint64_t at[4] = {0};
    MUST(jalon_cloud_station(a, i, &name, &has, &pose, &at[0], &at[1]));
    MUST(jalon_cloud_station(b, i, &other, &other_has, &other_pose, &at[2], &at[3]));
    assert_string_equal(name, other);
    assert_int_equal(has, other_has);
    assert_memory_equal(&pose, &other_pose, sizeof pose);
    assert_true(at[0] == at[2] && at[1] == at[3]);
  }
  jalon_fields *x = fields_of(a), *y = fields_of(b);
  same_fields(x, y);
  jalon_fields_release(x);
  jalon_fields_release(y);
}

/* What a user of a cloud does with it. */
static void look_at_cloud(void* object) {
  const jalon_cloud* cloud = object;
  jalon_box box;
  jalon_cloud* copy = NULL;
  const jalon_transform shift = {{1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}};
  const uint64_t none = 0;
  if (count_of(cloud) > 0) MUST(jalon_cloud_bounds(cloud, &box));
  const jalon_status status = jalon_cloud_transform(cloud, &shift, NULL, &copy);
  assert_true(status == JALON_OK || status == JALON_ERROR_INVALID_ARGUMENT);
  jalon_cloud_release(copy);
  MUST(jalon_cloud_select(cloud, &none, count_of(cloud) > 0, NULL, &copy));
  jalon_cloud_release(copy);
  MUST(jalon_cloud_append(cloud, cloud, NULL, &copy));
  same_clouds(cloud, cloud);
  jalon_cloud_release(copy);
}

static void look_at_fields(void* object) { same_fields(object, object); }

static void* empty_cloud(void) { return cloud_of(NULL, 0); }

KIND_CALLS(cloud, NULL_TASK, NULL_TASK)
KIND_CALLS(fields, NULL_TASK, NULL_TASK)

static const object_kind kCloud = {"cloud",    rich_cloud,    cloud_write,
                                   cloud_read, look_at_cloud, cloud_release};
static const object_kind kEmpty = {"empty cloud", empty_cloud,   cloud_write,
                                   cloud_read,    look_at_cloud, cloud_release};
static const object_kind kFields = {"fields",    rich_fields,    fields_write,
                                    fields_read, look_at_fields, fields_release};

static void cloud__comes_back_bit_by_bit(void** state) {
  (void)state;
  size_t count = 0;
  jalon_cloud *cloud = rich_cloud(), *back = NULL;
  uint8_t* bytes = bytes_of(&kCloud, cloud, &count);
  MUST(jalon_cloud_from_bytes(bytes, count, NULL, &back));
  memset(bytes, 0xee, count); /* they were copied */
  free(bytes);
  same_clouds(cloud, back);
  jalon_cloud_release(back);
  jalon_cloud_release(cloud);
  comes_back(&kCloud);
  comes_back(&kEmpty);
}

static void fields__come_back_bit_by_bit(void** state) {
  (void)state;
  size_t count = 0;
  jalon_fields *fields = rich_fields(), *back = NULL;
  uint8_t* bytes = bytes_of(&kFields, fields, &count);
  MUST(jalon_fields_from_bytes(bytes, count, NULL, &back));
  free(bytes);
  same_fields(fields, back);
  jalon_fields_release(back);
  jalon_fields_release(fields);
  comes_back(&kFields);
}

/* Larger than the pieces that threads take, so that blocks, sums and threads all play. */
static void cloud_bytes__are_the_same_for_any_number_of_threads(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(150000, 7);
  jalon_task* task = NULL;
  uint64_t hash[2] = {0, 0};
  MUST(jalon_task_create(&task));
  for (uint32_t threads = 1; threads <= 3; threads += 2) {
    jalon_bytes* bytes = NULL;
    jalon_array_view view;
    jalon_cloud* back = NULL;
    MUST(jalon_task_set_threads(task, threads));
    MUST(jalon_cloud_to_bytes(cloud, task, &bytes));
    MUST(jalon_bytes_view(bytes, &view));
    assert_true(view.count > 3 * kBytesMiB);
    hash[threads / 2] = hash_bytes(1, view.data, (size_t)view.count);
    MUST(jalon_cloud_from_bytes(view.data, view.count, task, &back));
    same_clouds(cloud, back);
    jalon_cloud_release(back);
    uint8_t* copy = malloc((size_t)view.count);
    memcpy(copy, view.data, (size_t)view.count);
    seal_anew(copy, (size_t)view.count); /* the checksum is the one that the header tells of */
    assert_memory_equal(copy, view.data, (size_t)view.count);
    copy[view.count - 5] ^= 1;
    refused_bytes(&kCloud, copy, (size_t)view.count, JALON_ERROR_FORMAT, "bit near the end", 0);
    free(copy);
    jalon_bytes_release(bytes);
  }
  assert_true(hash[0] == hash[1]);
  MUST(jalon_task_cancel(task));
  jalon_bytes* none = NULL;
  REFUSED(JALON_ERROR_CANCELLED, jalon_cloud_to_bytes(cloud, task, &none));
  assert_null(none);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

static void bytes__outlive_what_they_were_made_from(void** state) {
  (void)state;
  jalon_cloud *cloud = rich_cloud(), *back = NULL;
  jalon_bytes* bytes = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_to_bytes(cloud, NULL, &bytes));
  jalon_cloud_release(cloud);
  assert_ptr_equal(jalon_bytes_retain(bytes), bytes);
  jalon_bytes_release(bytes);
  MUST(jalon_bytes_view(bytes, &view));
  MUST(jalon_cloud_from_bytes(view.data, view.count, NULL, &back));
  assert_int_equal(count_of(back), kPoints);
  jalon_bytes_release(bytes);
  jalon_bytes_release(NULL);
  jalon_cloud_release(back);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_bytes_view(NULL, &view));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_to_bytes(NULL, NULL, &bytes));
}

static void damaged_bytes__are_refused(void** state) {
  (void)state;
  damage_is_told(&kCloud);
  damage_is_told(&kEmpty);
  damage_is_told(&kFields);
}

static void made_up_bytes__are_refused_or_whole(void** state) {
  (void)state;
  const int tries = is_full_run() ? 200000 : is_sanitized() ? 4000 : 20000;
  assert_true(made_up_is_survived(&kCloud, 1, tries) > tries / 4);
  assert_true(made_up_is_survived(&kEmpty, 2, tries / 4) > tries / 16);
  assert_true(made_up_is_survived(&kFields, 3, tries) > tries / 4);
}

static void bytes_of_others__are_told_apart(void** state) {
  (void)state;
  strangers_are_told(&kCloud, &kFields);
  strangers_are_told(&kFields, &kCloud);
}

static void cloud_copy__is_a_cloud_of_its_own(void** state) {
  (void)state;
  jalon_cloud *cloud = rich_cloud(), *copy = NULL;
  const char* crs = NULL;
  jalon_array_view v, w;
  MUST(jalon_cloud_copy(cloud, &copy));
  same_clouds(cloud, copy);
  MUST(jalon_cloud_set_crs(copy, "EPSG:4326"));
  MUST(jalon_cloud_remove_field(copy, "field 3 \xC2\xB5"));
  MUST(jalon_cloud_crs(cloud, &crs));
  assert_int_equal(strncmp(crs, "EPSG:2154", 9), 0);
  jalon_fields* fields = fields_of(cloud);
  MUST(jalon_fields_view(fields, "field 3 \xC2\xB5", &v));
  jalon_fields_release(fields);
  MUST(jalon_cloud_points(cloud, &v));
  MUST(jalon_cloud_points(copy, &w));
  assert_ptr_equal(v.data, w.data); /* shared */
  jalon_cloud_release(cloud);
  assert_int_equal(count_of(copy), kPoints);
  jalon_cloud_release(copy);
  copy = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_copy(NULL, &copy));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(cloud__comes_back_bit_by_bit),
      cmocka_unit_test(fields__come_back_bit_by_bit),
      cmocka_unit_test(cloud_bytes__are_the_same_for_any_number_of_threads),
      cmocka_unit_test(bytes__outlive_what_they_were_made_from),
      cmocka_unit_test(damaged_bytes__are_refused),
      cmocka_unit_test(made_up_bytes__are_refused_or_whole),
      cmocka_unit_test(bytes_of_others__are_told_apart),
      cmocka_unit_test(cloud_copy__is_a_cloud_of_its_own),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
