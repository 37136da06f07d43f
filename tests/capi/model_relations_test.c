/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* How the parts, faces and solids of a measured wall lie to each other. */
#include "lifted_square.h"
#include "wall_scene.h"

static wall_scene measured_wall;

static int make_measured_wall(void** state) {
  (void)state;
  measured_wall = make_wall_scene();
  return 0;
}

static int release_measured_wall(void** state) {
  (void)state;
  release_scene(&measured_wall);
  return 0;
}

static jalon_model* made_by(const char* method) {
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create(method, &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  if (strcmp(method, "extrusion") == 0) MUST(jalon_params_set_double(params, "thickness_m", 0.25));
  MUST(jalon_modeller_run(modeller, measured_wall.cloud, measured_wall.segmentation, NULL, &model));
  jalon_params_release(params);
  jalon_modeller_release(modeller);
  return model;
}

static jalon_fields* relations_of(const jalon_model* model, const char* of) {
  jalon_params* options = NULL;
  jalon_fields* table = NULL;
  MUST(jalon_params_create("relations", &options));
  MUST(jalon_params_set_string(options, "elements", of));
  MUST(jalon_model_relations(model, options, NULL, &table));
  jalon_params_release(options);
  return table;
}

static uint64_t part_of_class(const jalon_model* model, const char* wanted) {
  uint64_t count = 0;
  MUST(jalon_model_part_count(model, &count));
  for (uint64_t i = 0; i < count; ++i) {
    const char* part_class = NULL;
    MUST(jalon_model_part(model, i, NULL, &part_class, NULL));
    if (strcmp(part_class, wanted) == 0) return i;
  }
  return count;
}

static uint64_t row_of_pair(const jalon_fields* table, uint64_t first, uint64_t second) {
  uint64_t i = 0;
  while (i < rows_of(table, "first") && ((uint64_t)cell_of(table, "first", i, 0) != first ||
                                         (uint64_t)cell_of(table, "second", i, 0) != second))
    ++i;
  assert_true(i < rows_of(table, "first"));
  return i;
}

static void relations__a_wall_contains_its_opening(void** state) {
  (void)state;
  static const int kContains[9] = {-1, -1, 1, 1, 2, 2, -1, -1, 2};
  jalon_model* model = made_by("facade");
  jalon_fields* table = relations_of(model, "parts");
  const uint64_t opening = part_of_class(model, "window");
  uint64_t count = 0;
  MUST(jalon_model_part_count(model, &count));
  const uint64_t hole = opening < count ? opening : part_of_class(model, "opening");
  assert_true(hole < count);
  const uint64_t row = row_of_pair(table, part_of_class(model, "wall"), hole);
  assert_int_equal(cell_of(table, "relation", row, 0), JALON_RELATION_CONTAINS);
  for (uint32_t k = 0; k < 9; ++k) assert_int_equal(cell_of(table, "matrix", row, k), kContains[k]);
  assert_true(cell_of(table, "distance", row, 0) == 0);
  assert_int_equal(cell_of(table, "direction", row, 0), 0);
  /* the window's middle is at 2.6, 1.75 of a wall of 6 x 4 m, whichever side is its front */
  assert_true(fabs(fabs(cell_of(table, "offset", row, 0)) - 0.4) < 0.05);
  assert_true(fabs(cell_of(table, "offset", row, 1) + 0.25) < 0.05);
  jalon_fields_release(table);
  jalon_model_release(model);
}

static void relations__sides_of_a_solid_meet_along_their_edges(void** state) {
  (void)state;
  jalon_model* model = made_by("extrusion");
  jalon_fields *table = relations_of(model, "faces"), *edges = NULL;
  MUST(jalon_model_edges(model, &edges));
  for (uint64_t e = 0; e < rows_of(edges, "from"); ++e) {
    const uint64_t a = (uint64_t)cell_of(edges, "first_face", e, 0),
                   b = (uint64_t)cell_of(edges, "second_face", e, 0);
    const uint64_t row = row_of_pair(table, a < b ? a : b, a < b ? b : a);
    assert_int_equal(cell_of(table, "relation", row, 0), JALON_RELATION_MEET);
    assert_int_equal(cell_of(table, "matrix", row, 0), 1); /* the border of each, in a line */
    assert_int_equal(cell_of(table, "matrix", row, 8), 3); /* all else is space */
  }
  jalon_fields_release(edges);
  jalon_fields_release(table);
  jalon_model_release(model);
}

static void relations__refuse_what_cannot_be(void** state) {
  (void)state;
  jalon_fields* table = NULL;
  jalon_params *options = NULL, *other = NULL;
  jalon_model* model = model_of_scene(&measured_wall);
  MUST(jalon_params_create("relations", &options));
  MUST(jalon_params_set_string(options, "elements", "solids"));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_model_relations(model, options, NULL, &table));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(options, "elements", "roofs"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(options, "tolerance_m", 0));
  MUST(jalon_params_create("normals", &other));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_relations(model, other, NULL, &table));
  assert_null(table);
  jalon_params_release(other);
  jalon_params_release(options);
  jalon_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(relations__a_wall_contains_its_opening),
      cmocka_unit_test(relations__sides_of_a_solid_meet_along_their_edges),
      cmocka_unit_test(relations__refuse_what_cannot_be),
  };
  return cmocka_run_group_tests(tests, make_measured_wall, release_measured_wall);
}
