/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_jalon PREFIX: Jalon through its public C interface; the protocol is that of driver.h. */

#include "jalon_driver.h"

enum { NEIGHBOURS = 16 };
static const double kVoxel_m = 0.05;

typedef struct Bench {
  const char* prefix;
  Points points;
  Points second;          /* the scan that is compared with the scene; loaded when first needed */
  jalon_cloud* indexed;   /* the cloud of the last "index": knn16 asks it */
  jalon_cloud* segmented; /* the cloud of the first modelling operation, with its planes */
  jalon_segmentation* planes;
  uint32_t* neighbours;
  float* squared;
} Bench;

static jalon_cloud* fresh_cloud(const Bench* bench) {
  jalon_cloud* cloud = NULL;
  check(jalon_cloud_create(bench->points.xyz, JALON_FLOAT64, bench->points.count, 0, 0, &cloud));
  return cloud;
}

static uint64_t sample_step(uint64_t count) { return count > SAMPLES ? count / SAMPLES : 1; }

/* Every sample_step-th row of a packed float array, as doubles. */
static void write_sample(FILE* sample, const float* rows, uint64_t count, uint32_t columns) {
  uint64_t i;
  uint32_t k;
  for (i = 0; i < count; i += sample_step(count)) {
    for (k = 0; k < columns; ++k) {
      const double value = rows[i * columns + k];
      fwrite(&value, sizeof value, 1, sample);
    }
  }
}

static Result run_index(Bench* bench, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  (void)sample;
  jalon_cloud_release(bench->indexed);
  bench->indexed = fresh_cloud(bench);
  start = now();
  check(jalon_cloud_prepare(bench->indexed, task));
  result.seconds = now() - start;
  result.count = bench->points.count;
  return result;
}

static Result run_knn16(Bench* bench, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  if (bench->indexed == NULL) run_index(bench, task, NULL);
  if (bench->neighbours == NULL) {
    /* Touched once, as the peers' arrays are. */
    bench->neighbours = malloc(bench->points.count * NEIGHBOURS * sizeof *bench->neighbours);
    bench->squared = malloc(bench->points.count * NEIGHBOURS * sizeof *bench->squared);
    if (bench->neighbours == NULL || bench->squared == NULL) exit(1);
    memset(bench->neighbours, 0, bench->points.count * NEIGHBOURS * sizeof *bench->neighbours);
    memset(bench->squared, 0, bench->points.count * NEIGHBOURS * sizeof *bench->squared);
  }
  start = now();
  check(jalon_cloud_knn_all(bench->indexed, NEIGHBOURS, task, bench->neighbours, bench->squared));
  result.seconds = now() - start;
  result.count = bench->points.count;
  if (sample != NULL) write_sample(sample, bench->squared, bench->points.count, NEIGHBOURS);
  return result;
}

static Result run_normals16(Bench* bench, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  jalon_params* options = NULL;
  jalon_cloud* cloud = fresh_cloud(bench);
  check(jalon_params_create("normals", &options));
  check(jalon_params_set_string(options, "method", "pca"));
  check(jalon_params_set_int64(options, "k", NEIGHBOURS));
  check(jalon_params_set_string(options, "orientation", "none"));
  start = now();
  check(jalon_cloud_compute_normals(cloud, options, task));
  result.seconds = now() - start;
  result.count = bench->points.count;
  if (sample != NULL) {
    jalon_fields* fields = NULL;
    jalon_array_view view;
    check(jalon_cloud_fields(cloud, &fields));
    check(jalon_fields_view(fields, "normal", &view));
    write_sample(sample, view.data, view.count, view.components);
    jalon_fields_release(fields);
  }
  jalon_params_release(options);
  jalon_cloud_release(cloud);
  return result;
}

static Result run_voxel5cm(Bench* bench, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  jalon_params* options = NULL;
  jalon_cloud *cloud = fresh_cloud(bench), *thinned = NULL;
  (void)sample;
  check(jalon_params_create("subsample", &options));
  check(jalon_params_set_string(options, "method", "voxel"));
  check(jalon_params_set_double(options, "cell_m", kVoxel_m));
  start = now();
  check(jalon_cloud_subsample(cloud, options, task, &thinned, NULL));
  result.seconds = now() - start;
  check(jalon_cloud_count(thinned, &result.count));
  jalon_cloud_release(thinned);
  jalon_cloud_release(cloud);
  jalon_params_release(options);
  return result;
}

static Result run_las(Bench* bench, const char* suffix, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  char path[LINE_BYTES];
  jalon_cloud* cloud = NULL;
  jalon_array_view view;
  uint64_t i;
  snprintf(path, sizeof path, "%s%s", bench->prefix, suffix);
  start = now();
  check(jalon_cloud_read(path, NULL, task, &cloud));
  result.seconds = now() - start;
  check(jalon_cloud_points(cloud, &view));
  result.count = view.count;
  for (i = 0; sample != NULL && i < view.count; i += sample_step(view.count)) {
    fwrite((const char*)view.data + i * view.stride_bytes, sizeof(double), 3, sample);
  }
  jalon_cloud_release(cloud);
  return result;
}

static Result run_las0(Bench* bench, jalon_task* task, FILE* sample) {
  return run_las(bench, "_pf0.las", task, sample);
}
static Result run_las3(Bench* bench, jalon_task* task, FILE* sample) {
  return run_las(bench, "_pf3.las", task, sample);
}

static Result run_laz0(Bench* bench, jalon_task* task, FILE* sample) {
  return run_las(bench, "_pf0.laz", task, sample);
}
static Result run_laz3(Bench* bench, jalon_task* task, FILE* sample) {
  return run_las(bench, "_pf3.laz", task, sample);
}

/* A row a plane, largest first: normal, centroid of its points, how many they are. */
static void write_planes(FILE* sample, const jalon_fields* segments) {
  jalon_array_view normals, centroids, inliers;
  uint64_t i;
  check(jalon_fields_view(segments, "normal", &normals));
  check(jalon_fields_view(segments, "centroid", &centroids));
  check(jalon_fields_view(segments, "inliers", &inliers));
  for (i = 0; i < inliers.count; ++i) {
    const double points = (double)((const uint64_t*)inliers.data)[i];
    fwrite((const double*)normals.data + 3 * i, sizeof(double), 3, sample);
    fwrite((const double*)centroids.data + 3 * i, sizeof(double), 3, sample);
    fwrite(&points, sizeof points, 1, sample);
  }
}

/* From raw points to labels and planes, with the default parameters; count: the segments. */
static Result run_segmenter(Bench* bench, const char* method, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_fields* segments = NULL;
  jalon_array_view labels;
  jalon_cloud* cloud = fresh_cloud(bench);
  check(jalon_segmenter_create(method, &segmenter));
  start = now();
  check(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  result.seconds = now() - start;
  check(jalon_segmentation_segments(segmentation, &segments));
  check(jalon_fields_view(segments, "label", &labels));
  result.count = labels.count;
  if (sample != NULL) write_planes(sample, segments);
  jalon_fields_release(segments);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  return result;
}

static Result run_planes(Bench* bench, jalon_task* task, FILE* sample) {
  return run_segmenter(bench, "ransac", task, sample);
}
static Result run_region_growing(Bench* bench, jalon_task* task, FILE* sample) {
  return run_segmenter(bench, "region_growing", task, sample);
}

/* Distances of the second scan from the scene, the index of both clouds included; model: NULL or a local model. */
static Result run_comparer(Bench* bench, const char* model, jalon_task* task, FILE* sample) {
  Result result;
  double start;
  jalon_cloud *reference = fresh_cloud(bench), *compared = NULL;
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_comparison* comparison = NULL;
  if (bench->second.xyz == NULL) bench->second = load(bench->prefix, "_second.f64");
  check(jalon_cloud_create(bench->second.xyz, JALON_FLOAT64, bench->second.count, 0, 0, &compared));
  check(jalon_comparer_create("distance", &comparer));
  check(jalon_comparer_params(comparer, &params));
  if (model != NULL) {
    check(jalon_params_set_string(params, "local_model", model));
    check(jalon_params_set_double(params, "radius_m", 0.15));
  }
  start = now();
  check(jalon_comparer_run(comparer, reference, compared, task, &comparison));
  result.seconds = now() - start;
  result.count = bench->second.count;
  if (sample != NULL) {
    jalon_fields* points = NULL;
    jalon_array_view view;
    uint64_t i;
    check(jalon_comparison_points(comparison, &points));
    check(jalon_fields_view(points, "distance", &view));
    for (i = 0; i < view.count; i += sample_step(view.count))
      fwrite((const double*)view.data + i, sizeof(double), 1, sample);
    jalon_fields_release(points);
  }
  jalon_comparison_release(comparison);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(reference);
  jalon_cloud_release(compared);
  return result;
}

static Result run_c2c(Bench* bench, jalon_task* task, FILE* sample) {
  return run_comparer(bench, NULL, task, sample);
}
static Result run_c2c_plane(Bench* bench, jalon_task* task, FILE* sample) {
  return run_comparer(bench, "plane", task, sample);
}
static Result run_c2c_quadric(Bench* bench, jalon_task* task, FILE* sample) {
  return run_comparer(bench, "quadric", task, sample);
}

/* From planes to a drawing: the segmentation is not timed; count: the faces. dxf: also written. */
static Result run_modeller(Bench* bench, const char* method, int dxf, jalon_task* task) {
  Result result;
  double start;
  char path[LINE_BYTES];
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  jalon_fields* faces = NULL;
  jalon_array_view ids;
  if (bench->planes == NULL) {
    jalon_segmenter* segmenter = NULL;
    bench->segmented = fresh_cloud(bench);
    check(jalon_segmenter_create("ransac", &segmenter));
    check(jalon_segmenter_run(segmenter, bench->segmented, task, &bench->planes));
    jalon_segmenter_release(segmenter);
  }
  snprintf(path, sizeof path, "%s_model.dxf", bench->prefix);
  check(jalon_modeller_create(method, &modeller));
  start = now();
  check(jalon_modeller_run(modeller, bench->segmented, bench->planes, task, &model));
  if (dxf) check(jalon_model_write(model, path, NULL, task));
  result.seconds = now() - start;
  check(jalon_model_faces(model, &faces));
  check(jalon_fields_view(faces, "id", &ids));
  result.count = ids.count;
  jalon_fields_release(faces);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  return result;
}

static Result run_outlines(Bench* bench, jalon_task* task, FILE* sample) {
  (void)sample;
  return run_modeller(bench, "outlines", 0, task);
}
static Result run_facade_dxf(Bench* bench, jalon_task* task, FILE* sample) {
  (void)sample;
  return run_modeller(bench, "facade", 1, task);
}

typedef struct Operation {
  const char* name;
  Result (*run)(Bench* bench, jalon_task* task, FILE* sample);
} Operation;

static const Operation kOperations[] = {{"index", run_index},
                                        {"knn16", run_knn16},
                                        {"normals16", run_normals16},
                                        {"voxel5cm", run_voxel5cm},
                                        {"las0", run_las0},
                                        {"las3", run_las3},
                                        {"laz0", run_laz0},
                                        {"laz3", run_laz3},
                                        {"c2c", run_c2c},
                                        {"c2c_plane", run_c2c_plane},
                                        {"c2c_quadric", run_c2c_quadric},
                                        {"planes", run_planes},
                                        {"region_growing", run_region_growing},
                                        {"outlines", run_outlines},
                                        {"facade_dxf", run_facade_dxf}};
enum { OPERATIONS = sizeof kOperations / sizeof kOperations[0] };

static Result run(const char* name, void* bench, jalon_task* task, FILE* sample) {
  int i;
  for (i = 0; i < OPERATIONS && strcmp(name, kOperations[i].name) != 0; ++i) {
  }
  if (i == OPERATIONS) exit(1);
  return kOperations[i].run(bench, task, sample);
}

int main(int argc, char** argv) {
  Bench bench;
  int code;
  if (argc < 2) return 2;
  memset(&bench, 0, sizeof bench);
  bench.prefix = argv[1];
  bench.points = load(bench.prefix, ".f64");
  code = serve(
      "index,knn16,normals16,voxel5cm,las0,las3,laz0,laz3,c2c,c2c_plane,c2c_quadric,planes,region_"
      "growing,"
      "outlines,"
      "facade_dxf",
      bench.points.count, &bench, run);
  jalon_cloud_release(bench.indexed);
  jalon_segmentation_release(bench.planes);
  jalon_cloud_release(bench.segmented);
  free(bench.neighbours);
  free(bench.squared);
  free(bench.points.xyz);
  free(bench.second.xyz);
  return code;
}
