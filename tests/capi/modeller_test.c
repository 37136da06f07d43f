/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "wall_scene.h"

#include <math.h>

static void modeller__draws_the_wall_with_its_window(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  jalon_fields* faces = NULL;
  MUST(jalon_model_faces(model, &faces));
  jalon_array_view rows;
  MUST(jalon_fields_view(faces, "area", &rows));
  assert_int_equal(rows.count, 1);
  double area = 0, normal[3];
  uint64_t rings = 0;
  uint32_t id = 0;
  MUST(jalon_fields_copy(faces, "area", JALON_FLOAT64, &area, 1));
  MUST(jalon_fields_copy(faces, "normal", JALON_FLOAT64, normal, 3));
  MUST(jalon_fields_copy(faces, "ring_count", JALON_UINT64, &rings, 1));
  MUST(jalon_fields_copy(faces, "id", JALON_UINT32, &id, 1));
  assert_true(fabs(area / (6 * 3.99 - 1.2 * 1.5) - 1) < 0.02);
  assert_true(fabs(normal[1]) > 0.9999);
  assert_int_equal(rings, 2);
  assert_int_equal(id, 1);
  jalon_fields_release(faces);
  jalon_model_release(model);
  release_scene(&scene);
}

static void modeller__parameters_change_the_model(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  MUST(jalon_modeller_create("outlines", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  MUST(jalon_params_set_double(params, "min_opening_area_m2", 5));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, "alpha_factor", -1));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(params, "no_such_thing", 1));
  jalon_params_release(params);
  jalon_model* model = NULL;
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  jalon_fields* rings = NULL;
  jalon_array_view view;
  MUST(jalon_model_rings(model, &rings));
  MUST(jalon_fields_view(rings, "count", &view));
  assert_int_equal(view.count, 1);
  jalon_fields_release(rings);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__refuses_another_cloud_and_unknown_methods(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_cloud* other = NULL;
  jalon_model* model = NULL;
  const double point[3] = {0, 0, 0};
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_modeller_create("sculpture", &modeller));
  assert_null(modeller);
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_cloud_create(point, JALON_FLOAT64, 1, 0, 0, &other));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, other, scene.segmentation, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, scene.cloud, NULL, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(NULL, scene.cloud, scene.segmentation, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, NULL));
  assert_null(model);
  jalon_cloud_release(other);
  jalon_modeller_release(modeller);
  jalon_modeller_release(NULL);
  release_scene(&scene);
}

static void modeller__cancelled_leaves_everything_usable(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_task* task = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_task_create(&task));
  MUST(jalon_task_cancel(task));
  REFUSED(JALON_ERROR_CANCELLED,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, task, &model));
  assert_null(model);
  MUST(jalon_task_reset(task));
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, task, &model));
  jalon_model_release(model);
  jalon_task_release(task);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__facade_makes_a_tree_with_a_window(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, "max_depth_m", -1));
  MUST(jalon_params_set_double(params, "max_depth_m", 0.8));
  jalon_params_release(params);
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  uint64_t count = 0, parent = 0;
  MUST(jalon_model_part_count(model, &count));
  assert_int_equal(count, 3);
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_part(model, 2, &name, &part_class, &parent));
  assert_string_equal(name, "window 1.1");
  assert_string_equal(part_class, "window");
  assert_int_equal(parent, 1);
  jalon_fields* parts = NULL;
  MUST(jalon_model_parts(model, &parts));
  double width[3];
  uint8_t evidence[3];
  MUST(jalon_fields_copy(parts, "width", JALON_FLOAT64, width, 3));
  MUST(jalon_fields_copy(parts, "evidence", JALON_UINT8, evidence, 3));
  assert_true(fabs(width[2] - 1.2) < 0.03);
  assert_int_equal(evidence[2], JALON_EVIDENCE_SHAPE);
  jalon_fields_release(parts);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__extrusion_needs_a_depth_and_gives_a_closed_solid(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create("extrusion", &modeller));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  assert_null(model);
  MUST(jalon_modeller_params(modeller, &params));
  MUST(jalon_params_set_double(params, "thickness_m", 0.25));
  jalon_params_release(params);
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  jalon_fields *solids = NULL, *edges = NULL;
  uint64_t faces = 0;
  MUST(jalon_model_solids(model, &solids));
  MUST(jalon_fields_copy(solids, "face_count", JALON_UINT64, &faces, 1));
  assert_int_equal(faces, 2 + 4 + 4);
  jalon_array_view uses;
  MUST(jalon_model_edges(model, &edges));
  MUST(jalon_fields_view(edges, "uses", &uses));
  assert_int_equal(uses.count, 24);
  for (uint64_t i = 0; i < uses.count; ++i) assert_int_equal(((const uint32_t*)uses.data)[i], 2);
  jalon_fields_release(edges);
  jalon_fields_release(solids);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void model__parts_are_renamed_in_a_new_model(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model *model = model_of_scene(&scene), *renamed = NULL, *less = NULL;
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_rename_part(model, 1, "street front", NULL, &renamed));
  MUST(jalon_model_part(renamed, 1, &name, &part_class, NULL));
  assert_string_equal(name, "street front");
  MUST(jalon_model_part(model, 1, &name, NULL, NULL));
  assert_string_not_equal(name, "street front");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_rename_part(model, 99, "x", NULL, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_rename_part(model, 0, "\xff", NULL, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_remove_copy(model, 1, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_remove_copy(model, 99, &less));
  assert_null(less);
  jalon_model_release(renamed);
  jalon_model_release(model);
  release_scene(&scene);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(modeller__draws_the_wall_with_its_window),
      cmocka_unit_test(modeller__parameters_change_the_model),
      cmocka_unit_test(modeller__refuses_another_cloud_and_unknown_methods),
      cmocka_unit_test(modeller__cancelled_leaves_everything_usable),
      cmocka_unit_test(modeller__facade_makes_a_tree_with_a_window),
      cmocka_unit_test(modeller__extrusion_needs_a_depth_and_gives_a_closed_solid),
      cmocka_unit_test(model__parts_are_renamed_in_a_new_model),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
