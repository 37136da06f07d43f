/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_icp PREFIX: Jalon's registrar "icp" with its defaults through its public C interface, PREFIX_moved.f64 onto
 * PREFIX.f64; the protocol is that of driver.h. Indices and normals are part of the time; the sample is the pose. */

#include "jalon_driver.h"

static uint64_t iterations_of(const jalon_registration* registration) {
  jalon_fields* fields = NULL;
  jalon_array_view iterations;
  uint64_t count;
  check(jalon_registration_summary(registration, &fields));
  check(jalon_fields_view(fields, "iterations", &iterations));
  count = *(const uint64_t*)iterations.data;
  jalon_fields_release(fields);
  return count;
}

static Result run(const char* name, void* scene, jalon_task* task, FILE* sample) {
  const Points* points = scene;
  jalon_cloud *reference = NULL, *moving = NULL;
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  jalon_transform pose;
  double start;
  Result result;
  (void)name;
  check(jalon_cloud_create(points[0].xyz, JALON_FLOAT64, points[0].count, 24, 0, &reference));
  check(jalon_cloud_create(points[1].xyz, JALON_FLOAT64, points[1].count, 24, 0, &moving));
  check(jalon_registrar_create("icp", &registrar));
  start = now();
  check(jalon_registrar_run(registrar, reference, moving, NULL, task, &registration));
  result.seconds = now() - start;
  check(jalon_registration_pose(registration, &pose));
  if (sample != NULL) fwrite(pose.m, sizeof(double), 12, sample);
  result.count = iterations_of(registration);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  return result;
}

int main(int argc, char** argv) {
  Points points[2];
  int code;
  if (argc < 2) return 2;
  points[0] = load(argv[1], ".f64");
  points[1] = load(argv[1], "_moved.f64");
  code = serve("icp", points[0].count, points, run);
  free(points[0].xyz);
  free(points[1].xyz);
  return code;
}
