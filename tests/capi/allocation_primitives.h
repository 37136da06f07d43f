/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The scenario of fits and picks: a part of allocation_scenarios.h, which defines what it uses. */
#ifndef JALON_TEST_ALLOCATION_PRIMITIVES_H
#define JALON_TEST_ALLOCATION_PRIMITIVES_H

#include <math.h>

/* A ball of 300 points beside the street: fits, picks, and planes and spheres in one run. */
static jalon_status scenario_primitives(void) {
  enum { kBall = 300 };
  double xyz[3 * (kSmall + kBall)];
  uint64_t ball[kBall];
  const double four[12] = {5.5, -4, 1, 5, -3.5, 1, 5, -4, 1.5, 4.5, -4, 1};
  const double corners[9] = {0, 0, 0, 20, 0, 0, 20, 0, 10};
  const jalon_vec3 up = {0, 0, 1};
  jalon_cloud *cloud = NULL, *rest = NULL;
  jalon_fields *sphere = NULL, *cylinder = NULL, *circle = NULL;
  jalon_segmentation *start = NULL, *picked = NULL, *both = NULL, *run = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_params *wide = NULL, *params = NULL;
  memcpy(xyz, small_xyz, sizeof small_xyz);
  for (uint64_t i = 0; i < kBall; ++i) {
    const double a = 6.283185307179586 * uniform(5, 2 * i), z = 2 * uniform(5, 2 * i + 1) - 1,
                 s = sqrt(1 - z * z);
    double* p = xyz + 3 * (kSmall + i);
    p[0] = 5 + 0.5 * s * cos(a), p[1] = -4 + 0.5 * s * sin(a), p[2] = 1 + 0.5 * z;
    ball[i] = kSmall + i;
  }
  jalon_status status = jalon_cloud_create(xyz, JALON_FLOAT64, kSmall + kBall, 0, 0, &cloud);
  TRY(options_of("primitive", "{\"tolerance_m\": 4, \"robust\": false}", &wide));
  TRY(jalon_cloud_fit_sphere(cloud, ball, kBall, NULL, small_task, &sphere));
  TRY(jalon_cloud_fit_cylinder(cloud, ball, kBall, &up, wide, small_task, &cylinder));
  TRY(jalon_cloud_fit_circle(cloud, ball, kBall, wide, small_task, &circle));
  TRY(jalon_segmentation_start(cloud, small_task, &start));
  TRY(jalon_segmentation_pick(start, JALON_PRIMITIVE_SPHERE, four, 4, NULL, small_task, &picked));
  TRY(jalon_segmentation_pick(picked, JALON_PRIMITIVE_PLANE, corners, 3, NULL, small_task, &both));
  TRY(jalon_segmentation_remaining(both, small_task, &rest));
  TRY(jalon_segmentation_write_primitives(both, small_path("primitives.txt")));
  TRY(jalon_segmenter_create(NULL, &segmenter));
  TRY(jalon_segmenter_params(segmenter, &params));
  TRY(jalon_params_set_string(params, "primitives", "all"));
  TRY(jalon_segmenter_run(segmenter, cloud, small_task, &run));
  remove(small_path("primitives.txt"));
  jalon_fields* fields[] = {sphere, cylinder, circle};
  for (int i = 0; i < 3; ++i) jalon_fields_release(fields[i]);
  jalon_segmentation* segmentations[] = {start, picked, both, run};
  for (int i = 0; i < 4; ++i) jalon_segmentation_release(segmentations[i]);
  jalon_params_release(wide);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(rest);
  jalon_cloud_release(cloud);
  return status;
}

#endif
