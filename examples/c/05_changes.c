/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * What has changed between two scans: distances, then connected regions of changed points.
 * Build:  cc 05_changes.c $(pkg-config --cflags --libs jalon) -o changes
 * Run:    ./changes before.las after.las
 */
#include <jalon/jalon.h>
#include <stdio.h>

static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

/* Distances from local planes of the reference; only what its scanners could have seen counts. */
static int compare(const jalon_cloud* before, const jalon_cloud* after,
                   jalon_comparison** comparison) {
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  const int bad = failed(jalon_comparer_create("distance", &comparer)) ||
                  failed(jalon_comparer_params(comparer, &params)) ||
                  failed(jalon_params_set_string(params, "local_model", "plane")) ||
                  failed(jalon_params_set_double(params, "max_distance_m", 2)) ||
                  failed(jalon_comparer_run(comparer, before, after, NULL, comparison));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  return bad;
}

static int list_regions(const jalon_comparison* comparison) {
  jalon_params* options = NULL;
  jalon_fields* regions = NULL;
  jalon_array_view points, area, mean;
  uint64_t i;
  const int bad = failed(jalon_params_create("regions", &options)) ||
                  failed(jalon_params_set_string(options, "criterion", "threshold")) ||
                  failed(jalon_params_set_double(options, "threshold_m", 0.1)) ||
                  failed(jalon_params_set_int64(options, "min_points", 50)) ||
                  failed(jalon_comparison_regions(comparison, options, NULL, NULL, &regions)) ||
                  failed(jalon_fields_view(regions, "points", &points)) ||
                  failed(jalon_fields_view(regions, "area", &area)) ||
                  failed(jalon_fields_view(regions, "mean", &mean));
  for (i = 0; !bad && i < points.count; ++i)
    printf("region %d: %d points, %.3f m2, mean %.3f m\n", (int)i + 1,
           (int)((const uint64_t*)points.data)[i], ((const double*)area.data)[i],
           ((const double*)mean.data)[i]);
  jalon_fields_release(regions);
  jalon_params_release(options);
  return bad;
}

int main(int argc, char** argv) {
  jalon_cloud *before = NULL, *after = NULL;
  jalon_comparison* comparison = NULL;
  int bad;
  if (argc != 3) return fprintf(stderr, "usage: %s BEFORE AFTER\n", argv[0]), 2;
  bad = failed(jalon_cloud_read(argv[1], NULL, NULL, &before)) ||
        failed(jalon_cloud_read(argv[2], NULL, NULL, &after)) ||
        compare(before, after, &comparison) || list_regions(comparison);
  jalon_comparison_release(comparison);
  jalon_cloud_release(after);
  jalon_cloud_release(before);
  return bad;
}
