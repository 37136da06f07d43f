/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The tables of a model against each other: areas, edges and volumes worked out again from corners. */
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

typedef jalon_status (*table_getter)(const jalon_model*, jalon_fields**);

static jalon_fields* table_of(const jalon_model* model, table_getter get) {
  jalon_fields* table = NULL;
  MUST(get(model, &table));
  return table;
}

static uint64_t whole(const jalon_fields* table, const char* name, uint64_t i) {
  return (uint64_t)cell_of(table, name, i, 0);
}

/* Half the sum of the cross products of the ring's edges about the origin, along the normal. */
static double ring_area(const jalon_fields* vertices, const jalon_fields* corners, uint64_t first,
                        uint64_t count, const double normal[3]) {
  double twice = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t from = whole(corners, "vertex", first + i),
                   to = whole(corners, "vertex", first + (i + 1) % count);
    double a[3], b[3];
    for (uint32_t k = 0; k < 3; ++k)
      a[k] = cell_of(vertices, "xyz", from, k), b[k] = cell_of(vertices, "xyz", to, k);
    for (int k = 0; k < 3; ++k)
      twice += normal[k] * (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
  }
  return twice / 2;
}

static jalon_model* made_by(const wall_scene* scene, const char* method, double thickness_m) {
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create(method, &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  if (thickness_m > 0) MUST(jalon_params_set_double(params, "thickness_m", thickness_m));
  MUST(jalon_modeller_run(modeller, scene->cloud, scene->segmentation, NULL, &model));
  jalon_params_release(params);
  jalon_modeller_release(modeller);
  return model;
}

static void tables__tell_areas_that_follow_from_their_corners(void** state) {
  (void)state;
  jalon_model* model = model_of_scene(&measured_wall);
  jalon_fields *vertices = table_of(model, jalon_model_vertices),
               *faces = table_of(model, jalon_model_faces),
               *rings = table_of(model, jalon_model_rings),
               *corners = table_of(model, jalon_model_corners);
  uint64_t next_ring = 0, next_corner = 0;
  assert_true(rows_of(faces, "part") >= 1);
  for (uint64_t f = 0; f < rows_of(faces, "part"); ++f) {
    double normal[3], area = 0;
    for (uint32_t k = 0; k < 3; ++k) normal[k] = cell_of(faces, "normal", f, k);
    assert_true(fabs(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] - 1) <
                1e-12);
    assert_true(whole(faces, "first_ring", f) ==
                next_ring); /* rings of faces, one after the other */
    for (uint64_t r = 0; r < whole(faces, "ring_count", f); ++r, ++next_ring) {
      const uint64_t first = whole(rings, "first", next_ring),
                     count = whole(rings, "count", next_ring);
      assert_true(first == next_corner && count >= 3);
      next_corner += count;
      const double signed_area = ring_area(vertices, corners, first, count, normal);
      assert_true(r == 0 ? signed_area > 0 : signed_area < 0); /* outline and openings turn about */
      area += signed_area;
      for (uint64_t i = first; i < next_corner; ++i) {
        double height = -cell_of(faces, "offset", f, 0);
        for (uint32_t k = 0; k < 3; ++k)
          height += normal[k] * cell_of(vertices, "xyz", whole(corners, "vertex", i), k);
        assert_true(fabs(height) < 1e-9);
        assert_true(cell_of(corners, "sagitta", i, 0) == 0);
      }
    }
    assert_true(fabs(cell_of(faces, "area", f, 0) - area) < 1e-9 * area);
  }
  assert_int_equal(next_ring, rows_of(rings, "first"));
  assert_int_equal(next_corner, rows_of(corners, "vertex"));
  /* 6 x 4 m less a window of 1.2 x 1.5 m; the lattice of 3 cm blurs each border by half a step */
  assert_true(fabs(cell_of(faces, "area", 0, 0) - (24 - 1.8)) < (20 + 5.4) * 0.03);
  jalon_fields_release(vertices), jalon_fields_release(faces);
  jalon_fields_release(rings), jalon_fields_release(corners);
  jalon_model_release(model);
}

static void tables__of_a_solid_close_around_its_volume(void** state) {
  (void)state;
  jalon_model* model = made_by(&measured_wall, "extrusion", 0.25);
  jalon_fields *vertices = table_of(model, jalon_model_vertices),
               *faces = table_of(model, jalon_model_faces),
               *rings = table_of(model, jalon_model_rings),
               *corners = table_of(model, jalon_model_corners),
               *edges = table_of(model, jalon_model_edges),
               *solids = table_of(model, jalon_model_solids);
  const uint64_t count = rows_of(faces, "part");
  assert_int_equal(rows_of(solids, "part"), 1);
  assert_int_equal(whole(solids, "first_face", 0), 0);
  assert_int_equal(whole(solids, "face_count", 0), count);
  /* The divergence theorem: a third of the sum of area times height over the origin. */
  double volume = 0, largest = 0;
  for (uint64_t f = 0; f < count; ++f) {
    const double area = cell_of(faces, "area", f, 0);
    volume += area * cell_of(faces, "offset", f, 0) / 3;
    largest = area > largest ? area : largest;
  }
  assert_true(fabs(volume - 0.25 * largest) < 1e-9);
  /* Each edge once, ascending, between two faces; each pair of neighbours in a ring is one. */
  uint64_t uses = 0, last = 0;
  for (uint64_t i = 0; i < rows_of(edges, "from"); ++i) {
    const uint64_t from = whole(edges, "from", i), to = whole(edges, "to", i);
    assert_true(from < to && to < rows_of(vertices, "xyz"));
    assert_true(i == 0 || (from << 32 | to) > last);
    assert_true(whole(edges, "first_face", i) < count && whole(edges, "second_face", i) < count);
    assert_true(whole(edges, "first_face", i) != whole(edges, "second_face", i));
    last = from << 32 | to;
    uses += whole(edges, "uses", i);
  }
  assert_int_equal(uses, rows_of(corners, "vertex"));
  jalon_fields_release(vertices), jalon_fields_release(faces), jalon_fields_release(rings);
  jalon_fields_release(corners), jalon_fields_release(edges), jalon_fields_release(solids);
  jalon_model_release(model);
}

static void tables__of_parts_agree_with_what_tells_them_one_by_one(void** state) {
  (void)state;
  jalon_model* model = made_by(&measured_wall, "facade", 0);
  jalon_fields *parts = table_of(model, jalon_model_parts),
               *rings = table_of(model, jalon_model_rings),
               *vertices = table_of(model, jalon_model_vertices);
  uint64_t count = 0, windows = 0;
  MUST(jalon_model_part_count(model, &count));
  assert_int_equal(rows_of(parts, "parent"), count);
  jalon_array_view parents;
  MUST(jalon_fields_view(parts, "parent", &parents));
  for (uint64_t i = 0; i < count; ++i) {
    const char* part_class = NULL;
    uint64_t parent = 0;
    MUST(jalon_model_part(model, i, NULL, &part_class, &parent));
    assert_true(((const uint64_t*)parents.data)[i] == parent);
    if (strcmp(part_class, "window") != 0 && strcmp(part_class, "opening") != 0) continue;
    /* The window of 1.2 x 1.5 m, between points 3 cm apart. */
    ++windows;
    assert_true(fabs(cell_of(parts, "width", i, 0) - 1.2) < 0.06);
    assert_true(fabs(cell_of(parts, "height", i, 0) - 1.5) < 0.06);
    int is_filler = 0;
    for (uint64_t r = 0; r < rows_of(rings, "part"); ++r) is_filler |= whole(rings, "part", r) == i;
    assert_true(is_filler);
  }
  assert_int_equal(windows, 1);
  /* Covariances are symmetric with variances above zero, or not known at all. */
  for (uint64_t i = 0; i < rows_of(vertices, "xyz"); ++i)
    for (uint32_t k = 0; k < 9; ++k) {
      const double c = cell_of(vertices, "covariance", i, k);
      const double other = cell_of(vertices, "covariance", i, 3 * (k % 3) + k / 3);
      assert_true(isnan(c) ? isnan(other) : fabs(c - other) < 1e-15);
      assert_true(k % 4 != 0 || isnan(c) || c > 0);
    }
  jalon_fields_release(parts), jalon_fields_release(rings), jalon_fields_release(vertices);
  jalon_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(tables__tell_areas_that_follow_from_their_corners),
      cmocka_unit_test(tables__of_a_solid_close_around_its_volume),
      cmocka_unit_test(tables__of_parts_agree_with_what_tells_them_one_by_one),
  };
  return cmocka_run_group_tests(tests, make_measured_wall, release_measured_wall);
}
