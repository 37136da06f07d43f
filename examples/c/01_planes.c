/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * Planes of a scan. Build:  cc 01_planes.c $(pkg-config --cflags --libs jalon) -o planes
 * Run:  ./planes scan.las
 */
#include <jalon/jalon.h>
#include <stdio.h>

/* Every call says whether it worked; the line tells why not. */
static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

int main(int argc, char** argv) {
  jalon_cloud* cloud = NULL;               /* points, fields, stations */
  jalon_segmenter* segmenter = NULL;       /* a worker: parameters, no data */
  jalon_segmentation* segmentation = NULL; /* what it produces: immutable, keeps the cloud */
  jalon_fields* segments = NULL;           /* a table: one row a plane */
  jalon_array_view area, sigma;
  uint64_t i;
  int bad;

  if (argc != 2) return fprintf(stderr, "usage: %s SCAN\n", argv[0]), 2;
  bad = failed(jalon_cloud_read(argv[1], NULL, NULL, &cloud)) ||
        failed(jalon_segmenter_create("ransac", &segmenter)) ||
        failed(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation)) ||
        failed(jalon_segmentation_segments(segmentation, &segments)) ||
        failed(jalon_fields_view(segments, "area", &area)) ||
        failed(jalon_fields_view(segments, "sigma", &sigma));
  for (i = 0; !bad && i < area.count; ++i)
    printf("plane %2d: %7.2f m2, sigma %.1f mm\n", (int)i + 1, ((const double*)area.data)[i],
           1000 * ((const double*)sigma.data)[i]);

  /* Any order: a result keeps what it looks at. */
  jalon_cloud_release(cloud);
  jalon_segmenter_release(segmenter);
  jalon_segmentation_release(segmentation);
  jalon_fields_release(segments);
  return bad;
}
