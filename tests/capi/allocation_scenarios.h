/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Small jobs through the whole C surface. Each makes all it needs, gives everything back and returns the first
 * failure. */
#ifndef JALON_TEST_ALLOCATION_SCENARIOS_H
#define JALON_TEST_ALLOCATION_SCENARIOS_H

#include "support.h"

#define TRY(call)                            \
  do {                                       \
    if (status == JALON_OK) status = (call); \
  } while (0)

enum { kSmall = 700 };
static double small_xyz[3 * kSmall];
static jalon_task* small_task; /* two threads */
static char small_folder[300];

static inline const char* small_path(const char* name) {
  static char path[400];
  snprintf(path, sizeof path, "%s/%s", small_folder, name);
  return path;
}

static inline jalon_status small_cloud(jalon_cloud** out) {
  return jalon_cloud_create(small_xyz, JALON_FLOAT64, kSmall, 0, 0, out);
}

static inline jalon_status options_of(const char* operation, const char* json, jalon_params** out) {
  jalon_params* params = NULL;
  jalon_status status = jalon_params_create(operation, &params);
  TRY(jalon_params_from_json(params, json));
  if (status == JALON_OK) *out = params;
  else jalon_params_release(params);
  return status;
}

static jalon_status scenario_cloud(void) {
  jalon_cloud *cloud = NULL, *picked = NULL, *even = NULL, *odd = NULL, *both = NULL, *moved = NULL,
              *in = NULL, *out = NULL;
  jalon_fields* fields = NULL;
  const jalon_transform pose = {{0, -1, 0, 2, 1, 0, 0, 3, 0, 0, 1, 4}};
  const jalon_box box = {{1, -5, 1}, {9, 5, 8}};
  const double corners[8] = {1, 1, 9, 1, 9, 8, 1, 8};
  const jalon_vec3 foot = {5, 0, 0}, top = {5, 0, 9};
  const uint64_t indices[5] = {5, 3, 3, 1, 600};
  uint8_t parity[kSmall];
  for (int i = 0; i < kSmall; ++i) parity[i] = (uint8_t)(i % 2);
  jalon_status status = small_cloud(&cloud);
  TRY(jalon_cloud_set_field(cloud, "parity", parity, JALON_UINT8, 1, kSmall, 0, "", "0 or 1"));
  TRY(jalon_cloud_set_station(cloud, "a station with a rather long name", &pose));
  TRY(jalon_cloud_set_crs(cloud, "a coordinate reference system of more than sixteen letters"));
  TRY(jalon_cloud_fields(cloud, &fields));
  TRY(jalon_cloud_select(cloud, indices, 5, small_task, &picked));
  TRY(jalon_cloud_split(cloud, "parity", 0, small_task, &even, &odd));
  TRY(jalon_cloud_append(even, odd, small_task, &both));
  TRY(jalon_cloud_transform(both, &pose, small_task, &moved));
  TRY(jalon_cloud_crop_box(cloud, &box, NULL, small_task, &in, &out));
  jalon_cloud_release(in), jalon_cloud_release(out), in = out = NULL;
  TRY(jalon_cloud_crop_polygon(cloud, corners, 4, -9, 9, &pose, small_task, &in, &out));
  jalon_cloud_release(in), jalon_cloud_release(out), in = out = NULL;
  TRY(jalon_cloud_crop_cylinder(cloud, &foot, &top, 2, small_task, &in, &out));
  jalon_cloud* all[] = {cloud, picked, even, odd, both, moved, in, out};
  for (int i = 0; i < 8; ++i) jalon_cloud_release(all[i]);
  jalon_fields_release(fields);
  return status;
}

static jalon_status scenario_builder(void) {
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  const jalon_transform pose = {{1, 0, 0, 2, 0, 1, 0, 3, 0, 0, 1, 4}};
  jalon_status status = jalon_cloud_builder_create(JALON_CLOUD_DROP_INVALID, &builder);
  TRY(jalon_cloud_builder_set_crs(builder,
                                  "a coordinate reference system of more than sixteen letters"));
  TRY(jalon_cloud_builder_declare_field(builder, "a field with a rather long name", JALON_FLOAT32,
                                        3, "m", "something"));
  for (int block = 0; block < 3; ++block) {
    TRY(jalon_cloud_builder_begin_station(builder, "a station with a rather long name", &pose));
    TRY(jalon_cloud_builder_append_points(builder, small_xyz, JALON_FLOAT64, 200, 0));
    TRY(jalon_cloud_builder_append_field(builder, "a field with a rather long name", small_xyz,
                                         JALON_FLOAT64, 200, 0));
  }
  TRY(jalon_cloud_builder_seal(builder, &cloud));
  jalon_cloud_builder_release(builder);
  jalon_cloud_release(cloud);
  return status;
}

static jalon_status scenario_search(void) {
  jalon_cloud *cloud = NULL, *other = NULL;
  jalon_fields *ranges = NULL, *near = NULL, *cells = NULL, *order = NULL, *around = NULL;
  static uint64_t indices[kSmall * 4];
  static uint32_t all[kSmall * 4];
  int32_t level;
  jalon_status status = small_cloud(&cloud);
  TRY(jalon_cloud_create(small_xyz, JALON_FLOAT64, 300, 0, 0, &other));
  TRY(jalon_cloud_prepare(cloud, small_task));
  TRY(jalon_cloud_knn(cloud, small_xyz, JALON_FLOAT64, 100, 0, 4, JALON_LEVEL_AUTOMATIC, small_task,
                      indices, NULL));
  TRY(jalon_cloud_knn(cloud, small_xyz, JALON_FLOAT64, 50, 0, 4, 3, small_task, indices, NULL));
  TRY(jalon_cloud_knn_all(cloud, 4, small_task, all, NULL));
  TRY(jalon_cloud_radius_search(cloud, small_xyz, JALON_FLOAT64, 100, 0, 0.5, small_task, &ranges,
                                &near));
  TRY(jalon_cloud_cells(cloud, 4, small_task, &cells));
  TRY(jalon_cloud_order(cloud, small_task, &order));
  TRY(jalon_cloud_cell_neighbours(cloud, 3, 0, 2, small_task, &around));
  TRY(jalon_cloud_best_level(cloud, other, 4, small_task, &level));
  if (status == JALON_OK) {
    jalon_cloud* const both[2] = {cloud, other};
    TRY(jalon_cloud_share_octree(both, 2, small_task));
  }
  jalon_fields* fields[] = {ranges, near, cells, order, around};
  for (int i = 0; i < 5; ++i) jalon_fields_release(fields[i]);
  jalon_cloud_release(cloud);
  jalon_cloud_release(other);
  return status;
}

static jalon_status with_normals(const char* json) {
  jalon_cloud* cloud = NULL;
  jalon_params* options = NULL;
  jalon_status status = small_cloud(&cloud);
  TRY(options_of("normals", json, &options));
  TRY(jalon_cloud_compute_normals(cloud, options, small_task));
  TRY(jalon_cloud_invert_normals(cloud, small_task));
  jalon_params_release(options);
  jalon_cloud_release(cloud);
  return status;
}
static jalon_status scenario_normals(void) {
  return with_normals("{\"k\": 8, \"orientation\": \"centroid\"}");
}
static jalon_status scenario_normals_quadric(void) {
  return with_normals("{\"method\": \"quadric\"}");
}
static jalon_status scenario_normals_triangulation(void) {
  return with_normals("{\"method\": \"triangulation\"}");
}

static jalon_status scenario_features(void) {
  jalon_cloud* cloud = NULL;
  jalon_vec3 centroid;
  double covariance[9], moment;
  uint64_t components;
  jalon_status status = small_cloud(&cloud);
  TRY(jalon_cloud_compute_features(cloud, NULL, small_task));
  TRY(jalon_cloud_compute_components(cloud, NULL, small_task, &components));
  TRY(jalon_cloud_covariance(cloud, small_task, &centroid, covariance));
  TRY(jalon_cloud_moment(cloud, 2, 0, 1, 1, small_task, &moment));
  jalon_cloud_release(cloud);
  return status;
}

static jalon_status scenario_cleaning(void) {
  static const char* const methods[] = {"{\"method\": \"voxel\"}",
                                        "{\"method\": \"minimum_distance\"}",
                                        "{\"method\": \"random\"}", "{\"method\": \"octree\"}"};
  jalon_cloud *cloud = NULL, *out = NULL;
  jalon_reduction report;
  jalon_status status = small_cloud(&cloud);
  TRY(jalon_cloud_remove_duplicates(cloud, 1e-4, small_task, &out, &report));
  jalon_cloud_release(out), out = NULL;
  TRY(jalon_cloud_remove_outliers(cloud, NULL, small_task, &out, &report));
  jalon_cloud_release(out), out = NULL;
  for (int i = 0; i < 4; ++i) {
    jalon_params* options = NULL;
    TRY(options_of("subsample", methods[i], &options));
    TRY(jalon_cloud_subsample(cloud, options, small_task, &out, &report));
    jalon_params_release(options);
    jalon_cloud_release(out), out = NULL;
  }
  jalon_cloud* unwanted = NULL;
  TRY(jalon_cloud_split_interest(cloud, NULL, small_task, &out, &unwanted));
  jalon_cloud_release(out);
  jalon_cloud_release(unwanted);
  jalon_cloud_release(cloud);
  return status;
}

/* A segmentation, and when wanted its model. */
static jalon_status segmented(jalon_cloud** cloud, jalon_segmentation** segmentation,
                              jalon_model** model) {
  jalon_segmenter* segmenter = NULL;
  jalon_modeller* modeller = NULL;
  jalon_status status = small_cloud(cloud);
  TRY(jalon_segmenter_create("ransac", &segmenter));
  TRY(jalon_segmenter_run(segmenter, *cloud, small_task, segmentation));
  if (model != NULL) {
    jalon_model* facade = NULL;
    TRY(jalon_modeller_create("facade", &modeller));
    TRY(jalon_modeller_run(modeller, *cloud, *segmentation, small_task, &facade));
    jalon_model_release(facade);
    jalon_modeller_release(modeller), modeller = NULL;
    TRY(jalon_modeller_create("outlines", &modeller));
    TRY(jalon_modeller_run(modeller, *cloud, *segmentation, small_task, model));
  }
  jalon_segmenter_release(segmenter);
  jalon_modeller_release(modeller);
  return status;
}

static jalon_status scenario_segmentation(void) {
  jalon_cloud *cloud = NULL, *labelled = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_fields *points = NULL, *segments = NULL;
  jalon_transform frame;
  jalon_status status = segmented(&cloud, &segmentation, NULL);
  TRY(jalon_segmentation_points(segmentation, &points));
  TRY(jalon_segmentation_segments(segmentation, &segments));
  TRY(jalon_segmentation_cloud(segmentation, &labelled));
  TRY(jalon_segmentation_facade_frame(segmentation, &frame));
  jalon_fields_release(points);
  jalon_fields_release(segments);
  jalon_cloud_release(labelled);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  return status;
}

static jalon_status scenario_evaluation(void) {
  jalon_cloud *cloud = NULL, *labelled = NULL;
  jalon_segmentation *segmentation = NULL, *again = NULL;
  jalon_evaluation* evaluation = NULL;
  jalon_fields* f[6] = {NULL};
  jalon_status status = segmented(&cloud, &segmentation, NULL);
  TRY(jalon_segmentation_cloud(segmentation, &labelled));
  TRY(jalon_segmentation_from_labels(labelled, "label", NULL, small_task, &again));
  TRY(jalon_segmentation_evaluate(segmentation, again, NULL, small_task, &evaluation));
  TRY(jalon_evaluation_pairs(evaluation, &f[0]));
  TRY(jalon_evaluation_automatic(evaluation, &f[1]));
  TRY(jalon_evaluation_reference(evaluation, &f[2]));
  TRY(jalon_evaluation_totals(evaluation, &f[3]));
  TRY(jalon_cloud_confusion(labelled, "label", "orientation", NULL, small_task, &f[4], &f[5]));
  for (int i = 0; i < 6; ++i) jalon_fields_release(f[i]);
  jalon_evaluation_release(evaluation);
  jalon_segmentation_release(again);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(labelled);
  jalon_cloud_release(cloud);
  return status;
}

static jalon_status scenario_model(void) {
  jalon_cloud* cloud = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_model *model = NULL, *back = NULL;
  jalon_fields* f[5] = {NULL};
  jalon_status status = segmented(&cloud, &segmentation, &model);
  TRY(jalon_model_vertices(model, &f[0]));
  TRY(jalon_model_faces(model, &f[1]));
  TRY(jalon_model_rings(model, &f[2]));
  TRY(jalon_model_corners(model, &f[3]));
  TRY(jalon_model_triangles(model, &f[4]));
  TRY(jalon_model_write(model, small_path("a.obj"), NULL, small_task));
  TRY(jalon_model_read(small_path("a.obj"), NULL, small_task, &back));
  jalon_model_release(back), back = NULL;
  TRY(jalon_model_write(model, small_path("a.dxf"), NULL, small_task));
  TRY(jalon_model_write(model, small_path("a.geojson"), NULL, small_task));
  TRY(jalon_model_write(model, small_path("a.stl"), NULL, small_task));
  TRY(jalon_model_read(small_path("a.stl"), NULL, small_task, &back));
  jalon_model_release(back), back = NULL;
  TRY(jalon_model_write(model, small_path("a.city.json"), NULL, small_task));
  TRY(jalon_model_read(small_path("a.city.json"), NULL, small_task, &back));
  for (int i = 0; i < 5; ++i) jalon_fields_release(f[i]);
  jalon_model_release(model);
  jalon_model_release(back);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  static const char* const names[] = {"a.obj", "a.dxf", "a.geojson", "a.stl", "a.city.json"};
  for (int i = 0; i < 5; ++i) remove(small_path(names[i]));
  return status;
}

static jalon_status scenario_report(void) {
  jalon_cloud* cloud = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_model* model = NULL;
  const char* notes = "{\"title\": \"A title of some length\", \"times\": {\"read\": 0.5}}";
  jalon_status status = segmented(&cloud, &segmentation, &model);
  TRY(jalon_report_write_elevation(segmentation, model, small_path("a.svg"), NULL, small_task));
  TRY(jalon_report_write_html(segmentation, model, notes, small_path("a.html"), NULL, small_task));
  TRY(jalon_report_write_json(segmentation, model, notes, small_path("a.json"), NULL, small_task));
  TRY(jalon_report_write_picture(segmentation, small_path("a.png"), NULL, small_task));
  TRY(jalon_report_write_orthoimage(segmentation, model, small_path("b.png"), NULL, small_task));
  jalon_model_release(model);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  remove(small_path("a.svg")), remove(small_path("a.html")), remove(small_path("a.json"));
  remove(small_path("a.png")), remove(small_path("b.png")), remove(small_path("b.pgw"));
  return status;
}

static jalon_status scenario_files(void) {
  static const char* const names[] = {"a.las", "a.ply", "a.xyz"};
  jalon_cloud *cloud = NULL, *back = NULL;
  float value[kSmall] = {0};
  jalon_status status = small_cloud(&cloud);
  TRY(jalon_cloud_set_field(cloud, "a field of mine", value, JALON_FLOAT32, 1, kSmall, 0, "m", ""));
  TRY(jalon_cloud_set_crs(cloud, "EPSG:2154"));
  for (int i = 0; i < 3; ++i) {
    TRY(jalon_cloud_write(cloud, small_path(names[i]), NULL, small_task));
    TRY(jalon_cloud_read(small_path(names[i]), NULL, small_task, &back));
    jalon_cloud_release(back), back = NULL;
    remove(small_path(names[i]));
  }
  jalon_cloud_release(cloud);
  return status;
}

static jalon_status scenario_scan(void) {
  const double corners[12] = {-2, 3, -2, 2, 3, -2, 2, 3, 2, -2, 3, 2};
  const uint32_t triangles[6] = {0, 1, 2, 2, 3, 0};
  const jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  jalon_model *mesh = NULL, *scene = NULL;
  jalon_scanner* scanner = NULL;
  jalon_params *params = NULL, *options = NULL;
  jalon_cloud* cloud = NULL;
  jalon_status status =
      jalon_model_create_mesh(corners, JALON_FLOAT64, 4, 0, triangles, 2, NULL, &mesh);
  TRY(jalon_scanner_create(NULL, &scanner));
  TRY(jalon_scanner_params(scanner, &params));
  TRY(jalon_params_from_json(params,
                             "{\"horizontal_step_rad\": 0.05, \"vertical_step_rad\": 0.05}"));
  TRY(jalon_scanner_add_station(scanner, "a station with a rather long name", &pose));
  TRY(jalon_scanner_run(scanner, mesh, small_task, &cloud));
  TRY(options_of("scene", "{\"name\": \"facade\"}", &options));
  TRY(jalon_scene_create(options, small_task, &scene));
  jalon_params_release(params);
  jalon_params_release(options);
  jalon_scanner_release(scanner);
  jalon_cloud_release(cloud);
  jalon_model_release(mesh);
  jalon_model_release(scene);
  return status;
}

#include "allocation_primitives.h"
#include "allocation_worth.h"
#include "allocation_compare.h"

static jalon_status scenario_params(void) {
  jalon_params* params = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_task* task = NULL;
  const char* json = NULL;
  const double point[3] = {1, 2, 3};
  jalon_param_info info;
  info.struct_size = sizeof info;
  jalon_status status = jalon_segmenter_create(NULL, &segmenter);
  TRY(jalon_segmenter_params(segmenter, &params));
  TRY(jalon_params_info(params, 0, &info));
  TRY(jalon_params_to_json(params, &json));
  TRY(jalon_params_reset(params));
  jalon_params_release(params), params = NULL;
  TRY(jalon_params_create("normals", &params));
  TRY(jalon_params_set_string(params, "orientation", "point"));
  TRY(jalon_params_set_doubles(params, "viewpoint", point, 3));
  TRY(jalon_params_to_json(params, &json));
  TRY(jalon_params_from_json(params, "{\"k\": 20, \"viewpoint\": [3, 2, 1]}"));
  TRY(jalon_task_create(&task));
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  jalon_task_release(task);
  return status;
}

static const struct {
  const char* name;
  jalon_status (*run)(void);
} kScenarios[] = {
    {"cloud", scenario_cloud},
    {"builder", scenario_builder},
    {"search", scenario_search},
    {"normals", scenario_normals},
    {"normals quadric", scenario_normals_quadric},
    {"normals triangulation", scenario_normals_triangulation},
    {"features", scenario_features},
    {"cleaning", scenario_cleaning},
    {"segmentation", scenario_segmentation},
    {"evaluation", scenario_evaluation},
    {"model", scenario_model},
    {"report", scenario_report},
    {"files", scenario_files},
    {"scan", scenario_scan},
    {"params", scenario_params},
    {"primitives", scenario_primitives},
    {"worth", scenario_worth},
    {"changes", scenario_changes},
    {"m3c2, visibility", scenario_m3c2},
    {"icp", scenario_icp},
    {"coarse", scenario_coarse},
    {"targets", scenario_targets},
};
enum { kScenarioCount = sizeof kScenarios / sizeof *kScenarios };

#endif
