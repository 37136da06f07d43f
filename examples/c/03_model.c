/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * From a scan to a vector model with openings, for CAD.
 * Build:  cc 03_model.c $(pkg-config --cflags --libs jalon) -o model
 * Run:    ./model scan.las model.dxf
 */
#include <jalon/jalon.h>
#include <stdio.h>
#include <string.h>

static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

/* Planes, then the walls among them with their windows, doors and reveals. */
static int make_model(const char* path, jalon_model** model) {
  jalon_cloud* cloud = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_modeller* modeller = NULL;
  const int bad = failed(jalon_cloud_read(path, NULL, NULL, &cloud)) ||
                  failed(jalon_segmenter_create("ransac", &segmenter)) ||
                  failed(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation)) ||
                  failed(jalon_modeller_create("facade", &modeller)) ||
                  failed(jalon_modeller_run(modeller, cloud, segmentation, NULL, model));
  jalon_modeller_release(modeller);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  return bad;
}

int main(int argc, char** argv) {
  jalon_model* model = NULL;
  jalon_fields *faces = NULL, *parts = NULL;
  jalon_array_view area, width, height;
  uint64_t i;
  int bad;
  if (argc != 3) return fprintf(stderr, "usage: %s SCAN MODEL\n", argv[0]), 2;
  bad = make_model(argv[1], &model) || failed(jalon_model_write(model, argv[2], NULL, NULL)) ||
        failed(jalon_model_faces(model, &faces)) ||
        failed(jalon_fields_view(faces, "area", &area)) ||
        failed(jalon_model_parts(model, &parts)) ||
        failed(jalon_fields_view(parts, "width", &width)) ||
        failed(jalon_fields_view(parts, "height", &height));
  if (!bad) printf("%d faces\n", (int)area.count);
  for (i = 0; !bad && i < width.count; ++i) {
    const char *name, *part_class;
    bad = failed(jalon_model_part(model, i, &name, &part_class, NULL));
    if (!bad && (strcmp(part_class, "window") == 0 || strcmp(part_class, "door") == 0))
      printf("%s: %.3f x %.3f m\n", name, ((const double*)width.data)[i],
             ((const double*)height.data)[i]);
  }
  jalon_fields_release(faces);
  jalon_fields_release(parts);
  jalon_model_release(model);
  return bad;
}
