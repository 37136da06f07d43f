/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A short drive through a street, as a user has it and as it was; after cmocka.h and OK. */
#ifndef JALON_TESTS_CAPI_DRIVE_H
#define JALON_TESTS_CAPI_DRIVE_H

#include <jalon/jalon.h>

typedef struct Drive {
  jalon_model *model, *true_model;
  jalon_trajectory *trajectory, *true_trajectory;
  jalon_cloud* cloud;
} Drive;

static Drive drive_of(int64_t scenario) {
  Drive made;
  jalon_params* options = NULL;
  OK(jalon_params_create("drive_scenario", &options));
  OK(jalon_params_set_int64(options, "scenario", scenario));
  OK(jalon_params_set_double(options, "leg_m", 60));
  OK(jalon_params_set_double(options, "revolutions_per_s", 10));
  OK(jalon_params_set_int64(options, "pulses", 400));
  OK(jalon_scene_drive_scenario(options, NULL, &made.model, &made.trajectory, &made.cloud,
                                &made.true_model, &made.true_trajectory));
  jalon_params_release(options);
  return made;
}

static void release_drive(Drive* drive) {
  jalon_model_release(drive->model);
  jalon_model_release(drive->true_model);
  jalon_trajectory_release(drive->trajectory);
  jalon_trajectory_release(drive->true_trajectory);
  jalon_cloud_release(drive->cloud);
}

#endif
