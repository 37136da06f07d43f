/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* What small files tell of themselves is not believed before it is there: counts up to 2^64 - 1 in files of a
 * kilobyte, and texts without end. Memory is what the task counts. */
#include "lying_files.h"

enum { kMiB = 1 << 20, kBombBytes = 3 << 20, kDepth = 200000 };
static jalon_task* task;
static int refused, accepted;
static uint64_t good_peak; /* of the file before it lies */

/* The most that reading had in use; either it is refused in one line, or it is read. */
static uint64_t peak_of_reading(const char* path, const char* what, int as_model) {
  uint64_t peak = 0;
  jalon_cloud* cloud = NULL;
  jalon_model* model = NULL;
  const jalon_status status = as_model ? jalon_model_read(path, NULL, task, &model)
                                       : jalon_cloud_read(path, NULL, task, &cloud);
  if (status != JALON_OK) expect_one_line();
  if (status == JALON_ERROR_INTERNAL || status == JALON_ERROR_OUT_OF_MEMORY)
    fail_msg("%s: %s", what, jalon_last_error_message());
  refused += status != JALON_OK, accepted += status == JALON_OK;
  jalon_cloud_release(cloud);
  jalon_model_release(model);
  MUST(jalon_task_memory_peak(task, &peak));
  return peak;
}

static void expect_little(const char* extension, const char* lie, content c, int as_model) {
  char path[560], what[160];
  snprintf(path, sizeof path, "%s.%s", temporary("lie"), extension);
  snprintf(what, sizeof what, "%s: %s", extension, lie);
  write_file(path, c.bytes, c.count);
  assert_true(c.count < 8192);
  const int before = accepted;
  const uint64_t peak = peak_of_reading(path, what, as_model);
  remove(path);
  /* A number that nobody needs may be wrong; the file then takes what it takes with the right one. */
  if (peak >= kMiB + (accepted != before ? good_peak : 0))
    fail_msg("%s takes %d KiB", what, (int)(peak >> 10));
}

static content good_scan(const char* extension, uint64_t points) {
  char path[560];
  snprintf(path, sizeof path, "%s.%s", temporary("good"), extension);
  const content c = good_file(path, points);
  const int refused_before = refused;
  good_peak = c.bytes != NULL ? peak_of_reading(path, extension, 0) : 0;
  assert_int_equal(refused, refused_before);
  remove(path);
  return c;
}

static const uint64_t lies[] = {
    UINT64_MAX,        UINT64_MAX - 1,    (uint64_t)1 << 63, ((uint64_t)1 << 63) - 1,
    (uint64_t)1 << 61, (uint64_t)1 << 32, UINT32_MAX,        (uint64_t)1 << 31,
    INT32_MAX,         123456789};
enum { kLies = sizeof lies / sizeof *lies };

static void lie_in_numbers(const char* extension, size_t at, size_t bytes, const char* field) {
  content c = good_scan(extension, 20);
  for (int i = 0; i < kLies && c.bytes != NULL; ++i) {
    put_number(c, at, lies[i], bytes);
    expect_little(extension, field, c, 0);
  }
  free(c.bytes);
}

static void lie_in_text(const char* extension, const char* key, char end) {
  content c = good_scan(extension, 20);
  for (int i = 0; i < kLies && c.bytes != NULL; ++i) {
    char text[32];
    snprintf(text, sizeof text, "%llu", (unsigned long long)lies[i]);
    content lying =
        strcmp(extension, "e57") == 0 ? with_xml(c, key, text) : with_text(c, key, end, text);
    expect_little(extension, key, lying, 0);
    free(lying.bytes);
  }
  free(c.bytes);
}

/* So that what refuses the lies below is not the way in which they are written. */
static void tell_the_truth_in_xml(void) {
  content c = good_scan("e57", 20);
  if (c.bytes == NULL) return;
  content same = with_xml(c, "recordCount=\"", "20");
  const int before = accepted;
  expect_little("e57", "nothing", same, 0);
  assert_int_equal(accepted, before + 1);
  free(same.bytes);
  free(c.bytes);
}

static void counts__that_lie_take_less_than_a_mebibyte(void** state) {
  (void)state;
  refused = accepted = 0;
  for (int packed = 0; packed < 2; ++packed) {
    const char* extension = packed ? "laz" : "las";
    lie_in_numbers(extension, 107, 4, "points");
    lie_in_numbers(extension, 96, 4, "offset of the points");
    lie_in_numbers(extension, 100, 4, "records");
    lie_in_numbers(extension, 94, 2, "header's size");
    lie_in_numbers(extension, 105, 2, "length of a point");
  }
  lie_in_numbers("copc.laz", 247, 8, "points");
  lie_in_numbers("copc.laz", 235, 8, "first extended record");
  lie_in_numbers("copc.laz", 243, 4, "extended records");
  lie_in_numbers("copc.laz", 375 + 40, 8, "root's hierarchy");
  lie_in_numbers("copc.laz", 375 + 48, 8, "hierarchy's size");
  lie_in_numbers("e57", 24, 8, "place of the XML");
  lie_in_numbers("e57", 32, 8, "length of the XML");
  lie_in_numbers("e57", 40, 8, "size of a page");
  tell_the_truth_in_xml();
  lie_in_text("e57", "recordCount=\"", '"');
  lie_in_text("e57", "fileOffset=\"", '"');
  lie_in_text("ply", "element vertex ", '\n');
  lie_in_text("pcd", "POINTS ", '\n');
  lie_in_text("pcd", "WIDTH ", '\n');
  lie_in_text("pcd", "HEIGHT ", '\n');
  lie_in_text("pcd", "COUNT ", '\n');
  lie_in_text("pts", "", '\n');
  for (int i = 0; i < kLies; ++i) {
    char text[400];
    content c = {text, 0};
    for (int field = 0; field < 2; ++field) {
      c.count = (size_t)snprintf(
          text, sizeof text,
          "%llu\n%llu\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n",
          (unsigned long long)(field == 0 ? lies[i] : 1),
          (unsigned long long)(field == 1 ? lies[i] : 1));
      expect_little("ptx", "grid", c, 0);
    }
    char stl[134] = {0};
    content mesh = {stl, sizeof stl};
    put_number(mesh, 80, lies[i], 4);
    expect_little("stl", "triangles", mesh, 1);
    c.count =
        (size_t)snprintf(text, sizeof text,
                         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                         "float y\nproperty float z\n"
                         "element face %llu\nproperty list uint64 int "
                         "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n%llu 0 1 2\n",
                         (unsigned long long)lies[i], (unsigned long long)lies[(i + 3) % kLies]);
    expect_little("ply", "faces", c, 1);
    c.count = (size_t)snprintf(text, sizeof text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 %llu\n",
                               (unsigned long long)lies[i]);
    expect_little("obj", "a corner's number", c, 1);
    c.count =
        (size_t)snprintf(text, sizeof text,
                         "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[1,1,"
                         "1],\"translate\":[0,0,0]},\"vertices\":[[0,0,0]],"
                         "\"CityObjects\":{\"a\":{\"type\":\"Building\",\"geometry\":[{\"type\":"
                         "\"MultiSurface\",\"lod\":\"2\",\"boundaries\":[[[0,%llu,0]]]}]}}}",
                         (unsigned long long)lies[i]);
    expect_little("city.json", "a vertex' number", c, 1);
  }
  printf("FIGURE lying counts: %d refused, %d accepted, each with less than 1 MiB\n", refused,
         accepted);
  assert_true(refused > 150);
}

/* A file of one token, or of brackets, between a head and nothing. */
static void bomb(const char* extension, const char* head, const char* unit, size_t units,
                 int as_model) {
  const size_t length = strlen(unit), start = strlen(head);
  char path[560], what[80];
  content c = {malloc(start + length * units + 1), start + length * units};
  assert_non_null(c.bytes);
  memcpy(c.bytes, head, start);
  for (size_t i = 0; i < units; ++i) memcpy(c.bytes + start + i * length, unit, length);
  snprintf(path, sizeof path, "%s.%s", temporary("bomb"), extension);
  snprintf(what, sizeof what, "%s: %.20s... %zu x \"%s\"", extension, head, units, unit);
  write_file(path, c.bytes, c.count);
  const int before = accepted;
  const uint64_t peak = peak_of_reading(path, what, as_model);
  if (accepted != before) fail_msg("%s was read", what);
  if (peak > 4 * c.count + 64 * (uint64_t)kMiB)
    fail_msg("%s takes %d MiB", what, (int)(peak >> 20));
  remove(path);
  free(c.bytes);
}

static const char city_head[] =
    "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[1,1,1],\"translate\":[0,"
    "0,0]},\"vertices\":[],\"CityObjects\":";
static const char pcd_head[] =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT "
    "1\nPOINTS 1\nDATA ascii\n";
static const char ply_head[] =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
    "z\n";

static void texts__without_end_are_refused(void** state) {
  (void)state;
  refused = accepted = 0;
  bomb("xyz", "", "9", kBombBytes, 0);
  bomb("xyz", "1 2 ", "7", kBombBytes, 0);
  bomb("xyz", "", "x", kBombBytes, 0);
  bomb("csv", "x,y,z\n", "1,", kBombBytes / 2, 0);
  bomb("csv", "x,y,z\n1,2,\"", "a", kBombBytes, 0);
  bomb("csv", "", "a,", kBombBytes / 2, 0);
  bomb("pts", "", "1", kBombBytes, 0);
  bomb("pts", "1\n", "1", kBombBytes, 0);
  bomb("ptx", "", "1", kBombBytes, 0);
  bomb("ptx", "1\n1\n0 0 0\n", "1", kBombBytes, 0);
  bomb("pcd", "", "# .PCD ", kBombBytes / 7, 0);
  bomb("pcd", pcd_head, "1", kBombBytes, 0);
  bomb("pcd", "# .PCD v0.7\nVERSION 0.7\nFIELDS ", "x ", kBombBytes / 2, 0);
  bomb("ply", "ply\nformat ascii 1.0\ncomment ", "a", kBombBytes, 0);
  bomb("ply", ply_head, "property float a\n", kBombBytes / 17, 0);
  bomb("ply", "ply\nformat ascii 1.0\nelement ", "vertex", kBombBytes / 6, 0);
  bomb("obj", "v 0 0 ", "0", kBombBytes, 1);
  bomb("obj", "f ", "1 ", kBombBytes / 2, 1);
  bomb("stl", "solid ", "a", kBombBytes, 1);
  bomb("stl", "solid a\nfacet normal 0 0 ", "1", kBombBytes, 1);
  bomb("dxf", "0\n", "SECTION", kBombBytes / 7, 1);
  bomb("dxf", "0\nSECTION\n2\n", "ENTITIES", kBombBytes / 8, 1);
  bomb("city.json", city_head, "{\"a\":", kDepth, 1);
  bomb("city.json", city_head, "[", kDepth, 1);
  bomb("city.json", "", "[", kDepth, 1);
  bomb("city.json", "{\"", "a", kBombBytes, 1);
  bomb("city.json", "{\"type\":", "1", kBombBytes, 1);
  printf("FIGURE text bombs: %d refused\n", refused);
  assert_true(refused >= 20);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(counts__that_lie_take_less_than_a_mebibyte),
      cmocka_unit_test(texts__without_end_are_refused),
  };
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 1));
  if (jalon_task_set_memory_limit(task, UINT64_MAX) != JALON_OK) {
    printf("skipped: memory is not counted here\n");
    return 77;
  }
  const int failed = cmocka_run_group_tests_name("lying_counts", tests, NULL, NULL);
  jalon_task_release(task);
  return failed;
}
