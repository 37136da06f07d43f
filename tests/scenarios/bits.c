/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Same bits: one line a result, "name hash". bits.sh runs it with several numbers of threads and instruction sets and
 * compares.
 *   bits THREADS    hashes of every operation on seeded data
 *   bits --grid     the same scene at the origin and on the national grid: identical bits, or close (prints its own
 *   verdicts) */
#define JALON_TEST_PLAIN_PROGRAM
#include "bits_segments.h"

#include <math.h>

enum { kPoints = 30000, kNear = 8, kSeeds = 2, kLongSeeds = 5 };
static const double kEast = 652000, kNorth = 6861000;

static jalon_task* task_of(uint32_t threads) {
  jalon_task* task;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, threads));
  return task;
}

static uint64_t hash_file(const char* name) {
  size_t bytes = 0;
  char* content = content_of(temporary(name), &bytes);
  assert_true(content != NULL && bytes > 0);
  const uint64_t hash = hash_bytes(kStart, content, bytes);
  free(content);
  remove(temporary(name));
  return hash;
}

static void search(const jalon_cloud* cloud, uint64_t seed, jalon_task* task) {
  static uint32_t near[kPoints * kNear];
  static float distances[kPoints * kNear];
  static uint64_t some[2000 * kNear];
  static double some_distances[2000 * kNear];
  jalon_array_view xyz;
  jalon_fields* fields;
  MUST(jalon_cloud_points(cloud, &xyz));
  MUST(jalon_cloud_knn_all(cloud, kNear, task, near, distances));
  tell("knn_all", seed,
       hash_bytes(hash_bytes(kStart, near, sizeof near), distances, sizeof distances));
  MUST(jalon_cloud_knn(cloud, xyz.data, JALON_FLOAT64, 2000, 0, kNear, JALON_LEVEL_AUTOMATIC, task,
                       some, some_distances));
  tell("knn", seed,
       hash_bytes(hash_bytes(kStart, some, sizeof some), some_distances, sizeof some_distances));
  MUST(jalon_cloud_cells(cloud, 6, task, &fields));
  tell("cells", seed, hash_and_release(fields));
  MUST(jalon_cloud_order(cloud, task, &fields));
  tell("order", seed, hash_and_release(fields));
}

static void triangulated(const jalon_cloud* cloud, uint64_t seed, jalon_task* task) {
  made out = {NULL, NULL, NULL};
  MUST(change(cloud, task, &out, jalon_cloud_compute_normals, "normals",
              "{\"method\": \"triangulation\"}"));
  tell("normals triangulation", seed, hash_made(&out));
  release_made(&out);
}

static void statistics(const jalon_cloud* cloud, uint64_t seed, jalon_task* task) {
  jalon_vec3 centroid;
  double covariance[9], moment;
  MUST(jalon_cloud_covariance(cloud, task, &centroid, covariance));
  MUST(jalon_cloud_moment(cloud, 1, 0, 3, 1, task, &moment));
  uint64_t hash = hash_bytes(kStart, &centroid, sizeof centroid);
  hash = hash_bytes(hash, covariance, sizeof covariance);
  tell("covariance and moment", seed, hash_bytes(hash, &moment, sizeof moment));
}

static void model_and_files(const jalon_cloud* cloud, uint64_t seed, jalon_task* task) {
  made out = {NULL, NULL, NULL};
  jalon_modeller* modeller;
  jalon_model* model;
  jalon_fields* fields;
  MUST(op_segment(cloud, task, &out));
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_modeller_run(modeller, cloud, out.segmentation, task, &model));
  MUST(jalon_model_vertices(model, &fields));
  tell("model vertices", seed, hash_and_release(fields));
  MUST(jalon_model_faces(model, &fields));
  tell("model faces", seed, hash_and_release(fields));
  MUST(jalon_model_write(model, temporary("m.obj"), NULL, task));
  tell("model.obj", seed, hash_file("m.obj"));
  MUST(jalon_model_write(model, temporary("m.dxf"), NULL, task));
  tell("model.dxf", seed, hash_file("m.dxf"));
  MUST(jalon_model_write(model, temporary("m.city.json"), NULL, task));
  tell("model.city.json", seed, hash_file("m.city.json"));
  MUST(jalon_report_write_elevation(out.segmentation, model, temporary("e.svg"), NULL, task));
  tell("elevation.svg", seed, hash_file("e.svg"));
  MUST(jalon_report_write_orthoimage(out.segmentation, model, temporary("o.png"), NULL, task));
  tell("orthoimage.png", seed, hash_file("o.png"));
  MUST(jalon_segmentation_cloud(out.segmentation, &out.cloud));
  MUST(jalon_cloud_write(out.cloud, temporary("s.las"), NULL, task));
  tell("segments.las", seed, hash_file("s.las"));
  MUST(jalon_cloud_write(out.cloud, temporary("s.ply"), NULL, task));
  tell("segments.ply", seed, hash_file("s.ply"));
  MUST(jalon_cloud_write(out.cloud, temporary("s.xyz"), NULL, task));
  jalon_cloud* back;
  MUST(jalon_cloud_read(temporary("s.xyz"), NULL, task, &back));
  tell("text there and back", seed, hash_cloud(kStart, back));
  tell("segments.xyz", seed, hash_file("s.xyz"));
  jalon_cloud_release(back);
  jalon_model_evaluation* judged;
  MUST(jalon_model_evaluate(model, model, NULL, task, &judged));
  MUST(jalon_model_evaluation_pairs(judged, &fields));
  tell("model evaluation pairs", seed, hash_and_release(fields));
  MUST(jalon_model_evaluation_totals(judged, &fields));
  tell("model evaluation totals", seed, hash_and_release(fields));
  jalon_model_evaluation_release(judged);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_run(modeller, cloud, out.segmentation, task, &model));
  MUST(jalon_model_vertices(model, &fields));
  tell("facade vertices", seed, hash_and_release(fields));
  MUST(jalon_model_corners(model, &fields));
  tell("facade corners", seed, hash_and_release(fields));
  MUST(jalon_model_parts(model, &fields));
  tell("facade parts", seed, hash_and_release(fields));
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_made(&out);
}

static void evaluation(const jalon_cloud* cloud, uint64_t seed, jalon_task* task) {
  made found = {NULL, NULL, NULL}, grown = {NULL, NULL, NULL};
  jalon_evaluation* evaluation;
  jalon_cloud* labelled;
  jalon_fields *fields, *totals;
  MUST(op_segment(cloud, task, &found));
  MUST(op_grow(cloud, task, &grown));
  MUST(
      jalon_segmentation_evaluate(found.segmentation, grown.segmentation, NULL, task, &evaluation));
  MUST(jalon_evaluation_pairs(evaluation, &fields));
  tell("evaluation pairs", seed, hash_and_release(fields));
  MUST(jalon_evaluation_totals(evaluation, &fields));
  tell("evaluation totals", seed, hash_and_release(fields));
  MUST(jalon_segmentation_cloud(found.segmentation, &labelled));
  MUST(jalon_cloud_confusion(labelled, "label", "orientation", NULL, task, &fields, &totals));
  tell("confusion", seed, hash_and_release(fields));
  tell("confusion totals", seed, hash_and_release(totals));
  MUST(jalon_report_write_picture(found.segmentation, temporary("p.svg"), NULL, task));
  tell("segments.svg", seed, hash_file("p.svg"));
  jalon_cloud_release(labelled);
  jalon_evaluation_release(evaluation);
  release_made(&found);
  release_made(&grown);
}

/* A scan of a scene by a method, with these parameters besides the seed, and its true planes. */
static void scan(const char* name, const char* scene_name, const char* method, const char* more,
                 uint64_t seed, jalon_task* task) {
  jalon_scanner* scanner;
  jalon_params *params, *options;
  jalon_model* scene;
  jalon_cloud* cloud;
  jalon_fields* truth;
  char json[600];
  const jalon_transform pose = {{1, 0, 0, 11, 0, 1, 0, -12, 0, 0, 1, 1.7}};
  snprintf(json, sizeof json, "{\"seed\": %llu, %s}", (unsigned long long)seed, more);
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", scene_name));
  MUST(jalon_scene_create(options, task, &scene));
  MUST(jalon_scanner_create(method, &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_from_json(params, json));
  if (method == NULL) MUST(jalon_scanner_add_station(scanner, "tripod", &pose));
  MUST(jalon_scanner_run(scanner, scene, task, &cloud));
  assert_true(count_of(cloud) > 1000);
  MUST(jalon_scanner_truth(scanner, scene, cloud, task, &truth));
  tell(name, seed, hash_fields(hash_cloud(kStart, cloud), truth));
  jalon_fields_release(truth);
  jalon_cloud_release(cloud);
  jalon_model_release(scene);
  jalon_params_release(params);
  jalon_params_release(options);
  jalon_scanner_release(scanner);
}

static void scans(uint64_t seed, jalon_task* task) {
  scan("virtual scan", "facade", NULL, "\"horizontal_step_rad\": 0.01, \"vertical_step_rad\": 0.01",
       seed, task);
  scan("virtual scan, all effects", "unwanted", NULL,
       "\"horizontal_step_rad\": 0.01, \"vertical_step_rad\": 0.01, \"instrument\": \"gx\", "
       "\"misfit_shift_m\": 0.004, "
       "\"misfit_rotation_rad\": 0.0001, \"glass_return_min\": 0.05, \"glass_return_max\": 0.3, "
       "\"outliers\": 0.02, "
       "\"dropout\": 0.01, \"spacing_m\": 0.05, \"max_points\": 5000",
       seed, task);
  scan("virtual samples", "lycee", "sample", "\"points\": 20000, \"outliers\": 0.01", seed, task);
}

static int print_hashes(uint32_t threads) {
  jalon_task* task = task_of(threads);
  const uint64_t seeds = is_full_run() ? kLongSeeds : kSeeds;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    jalon_cloud* cloud = street_cloud(kPoints, seed);
    for (int i = 0; i < kOperationCount; ++i) {
      made out = {NULL, NULL, NULL};
      MUST(kOperations[i].run(cloud, task, &out));
      tell(kOperations[i].name, seed, hash_made(&out));
      release_made(&out);
    }
    search(cloud, seed, task);
    triangulated(cloud, seed, task);
    statistics(cloud, seed, task);
    model_and_files(cloud, seed, task);
    evaluation(cloud, seed, task);
    scans(seed, task);
    segmenters(seed, task);
    picks(seed, task);
    if (seed == 1) every_scene(seed, task);
    jalon_cloud_release(cloud);
  }
  jalon_task_release(task);
  return 0;
}

/* ---- the national grid ---- */

static int passed, failed;

static void verdict(int good, const char* name) {
  printf("%s - grid: %s\n", good ? "ok" : "not ok", name);
  good ? ++passed : ++failed;
}

static double* shifted_points(double east, double north, int on_the_grid) {
  double* xyz = malloc(sizeof(double) * 3 * kPoints);
  street_points(xyz, kPoints, 21, 0, 0);
  for (int i = 0; i < kPoints; ++i) {
    /* Off the grid: a third of a grid step is no dyadic number, so the sum is rounded. */
    xyz[3 * i] += east + (on_the_grid ? 0 : 0x1p-20 / 3);
    xyz[3 * i + 1] += north + (on_the_grid ? 0 : 0x1p-20 / 3);
  }
  return xyz;
}

/* The largest difference of two (n, 3) columns after the shift is taken off the second. */
static double distance_apart(const jalon_array_view* a, const jalon_array_view* b, double east,
                             double north) {
  const double shift[3] = {east, north, 0};
  double worst = 0;
  if (a->count != b->count) return INFINITY;
  for (uint64_t i = 0; i < a->count; ++i)
    for (int c = 0; c < 3; ++c) {
      const double x = ((const double*)((const char*)a->data + i * a->stride_bytes))[c];
      const double y = ((const double*)((const char*)b->data + i * b->stride_bytes))[c] - shift[c];
      worst = fmax(worst, fabs(x - y));
    }
  return worst;
}

/* How far plane b lies from plane a, measured at its centroid along the normal: what a label more or less may
 * change. */
static double planes_apart(const jalon_fields* a, const jalon_fields* b, double east,
                           double north) {
  const double shift[3] = {east, north, 0};
  jalon_array_view normals, p, q;
  double worst = 0;
  MUST(jalon_fields_view(a, "normal", &normals));
  MUST(jalon_fields_view(a, "centroid", &p));
  MUST(jalon_fields_view(b, "centroid", &q));
  if (p.count != q.count) return INFINITY;
  for (uint64_t i = 0; i < p.count; ++i) {
    double apart = 0;
    for (int c = 0; c < 3; ++c)
      apart += ((const double*)normals.data)[3 * i + c] *
               (((const double*)q.data)[3 * i + c] - shift[c] - ((const double*)p.data)[3 * i + c]);
    worst = fmax(worst, fabs(apart));
  }
  return worst;
}

static double clouds_apart(const jalon_cloud* a, const jalon_cloud* b, double east, double north) {
  jalon_array_view p, q;
  MUST(jalon_cloud_points(a, &p));
  MUST(jalon_cloud_points(b, &q));
  return distance_apart(&p, &q, east, north);
}

static uint64_t hash_cloud_fields(const jalon_cloud* cloud) {
  jalon_fields* fields;
  MUST(jalon_cloud_fields(cloud, &fields));
  return hash_and_release(fields);
}

/* Of one operation: coordinates exact where they are the caller's, computed ones to a rounding; fields identical. */
static void compare_operation(int i, const jalon_cloud* local, const jalon_cloud* national) {
  made a = {NULL, NULL, NULL}, b = {NULL, NULL, NULL};
  char name[96];
  MUST(kOperations[i].run(local, NULL, &a));
  MUST(kOperations[i].run(national, NULL, &b));
  int same = 1;
  if (a.cloud != NULL) {
    const double apart = clouds_apart(a.cloud, b.cloud, kEast, kNorth);
    const int computed = strcmp(kOperations[i].name, "voxel") == 0 ||   /* centroids */
                         strcmp(kOperations[i].name, "landslide") == 0; /* middles of cells */
    same =
        apart <= (computed ? 2e-9 : 0) && hash_cloud_fields(a.cloud) == hash_cloud_fields(b.cloud);
    if (strcmp(kOperations[i].name, "crop") == 0) same = 1; /* its box stays where it is */
  }
  if (a.fields != NULL)
    same = same && (strcmp(kOperations[i].name, "radius search") != 0 ||
                    hash_fields(kStart, a.fields) == hash_fields(kStart, b.fields));
  if (a.segmentation != NULL) {
    jalon_fields *p, *q;
    MUST(jalon_segmentation_points(a.segmentation, &p));
    MUST(jalon_segmentation_points(b.segmentation, &q));
    same = hash_and_release(p) == hash_and_release(q);
  }
  snprintf(name, sizeof name, "%s gives identical bits on a 2^-20 m grid at E 652 000, N 6 861 000",
           kOperations[i].name);
  if (strcmp(kOperations[i].name, "crop") != 0) verdict(same, name);
  release_made(&a);
  release_made(&b);
}

static void compare_neighbours(const jalon_cloud* local, const jalon_cloud* national) {
  static uint32_t a[kPoints * kNear], b[kPoints * kNear];
  static float da[kPoints * kNear], db[kPoints * kNear];
  MUST(jalon_cloud_knn_all(local, kNear, NULL, a, da));
  MUST(jalon_cloud_knn_all(national, kNear, NULL, b, db));
  verdict(memcmp(a, b, sizeof a) == 0 && memcmp(da, db, sizeof da) == 0,
          "neighbours and distances are identical on the grid");
}

/* Labels and planes of arbitrary coordinates, and how far they may move: 1e-4 of the labels, 1e-5 m. */
static void compare_arbitrary(void) {
  const double east = kEast + 0.123456789, north = kNorth + 0.987654321;
  double *xyz = shifted_points(0, 0, 0), *moved = shifted_points(east, north, 0);
  jalon_cloud *local = cloud_of(xyz, kPoints), *national = cloud_of(moved, kPoints);
  made a = {NULL, NULL, NULL}, b = {NULL, NULL, NULL};
  jalon_fields *p, *q;
  jalon_array_view la, lb;
  MUST(op_segment(local, NULL, &a));
  MUST(op_segment(national, NULL, &b));
  MUST(jalon_segmentation_points(a.segmentation, &p));
  MUST(jalon_segmentation_points(b.segmentation, &q));
  MUST(jalon_fields_view(p, "label", &la));
  MUST(jalon_fields_view(q, "label", &lb));
  int other = 0;
  for (uint64_t i = 0; i < kPoints; ++i)
    other += *(const uint32_t*)((const char*)la.data + i * la.stride_bytes) !=
             *(const uint32_t*)((const char*)lb.data + i * lb.stride_bytes);
  jalon_fields_release(p);
  jalon_fields_release(q);
  MUST(jalon_segmentation_segments(a.segmentation, &p));
  MUST(jalon_segmentation_segments(b.segmentation, &q));
  const double apart = planes_apart(p, q, east, north);
  printf(
      "FIGURE arbitrary coordinates on the national grid: %d of %d labels differ, planes %.2g m "
      "apart\n",
      other, kPoints, apart);
  verdict(other <= 1e-4 * kPoints, "at most 1e-4 of the labels differ for arbitrary coordinates");
  verdict(apart <= 1e-5, "planes move by at most 1e-5 m for arbitrary coordinates");
  jalon_fields_release(p);
  jalon_fields_release(q);
  release_made(&a);
  release_made(&b);
  jalon_cloud_release(local);
  jalon_cloud_release(national);
  free(xyz);
  free(moved);
}

static int compare_grids(void) {
  double *xyz = shifted_points(0, 0, 1), *moved = shifted_points(kEast, kNorth, 1);
  jalon_cloud *local = cloud_of(xyz, kPoints), *national = cloud_of(moved, kPoints);
  for (int i = 0; i < kOperationCount; ++i) compare_operation(i, local, national);
  compare_neighbours(local, national);
  compare_arbitrary();
  jalon_cloud_release(local);
  jalon_cloud_release(national);
  free(xyz);
  free(moved);
  printf("%d passed, %d failed, 0 skipped\n", passed, failed);
  return failed != 0;
}

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--grid") == 0) return compare_grids();
  if (argc == 2) return print_hashes((uint32_t)atoi(argv[1]));
  printf("usage: bits THREADS | --grid\n");
  return 2;
}
