/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * What a surveyor coded in the field, "ID;X;Y;Z;code" a line, gives the points of a scan their classes and objects, and
 * makes a model of them.
 * Build:  cc 07_feature_codes.c $(pkg-config --cflags --libs jalon) -o feature_codes
 * Run:    ./feature_codes scan.las codes.txt classified.las objects.dxf
 */
#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(jalon_status status) {
  if (status != JALON_OK)
    fprintf(stderr, "%s: %s\n", jalon_status_name(status), jalon_last_error_message());
  return status != JALON_OK;
}

/* The whole file as text, to be freed; NULL where it cannot be read. */
static char* text_of(const char* path) {
  FILE* file = fopen(path, "rb");
  char* text = NULL;
  long size = -1;
  if (file != NULL && fseek(file, 0, SEEK_END) == 0) size = ftell(file);
  if (size >= 0 && fseek(file, 0, SEEK_SET) == 0) text = calloc((size_t)size + 1, 1);
  if (text != NULL && fread(text, 1, (size_t)size, file) != (size_t)size) {
    free(text);
    text = NULL;
  }
  if (file != NULL) fclose(file);
  if (text == NULL) fprintf(stderr, "%s: cannot be read\n", path);
  return text;
}

/* Every object is a segment; its source label is its number in the list. */
static int tell_segments(const jalon_segmentation* coded) {
  jalon_fields* segments = NULL;
  jalon_array_view object, points;
  uint64_t i;
  const int bad = failed(jalon_segmentation_segments(coded, &segments)) ||
                  failed(jalon_fields_view(segments, "source_label", &object)) ||
                  failed(jalon_fields_view(segments, "inliers", &points));
  for (i = 0; !bad && i < object.count; ++i)
    printf("object %d: %d points\n", (int)((const int64_t*)object.data)[i],
           (int)((const uint64_t*)points.data)[i]);
  jalon_fields_release(segments);
  return bad;
}

static int tell_parts(const jalon_model* model) {
  uint64_t count = 0, i;
  int bad = failed(jalon_model_part_count(model, &count));
  for (i = 0; !bad && i < count; ++i) {
    const char *name = NULL, *part_class = NULL;
    bad = failed(jalon_model_part(model, i, &name, &part_class, NULL));
    if (!bad) printf("%s: %s\n", part_class, name);
  }
  return bad;
}

static int run(char** files, const char* codes) {
  jalon_segmenter* segmenter = NULL;
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_cloud *cloud = NULL, *classified = NULL;
  jalon_segmentation* coded = NULL;
  jalon_model* model = NULL;
  const int bad = failed(jalon_segmenter_create("survey_codes", &segmenter)) ||
                  failed(jalon_segmenter_params(segmenter, &params)) ||
                  failed(jalon_params_set_string(params, "codes", codes)) ||
                  failed(jalon_cloud_read(files[1], NULL, NULL, &cloud)) ||
                  failed(jalon_segmenter_run(segmenter, cloud, NULL, &coded)) ||
                  tell_segments(coded) || failed(jalon_segmentation_cloud(coded, &classified)) ||
                  failed(jalon_cloud_write(classified, files[3], NULL, NULL)) ||
                  failed(jalon_modeller_create("coded_objects", &modeller)) ||
                  failed(jalon_modeller_run(modeller, cloud, coded, NULL, &model)) ||
                  tell_parts(model) || failed(jalon_model_write(model, files[4], NULL, NULL));
  jalon_model_release(model);
  jalon_segmentation_release(coded);
  jalon_cloud_release(classified);
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_modeller_release(modeller);
  jalon_segmenter_release(segmenter);
  return bad;
}

int main(int argc, char** argv) {
  char* codes;
  int bad = 1;
  if (argc != 5) return fprintf(stderr, "usage: %s SCAN CODES CLASSIFIED MODEL\n", argv[0]), 2;
  codes = text_of(argv[2]);
  if (codes != NULL) bad = run(argv, codes);
  free(codes);
  return bad;
}
