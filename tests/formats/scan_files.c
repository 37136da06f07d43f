/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Models a scan and writes the model in every format, and its tables as model.json: scan_files SCAN METHOD FOLDER; or
 * outlines of what changed since an earlier scan: scan_files SCAN changes FOLDER EARLIER_SCAN */
#include <stdio.h>
#include <string.h>
#include <stdlib.h>

#include <jalon/jalon.h>

static void must(jalon_status status) {
  if (status == JALON_OK) return;
  fprintf(stderr, "%s\n", jalon_last_error_message());
  exit(1);
}

static jalon_model* model_of(const char* scan, const char* method) {
  jalon_cloud* cloud = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  must(jalon_cloud_read(scan, NULL, NULL, &cloud));
  must(jalon_segmenter_create("ransac", &segmenter));
  must(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  must(jalon_modeller_create(method, &modeller));
  must(jalon_modeller_run(modeller, cloud, segmentation, NULL, &model));
  jalon_modeller_release(modeller);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  return model;
}

// Outlines of what changed between two scans.
static jalon_model* changes_between(const char* before, const char* after) {
  jalon_cloud *reference = NULL, *compared = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison *forward = NULL, *reverse = NULL;
  jalon_params* options = NULL;
  jalon_fields *now = NULL, *then = NULL, *changes = NULL;
  jalon_model* model = NULL;
  must(jalon_cloud_read(before, NULL, NULL, &reference));
  must(jalon_cloud_read(after, NULL, NULL, &compared));
  must(jalon_comparer_create("distance", &comparer));
  must(jalon_comparer_run(comparer, reference, compared, NULL, &forward));
  must(jalon_comparer_run(comparer, compared, reference, NULL, &reverse));
  must(jalon_params_create("diagnosis", &options));
  must(jalon_params_set_double(options, "threshold_m", 0.2));
  must(jalon_comparison_diagnose(forward, reverse, options, NULL, &now, &then, &changes));
  must(jalon_comparison_outlines(forward, now, reverse, then, changes, NULL, NULL, &model));
  jalon_fields_release(changes);
  jalon_fields_release(then);
  jalon_fields_release(now);
  jalon_params_release(options);
  jalon_comparison_release(reverse);
  jalon_comparison_release(forward);
  jalon_comparer_release(comparer);
  jalon_cloud_release(compared);
  jalon_cloud_release(reference);
  return model;
}

static void write_one(const jalon_model* model, const char* folder, const char* name,
                      const char* option, const char* value) {
  char path[4096];
  jalon_params* options = NULL;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  must(jalon_params_create("write", &options));
  if (option != NULL) must(jalon_params_set_string(options, option, value));
  if (strcmp(name, "solid.ifc") == 0)
    must(jalon_params_set_double(options, "ifc_wall_thickness_m", 0.3));
  const jalon_status status = jalon_model_write(model, path, options, NULL);
  if (status != JALON_ERROR_UNSUPPORTED) must(status); /* of a library without SQLite */
  jalon_params_release(options);
}

typedef struct {
  const char* field;
  const char* format; /* of one number */
} column;

/* "name": [[field, field, ...], ...], or a flat list where there is one field of one component. */
static void write_table(FILE* out, const char* name, jalon_fields* fields, const column* columns,
                        int count) {
  jalon_array_view view;
  double* values[8];
  must(jalon_fields_view(fields, columns[0].field, &view));
  const uint64_t rows = view.count;
  uint32_t components[8];
  for (int c = 0; c < count; ++c) {
    must(jalon_fields_view(fields, columns[c].field, &view));
    components[c] = view.components;
    values[c] = malloc((rows * view.components + 1) * sizeof(double));
    must(jalon_fields_copy(fields, columns[c].field, JALON_FLOAT64, values[c],
                           rows * view.components));
  }
  const int flat = count == 1 && components[0] == 1;
  fprintf(out, "\"%s\": [", name);
  for (uint64_t i = 0; i < rows; ++i) {
    fprintf(out, "%s%s", i == 0 ? "" : ",", flat ? "" : "[");
    for (int c = 0; c < count; ++c)
      for (uint32_t k = 0; k < components[c]; ++k) {
        if (c + (int)k > 0) fputc(',', out);
        fprintf(out, columns[c].format, values[c][i * components[c] + k]);
      }
    if (!flat) fputc(']', out);
  }
  fputs("],\n", out);
  for (int c = 0; c < count; ++c) free(values[c]);
  jalon_fields_release(fields);
}

static void write_text(FILE* out, const char* text) {
  fputc('"', out);
  for (; *text != 0; ++text) {
    if (*text == '"' || *text == '\\') fputc('\\', out);
    fputc((unsigned char)*text < 0x20 ? ' ' : *text, out);
  }
  fputc('"', out);
}

static void write_parts(FILE* out, const jalon_model* model) {
  uint64_t count = 0;
  jalon_fields* fields = NULL;
  must(jalon_model_part_count(model, &count));
  must(jalon_model_parts(model, &fields));
  double *evidence = malloc((count + 1) * sizeof(double)),
         *parent = malloc((count + 1) * sizeof(double));
  if (count > 0) {
    must(jalon_fields_copy(fields, "evidence", JALON_FLOAT64, evidence, count));
    must(jalon_fields_copy(fields, "parent", JALON_FLOAT64, parent, count));
  }
  fputs("\"parts\": [", out);
  for (uint64_t i = 0; i < count; ++i) {
    const char *name = NULL, *part_class = NULL;
    must(jalon_model_part(model, i, &name, &part_class, NULL));
    fputs(i == 0 ? "[" : ",[", out);
    write_text(out, name);
    fputc(',', out);
    write_text(out, part_class);
    fprintf(out, ",%.0f,%.0f]", evidence[i], parent[i]);
  }
  fputs("]}\n", out);
  free(evidence);
  free(parent);
  jalon_fields_release(fields);
}

static void write_tables(const jalon_model* model, const char* folder) {
  static const column kVertices[] = {{"xyz", "%.17g"}}, kVertex[] = {{"vertex", "%.0f"}},
                      kSagitta[] = {{"sagitta", "%.17g"}},
                      kRings[] = {{"first", "%.0f"}, {"count", "%.0f"}, {"part", "%.0f"}},
                      kFaces[] = {{"part", "%.0f"}, {"first_ring", "%.0f"}, {"ring_count", "%.0f"},
                                  {"id", "%.0f"},   {"area", "%.17g"},      {"normal", "%.17g"}},
                      kSolids[] = {
                          {"part", "%.0f"}, {"first_face", "%.0f"}, {"face_count", "%.0f"}};
  jalon_fields* fields = NULL;
  char path[4096];
  snprintf(path, sizeof path, "%s/model.json", folder);
  FILE* out = fopen(path, "w");
  if (out == NULL) exit(1);
  fputc('{', out);
  must(jalon_model_vertices(model, &fields));
  write_table(out, "vertices", fields, kVertices, 1);
  must(jalon_model_corners(model, &fields));
  write_table(out, "corners", fields, kVertex, 1);
  must(jalon_model_corners(model, &fields));
  write_table(out, "sagittas", fields, kSagitta, 1);
  must(jalon_model_rings(model, &fields));
  write_table(out, "rings", fields, kRings, 3);
  must(jalon_model_faces(model, &fields));
  write_table(out, "faces", fields, kFaces, 6);
  must(jalon_model_solids(model, &fields));
  write_table(out, "solids", fields, kSolids, 3);
  write_parts(out, model);
  if (fclose(out) != 0) exit(1);
}

int main(int argc, char** argv) {
  static const char* const kFiles[][3] = {{"r2000.dxf", "dxf_version", "r2000"},
                                          {"r12.dxf", "dxf_version", "r12"},
                                          {"elevation.dxf", "dxf_view", "elevation"},
                                          {"model.city.json", NULL, NULL},
                                          {"model.geojson", NULL, NULL},
                                          {"model.obj", NULL, NULL},
                                          {"binary.stl", "stl_format", "binary"},
                                          {"ascii.stl", "stl_format", "ascii"},
                                          {"model.ply", NULL, NULL},
                                          {"model.ifc", NULL, NULL},
                                          {"solid.ifc", NULL, NULL},
                                          {"model.gpkg", NULL, NULL}};
  if (argc != 4 && argc != 5) return 2;
  jalon_model* model = argc == 5 ? changes_between(argv[4], argv[1]) : model_of(argv[1], argv[2]);
  for (size_t i = 0; i < sizeof kFiles / sizeof *kFiles; ++i)
    write_one(model, argv[3], kFiles[i][0], kFiles[i][1], kFiles[i][2]);
  write_tables(model, argv[3]);
  jalon_model_release(model);
  return 0;
}
