/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The scenario of what models and points are worth: a part of allocation_scenarios.h, which defines what it uses. */
#ifndef JALON_TEST_ALLOCATION_WORTH_H
#define JALON_TEST_ALLOCATION_WORTH_H

static jalon_status scenario_worth(void) {
  jalon_cloud* cloud = NULL;
  jalon_segmentation *segmentation = NULL, *again = NULL;
  jalon_model* model = NULL;
  jalon_model_evaluation* evaluation = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_fields* f[14] = {NULL};
  double range = 0;
  const jalon_transform pose = {{1, 0, 0, 10, 0, 1, 0, -25, 0, 0, 1, 1.7}};
  const double lengths[2] = {10, 9.5}, parts[2] = {1, 1};
  jalon_status status = segmented(&cloud, &segmentation, &model);
  TRY(jalon_model_evaluate(model, model, NULL, small_task, &evaluation));
  TRY(jalon_model_evaluation_pairs(evaluation, &f[0]));
  TRY(jalon_model_evaluation_automatic(evaluation, &f[1]));
  TRY(jalon_model_evaluation_reference(evaluation, &f[2]));
  TRY(jalon_model_evaluation_vertices(evaluation, &f[3]));
  TRY(jalon_model_evaluation_totals(evaluation, &f[4]));
  TRY(jalon_area_indices(lengths, lengths, parts, 2, NULL, &f[5], &f[6]));
  TRY(jalon_vertex_deviations(small_xyz, small_xyz + 3, 3, &f[7], &f[8]));
  TRY(jalon_precision_budget(lengths, NULL, NULL, 2, NULL, &f[9]));
  TRY(jalon_baseline_constant(lengths, parts, 2, &f[10]));
  TRY(jalon_angular_precision(lengths, parts, lengths, 2, &f[11]));
  TRY(jalon_phase_range(lengths, parts, 2, &range));
  TRY(jalon_cloud_range_precision(cloud, NULL, 0, small_task, &f[12]));
  TRY(jalon_cloud_set_station(cloud, "tripod", &pose));
  TRY(jalon_cloud_compute_covariances(cloud, NULL, small_task));
  TRY(jalon_segmenter_create(NULL, &segmenter));
  TRY(jalon_segmenter_run(segmenter, cloud, small_task, &again));
  TRY(jalon_segmentation_plane_covariances(again, NULL, small_task, &f[13]));
  for (int i = 0; i < 14; ++i) jalon_fields_release(f[i]);
  jalon_model_evaluation_release(evaluation);
  jalon_segmenter_release(segmenter);
  jalon_segmentation_release(again);
  jalon_model_release(model);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  return status;
}

#endif
