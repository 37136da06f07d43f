/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * One scan laid onto another: the pose, what it is worth, and the moved scan.
 * Build:  cc 04_register.c $(pkg-config --cflags --libs jalon) -lm -o register
 * Run:    ./register reference.las moving.las registered.las
 */
#include <jalon/jalon.h>
#include <math.h>
#include <stdio.h>

static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

static int print_pose(const jalon_registration* registration) {
  jalon_transform pose;
  jalon_fields* summary = NULL;
  jalon_array_view converged, covariance;
  int i, bad = failed(jalon_registration_pose(registration, &pose)) ||
               failed(jalon_registration_summary(registration, &summary)) ||
               failed(jalon_fields_view(summary, "converged", &converged)) ||
               failed(jalon_fields_view(summary, "covariance", &covariance));
  for (i = 0; !bad && i < 3; ++i)
    printf("%.6f %.6f %.6f %.4f\n", pose.m[4 * i], pose.m[4 * i + 1], pose.m[4 * i + 2],
           pose.m[4 * i + 3]);
  if (!bad) {
    const double* c = covariance.data; /* of rotation and shift, 6 x 6 */
    const char* outcome = *(const uint8_t*)converged.data ? "converged" : "not converged";
    printf("%s, sigma of the shift %.2f %.2f %.2f mm\n", outcome, 1000 * sqrt(c[21]),
           1000 * sqrt(c[28]), 1000 * sqrt(c[35]));
  }
  jalon_fields_release(summary);
  return bad;
}

int main(int argc, char** argv) {
  jalon_cloud *reference = NULL, *moving = NULL, *registered = NULL;
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  int bad;
  if (argc != 4) return fprintf(stderr, "usage: %s REFERENCE MOVING REGISTERED\n", argv[0]), 2;
  bad = failed(jalon_cloud_read(argv[1], NULL, NULL, &reference)) ||
        failed(jalon_cloud_read(argv[2], NULL, NULL, &moving)) ||
        failed(jalon_registrar_create("icp", &registrar)) ||
        failed(jalon_registrar_run(registrar, reference, moving, NULL, NULL, &registration)) ||
        print_pose(registration) ||
        failed(jalon_registration_apply(registration, moving, NULL, &registered)) ||
        failed(jalon_cloud_write(registered, argv[3], NULL, NULL));
  jalon_cloud_release(registered);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  return bad;
}
