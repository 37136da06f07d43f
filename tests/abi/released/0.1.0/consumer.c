/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * A host as it was built with the headers of 0.1.0; its binary beside it stays as it is. It passes
 * every kind of value that crosses the interface: structs by pointer, structs with a size, arrays
 * with strides, texts, callbacks, sets of parameters, tables, handles.
 */
#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(jalon_status status, const char* what) {
  if (status == JALON_OK) return;
  fprintf(stderr, "%s: %s: %s\n", what, jalon_status_name(status), jalon_last_error_message());
  exit(1);
}
#define MUST(call) must(call, #call)

static int32_t count_calls(double fraction, const char* stage, void* user) {
  if (fraction >= 0 && fraction <= 1 && stage != NULL) ++*(int*)user;
  return 0;
}

static void print_params(jalon_params* params, const char* name) {
  uint64_t count = 0, i;
  const char* json = NULL;
  MUST(jalon_params_count(params, &count));
  for (i = 0; i < count; ++i) {
    jalon_param_info info;
    memset(&info, 0, sizeof info);
    info.struct_size = (uint32_t)sizeof info;
    MUST(jalon_params_info(params, i, &info));
    if (strcmp(info.name, name) == 0)
      printf("parameter %s: type %d, unit \"%s\", from %g to %g\n", info.name, (int)info.type,
             info.unit, info.minimum, info.maximum);
  }
  MUST(jalon_params_to_json(params, &json));
  printf("parameter %s stands in the JSON: %d\n", name, strstr(json, name) != NULL);
}

/* The columns that a table had, by name; what a later release adds is none of this program's business. */
static void print_table(const char* what, const jalon_fields* fields, const char* const* names,
                        int count) {
  int k;
  for (k = 0; k < count; ++k) {
    jalon_array_view view;
    double* values;
    double sum = 0;
    uint64_t i, n;
    MUST(jalon_fields_view(fields, names[k], &view));
    n = view.count * view.components;
    values = malloc((size_t)(n == 0 ? 1 : n) * sizeof *values);
    MUST(jalon_fields_copy(fields, names[k], JALON_FLOAT64, values, n));
    for (i = 0; i < n; ++i) sum += values[i];
    printf("%s.%s: type %d, %d components, sum %.9g\n", what, names[k], (int)view.type,
           (int)view.components, sum);
    free(values);
  }
}

static jalon_model* house(void) {
  jalon_params* scene = NULL;
  jalon_model* model = NULL;
  MUST(jalon_params_create("scene", &scene));
  MUST(jalon_params_set_string(scene, "name", "facade"));
  MUST(jalon_scene_create(scene, NULL, &model));
  jalon_params_release(scene);
  return model;
}

static jalon_cloud* scanned(const jalon_model* model, int64_t seed) {
  const jalon_transform pose = {{1, 0, 0, 5, 0, 1, 0, -12, 0, 0, 1, 1.7}};
  jalon_scanner* scanner = NULL;
  jalon_params* params = NULL;
  jalon_cloud* cloud = NULL;
  MUST(jalon_scanner_create("static", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_set_double(params, "horizontal_step_rad", 0.006));
  MUST(jalon_params_set_double(params, "vertical_step_rad", 0.006));
  MUST(jalon_params_set_int64(params, "seed", seed));
  MUST(jalon_scanner_add_station(scanner, "S1", &pose));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  jalon_params_release(params);
  jalon_scanner_release(scanner);
  return cloud;
}

static void print_cloud(const jalon_cloud* cloud) {
  jalon_array_view xyz;
  jalon_box box;
  uint64_t nearest[3];
  double squared_m2[3];
  MUST(jalon_cloud_points(cloud, &xyz));
  MUST(jalon_cloud_bounds(cloud, &box));
  MUST(jalon_cloud_knn(cloud, xyz.data, JALON_FLOAT64, 1, 0, 3, JALON_LEVEL_AUTOMATIC, NULL,
                       nearest, squared_m2));
  printf("cloud: %d points, from %.6f %.6f %.6f to %.6f %.6f %.6f, nearest %d %d %d\n",
         (int)xyz.count, box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z,
         (int)nearest[0], (int)nearest[1], (int)nearest[2]);
}

static void segment_and_model(const jalon_cloud* cloud) {
  static const char* const columns[] = {"label", "area", "sigma", "normal"};
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* planes = NULL;
  jalon_fields *segments = NULL, *faces = NULL;
  jalon_params* params = NULL;
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  jalon_task* task = NULL;
  int calls = 0;
  uint64_t n = 0;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 1));
  MUST(jalon_task_set_progress(task, count_calls, &calls));
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  print_params(params, "distance_tolerance_m");
  MUST(jalon_segmenter_run(segmenter, cloud, task, &planes));
  MUST(jalon_segmentation_segments(planes, &segments));
  print_table("segments", segments, columns, 4);
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_run(modeller, cloud, planes, task, &model));
  MUST(jalon_model_faces(model, &faces));
  MUST(jalon_fields_count(faces, &n));
  printf("progress was told: %d; faces have columns: %d\n", calls > 0, n > 0);
  MUST(jalon_task_cancel(task));
  printf("cancelled: %s\n",
         jalon_status_name(jalon_segmenter_run(segmenter, cloud, task, &planes)));
  jalon_fields_release(faces);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  jalon_params_release(params);
  jalon_fields_release(segments);
  jalon_segmentation_release(planes);
  jalon_segmenter_release(segmenter);
  jalon_task_release(task);
}

static void compare(const jalon_cloud* one, const jalon_cloud* other) {
  static const char* const columns[] = {"points"};
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  jalon_fields* summary = NULL;
  const char* json = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  MUST(jalon_comparer_run(comparer, one, other, NULL, &comparison));
  MUST(jalon_comparison_summary(comparison, &summary));
  print_table("summary", summary, columns, 1);
  MUST(jalon_comparison_parameters(comparison, &json));
  printf("parameters are JSON: %d\n", json[0] == '{');
  jalon_fields_release(summary);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
}

static void register_targets(void) {
  jalon_target there[4], here[4];
  jalon_registrar* registrar = NULL;
  jalon_registration* found = NULL;
  jalon_transform pose;
  const double at[4][3] = {{0, 0, 0}, {9, 1, 0}, {8, 7, 3}, {1, 6, 2}};
  int i;
  memset(there, 0, sizeof there);
  for (i = 0; i < 4; ++i) {
    there[i].xyz.x = at[i][0], there[i].xyz.y = at[i][1], there[i].xyz.z = at[i][2];
    here[i] = there[i];
    here[i].xyz.x += 0.25;
  }
  MUST(jalon_registrar_create("targets", &registrar));
  MUST(jalon_registrar_run_targets(registrar, there, 4, here, 4, NULL, &found));
  MUST(jalon_registration_pose(found, &pose));
  printf("pose: shift %.6f %.6f %.6f\n", pose.m[3], pose.m[7], pose.m[11]);
  jalon_registration_release(found);
  jalon_registrar_release(registrar);
}

int main(void) {
  jalon_cloud *one, *other, *none = NULL;
  jalon_model* model = house();
  jalon_status status;
  printf("%s %d\n", strncmp(jalon_version(), "0.", 2) == 0 ? "0" : "later",
         jalon_version_number() >= 100);
  one = scanned(model, 1);
  other = scanned(model, 2);
  print_cloud(one);
  segment_and_model(one);
  compare(one, other);
  register_targets();
  status = jalon_cloud_read("no/such/file.las", NULL, NULL, &none);
  printf("%s, a cloud: %d, a line: %d\n", jalon_status_name(status), none != NULL,
         strlen(jalon_last_error_message()) > 10);
  jalon_cloud_release(other);
  jalon_cloud_release(one);
  jalon_model_release(model);
  return 0;
}
