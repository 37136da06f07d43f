/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* Drawn clouds through each format that holds clouds and back: coordinates within half a step, fields and CRS as
 * they were. */
#include <math.h>

#include "support.h"

enum { kRounds = 40, kLongRounds = 1000, kMostPoints = 60, kMostFields = 4, kTypes = 10 };

typedef struct {
  const char* extension;
  double step_m;    /* of coordinates by default; 0 = doubles */
  int keeps_order;  /* else the points come back by "id" */
  int keeps_fields; /* of any name; else intensity and colours alone */
  int keeps_crs;
} kept;

static const kept formats[] = {
    {"las", 1e-4, 1, 1, 1}, {"laz", 1e-4, 1, 1, 1}, {"copc.laz", 1e-4, 0, 1, 1},
    {"e57", 0, 1, 1, 1},    {"ply", 0, 1, 1, 0},    {"pcd", 0, 1, 1, 0},
    {"xyz", 0, 1, 1, 0},    {"csv", 0, 1, 1, 0},    {"pts", 0, 1, 0, 0},
};
static const char* const crs_texts[] = {
    "", "EPSG:2154", "EPSG:25832",
    "PROJCS[\"RGF93\",GEOGCS[\"g\",UNIT[\"degree\",0.01745]],UNIT[\"metre\",1]]"};
static const int32_t types[kTypes] = {JALON_INT8,    JALON_UINT8,  JALON_INT16, JALON_UINT16,
                                      JALON_INT32,   JALON_UINT32, JALON_INT64, JALON_UINT64,
                                      JALON_FLOAT32, JALON_FLOAT64};

typedef struct {
  uint64_t seed, next, n;
  double xyz[3 * kMostPoints];
  double field[kMostFields][kMostPoints];
  int32_t type[kMostFields];
  int fields;
  const char* crs;
} drawing;

static double drawn(drawing* d) { return uniform(d->seed, d->next++); }

/* A value that the type holds, its ends among them. */
static double value_of(drawing* d, int32_t type) {
  const double a = drawn(d), end = drawn(d);
  static const double bits[] = {7, 8, 15, 16, 31, 32, 50, 50};
  for (int k = 0; k < 8; ++k)
    if (types[k] == type) {
      const double size = ldexp(1, (int)bits[k]), least = k % 2 == 0 ? -size : 0;
      return end < 0.1 ? least : end < 0.2 ? size - 1 : floor(least + a * (size - least));
    }
  const double value = (a - 0.5) * pow(10, 12 * end - 6);
  return type == JALON_FLOAT32 ? (double)(float)value : value;
}

static void draw_cloud(drawing* d, uint64_t seed) {
  memset(d, 0, sizeof *d);
  d->seed = seed;
  d->n = 1 + (uint64_t)(drawn(d) * kMostPoints);
  d->crs = crs_texts[seed % 4];
  const double size = pow(10, 5 * drawn(d) - 1), east = seed % 3 == 0 ? 652381 : 0,
               north = seed % 3 == 0 ? 6862047 : 0;
  for (uint64_t i = 0; i < d->n; ++i) {
    d->xyz[3 * i] = size * (drawn(d) - 0.5) + east;
    d->xyz[3 * i + 1] = size * (drawn(d) - 0.5) + north;
    d->xyz[3 * i + 2] = 0.1 * size * (drawn(d) - 0.5);
  }
  d->fields = (int)(drawn(d) * (kMostFields + 1));
  for (int f = 0; f < d->fields; ++f) {
    d->type[f] = types[(int)(drawn(d) * kTypes)];
    for (uint64_t i = 0; i < d->n; ++i) d->field[f][i] = value_of(d, d->type[f]);
  }
}

static const char* field_name(int f) {
  static const char* const names[kMostFields] = {"height_a", "class_b", "c", "grade_d"};
  return names[f];
}

static void set_field(jalon_cloud* cloud, const char* name, int32_t type, const double* values,
                      uint64_t n) {
  unsigned char cells[kMostPoints * 8];
  for (uint64_t i = 0; i < n; ++i) {
    const double v = values[i];
    switch (type) {
      case JALON_INT8:
        ((int8_t*)cells)[i] = (int8_t)v;
        break;
      case JALON_UINT8:
        ((uint8_t*)cells)[i] = (uint8_t)v;
        break;
      case JALON_INT16:
        ((int16_t*)cells)[i] = (int16_t)v;
        break;
      case JALON_UINT16:
        ((uint16_t*)cells)[i] = (uint16_t)v;
        break;
      case JALON_INT32:
        ((int32_t*)cells)[i] = (int32_t)v;
        break;
      case JALON_UINT32:
        ((uint32_t*)cells)[i] = (uint32_t)v;
        break;
      case JALON_INT64:
        ((int64_t*)cells)[i] = (int64_t)v;
        break;
      case JALON_UINT64:
        ((uint64_t*)cells)[i] = (uint64_t)v;
        break;
      case JALON_FLOAT32:
        ((float*)cells)[i] = (float)v;
        break;
      default:
        ((double*)cells)[i] = v;
        break;
    }
  }
  MUST(jalon_cloud_set_field(cloud, name, cells, type, 1, n, 0, NULL, NULL));
}

static jalon_cloud* cloud_of_drawing(const drawing* d, const kept* format) {
  jalon_cloud* cloud = cloud_of(d->xyz, d->n);
  double numbers[kMostPoints], grey[kMostPoints];
  for (uint64_t i = 0; i < d->n; ++i) {
    numbers[i] = (double)i;
    grey[i] = floor(255 * uniform(d->seed, 100000 + i));
  }
  if (format->keeps_fields) set_field(cloud, "id", JALON_UINT32, numbers, d->n);
  set_field(cloud, "red", JALON_UINT8, grey, d->n);
  set_field(cloud, "green", JALON_UINT8, grey, d->n);
  set_field(cloud, "blue", JALON_UINT8, numbers, d->n);
  for (int f = 0; f < d->fields && format->keeps_fields; ++f)
    set_field(cloud, field_name(f), d->type[f], d->field[f], d->n);
  MUST(jalon_cloud_set_crs(cloud, d->crs));
  return cloud;
}

static void field_of(const jalon_fields* fields, const char* name, const char* where,
                     double* values, uint64_t n) {
  const jalon_status status = jalon_fields_copy(fields, name, JALON_FLOAT64, values, n);
  if (status != JALON_OK) fail_msg("%s: %s", where, jalon_last_error_message());
}

static void expect_same(const drawing* d, const kept* format, const jalon_cloud* back) {
  char where[80];
  double xyz[3 * kMostPoints], numbers[kMostPoints], values[kMostPoints];
  jalon_array_view view;
  jalon_fields* fields = NULL;
  snprintf(where, sizeof where, "%s, seed %d", format->extension, (int)d->seed);
  if (count_of(back) != d->n)
    fail_msg("%s: %d points of %d", where, (int)count_of(back), (int)d->n);
  MUST(jalon_cloud_points(back, &view));
  memcpy(xyz, view.data, (size_t)d->n * 24);
  MUST(jalon_cloud_fields(back, &fields));
  for (uint64_t i = 0; i < d->n; ++i) numbers[i] = (double)i;
  if (!format->keeps_order) field_of(fields, "id", where, numbers, d->n);
  for (uint64_t i = 0; i < d->n; ++i) {
    const uint64_t own = (uint64_t)numbers[i];
    for (int k = 0; k < 3; ++k) {
      const double was = d->xyz[3 * own + (uint64_t)k];
      if (!(fabs(xyz[3 * i + (uint64_t)k] - was) <=
            0.5 * format->step_m * (1 + 1e-9) + (format->step_m > 0 ? 2e-9 : 0)))
        fail_msg("%s: %.17g became %.17g", where, was, xyz[3 * i + (uint64_t)k]);
    }
  }
  field_of(fields, "blue", where, values, d->n);
  for (uint64_t i = 0; i < d->n; ++i) assert_true(values[i] == numbers[i]);
  for (int f = 0; f < d->fields && format->keeps_fields; ++f) {
    field_of(fields, field_name(f), where, values, d->n);
    for (uint64_t i = 0; i < d->n; ++i) {
      const double was = d->field[f][(uint64_t)numbers[i]];
      /* Text tells no types: a float32 in as few digits as name it may come back as the double of these digits. */
      const int same =
          d->type[f] == JALON_FLOAT32 ? (float)values[i] == (float)was : values[i] == was;
      if (!same)
        fail_msg("%s: field %s of type %d, %.17g became %.17g", where, field_name(f),
                 (int)d->type[f], was, values[i]);
    }
  }
  if (format->keeps_crs) {
    const char* crs = NULL;
    MUST(jalon_cloud_crs(back, &crs));
    if (strcmp(crs, d->crs) != 0) fail_msg("%s: CRS \"%s\" became \"%s\"", where, d->crs, crs);
  }
  jalon_fields_release(fields);
}

static void round_trips__of_drawn_clouds_keep_what_each_format_promises(void** state) {
  (void)state;
  const int rounds = getenv("JALON_FULL") != NULL ? kLongRounds : kRounds;
  char path[560];
  int formats_done = 0;
  for (size_t f = 0; f < sizeof formats / sizeof *formats; ++f) {
    snprintf(path, sizeof path, "%s.%s", temporary("trip"), formats[f].extension);
    int trips = 0;
    for (; trips < rounds; ++trips) {
      drawing d;
      draw_cloud(&d, (uint64_t)trips + 1);
      jalon_cloud *cloud = cloud_of_drawing(&d, &formats[f]), *back = NULL;
      const jalon_status status = jalon_cloud_write(cloud, path, NULL, NULL);
      jalon_cloud_release(cloud);
      if (status == JALON_ERROR_UNSUPPORTED) break; /* a library without its Rust component */
      if (status != JALON_OK)
        fail_msg("%s, seed %d: %s", formats[f].extension, (int)d.seed, jalon_last_error_message());
      MUST(jalon_cloud_read(path, NULL, NULL, &back));
      expect_same(&d, &formats[f], back);
      jalon_cloud_release(back);
    }
    formats_done += trips == rounds;
    remove(path);
  }
  printf("FIGURE round trips: %d clouds through each of %d formats\n", rounds, formats_done);
  assert_true(formats_done >= 6);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(round_trips__of_drawn_clouds_keep_what_each_format_promises),
  };
  return cmocka_run_group_tests_name("round_trips", tests, NULL, NULL);
}
