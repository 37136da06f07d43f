/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_m3c2 PREFIX: Jalon's comparer "m3c2" through its public C interface, PREFIX.f64 against PREFIX_second.f64; the
 * protocol is that of driver.h. Indices are part of the time; the core points are every so many-th reference point. */

#include "jalon_driver.h"

static jalon_cloud* cloud_of(const Points* points, uint64_t step) {
  jalon_cloud* cloud = NULL;
  check(jalon_cloud_create(points->xyz, JALON_FLOAT64, (points->count + step - 1) / step, 24 * step,
                           0, &cloud));
  return cloud;
}

static void write_sample(FILE* sample, const jalon_comparison* comparison) {
  jalon_fields* fields = NULL;
  jalon_array_view distance;
  uint64_t i;
  check(jalon_comparison_points(comparison, &fields));
  check(jalon_fields_view(fields, "distance", &distance));
  for (i = 0; i<distance.count; i += distance.count> SAMPLES ? distance.count / SAMPLES : 1) {
    fwrite((const double*)distance.data + i, sizeof(double), 1, sample);
  }
  jalon_fields_release(fields);
}

/* Normals within 0.25 m, cylinders of 0.15 m radius and 1 m to either side: the defaults. */
static Result run(const char* name, void* scene, jalon_task* task, FILE* sample) {
  const Points* epochs = scene;
  const uint64_t core_count = strcmp(name, "m3c2_1m") == 0 ? 1000000 : 100000;
  const uint64_t step = epochs[0].count > core_count ? epochs[0].count / core_count : 1;
  jalon_cloud *reference = cloud_of(&epochs[0], 1), *compared = cloud_of(&epochs[1], 1);
  jalon_cloud* core = cloud_of(&epochs[0], step);
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  double start;
  Result result = {0, core_count};
  check(jalon_comparer_create("m3c2", &comparer));
  start = now();
  check(jalon_comparer_run_core(comparer, reference, compared, core, task, &comparison));
  result.seconds = now() - start;
  if (sample != NULL) write_sample(sample, comparison);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(core);
  jalon_cloud_release(compared);
  jalon_cloud_release(reference);
  return result;
}

int main(int argc, char** argv) {
  Points epochs[2];
  int code;
  if (argc < 2) return 2;
  epochs[0] = load(argv[1], ".f64");
  epochs[1] = load(argv[1], "_second.f64");
  code = serve("m3c2_100k,m3c2_1m", epochs[0].count, epochs, run);
  free(epochs[0].xyz);
  free(epochs[1].xyz);
  return code;
}
