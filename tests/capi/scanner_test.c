/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The virtual scanner and its scenes through the public surface. */
#include "support.h"

#include <math.h>

static jalon_model* scene(const char* name) {
  jalon_params* options;
  jalon_model* model;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", name));
  MUST(jalon_scene_create(options, NULL, &model));
  jalon_params_release(options);
  return model;
}

static jalon_scanner* coarse_scanner(double noise_m) {
  jalon_scanner* scanner;
  jalon_params* params;
  MUST(jalon_scanner_create("static", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_set_double(params, "horizontal_step_rad", 0.01));
  MUST(jalon_params_set_double(params, "vertical_step_rad", 0.01));
  MUST(jalon_params_set_double(params, "range_noise_m", noise_m));
  MUST(jalon_params_set_double(params, "angle_noise_rad", 0));
  jalon_params_release(params);
  return scanner;
}

static jalon_transform pose_at(double x, double y, double z) {
  const jalon_transform pose = {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z}};
  return pose;
}

static const void* column(jalon_fields* fields, const char* name, uint64_t* count) {
  jalon_array_view view;
  MUST(jalon_fields_view(fields, name, &view));
  *count = view.count;
  return view.data;
}

static void scanner__gives_points_with_their_truth(void** state) {
  (void)state;
  jalon_model* model = scene("facade");
  jalon_scanner* scanner = coarse_scanner(0);
  const jalon_transform pose = pose_at(11, -13, 1.7);
  MUST(jalon_scanner_add_station(scanner, "S1", &pose));
  jalon_cloud* cloud;
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));

  jalon_fields *fields, *faces;
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_model_faces(model, &faces));
  jalon_array_view xyz;
  MUST(jalon_cloud_points(cloud, &xyz));
  uint64_t n, face_count;
  const uint32_t* face = column(fields, "face", &n);
  const float* range = column(fields, "range", &n);
  const double* truth = column(fields, "true_xyz", &n);
  const uint32_t* id = column(faces, "id", &face_count);
  const double* normal = column(faces, "normal", &face_count);
  const double* offset = column(faces, "offset", &face_count);
  assert_true(n > 5000 && n == xyz.count);
  for (uint64_t i = 0; i < n; ++i) {
    const double* p = (const double*)xyz.data + 3 * i;
    assert_memory_equal(p, truth + 3 * i, 3 * sizeof(double));
    const double dx = p[0] - 11, dy = p[1] + 13, dz = p[2] - 1.7;
    assert_true(fabs(sqrt(dx * dx + dy * dy + dz * dz) - range[i]) < 1e-5);
    uint64_t f = 0;
    while (f < face_count && id[f] != face[i]) ++f;
    assert_true(f < face_count);
    assert_true(fabs(normal[3 * f] * p[0] + normal[3 * f + 1] * p[1] + normal[3 * f + 2] * p[2] -
                     offset[f]) < 1e-9);
  }
  const char* name;
  int32_t has_pose;
  jalon_transform kept;
  uint64_t first, count;
  MUST(jalon_cloud_station(cloud, 0, &name, &has_pose, &kept, &first, &count));
  assert_string_equal(name, "S1");
  assert_true(has_pose && first == 0 && count == n);
  assert_memory_equal(&kept, &pose, sizeof pose);
  jalon_fields_release(fields);
  jalon_fields_release(faces);
  jalon_cloud_release(cloud);
  jalon_scanner_release(scanner);
  jalon_model_release(model);
}

static void scanner__places_stations_by_itself(void** state) {
  (void)state;
  jalon_model* model;
  jalon_scanner* scanner = coarse_scanner(0.003);
  jalon_cloud* cloud;
  uint64_t stations;
  MUST(jalon_scene_create(NULL, NULL, &model));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  MUST(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 2);
  assert_true(count_of(cloud) > 10000);
  jalon_cloud_release(cloud);
  jalon_scanner_release(scanner);
  jalon_model_release(model);
}

static void scanner__hands_on_the_ids_of_a_mesh(void** state) {
  (void)state;
  const double vertices[] = {-5, 5, -5, 5, 5, -5, 5, 5, 5, -5, 5, 5};
  const uint32_t triangles[] = {0, 1, 2, 0, 2, 3}, ids[] = {70, 80};
  jalon_model* model;
  jalon_cloud* cloud;
  jalon_fields* fields;
  uint64_t n;
  MUST(jalon_model_create_mesh(vertices, JALON_FLOAT64, 4, 0, triangles, 2, ids, &model));
  jalon_scanner* scanner = coarse_scanner(0);
  const jalon_transform pose = pose_at(0, 0, 0);
  MUST(jalon_scanner_add_station(scanner, NULL, &pose));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  MUST(jalon_cloud_fields(cloud, &fields));
  const uint32_t* face = column(fields, "face", &n);
  uint64_t lower = 0, upper = 0;
  for (uint64_t i = 0; i < n; ++i) {
    lower += face[i] == 70;
    upper += face[i] == 80;
  }
  assert_true(lower > 1000 && upper > 1000 && lower + upper == n);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  jalon_scanner_release(scanner);
  jalon_model_release(model);
}

static void scanner__tells_the_true_planes_and_how_many_points_each_has(void** state) {
  (void)state;
  jalon_model* model = scene("sills");
  jalon_scanner* scanner;
  jalon_params* params;
  jalon_cloud* cloud;
  jalon_fields *fields, *truth, *bare;
  const double grid[] = {652000, 6861000, 35};
  MUST(jalon_scanner_create("sample", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_set_int64(params, "points", 6060));
  MUST(jalon_params_set_double(params, "noise_m", 0));
  MUST(jalon_params_set_doubles(params, "offset_m", grid, 3));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  assert_int_equal(count_of(cloud), 6060);
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_scanner_truth(scanner, model, cloud, NULL, &truth));
  uint64_t n, planes;
  const uint32_t* segment = column(fields, "segment", &n);
  const uint32_t* number = column(truth, "segment", &planes);
  const double* normal = column(truth, "normal", &planes);
  const double* offset = column(truth, "offset", &planes);
  const double* area = column(truth, "area", &planes);
  const uint64_t* count = column(truth, "count", &planes);
  const uint32_t* part = column(truth, "part", &planes);
  assert_int_equal(planes, 3); /* the wall and two sills */
  jalon_array_view xyz;
  MUST(jalon_cloud_points(cloud, &xyz));
  uint64_t counted[4] = {0};
  for (uint64_t i = 0; i < n; ++i) {
    const double* p = (const double*)xyz.data + 3 * i;
    const uint64_t k = segment[i] - 1;
    assert_true(segment[i] >= 1 && segment[i] <= 3);
    ++counted[segment[i]];
    assert_true(fabs(normal[3 * k] * p[0] + normal[3 * k + 1] * p[1] + normal[3 * k + 2] * p[2] -
                     offset[k]) < 1e-8);
  }
  const char* expected[] = {"wall", "sill", "sill"};
  for (uint64_t k = 0; k < 3; ++k) {
    const char* part_class;
    MUST(jalon_model_part(model, part[k], NULL, &part_class, NULL));
    assert_string_equal(part_class, expected[k]);
    assert_int_equal(number[k], k + 1);
    assert_int_equal(count[k], counted[k + 1]);
    assert_true(fabs(area[k] - (k == 0 ? 60 : 0.3)) < 1e-9);
    assert_true(fabs((double)count[k] - 100 * area[k]) < 3);
  }
  MUST(jalon_scanner_truth(scanner, model, NULL, NULL, &bare));
  count = column(bare, "count", &planes);
  assert_true(planes == 3 && count[0] == 0);
  jalon_fields_release(bare);
  /* A larger least area leaves the sills out. */
  MUST(jalon_params_set_double(params, "truth_min_area_m2", 0.5));
  MUST(jalon_scanner_truth(scanner, model, NULL, NULL, &bare));
  column(bare, "count", &planes);
  assert_int_equal(planes, 1);
  /* A cloud without the field, and a station for a scanner that stands nowhere. */
  const double origin[3] = {0, 0, 0};
  const jalon_transform pose = pose_at(0, 0, 0);
  jalon_cloud *other, *none = NULL;
  jalon_fields* nothing = NULL;
  MUST(jalon_cloud_create(origin, JALON_FLOAT64, 1, 0, 0, &other));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_scanner_truth(scanner, model, other, NULL, &nothing));
  assert_null(nothing);
  MUST(jalon_cloud_set_field(other, "segment", origin, JALON_FLOAT64, 1, 1, 0, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scanner_truth(scanner, model, other, NULL, &nothing));
  assert_null(nothing);
  MUST(jalon_scanner_add_station(scanner, NULL, &pose));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scanner_run(scanner, model, NULL, &none));
  assert_null(none);
  jalon_cloud_release(other);
  jalon_fields_release(bare);
  jalon_fields_release(truth);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_scanner_release(scanner);
  jalon_model_release(model);
}

static void scanner__surveys_the_school_as_its_recipe_says(void** state) {
  (void)state;
  jalon_model* model = scene("insa");
  jalon_scanner* scanner;
  jalon_params* params;
  jalon_cloud* cloud;
  jalon_fields* truth;
  uint64_t planes, stations;
  MUST(jalon_scanner_create("static", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_from_json(
      params,
      "{\"instrument\": \"gx\", \"horizontal_step_rad\": 0.0029, "
      "\"vertical_step_rad\": 0.0029, "
      "\"stations\": 4, \"station_distance_m\": 30, \"misfit_shift_m\": 0.004, "
      "\"glass_return_min\": 0.05, \"glass_return_max\": 0.3, \"outliers\": 0.02, "
      "\"outlier_place\": \"box\", \"max_points\": 200000}"));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  assert_int_equal(count_of(cloud), 200000);
  MUST(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 4);
  MUST(jalon_scanner_truth(scanner, model, cloud, NULL, &truth));
  const uint64_t* count = column(truth, "count", &planes);
  uint64_t with_points = 0, points = 0;
  for (uint64_t k = 0; k < planes; ++k) {
    with_points += count[k] > 0;
    points += count[k];
  }
  assert_true(planes > 900 && with_points > 500);
  assert_true(points > 180000 &&
              points < 197000); /* the rest: outliers, mixed pixels, small faces */
  jalon_fields_release(truth);
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_scanner_release(scanner);
  jalon_model_release(model);
}

static void scanner__shares_its_parameters_with_the_set_it_hands_out(void** state) {
  (void)state;
  jalon_scanner* scanner = coarse_scanner(0);
  jalon_params *a, *b;
  double value;
  MUST(jalon_scanner_params(scanner, &a));
  MUST(jalon_scanner_params(scanner, &b));
  MUST(jalon_params_set_double(a, "dropout", 0.25));
  MUST(jalon_params_get_double(b, "dropout", &value));
  assert_true(value == 0.25);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(a, "dropout", 1.5));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(a, "beam", 1));
  jalon_scanner_release(scanner);
  MUST(jalon_params_set_double(a, "dropout", 0.5)); /* the set outlives its scanner */
  jalon_params_release(a);
  jalon_params_release(b);
}

static void scanner__refuses_wrong_methods_poses_and_options(void** state) {
  (void)state;
  jalon_scanner* scanner = NULL;
  jalon_params* options;
  jalon_model* model = NULL;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_scanner_create("flying", &scanner));
  assert_null(scanner);
  MUST(jalon_scanner_create(NULL, &scanner));
  jalon_transform pose = pose_at(0, 0, 0);
  pose.m[0] = 2;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scanner_add_station(scanner, NULL, &pose));
  pose = pose_at(NAN, 0, 0);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scanner_add_station(scanner, NULL, &pose));
  pose = pose_at(0, 0, 0);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scanner_add_station(scanner, "\xff", &pose));
  MUST(jalon_params_create("normals", &options));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scene_create(options, NULL, &model));
  assert_null(model);
  jalon_params_release(options);
  MUST(jalon_params_create("scene", &options));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(options, "name", "castle"));
  MUST(jalon_params_set_int64(options, "bays", 50));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_scene_create(options, NULL, &model));
  assert_null(model);
  jalon_params_release(options);
  jalon_scanner_release(scanner);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(scanner__gives_points_with_their_truth),
      cmocka_unit_test(scanner__places_stations_by_itself),
      cmocka_unit_test(scanner__hands_on_the_ids_of_a_mesh),
      cmocka_unit_test(scanner__tells_the_true_planes_and_how_many_points_each_has),
      cmocka_unit_test(scanner__surveys_the_school_as_its_recipe_says),
      cmocka_unit_test(scanner__shares_its_parameters_with_the_set_it_hands_out),
      cmocka_unit_test(scanner__refuses_wrong_methods_poses_and_options),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
