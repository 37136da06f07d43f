/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Direct georeferencing of a drive of mobile mapping: returns of a plane scanner a second, with and
 * without covariances. The best of five runs each. */
#include <math.h>

#include "jalon_driver.h"

enum { EPOCHS = 6000, RETURNS = 8000000, RUNS = 5 }; /* a minute at 100 Hz */

static double* column(uint64_t count) {
  double* made = malloc(count * sizeof *made);
  if (made == NULL) exit(1);
  return made;
}

static jalon_trajectory* drive(void) {
  double *times = column(EPOCHS), *positions = column(3 * EPOCHS), *attitudes = column(3 * EPOCHS),
         *sigmas = column(3 * EPOCHS);
  jalon_trajectory* made = NULL;
  for (int i = 0; i < EPOCHS; ++i) {
    const double t = 0.01 * i;
    times[i] = t;
    positions[3 * i] = 652000 + 5 * t, positions[3 * i + 1] = 6861000 + sin(0.1 * t);
    positions[3 * i + 2] = 40 + 0.1 * sin(t);
    attitudes[3 * i] = 0.01 * sin(3 * t), attitudes[3 * i + 1] = 0.005 * cos(2 * t);
    attitudes[3 * i + 2] = 0.02 * cos(0.1 * t);
    for (int k = 0; k < 3; ++k) sigmas[3 * i + k] = 0.02;
  }
  check(jalon_trajectory_create(times, positions, attitudes, sigmas, sigmas, sigmas, EPOCHS, NULL,
                                NULL, &made));
  free(times), free(positions), free(attitudes), free(sigmas);
  return made;
}

int main(void) {
  double *times = column(RETURNS), *ranges = column(RETURNS), *thetas = column(RETURNS),
         *phis = column(RETURNS);
  jalon_trajectory* trajectory = drive();
  for (int i = 0; i < RETURNS; ++i) {
    times[i] = 59.9 * i / RETURNS, ranges[i] = 5 + 40 * fabs(sin(0.001 * i));
    thetas[i] = 6.283185307179586 * (i % 3000) / 3000, phis[i] = 1.5707963267948966;
  }
  for (int with = 1; with >= 0; --with)
    for (uint32_t threads = 2; threads >= 1; --threads) {
      double best = 1e9, processor = 1e9;
      for (int run = 0; run < RUNS; ++run) {
        jalon_task* task = NULL;
        jalon_params* options = NULL;
        jalon_cloud* cloud = NULL;
        check(jalon_task_create(&task));
        check(jalon_task_set_threads(task, threads));
        check(jalon_params_create("georeference", &options));
        check(jalon_params_set_bool(options, "covariances", with));
        const double start = now();
        const clock_t used = clock();
        check(jalon_trajectory_georeference(trajectory, times, ranges, thetas, phis, RETURNS,
                                            options, task, &cloud));
        const double taken = now() - start;
        const double spent = (double)(clock() - used) / CLOCKS_PER_SEC;
        best = taken < best ? taken : best;
        processor = spent < processor ? spent : processor;
        jalon_cloud_release(cloud);
        jalon_params_release(options);
        jalon_task_release(task);
      }
      printf(
          "FIGURE georeferencing %s covariances: %.1f M points a second on %u thread%s, %.1f M a "
          "processor second\n",
          with ? "with" : "without", RETURNS / best / 1e6, (unsigned)threads,
          threads == 1 ? "" : "s", RETURNS / processor / 1e6);
    }
  jalon_trajectory_release(trajectory);
  free(times), free(ranges), free(thetas), free(phis);
  return 0;
}
