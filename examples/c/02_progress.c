/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * Arrays in, progress and cancel, arrays out: normals of points that a program holds in memory.
 * Build:  cc 02_progress.c $(pkg-config --cflags --libs jalon) -o progress
 */
#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>

static int32_t show(double fraction, const char* stage, void* user) {
  (void)user;
  fprintf(stderr, "\r%3.0f %% %s", 100 * fraction, stage);
  return 0; /* anything else cancels */
}

int main(void) {
  enum { SIDE = 1000 };
  float* xyz = malloc(sizeof(float) * 3 * SIDE * SIDE); /* a gentle dome of a million points */
  jalon_cloud* cloud = NULL;
  jalon_params* options = NULL;
  jalon_task* task = NULL;
  jalon_fields* fields = NULL;
  jalon_array_view normals;
  int i, bad;
  if (xyz == NULL) return 1;
  for (i = 0; i < SIDE * SIDE; ++i) {
    const float x = 0.01f * (float)(i % SIDE) - 5, y = 0.01f * (float)(i / SIDE) - 5;
    xyz[3 * i] = x, xyz[3 * i + 1] = y, xyz[3 * i + 2] = -0.02f * (x * x + y * y);
  }
  bad = jalon_cloud_create(xyz, JALON_FLOAT32, SIDE * SIDE, 0, 0, &cloud) != JALON_OK ||
        jalon_task_create(&task) != JALON_OK ||
        jalon_task_set_progress(task, show, NULL) != JALON_OK ||
        jalon_params_create("normals", &options) != JALON_OK ||
        jalon_params_set_int64(options, "k", 16) != JALON_OK ||
        jalon_cloud_compute_normals(cloud, options, task) != JALON_OK ||
        jalon_cloud_fields(cloud, &fields) != JALON_OK ||
        jalon_fields_view(fields, "normal", &normals) != JALON_OK;
  if (bad) fprintf(stderr, "%s\n", jalon_last_error_message());
  else {
    const float* n = (const float*)normals.data + 3 * (SIDE * SIDE / 2 + SIDE / 2);
    printf("\nnormal at the top: %.4f %.4f %.4f\n", n[0], n[1], n[2]);
  }
  jalon_fields_release(fields);
  jalon_params_release(options);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
  free(xyz);
  return bad;
}
