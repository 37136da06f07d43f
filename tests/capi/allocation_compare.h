/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The scenarios on two clouds: a part of allocation_scenarios.h, which defines what it uses. */
#ifndef JALON_TEST_ALLOCATION_COMPARE_H
#define JALON_TEST_ALLOCATION_COMPARE_H

/* A part of the facade came forward. */
static jalon_status changed_cloud(jalon_cloud** out) {
  static double xyz[3 * kSmall];
  memcpy(xyz, small_xyz, sizeof xyz);
  for (int i = 0; i < kSmall; ++i)
    if (xyz[3 * i] > 2 && xyz[3 * i] < 7 && xyz[3 * i + 2] > 3) xyz[3 * i + 1] -= 1;
  return jalon_cloud_create(xyz, JALON_FLOAT64, kSmall, 0, 0, out);
}

static jalon_status comparer_of(const char* method, const char* json, jalon_comparer** out) {
  jalon_params* params = NULL;
  jalon_status status = jalon_comparer_create(method, out);
  TRY(jalon_comparer_params(*out, &params));
  TRY(jalon_params_from_json(params, json));
  jalon_params_release(params);
  return status;
}

static jalon_status scenario_changes(void) {
  jalon_cloud *before = NULL, *after = NULL, *rows = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison *forward = NULL, *reverse = NULL;
  jalon_params *regions = NULL, *options = NULL;
  jalon_fields* f[9] = {NULL};
  jalon_model* outlines = NULL;
  const char* made_by = NULL;
  jalon_status status = small_cloud(&before);
  TRY(changed_cloud(&after));
  TRY(comparer_of("distance", "{\"local_model\": \"plane\", \"differences\": true}", &comparer));
  TRY(jalon_comparer_run(comparer, before, after, small_task, &forward));
  TRY(jalon_comparer_run(comparer, after, before, small_task, &reverse));
  TRY(jalon_comparison_points(forward, &f[0]));
  TRY(jalon_comparison_summary(forward, &f[1]));
  TRY(jalon_comparison_parameters(forward, &made_by));
  TRY(jalon_comparison_cloud(forward, &rows));
  jalon_cloud_release(rows), rows = NULL;
  TRY(jalon_comparison_closest_points(forward, before, small_task, &rows));
  TRY(options_of("regions", "{\"criterion\": \"threshold\", \"threshold_m\": 0.5, \"cell_m\": 1}",
                 &regions));
  TRY(jalon_comparison_regions(forward, regions, small_task, &f[2], &f[3]));
  TRY(options_of("diagnosis", "{\"criterion\": \"threshold\", \"threshold_m\": 0.5, \"cell_m\": 1}",
                 &options));
  TRY(jalon_comparison_diagnose(forward, reverse, options, small_task, &f[4], &f[5], &f[6]));
  TRY(jalon_comparison_outlines(forward, f[4], reverse, f[5], f[6], NULL, small_task, &outlines));
  TRY(jalon_cloud_volume(before, after, NULL, small_task, &f[7], NULL));
  TRY(jalon_cloud_overlap(before, after, small_task, &f[8]));
  for (int i = 0; i < 9; ++i) jalon_fields_release(f[i]);
  jalon_model_release(outlines);
  jalon_params_release(regions), jalon_params_release(options);
  jalon_comparison_release(forward), jalon_comparison_release(reverse);
  jalon_comparer_release(comparer);
  jalon_cloud_release(before), jalon_cloud_release(after), jalon_cloud_release(rows);
  return status;
}

static jalon_status scenario_m3c2(void) {
  const double corners[12] = {0, 0, 0, 20, 0, 0, 20, 0, 10, 0, 0, 10};
  const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  jalon_cloud *before = NULL, *after = NULL, *seen = NULL, *sampled = NULL;
  jalon_comparer *comparer = NULL, *from_model = NULL;
  jalon_comparison *comparison = NULL, *of_model = NULL;
  jalon_model* wall = NULL;
  jalon_params* options = NULL;
  jalon_fields *points = NULL, *parts = NULL;
  const jalon_transform pose = {{1, 0, 0, 10, 0, 1, 0, -25, 0, 0, 1, 1.7}};
  jalon_status status = small_cloud(&before);
  TRY(changed_cloud(&after));
  TRY(comparer_of("m3c2",
                  "{\"core_spacing_m\": 2, \"normal_radius_m\": 4, \"cylinder_radius_m\": 2}",
                  &comparer));
  TRY(jalon_comparer_run(comparer, before, after, small_task, &comparison));
  TRY(jalon_comparison_points(comparison, &points));
  TRY(jalon_model_create_mesh(corners, JALON_FLOAT64, 4, 0, triangles, 2, NULL, &wall));
  TRY(jalon_comparer_create("distance", &from_model));
  TRY(jalon_comparer_run_model(from_model, wall, after, small_task, &of_model));
  TRY(jalon_comparison_parts(of_model, &parts));
  TRY(options_of("model_sample", "{\"spacing_m\": 1}", &options));
  TRY(jalon_model_sample(wall, options, small_task, &sampled));
  TRY(jalon_cloud_set_station(before, "tripod", &pose));
  TRY(jalon_cloud_transform(after, &pose, small_task, &seen));
  TRY(jalon_cloud_compute_visibility(seen, before, NULL, small_task));
  jalon_fields_release(points), jalon_fields_release(parts);
  jalon_params_release(options);
  jalon_comparison_release(comparison), jalon_comparison_release(of_model);
  jalon_comparer_release(comparer), jalon_comparer_release(from_model);
  jalon_model_release(wall);
  jalon_cloud_release(before), jalon_cloud_release(after), jalon_cloud_release(seen),
      jalon_cloud_release(sampled);
  return status;
}

static jalon_status registered(const char* method, const char* json, const jalon_cloud* to,
                               const jalon_cloud* from, jalon_registration** out) {
  jalon_registrar* registrar = NULL;
  jalon_params* params = NULL;
  jalon_status status = jalon_registrar_create(method, &registrar);
  TRY(jalon_registrar_params(registrar, &params));
  TRY(jalon_params_from_json(params, json));
  TRY(jalon_registrar_run(registrar, to, from, NULL, small_task, out));
  jalon_params_release(params);
  jalon_registrar_release(registrar);
  return status;
}

/* Two clouds, the second some centimetres from the first. */
static jalon_status two_small_clouds(jalon_cloud** to, jalon_cloud** from) {
  const jalon_transform move = {{1, 0, 0, 0.05, 0, 1, 0, -0.02, 0, 0, 1, 0.03}};
  jalon_status status = small_cloud(to);
  TRY(jalon_cloud_transform(*to, &move, small_task, from));
  return status;
}

static jalon_status scenario_icp(void) {
  jalon_cloud *to = NULL, *from = NULL, *laid = NULL;
  jalon_registration* icp = NULL;
  jalon_fields* f[4] = {NULL};
  jalon_status status = two_small_clouds(&to, &from);
  TRY(registered("icp", "{\"k\": 8}", to, from, &icp));
  TRY(jalon_registration_summary(icp, &f[0]));
  TRY(jalon_registration_iterations(icp, &f[1]));
  TRY(jalon_registration_directions(icp, &f[2]));
  TRY(jalon_registration_residuals(icp, &f[3]));
  TRY(jalon_registration_apply(icp, from, small_task, &laid));
  TRY(jalon_report_write_registration(icp, to, from, NULL, small_path("a.html"), NULL, small_task));
  for (int i = 0; i < 4; ++i) jalon_fields_release(f[i]);
  jalon_registration_release(icp);
  jalon_cloud_release(to), jalon_cloud_release(from), jalon_cloud_release(laid);
  remove(small_path("a.html"));
  return status;
}

static jalon_status scenario_coarse(void) {
  jalon_cloud *to = NULL, *from = NULL;
  jalon_registration* coarse = NULL;
  jalon_status status = two_small_clouds(&to, &from);
  TRY(registered("coarse", "{\"cells\": 500}", to, from, &coarse));
  jalon_registration_release(coarse);
  jalon_cloud_release(to), jalon_cloud_release(from);
  return status;
}

static jalon_status scenario_targets(void) {
  static const double at[12] = {0, 0, 0, 9, 0, 1, 8, 7, 2, 1, 6, 0};
  static const char* const names[4] = {"a pillar north of the bridge", "B", "C", NULL};
  jalon_target to[4], from[4];
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  jalon_comparer* comparer = NULL;
  jalon_fields *residuals = NULL, *measured = NULL;
  jalon_cloud* cloud = NULL;
  const char* name = NULL;
  memset(to, 0, sizeof to);
  for (int i = 0; i < 4; ++i) {
    to[i].name = names[i];
    to[i].xyz.x = at[3 * i], to[i].xyz.y = at[3 * i + 1], to[i].xyz.z = at[3 * i + 2];
    from[i] = to[i];
    from[i].xyz.x += 2;
  }
  jalon_status status = jalon_registrar_create("targets", &registrar);
  TRY(jalon_registrar_run_targets(registrar, to, 4, from, 4, small_task, &registration));
  TRY(jalon_registration_residuals(registration, &residuals));
  TRY(jalon_registration_pair_name(registration, 0, &name));
  TRY(jalon_comparer_create("m3c2", &comparer));
  TRY(jalon_comparer_use_registration(comparer, registration));
  TRY(small_cloud(&cloud));
  TRY(jalon_cloud_measure_targets(cloud, small_xyz, 2, NULL, small_task, &measured));
  jalon_cloud_release(cloud);
  jalon_fields_release(residuals), jalon_fields_release(measured);
  jalon_comparer_release(comparer);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  return status;
}

#endif
