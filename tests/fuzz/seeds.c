/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Small sound inputs of each fuzz target, to begin with: seeds FOLDER, which gets a folder a target. */
#define JALON_TEST_PLAIN_PROGRAM 1
#include "seeds.h"
#include "support.h"

#include <sys/stat.h>

enum { kPoints = 60 };

static const char* root;

static const char* place(const char* target, const char* name) {
  static char path[700];
  snprintf(path, sizeof path, "%s/%s", root, target);
  mkdir(path, 0777);
  snprintf(path, sizeof path, "%s/%s/%s", root, target, name);
  return path;
}

void put(const char* target, const char* name, int first, const void* data, size_t bytes) {
  FILE* const f = fopen(place(target, name), "wb");
  assert_non_null(f);
  if (first >= 0) fputc(first, f);
  assert_int_equal(fwrite(data, 1, bytes, f), bytes);
  fclose(f);
}

void put_lines(const char* target, const char* name, const char* words, size_t bytes) {
  char* const lines = malloc(bytes);
  assert_non_null(lines);
  for (size_t i = 0; i < bytes; ++i) lines[i] = words[i] == ' ' ? '\n' : words[i];
  put(target, name, -1, lines, bytes);
  free(lines);
}

static void put_bytes(int kind, const char* name, jalon_bytes* bytes) {
  jalon_array_view view;
  MUST(jalon_bytes_view(bytes, &view));
  put("bytes", name, kind, view.data, view.count);
  jalon_bytes_release(bytes);
}

/* An object and the formats that it is written in. */
static void put_to_write(const char* target, int formats, int rich, const jalon_bytes* bytes) {
  jalon_array_view view;
  MUST(jalon_bytes_view(bytes, &view));
  for (int format = 0; format < formats; ++format) {
    char name[40];
    snprintf(name, sizeof name, "%s_%d", rich ? "rich" : "plain", format);
    put(target, name, format, view.data, view.count);
  }
}

static jalon_cloud* seed_cloud(int with_fields) {
  jalon_cloud* const cloud = street_cloud(kPoints, 4);
  const jalon_transform pose = {{1, 0, 0, 5, 0, 1, 0, -4, 0, 0, 1, 1.5}};
  uint16_t colour[3 * kPoints];
  float intensity[kPoints];
  uint8_t label[kPoints];
  for (int i = 0; i < kPoints; ++i) {
    for (int k = 0; k < 3; ++k) colour[3 * i + k] = (uint16_t)(257 * ((31 * i + 7 * k) % 256));
    intensity[i] = (float)(i % 17) / 16;
    label[i] = (uint8_t)(i % 5);
  }
  if (!with_fields) return cloud;
  MUST(jalon_cloud_set_field(cloud, "rgb", colour, JALON_UINT16, 3, kPoints, 0, "", ""));
  MUST(jalon_cloud_set_field(cloud, "intensity", intensity, JALON_FLOAT32, 1, kPoints, 0, "", ""));
  MUST(jalon_cloud_set_field(cloud, "label", label, JALON_UINT8, 1, kPoints, 0, "", ""));
  MUST(jalon_cloud_set_station(cloud, "A", &pose));
  MUST(jalon_cloud_set_crs(cloud, "EPSG:2154"));
  return cloud;
}

static void write_clouds(void) {
  static const char* const formats[] = {"las", "laz", "copc.laz", "e57", "ply",
                                        "pcd", "pts", "xyz",      "csv", "png"};
  for (int rich = 0; rich < 2; ++rich) {
    jalon_cloud* const cloud = seed_cloud(rich);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i) {
      char name[40];
      snprintf(name, sizeof name, "%s.%s", rich ? "rich" : "plain", formats[i]);
      /* Without the component for LAZ and E57 there is nothing to begin with. */
      if (jalon_cloud_write(cloud, place(formats[i], name), NULL, NULL) != JALON_OK)
        printf("skipped: %s: %s\n", name, jalon_last_error_message());
    }
    jalon_bytes* bytes = NULL;
    MUST(jalon_cloud_to_bytes(cloud, NULL, &bytes));
    put_to_write("cloud_writers", (int)(sizeof formats / sizeof *formats), rich, bytes);
    enum { kOperations = 16 }; /* of run_clouds.cpp, methods of segmenting after them */
    put_to_write("clouds", kOperations, rich, bytes);
    put_bytes(0, rich ? "cloud_rich" : "cloud", bytes);
    jalon_fields* fields = NULL;
    MUST(jalon_cloud_fields(cloud, &fields));
    MUST(jalon_fields_to_bytes(fields, NULL, &bytes));
    put_bytes(1, rich ? "fields_rich" : "fields", bytes);
    jalon_fields_release(fields);
    jalon_cloud_release(cloud);
  }
  static const char ptx[] =
      "2\n2\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n"
      "0 0 1 0.5 10 20 30\n0 1 1 0.25 0 0 0\n0 0 0 0.5 0 0 0\n1 1 1 1 255 255 255\n";
  put("ptx", "grid.ptx", -1, ptx, sizeof ptx - 1);
}

static void write_models(void) {
  static const struct {
    const char *target, *name;
  } files[] = {{"obj", "scene.obj"},
               {"stl", "scene.stl"},
               {"city.json", "scene.city.json"},
               {"dxf", "scene.dxf"},
               {"ply_model", "scene.ply"}};
  jalon_params* options = NULL;
  jalon_model* model = NULL;
  jalon_bytes* bytes = NULL;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_from_json(options, "{\"name\": \"box\"}"));
  MUST(jalon_scene_create(options, NULL, &model));
  for (size_t i = 0; i < sizeof files / sizeof *files; ++i)
    MUST(jalon_model_write(model, place(files[i].target, files[i].name), NULL, NULL));
  MUST(jalon_model_to_bytes(model, NULL, &bytes));
  enum { kModelFormats = 9 }; /* of read_objects.cpp */
  put_to_write("model_writers", kModelFormats, 0, bytes);
  put_bytes(3, "model", bytes);
  jalon_model_evaluation* evaluation = NULL;
  MUST(jalon_model_evaluate(model, model, NULL, NULL, &evaluation));
  MUST(jalon_model_evaluation_to_bytes(evaluation, &bytes));
  put_bytes(8, "model_evaluation", bytes);
  jalon_model_evaluation_release(evaluation);
  jalon_model_release(model);
  jalon_params_release(options);
}

static void write_results(void) {
  jalon_cloud* const cloud = street_cloud(400, 9);
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  jalon_params* params = NULL;
  jalon_bytes* bytes = NULL;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  MUST(jalon_segmentation_to_bytes(segmentation, NULL, &bytes));
  put_bytes(4, "segmentation", bytes);
  jalon_segmenter* by_codes = NULL;
  jalon_segmentation* coded = NULL;
  MUST(jalon_segmenter_create("survey_codes", &by_codes));
  MUST(jalon_segmenter_params(by_codes, &params));
  MUST(jalon_params_set_string(
      params, "codes",
      "1;0;0;9;300.2\n2;9;0;9;300\n3;9;9;9;300.0\n4;5;5;0;300\n5;2;0;1;350\n6;3;0;3;350\n"
      "7;1;0;3;370\n8;1.1;0;3;371\n9;1;0;5;372\n10;20;0;0;777\n"));
  MUST(jalon_segmenter_run(by_codes, cloud, NULL, &coded));
  MUST(jalon_segmentation_to_bytes(coded, NULL, &bytes));
  put_bytes(4, "coded", bytes);
  jalon_segmentation_release(coded);
  jalon_params_release(params);
  jalon_segmenter_release(by_codes);
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_to_bytes(params, &bytes));
  put_bytes(2, "params", bytes);
  MUST(jalon_comparer_create("distance", &comparer));
  MUST(jalon_comparer_run(comparer, cloud, cloud, NULL, &comparison));
  MUST(jalon_comparison_to_bytes(comparison, NULL, &bytes));
  put_bytes(5, "comparison", bytes);
  jalon_evaluation* evaluation = NULL;
  MUST(jalon_segmentation_evaluate(segmentation, segmentation, NULL, NULL, &evaluation));
  MUST(jalon_evaluation_to_bytes(evaluation, &bytes));
  put_bytes(7, "evaluation", bytes);
  jalon_evaluation_release(evaluation);
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  MUST(jalon_registrar_create("icp", &registrar));
  MUST(jalon_registrar_run(registrar, cloud, cloud, NULL, NULL, &registration));
  MUST(jalon_registration_to_bytes(registration, NULL, &bytes));
  put_bytes(6, "registration", bytes);
  jalon_registration_release(registration);
  MUST(jalon_segmenter_to_bytes(segmenter, &bytes));
  put_bytes(10, "segmenter", bytes);
  MUST(jalon_comparer_to_bytes(comparer, &bytes));
  put_bytes(12, "comparer", bytes);
  MUST(jalon_registrar_to_bytes(registrar, &bytes));
  put_bytes(13, "registrar", bytes);
  jalon_registrar_release(registrar);
  jalon_params_release(params);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
}

static void write_workers(void) {
  jalon_modeller* modeller = NULL;
  jalon_scanner* scanner = NULL;
  jalon_noise_law* law = NULL;
  jalon_bytes* bytes = NULL;
  const char* const* names = NULL;
  uint64_t count = 0;
  const jalon_transform pose = {{1, 0, 0, 5, 0, 1, 0, -4, 0, 0, 1, 1.5}};
  MUST(jalon_modeller_methods(&names, &count));
  MUST(jalon_modeller_create(names[0], &modeller));
  MUST(jalon_modeller_to_bytes(modeller, &bytes));
  put_bytes(11, "modeller", bytes);
  MUST(jalon_scanner_methods(&names, &count));
  MUST(jalon_scanner_create(names[0], &scanner));
  MUST(jalon_scanner_add_station(scanner, "A", &pose));
  MUST(jalon_scanner_to_bytes(scanner, &bytes));
  put_bytes(14, "scanner", bytes);
  MUST(jalon_noise_law_from_json("{\"law\": \"empirical\", \"quantiles\": [0, 0.1, 0.2, 0.3]}",
                                 &law));
  MUST(jalon_noise_law_to_bytes(law, &bytes));
  put_bytes(9, "law", bytes);
  jalon_noise_law_release(law);
  jalon_scanner_release(scanner);
  jalon_modeller_release(modeller);
}

static void write_text_seeds(void) {
  static const char trajectory[] = "t,x,y,z,roll,pitch,heading\n0,1,2,3,0,0,0\n1,2,2,3,0,0,0.1\n";
  static const char normals[] =
      "{\"k\": 12, \"viewpoint\": [1, 2.5, -3e2], \"orientation\": \"point\"}";
  static const char law[] = "{\"law\": \"weibull\", \"shape\": 2, \"scale\": 0.005}";
  double records[2 * 17], sigmas[4 * 10];
  for (int i = 0; i < 2 * 17; ++i) records[i] = 0.01 * i;
  for (int i = 0; i < 4 * 10; ++i) sigmas[i] = i % 10 == 0 ? 0.17 * (i / 10) : 0.02;
  put("trajectory_text", "short.csv", -1, trajectory, sizeof trajectory - 1);
  put("trajectory_sbet", "two.sbet", -1, records, sizeof records);
  put("smrmsg", "four.smrmsg", -1, sigmas, sizeof sigmas);
  put("params", "normals", 0, normals, sizeof normals - 1);
  put("law", "weibull", -1, law, sizeof law - 1);
}

int main(int count, char** arguments) {
  if (count != 2) return 2;
  root = arguments[1];
  mkdir(root, 0777);
  write_clouds();
  write_models();
  write_results();
  write_workers();
  write_text_seeds();
  write_seed_texts();
  return 0;
}
