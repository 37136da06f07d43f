/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

static const float kVertices[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
static const uint32_t kTriangles[] = {0, 1, 2, 0, 2, 3};

static void mesh__gives_back_vertices_triangles_and_ids(void** state) {
  (void)state;
  const uint32_t ids[] = {7, 9};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 0, kTriangles, 2, ids, &model));
  jalon_fields* fields = NULL;
  double xyz[12];
  MUST(jalon_model_vertices(model, &fields));
  MUST(jalon_fields_copy(fields, "xyz", JALON_FLOAT64, xyz, 12));
  for (int i = 0; i < 12; ++i) assert_true(xyz[i] == kVertices[i]);
  jalon_fields_release(fields);
  uint32_t vertices[6], face[2];
  MUST(jalon_model_triangles(model, &fields));
  MUST(jalon_fields_copy(fields, "vertices", JALON_UINT32, vertices, 6));
  MUST(jalon_fields_copy(fields, "face", JALON_UINT32, face, 2));
  assert_memory_equal(vertices, kTriangles, sizeof vertices);
  assert_memory_equal(face, ids, sizeof face);
  jalon_model_release(model); /* the snapshot lives on */
  jalon_array_view view;
  MUST(jalon_fields_view(fields, "vertices", &view));
  assert_int_equal(view.count, 2);
  assert_int_equal(view.components, 3);
  jalon_fields_release(fields);
}

static void mesh__numbers_faces_by_triangle_when_no_ids_are_given(void** state) {
  (void)state;
  jalon_model* model = NULL;
  jalon_fields* fields = NULL;
  uint32_t face[2];
  MUST(jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 12, kTriangles, 2, NULL, &model));
  MUST(jalon_model_triangles(model, &fields));
  MUST(jalon_fields_copy(fields, "face", JALON_UINT32, face, 2));
  assert_int_equal(face[0], 0);
  assert_int_equal(face[1], 1);
  jalon_fields_release(fields);
  jalon_model_release(model);
}

static void mesh__has_one_part_and_tables_of_every_kind(void** state) {
  (void)state;
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 0, kTriangles, 2, NULL, &model));
  uint64_t count = 0, parent = 0;
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_part_count(model, &count));
  assert_int_equal(count, 1);
  MUST(jalon_model_part(model, 0, &name, &part_class, &parent));
  assert_true(name[0] != 0 && part_class[0] != 0);
  assert_true(parent == UINT64_MAX);
  MUST(jalon_model_part(model, 0, NULL, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_part(model, 1, &name, &part_class, &parent));
  jalon_status (*const tables[])(const jalon_model*, jalon_fields**) = {
      jalon_model_faces, jalon_model_rings,  jalon_model_corners, jalon_model_vertices,
      jalon_model_edges, jalon_model_solids, jalon_model_parts};
  const uint64_t columns[] = {10, 3, 2, 2, 6, 3, 8};
  for (int i = 0; i < 7; ++i) {
    jalon_fields* fields = NULL;
    MUST(tables[i](model, &fields));
    MUST(jalon_fields_count(fields, &count));
    assert_int_equal(count, columns[i]);
    jalon_fields_release(fields);
  }
  jalon_model_release(model);
}

static void mesh__refuses_what_is_impossible(void** state) {
  (void)state;
  jalon_model* model = NULL;
  const uint32_t beyond[] = {0, 1, 4};
  const double nan_vertex[] = {0, 0, NAN};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 0, beyond, 1, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(nan_vertex, JALON_FLOAT64, 1, 0, NULL, 0, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(NULL, JALON_FLOAT32, 4, 0, kTriangles, 2, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(kVertices, 99, 4, 0, kTriangles, 2, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 0, NULL, 2, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_model_create_mesh(kVertices, JALON_FLOAT32, 4, 0, kTriangles, 2, NULL, NULL));
  assert_null(model);
  MUST(jalon_model_create_mesh(NULL, JALON_FLOAT64, 0, 0, NULL, 0, NULL, &model));
  assert_ptr_equal(jalon_model_retain(model), model);
  jalon_model_release(model);
  jalon_model_release(model);
  jalon_model_release(NULL);
  assert_null(jalon_model_retain(NULL));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(mesh__gives_back_vertices_triangles_and_ids),
      cmocka_unit_test(mesh__numbers_faces_by_triangle_when_no_ids_are_given),
      cmocka_unit_test(mesh__has_one_part_and_tables_of_every_kind),
      cmocka_unit_test(mesh__refuses_what_is_impossible),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
