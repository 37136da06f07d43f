/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Models and results as bytes and back. */
#include "bytes_support.h"
#include "lifted_square.h"
#include "wall_scene.h"

/* ---- what is written ---- */

/* Points on a floor and a wall, and which is which. */
static jalon_cloud* labelled_cloud(void) {
  enum { kSide = 6, kAll = 2 * kSide * kSide };
  double xyz[3 * kAll];
  uint8_t label[kAll];
  for (int i = 0; i < kAll; ++i) {
    const int wall = i >= kSide * kSide, k = i % (kSide * kSide);
    const double u = 0.2 * (k % kSide), v = 0.2 * (k / kSide),
                 noise = 0.004 * uniform(9, (uint64_t)i);
    xyz[3 * i] = 652000 + u;
    xyz[3 * i + 1] = 6861000 + (wall ? noise : v);
    xyz[3 * i + 2] = wall ? v : noise;
    label[i] = (uint8_t)(i % 17 == 0 ? 0 : wall + 1);
  }
  jalon_cloud* cloud = cloud_of(xyz, kAll);
  MUST(jalon_cloud_set_field(cloud, "label", label, JALON_UINT8, 1, kAll, 0, NULL, NULL));
  MUST(jalon_cloud_set_crs(cloud, "EPSG:2154"));
  return cloud;
}

static void* made_segmentation(void) {
  jalon_cloud* cloud = labelled_cloud();
  jalon_segmentation* made = NULL;
  MUST(jalon_segmentation_from_labels(cloud, "label", NULL, NULL, &made));
  jalon_cloud_release(cloud);
  return made;
}

/* Two faces in a tree of parts. */
static void* made_model(void) {
  jalon_cloud* cloud = NULL;
  jalon_segmentation* segmentation = made_segmentation();
  jalon_modeller* modeller = NULL;
  jalon_model* made = NULL;
  jalon_fields* faces = NULL;
  MUST(jalon_segmentation_cloud(segmentation, &cloud));
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_modeller_run(modeller, cloud, segmentation, NULL, &made));
  MUST(jalon_model_faces(made, &faces));
  assert_int_equal(rows_of(faces, "id"), 2);
  jalon_fields_release(faces);
  jalon_modeller_release(modeller);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  return made;
}

static void* made_mesh(void) {
  const double vertices[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t triangles[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3},
                 ids[4] = {7, 8, 9, 4000000000u};
  jalon_model* made = NULL;
  MUST(jalon_model_create_mesh(vertices, JALON_FLOAT64, 4, 0, triangles, 4, ids, &made));
  return made;
}

static void* made_comparison(void) {
  jalon_cloud *reference = labelled_cloud(), *compared = NULL;
  const jalon_transform lift = {{1, 0, 0, 0.01, 0, 1, 0, 0, 0, 0, 1, 0.3}};
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_comparison* made = NULL;
  MUST(jalon_cloud_transform(reference, &lift, NULL, &compared));
  MUST(jalon_comparer_create(NULL, &comparer));
  MUST(jalon_comparer_params(comparer, &params));
  MUST(jalon_params_set_bool(params, "differences", 1));
  MUST(jalon_comparer_run(comparer, reference, compared, NULL, &made));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(reference);
  jalon_cloud_release(compared);
  return made;
}

static void* made_registration(void) {
  static const char* const kNames[5] = {"A", "B", "", "D", "E"};
  const double xyz[5][3] = {{0, 0, 0}, {9, 0, 1}, {1, 8, 0}, {7, 6, 2}, {3, 3, 5}};
  jalon_target reference[5], moving[5];
  jalon_registrar* registrar = NULL;
  jalon_registration* made = NULL;
  memset(reference, 0, sizeof reference);
  memset(moving, 0, sizeof moving);
  for (int i = 0; i < 5; ++i) {
    reference[i].name = moving[i].name = kNames[i];
    reference[i].xyz = (jalon_vec3){xyz[i][0], xyz[i][1], xyz[i][2]};
    moving[i].xyz = (jalon_vec3){xyz[i][1] + 0.001 * i, -xyz[i][0], xyz[i][2] - 30};
  }
  MUST(jalon_registrar_create("targets", &registrar));
  MUST(jalon_registrar_run_targets(registrar, reference, 5, moving, 5, NULL, &made));
  jalon_registrar_release(registrar);
  return made;
}

static void* made_evaluation(void) {
  jalon_segmentation* segmentation = made_segmentation();
  jalon_evaluation* made = NULL;
  MUST(jalon_segmentation_evaluate(segmentation, segmentation, NULL, NULL, &made));
  jalon_segmentation_release(segmentation);
  return made;
}

static void* made_model_evaluation(void) {
  jalon_model* model = made_model();
  jalon_model_evaluation* made = NULL;
  MUST(jalon_model_evaluate(model, model, NULL, NULL, &made));
  jalon_model_release(model);
  return made;
}

static void* made_law(void) {
  jalon_noise_law* made = NULL;
  MUST(jalon_noise_law_from_json(
      "{\"law\": \"weibull\", \"shape\": 1.9, \"scale\": 0.004, \"shift\": -0.1, \"samples\": 77}",
      &made));
  return made;
}

/* ---- what users do with what came back: no status but a defect of Jalon is a surprise ---- */

static void survived(jalon_status status) {
  if (status == JALON_ERROR_INTERNAL) fail_msg("%s", jalon_last_error_message());
}

#define SEE_TABLE(call)                                 \
  do {                                                  \
    jalon_fields* table_ = NULL;                        \
    const jalon_status made_ = (call)(object, &table_); \
    survived(made_);                                    \
    jalon_fields_release(table_);                       \
  } while (0)

static void look_at_model(void* object) {
  const jalon_model* model = object;
  jalon_model* changed = NULL;
  jalon_fields* summary = NULL;
  jalon_cloud* points = cloud_of((const double[6]){0, 0, 0, 1, 1, 1}, 2);
  uint64_t parts = 0;
  SEE_TABLE(jalon_model_vertices);
  SEE_TABLE(jalon_model_faces);
  SEE_TABLE(jalon_model_corners);
  SEE_TABLE(jalon_model_edges);
  SEE_TABLE(jalon_model_triangles);
  SEE_TABLE(jalon_model_parts);
  MUST(jalon_model_part_count(model, &parts));
  for (uint64_t i = 0; i < parts; ++i) {
    survived(jalon_model_remove_copy(model, i, &changed));
    jalon_model_release(changed);
    changed = NULL;
  }
  survived(jalon_model_clearance(model, JALON_WHOLE_MODEL, points, NULL, NULL, &summary, NULL));
  jalon_fields_release(summary);
  jalon_cloud_release(points);
  survived(jalon_model_write(model, temporary("bytes.obj"), NULL, NULL));
  survived(jalon_model_write(model, temporary("bytes.city.json"), NULL, NULL));
  remove(temporary("bytes.obj"));
  remove(temporary("bytes.city.json"));
}

static void look_at_segmentation(void* object) {
  const jalon_segmentation* segmentation = object;
  jalon_cloud* cloud = NULL;
  jalon_fields *bins = NULL, *normal = NULL;
  jalon_evaluation* evaluation = NULL;
  SEE_TABLE(jalon_segmentation_points);
  SEE_TABLE(jalon_segmentation_segments);
  MUST(jalon_segmentation_cloud(segmentation, &cloud));
  for (uint32_t label = 0; label < 3; ++label) {
    survived(jalon_segmentation_residuals(segmentation, label, 20, NULL, &bins, &normal));
    jalon_fields_release(bins), jalon_fields_release(normal);
    bins = normal = NULL;
  }
  survived(jalon_segmentation_evaluate(segmentation, segmentation, NULL, NULL, &evaluation));
  jalon_evaluation_release(evaluation);
  survived(jalon_report_write_json(segmentation, NULL, NULL, temporary("bytes.json"), NULL, NULL));
  remove(temporary("bytes.json"));
  jalon_cloud_release(cloud);
}

static void look_at_comparison(void* object) {
  const jalon_comparison* comparison = object;
  jalon_cloud* cloud = NULL;
  jalon_fields *points = NULL, *regions = NULL, *changes = NULL;
  SEE_TABLE(jalon_comparison_points);
  SEE_TABLE(jalon_comparison_summary);
  SEE_TABLE(jalon_comparison_parts);
  MUST(jalon_comparison_cloud(comparison, &cloud));
  survived(jalon_comparison_regions(comparison, NULL, NULL, &points, &regions));
  jalon_fields_release(points), jalon_fields_release(regions);
  jalon_params* options = options_of("diagnosis", "{\"threshold_m\": 0.1}");
  survived(jalon_comparison_diagnose(comparison, comparison, options, NULL, NULL, NULL, &changes));
  jalon_params_release(options);
  jalon_fields_release(changes);
  jalon_cloud* closest = NULL;
  survived(jalon_comparison_closest_points(comparison, cloud, NULL, &closest));
  jalon_cloud_release(closest);
  jalon_cloud_release(cloud);
}

static void look_at_registration(void* object) {
  const jalon_registration* registration = object;
  const char* name = NULL;
  jalon_cloud *cloud = labelled_cloud(), *moved = NULL;
  jalon_comparer* comparer = NULL;
  SEE_TABLE(jalon_registration_summary);
  SEE_TABLE(jalon_registration_iterations);
  SEE_TABLE(jalon_registration_residuals);
  SEE_TABLE(jalon_registration_directions);
  for (uint64_t i = 0; i < 6; ++i) survived(jalon_registration_pair_name(registration, i, &name));
  survived(jalon_registration_apply(registration, cloud, NULL, &moved));
  MUST(jalon_comparer_create("m3c2", &comparer));
  survived(jalon_comparer_use_registration(comparer, registration));
  jalon_comparer_release(comparer);
  survived(jalon_report_write_registration(registration, cloud, cloud, NULL,
                                           temporary("bytes.html"), NULL, NULL));
  remove(temporary("bytes.html"));
  jalon_cloud_release(moved);
  jalon_cloud_release(cloud);
}

static void look_at_evaluation(void* object) {
  SEE_TABLE(jalon_evaluation_pairs);
  SEE_TABLE(jalon_evaluation_automatic);
  SEE_TABLE(jalon_evaluation_reference);
  SEE_TABLE(jalon_evaluation_totals);
}

static void look_at_model_evaluation(void* object) {
  SEE_TABLE(jalon_model_evaluation_pairs);
  SEE_TABLE(jalon_model_evaluation_automatic);
  SEE_TABLE(jalon_model_evaluation_reference);
  SEE_TABLE(jalon_model_evaluation_vertices);
  SEE_TABLE(jalon_model_evaluation_totals);
}

static void look_at_law(void* object) {
  const double at[2] = {0.001, 0.01};
  double density[2], cumulative[2];
  SEE_TABLE(jalon_noise_law_table);
  MUST(jalon_noise_law_evaluate(object, at, 2, density, cumulative));
}

/* ---- all kinds ---- */

KIND_CALLS(model, NULL_TASK, NULL_TASK)
KIND_CALLS(segmentation, NULL_TASK, NULL_TASK)
KIND_CALLS(comparison, NULL_TASK, NULL_TASK)
KIND_CALLS(registration, NULL_TASK, NULL_TASK)
KIND_CALLS(evaluation, NO_TASK, NO_TASK)
KIND_CALLS(model_evaluation, NO_TASK, NO_TASK)
KIND_CALLS(noise_law, NO_TASK, NO_TASK)

#define RESULT(noun, make, look) \
  { #noun, make, noun##_write, noun##_read, look, noun##_release }
static const object_kind kKinds[] = {
    RESULT(model, made_model, look_at_model),
    RESULT(model, made_mesh, look_at_model),
    RESULT(segmentation, made_segmentation, look_at_segmentation),
    RESULT(comparison, made_comparison, look_at_comparison),
    RESULT(registration, made_registration, look_at_registration),
    RESULT(evaluation, made_evaluation, look_at_evaluation),
    RESULT(model_evaluation, made_model_evaluation, look_at_model_evaluation),
    RESULT(noise_law, made_law, look_at_law)};
enum { kKindCount = sizeof kKinds / sizeof *kKinds };

static void results__come_back_bit_by_bit(void** state) {
  (void)state;
  for (int k = 0; k < kKindCount; ++k) comes_back(&kKinds[k]);
}

/* Of every method of every worker: whatever a result can hold comes back. */
static void results_of_all_methods__come_back(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_cloud* moved = NULL;
  const jalon_transform shift = {{1, 0, 0, 0.004, 0, 1, 0, 0.01, 0, 0, 1, 0.003}};
  const char* const* names = NULL;
  uint64_t count = 0, total = 0;
  MUST(jalon_cloud_transform(scene.cloud, &shift, NULL, &moved));
#define EACH(noun, result, run_arguments)                           \
  MUST(jalon_##noun##_methods(&names, &count));                     \
  for (uint64_t i = 0; i < count; ++i) {                            \
    jalon_##noun* worker = NULL;                                    \
    jalon_##result *made = NULL, *back = NULL;                      \
    MUST(jalon_##noun##_create(names[i], &worker));                 \
    if (jalon_##noun##_run run_arguments == JALON_OK) {             \
      size_t bytes = 0, again = 0;                                  \
      const object_kind kind = RESULT(result, NULL, NULL);          \
      uint8_t* first = bytes_of(&kind, made, &bytes);               \
      MUST(jalon_##result##_from_bytes(first, bytes, NULL, &back)); \
      uint8_t* second = bytes_of(&kind, back, &again);              \
      assert_int_equal(bytes, again);                               \
      assert_memory_equal(first, second, bytes);                    \
      free(first), free(second);                                    \
      jalon_##result##_release(back);                               \
      jalon_##result##_release(made);                               \
      ++total;                                                      \
    }                                                               \
    jalon_##noun##_release(worker);                                 \
  }
  EACH(segmenter, segmentation, (worker, scene.cloud, NULL, &made))
  EACH(comparer, comparison, (worker, scene.cloud, moved, NULL, &made))
  EACH(registrar, registration, (worker, scene.cloud, moved, NULL, NULL, &made))
  EACH(modeller, model, (worker, scene.cloud, scene.segmentation, NULL, &made))
  assert_true(total >= 9);
  jalon_cloud_release(moved);
  release_scene(&scene);
}

/* Cloud and segmentation that came back each for itself are of the same points still. */
static void segmentation__from_bytes_models_the_cloud_from_bytes(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene(), back = {NULL, NULL};
  size_t counts[2];
  jalon_bytes* written = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_to_bytes(scene.cloud, NULL, &written));
  MUST(jalon_bytes_view(written, &view));
  MUST(jalon_cloud_from_bytes(view.data, view.count, NULL, &back.cloud));
  jalon_bytes_release(written);
  MUST(jalon_segmentation_to_bytes(scene.segmentation, NULL, &written));
  MUST(jalon_bytes_view(written, &view));
  MUST(jalon_segmentation_from_bytes(view.data, view.count, NULL, &back.segmentation));
  jalon_bytes_release(written);
  jalon_model *model = model_of_scene(&scene), *same = model_of_scene(&back);
  uint8_t *bytes = bytes_of(&kKinds[0], model, &counts[0]),
          *others = bytes_of(&kKinds[0], same, &counts[1]);
  assert_int_equal(counts[0], counts[1]);
  assert_memory_equal(bytes, others, counts[0]);
  free(bytes), free(others);
  jalon_model_release(model), jalon_model_release(same);
  release_scene(&scene);
  release_scene(&back);
}

static void damaged_bytes__are_refused(void** state) {
  (void)state;
  for (int k = 0; k < kKindCount; ++k) damage_is_told(&kKinds[k]);
}

static void made_up_bytes__are_refused_or_whole(void** state) {
  (void)state;
  const int tries = is_full_run() ? 20000 : is_sanitized() ? 100 : 300;
  for (int k = 0; k < kKindCount; ++k)
    assert_true(made_up_is_survived(&kKinds[k], (uint64_t)(k + 40), tries) > tries / 20);
}

static void bytes_of_others__are_told_apart(void** state) {
  (void)state;
  for (int k = 1; k < kKindCount; ++k)
    strangers_are_told(&kKinds[k], &kKinds[(k + 1) % kKindCount]);
}

/* Nearest points beyond the other cloud are an error of the caller's, not a look into other memory. */
static void diagnosis__of_comparisons_that_do_not_belong_together_is_refused(void** state) {
  (void)state;
  jalon_cloud *large = floor_cloud(0), *lifted = floor_cloud(1), *small = NULL;
  const uint64_t first[3] = {0, 1, 2};
  MUST(jalon_cloud_select(lifted, first, 3, NULL, &small));
  jalon_comparison *forward = compared_by("distance", large, lifted),
                   *reverse = compared_by("distance", large, small);
  jalon_params* options = options_of("diagnosis", "{\"threshold_m\": 0.1}");
  jalon_fields* changes = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_diagnose(forward, reverse, options, NULL, NULL, NULL, &changes));
  expect_message("not of the same two clouds");
  assert_null(changes);
  jalon_params_release(options);
  jalon_comparison_release(forward), jalon_comparison_release(reverse);
  jalon_cloud_release(large), jalon_cloud_release(lifted), jalon_cloud_release(small);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(results__come_back_bit_by_bit),
      cmocka_unit_test(results_of_all_methods__come_back),
      cmocka_unit_test(segmentation__from_bytes_models_the_cloud_from_bytes),
      cmocka_unit_test(damaged_bytes__are_refused),
      cmocka_unit_test(made_up_bytes__are_refused_or_whole),
      cmocka_unit_test(bytes_of_others__are_told_apart),
      cmocka_unit_test(diagnosis__of_comparisons_that_do_not_belong_together_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
