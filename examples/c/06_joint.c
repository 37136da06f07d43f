/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * A mobile scan and a building model, each wrong in its own way, brought into agreement by their standard deviations.
 * Build:  cc 06_joint.c $(pkg-config --cflags --libs jalon) -o joint
 * Run:    ./joint street.obj drive.ply drive.txt adjusted.txt
 */
#include <jalon/jalon.h>
#include <stdio.h>

static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

/* Facades are cut into strips, which may bend; roofs come along: they hide what is behind them. */
static int read_strips(const char* path, jalon_model** strips) {
  jalon_model* buildings = NULL;
  jalon_params* options = NULL;
  const int bad = failed(jalon_model_read(path, NULL, NULL, &buildings)) ||
                  failed(jalon_params_create("building_strips", &options)) ||
                  failed(jalon_params_set_bool(options, "others", 1)) ||
                  failed(jalon_params_set_double(options, "touch_m", 2)) ||
                  failed(jalon_model_building_strips(buildings, options, NULL, strips, NULL));
  jalon_params_release(options);
  jalon_model_release(buildings);
  return bad;
}

static int tell(const jalon_adjustment* adjustment) {
  jalon_fields *summary = NULL, *controls = NULL, *blocks = NULL;
  jalon_array_view converged, matched, p, correction, sigma, offset, block_sigma;
  uint64_t i;
  const int bad = failed(jalon_adjustment_summary(adjustment, &summary)) ||
                  failed(jalon_adjustment_controls(adjustment, &controls)) ||
                  failed(jalon_adjustment_blocks(adjustment, &blocks)) ||
                  failed(jalon_fields_view(summary, "converged", &converged)) ||
                  failed(jalon_fields_view(summary, "matched", &matched)) ||
                  failed(jalon_fields_view(summary, "p_value", &p)) ||
                  failed(jalon_fields_view(controls, "correction", &correction)) ||
                  failed(jalon_fields_view(controls, "sigma", &sigma)) ||
                  failed(jalon_fields_view(blocks, "offset", &offset)) ||
                  failed(jalon_fields_view(blocks, "sigma", &block_sigma));
  if (!bad) {
    const double *by = correction.data, *worth = sigma.data;
    printf("%s, %d points matched, p %.3f\n",
           *(const uint8_t*)converged.data ? "converged" : "not converged",
           (int)*(const uint64_t*)matched.data, *(const double*)p.data);
    printf("start of the drive: %.3f %.3f m, sigma %.3f %.3f m\n", by[0], by[1], worth[0],
           worth[1]);
  }
  for (i = 0; !bad && i < offset.count; ++i) {
    const double *by = (const double*)offset.data + 2 * i,
                 *worth = (const double*)block_sigma.data + 2 * i;
    printf("block %d: %.3f %.3f m, sigma %.3f %.3f m\n", (int)i + 1, by[0], by[1], worth[0],
           worth[1]);
  }
  jalon_fields_release(blocks);
  jalon_fields_release(controls);
  jalon_fields_release(summary);
  return bad;
}

int main(int argc, char** argv) {
  jalon_model* strips = NULL;
  jalon_cloud* cloud = NULL;
  jalon_trajectory *drive = NULL, *adjusted = NULL;
  jalon_adjustment* adjustment = NULL;
  int bad;
  if (argc != 5) return fprintf(stderr, "usage: %s MODEL CLOUD TRAJECTORY ADJUSTED\n", argv[0]), 2;
  bad = read_strips(argv[1], &strips) || failed(jalon_cloud_read(argv[2], NULL, NULL, &cloud)) ||
        failed(jalon_trajectory_read(argv[3], NULL, NULL, NULL, &drive)) ||
        failed(jalon_trajectory_adjust(drive, cloud, strips, NULL, NULL, &adjustment)) ||
        tell(adjustment) || failed(jalon_adjustment_trajectory(adjustment, &adjusted)) ||
        failed(jalon_trajectory_write(adjusted, argv[4], NULL, NULL, NULL));
  jalon_trajectory_release(adjusted);
  jalon_adjustment_release(adjustment);
  jalon_trajectory_release(drive);
  jalon_cloud_release(cloud);
  jalon_model_release(strips);
  return bad;
}
