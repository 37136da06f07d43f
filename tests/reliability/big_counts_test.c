/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* More points than 32 bits count, from a file that is mostly a hole: a point on either side of each edge of a number
 * type stands out and must come through, in its place and alone. By default the edges are those of pieces of half a
 * million points; with JALON_FULL=1 those of 2^31 and 2^32, some minutes of processor. */
#include "support.h"

#include <fcntl.h>
#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
  kHeader = 375,       /* LAS 1.4 */
  kRecord = 20,        /* of point format 0 */
  kFirstMark = 100,    /* intensity */
  kMostHeldMib = 64,   /* on the disk: the rest of the file is a hole */
  kMostMemoryMib = 512 /* the points alone are 96 GiB */
};
static const double kScale_m = 0.01;
static const double kBox[6] = {0.005, -1, -1, 1000, 1, 1}; /* what lies in the hole is at 0, 0, 0 */

typedef struct {
  uint64_t count, marked[8];
  int marks;
} long_file;

static long_file file_about(uint64_t first_edge, uint64_t last_edge) {
  const long_file file = {last_edge + (last_edge >> 12) + 7,
                          {0, first_edge - 1, first_edge, first_edge + 1, last_edge - 1, last_edge,
                           last_edge + 1, last_edge + (last_edge >> 12) + 6},
                          8};
  return file;
}

static void put(unsigned char* to, uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to[i] = (unsigned char)(value >> (8 * i) & 255);
}
static void put_double(unsigned char* to, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  put(to, bits, 8);
}

/* 0 where the disk keeps no holes. */
static int write_holes(const char* path, const long_file* file) {
  unsigned char header[kHeader] = {0}, record[kRecord] = {0};
  struct stat held;
  memcpy(header, "LASF", 4);
  header[24] = 1, header[25] = 4;
  put(header + 94, kHeader, 2), put(header + 96, kHeader, 4), put(header + 105, kRecord, 2);
  for (int axis = 0; axis < 3; ++axis) put_double(header + 131 + 8 * axis, kScale_m);
  put(header + 247, file->count, 8);
  const int disk = open(path, O_CREAT | O_TRUNC | O_WRONLY, 0600);
  assert_true(disk >= 0);
  int fits = ftruncate(disk, (off_t)(kHeader + file->count * kRecord)) == 0 &&
             pwrite(disk, header, kHeader, 0) == kHeader;
  for (int k = 0; fits && k < file->marks; ++k) {
    put(record, (uint64_t)k + 1, 4),
        put(record + 12, (uint64_t)kFirstMark + (uint64_t)k, 2); /* x, intensity */
    fits = pwrite(disk, record, kRecord, (off_t)(kHeader + file->marked[k] * kRecord)) == kRecord;
  }
  fits = fits && fstat(disk, &held) == 0 && held.st_blocks <= kMostHeldMib * 2048;
  close(disk);
  return fits;
}

static void expect_marks(const char* path, const long_file* file) {
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = NULL;
  jalon_array_view xyz, intensity;
  MUST(jalon_cloud_read(path, NULL, NULL, &cloud));
  assert_int_equal(count_of(cloud), file->marks);
  MUST(jalon_cloud_points(cloud, &xyz));
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_view(fields, "intensity", &intensity));
  assert_int_equal(intensity.type, JALON_UINT16);
  for (int k = 0; k < file->marks; ++k) {
    const double x = ((const double*)xyz.data)[3 * k];
    const int mark = ((const uint16_t*)intensity.data)[k];
    if (fabs(x - kScale_m * (k + 1)) > kScale_m / 4 || mark != kFirstMark + k)
      fail_msg("point %d, number %llu of the file, is at %g, of intensity %d", k,
               (unsigned long long)file->marked[k], x, mark);
  }
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

/* Piece by piece from file to file, of which a box leaves the points that stand out. */
static void counts__beyond_32_bits_go_through_whole(void** state) {
  const uint64_t edge = is_full_run() ? (uint64_t)1 << 31 : (uint64_t)1 << 19;
  const long_file file = file_about(edge, 2 * edge);
  char from[512], to[512];
  jalon_params* options = NULL;
  jalon_task* task = NULL;
  uint64_t written = 0, peak = 0;
  (void)state;
  snprintf(from, sizeof from, "%s", temporary("long.las"));
  snprintf(to, sizeof to, "%s", temporary("marked.las"));
  const int fits = write_holes(from, &file);
  if (!fits) {
    remove(from);
    skip();
  }
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_memory_limit(task, (uint64_t)kMostMemoryMib << 20));
  MUST(jalon_params_create("convert", &options));
  MUST(jalon_params_set_doubles(options, "box", kBox, 6));
  MUST(jalon_params_set_string(options, "fields", "intensity"));
  const jalon_status status = jalon_cloud_convert(from, to, options, task, &written);
  remove(from);
  if (status != JALON_OK) fail_msg("%s", jalon_last_error_message());
  assert_int_equal(written, file.marks);
  expect_marks(to, &file);
  remove(to);
  MUST(jalon_task_memory_peak(task, &peak));
  assert_true(peak > 0);
  printf("FIGURE big counts: %llu points, %d of them about 2^%d and 2^%d found, %llu MiB in use\n",
         (unsigned long long)file.count, file.marks, is_full_run() ? 31 : 19,
         is_full_run() ? 32 : 20, (unsigned long long)(peak >> 20));
  jalon_params_release(options);
  jalon_task_release(task);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(counts__beyond_32_bits_go_through_whole)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
