/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Valid handles of every kind, rich and poor: what the wild calls vary around. */
#define _XOPEN_SOURCE 700
#include "wild_support.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

jalon_cloud *fx_cloud, *fx_small, *fx_empty, *fx_one, *fx_two, *fx_equal, *fx_collinear, *fx_far,
    *fx_nan_field, *fx_ball;
jalon_cloud* fx_clouds[3];
jalon_cloud_builder *fx_builder, *fx_builder_ready;
jalon_fields* fx_fields;
jalon_fields* fx_changed;
jalon_model *fx_model, *fx_mesh, *fx_bare, *fx_block;
jalon_segmenter* fx_segmenter;
jalon_segmentation *fx_segmentation, *fx_no_segments, *fx_start;
jalon_evaluation* fx_evaluation;
jalon_model_evaluation* fx_model_evaluation;
jalon_modeller* fx_modeller;
jalon_comparer* fx_comparer;
jalon_comparer* fx_m3c2;
jalon_comparison* fx_comparison;
jalon_registrar* fx_registrar;
jalon_registration* fx_registration;
jalon_noise_law* fx_law;
jalon_scanner *fx_scanner, *fx_mobile;
jalon_model* fx_strips;
jalon_trajectory *fx_trajectory, *fx_bare_trajectory, *fx_driven;
jalon_cloud* fx_driven_cloud;
jalon_model* fx_driven_strips;
jalon_adjustment* fx_adjustment;
jalon_network* fx_network;
jalon_sections* fx_sections;
jalon_task *fx_task, *fx_task_own;
jalon_params* fx_typed[7];
const char* fx_typed_name[7];
double fx_double_value;
int64_t fx_int64_value;
const char* fx_text_value;
double fx_xyz[3 * kArrayItems];
uint64_t fx_indices[kArrayItems];
uint32_t fx_triangles[kArrayItems] = {0, 1, 2, 2, 3, 0};
const double fx_square[8] = {-50, -50, 50, -50, 50, 50, -50, 50};
const double fx_picks[24] = {0,   0, 0,   2.5, 0, 0,   4.9, 0, 0,   4.9, 0, 1.5,
                             4.9, 0, 2.9, 2,   0, 2.9, 0,   0, 2.9, 0,   0, 1};
const double fx_areas[8] = {0, 1, 2, 3, 4, 5, 6, 7}, fx_ranges[8] = {1, 2, 4, 8, 16, 32, 64, 128};
const jalon_transform fx_identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
const jalon_transform fx_zero = {{0}};
const jalon_transform fx_nan_transform = {{1, 0, 0, NAN, 0, 1, 0, 0, 0, 0, 1, 0}};
const jalon_transform fx_inf_transform = {{INFINITY, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
const jalon_transform fx_big_transform = {{1e300, 0, 0, 0, 0, 1e300, 0, 0, 0, 0, 1e300, 0}};
#define IDENTITY \
  { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 }
const jalon_transform fx_poses[8] = {{IDENTITY},
                                     {IDENTITY},
                                     {IDENTITY},
                                     {IDENTITY},
                                     {IDENTITY},
                                     {{0.96, -0.28, 0, 0.5, 0.28, 0.96, 0, 0, 0, 0, 1, 0}},
                                     {{1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0}},
                                     {{1, 0, 0, 1e6, 0, 1, 0, 0, 0, 0, 1, 0}}};
const jalon_transform fx_wild_poses[8] = {
    {IDENTITY}, {IDENTITY}, {{2, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0}}, {{0}}};
#define BOX \
  { JALON_GAUGE_BOX, 0, {IDENTITY}, {1, 2, 3}, 0, 0 }
const jalon_gauge_piece fx_pieces[8] = {BOX,
                                        BOX,
                                        BOX,
                                        BOX,
                                        BOX,
                                        BOX,
                                        {JALON_GAUGE_SPHERE, 0, {IDENTITY}, {1, 0, 0}, 0, 0},
                                        {JALON_GAUGE_CYLINDER, 0, {IDENTITY}, {1, 0, 2}, 0, 0}};
const jalon_gauge_piece fx_wild_pieces[8] = {
    BOX,
    BOX,
    {JALON_GAUGE_HULL, 0, {IDENTITY}, {0, 0, 0}, UINT64_MAX, 5},
    {99, 0, {IDENTITY}, {1, 2, 3}, 0, 0}};
#define TARGET(name, x, y, z) \
  {                           \
    name, {x, y, z}, { 0 }    \
  }
const jalon_target fx_targets[8] = {
    TARGET("a", 0, 0, 0), TARGET("b", 5, 0, 0), TARGET("c", 0, 5, 0), TARGET("d", 0, 0, 5),
    TARGET("e", 5, 5, 0), TARGET("f", 5, 0, 4), TARGET("g", 9, 5, 1), TARGET("h", 1, 2, 7)};
const jalon_target fx_wild_targets[8] = {TARGET("a", 0, 0, 0),
                                         TARGET("a", NAN, 0, 0),
                                         TARGET(NULL, 0, INFINITY, 0),
                                         {"\xff\xfe", {1, 2, 3}, {-1, NAN, 0}}};
const jalon_box fx_box = {{-50, -50, -50}, {50, 50, 50}},
                fx_reversed_box = {{1, 1, 1}, {-1, -1, -1}};
const jalon_box fx_nan_box = {{NAN, -1, -1}, {1, 1, 1}};
const jalon_vec3 fx_foot = {0, 0, -5}, fx_top = {0, 0, 5}, fx_nan_vec = {0, NAN, 0},
                 fx_inf_vec = {0, 0, INFINITY};
char *fx_long_text, *fx_deep_json;

static char folder[256];
static int made_options;
static struct {
  const char* operation;
  jalon_params* params;
} options[64];

static void must(jalon_status status, const char* what) {
  if (status == JALON_OK) return;
  printf("not ok - wild: fixture %s: %s\n0 passed, 1 failed, 0 skipped\n", what,
         jalon_last_error_message());
  exit(1);
}
#define MUST(call) must((call), #call)

const char* fx_path(const char* name) {
  enum { kAtOnce = 4 }; /* of one call's arguments, which compilers fill in their own order */
  static char paths[kAtOnce][600];
  static int next;
  char* const path = paths[next++ % kAtOnce];
  snprintf(path, sizeof paths[0], "%s/%s", folder, name);
  return path;
}

jalon_params* fx_options(const char* operation) {
  for (int i = 0; i < made_options; ++i)
    if (strcmp(options[i].operation, operation) == 0) return options[i].params;
  return NULL;
}

int32_t fx_progress(double fraction, const char* stage, void* user) {
  (void)user;
  return fraction >= 0 && fraction <= 1 && stage != NULL ? 0 : 1;
}

void fx_log(int32_t level, const char* text, void* user) { (void)level, (void)text, (void)user; }

/* One set of each operation, and for each type of parameter a set and a row that has it. */
static void make_params(void) {
  uint64_t count, rows;
  MUST(jalon_params_operation_count(&count));
  for (uint64_t i = 0; i < count && made_options < 64; ++i) {
    jalon_params* params;
    MUST(jalon_params_operation_name(i, &options[made_options].operation));
    MUST(jalon_params_create(options[made_options].operation, &params));
    options[made_options++].params = params;
    MUST(jalon_params_count(params, &rows));
    for (uint64_t r = 0; r < rows; ++r) {
      jalon_param_info info = {sizeof info, 0, 0, 0, 0, 0, 0, 0, 0, 0};
      MUST(jalon_params_info(params, r, &info));
      if (fx_typed[info.type] != NULL) continue;
      fx_typed[info.type] = params;
      fx_typed_name[info.type] = info.name;
    }
  }
  MUST(jalon_params_get_double(fx_typed[JALON_PARAM_DOUBLE], fx_typed_name[JALON_PARAM_DOUBLE],
                               &fx_double_value));
  MUST(jalon_params_get_int64(fx_typed[JALON_PARAM_INT64], fx_typed_name[JALON_PARAM_INT64],
                              &fx_int64_value));
  if (fx_typed[JALON_PARAM_STRING] == NULL) must(-1, "no operation has a string parameter");
  MUST(jalon_params_get_string(fx_typed[JALON_PARAM_STRING], fx_typed_name[JALON_PARAM_STRING],
                               &fx_text_value));
  if (fx_typed[JALON_PARAM_DOUBLES] == NULL) must(-1, "no operation has a parameter of doubles");
}

static jalon_cloud* cloud_of(const double* xyz, uint64_t count) {
  jalon_cloud* cloud;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  return cloud;
}

static double noise(uint32_t i) {
  i = (i ^ 61u) * 2654435761u;
  i = (i ^ (i >> 15)) * 2246822519u;
  return ((i >> 8) / 16777216.0 - 0.5) * 0.004;
}

/* A wall of 2.5 x 1.5 m with a hole, and the ground before it: 10 cm steps, 4 mm of noise. */
static void make_clouds(void) {
  int n = 0;
  for (int i = 0; i < 25; ++i)
    for (int j = 0; j < 15; ++j) {
      if (i > 8 && i < 16 && j > 4 && j < 12) continue;
      fx_xyz[3 * n] = 0.1 * i, fx_xyz[3 * n + 1] = noise(n), fx_xyz[3 * n + 2] = 0.1 * j, ++n;
    }
  for (int i = 0; i < 25; ++i)
    for (int j = 1; j < 10; ++j)
      fx_xyz[3 * n] = 0.1 * i, fx_xyz[3 * n + 1] = -0.1 * j, fx_xyz[3 * n + 2] = noise(n), ++n;
  static float intensity[kArrayItems], deviation[kArrayItems];
  for (int i = 0; i < n; ++i) intensity[i] = (float)(i % 2);
  for (int i = 0; i < n; ++i) deviation[i] = (float)(i % 7 + 1);
  fx_cloud = cloud_of(fx_xyz, n);
  const jalon_transform pose = {{1, 0, 0, 2.5, 0, 1, 0, -6, 0, 0, 1, 1.7}};
  MUST(jalon_cloud_set_station(fx_cloud, "tripod", &pose));
  MUST(jalon_cloud_set_crs(fx_cloud, "EPSG:2154"));
  MUST(jalon_cloud_set_field(fx_cloud, "intensity", intensity, JALON_FLOAT32, 1, n, 0, NULL, NULL));
  MUST(jalon_cloud_set_field(fx_cloud, "deviation", deviation, JALON_FLOAT32, 1, n, 0, NULL, NULL));
  MUST(jalon_cloud_compute_normals(fx_cloud, NULL, NULL));
  MUST(jalon_cloud_compute_covariances(fx_cloud, NULL, NULL));
  MUST(jalon_cloud_fields(fx_cloud, &fx_fields));
  fx_small = cloud_of(fx_xyz, 12);
  fx_empty = cloud_of(NULL, 0);
  fx_one = cloud_of(fx_xyz, 1);
  fx_two = cloud_of(fx_xyz, 2);
  static double line[300], same[300],
      far_away[12] = {-1e150, 0, 0, 1e150, 1e150, 3, 0, 0, -1e150, 5, 5, 5};
  for (int i = 0; i < 100; ++i) {
    line[3 * i] = 0.01 * i, line[3 * i + 1] = 0.02 * i, line[3 * i + 2] = 0.03 * i;
    same[3 * i] = 7, same[3 * i + 1] = 8, same[3 * i + 2] = 9;
  }
  fx_collinear = cloud_of(line, 100);
  fx_equal = cloud_of(same, 100);
  fx_far = cloud_of(far_away, 4);
  static float nans[3 * 200];
  for (int i = 0; i < 600; ++i) nans[i] = NAN;
  fx_nan_field = cloud_of(fx_xyz, 200);
  MUST(jalon_cloud_set_field(fx_nan_field, "intensity", nans, JALON_FLOAT32, 1, 200, 0, "", ""));
  MUST(jalon_cloud_set_field(fx_nan_field, "normal", nans, JALON_FLOAT32, 3, 200, 0, "", ""));
  double rings[36]; /* on a sphere and on an upright cylinder */
  for (int i = 0; i < 12; ++i)
    rings[3 * i] = cos(0.5 * i), rings[3 * i + 1] = sin(0.5 * i),
              rings[3 * i + 2] = i % 2 ? 0.2 : -0.2;
  fx_ball = cloud_of(rings, 12);
  fx_clouds[0] = fx_cloud, fx_clouds[1] = fx_small, fx_clouds[2] = fx_two;
}

static void make_builders(void) {
  jalon_cloud_builder** both[2] = {&fx_builder, &fx_builder_ready};
  for (int i = 0; i < 2; ++i) {
    MUST(jalon_cloud_builder_create(0, both[i]));
    MUST(jalon_cloud_builder_declare_field(*both[i], "extra", JALON_FLOAT64, 1, "m", ""));
    MUST(jalon_cloud_builder_append_points(*both[i], fx_xyz, JALON_FLOAT64, 8, 0));
    if (i == 1)
      MUST(jalon_cloud_builder_append_field(*both[i], "extra", fx_xyz, JALON_FLOAT64, 8, 0));
  }
}

static void make_workers(void) {
  MUST(jalon_segmenter_create(NULL, &fx_segmenter));
  MUST(jalon_segmenter_run(fx_segmenter, fx_cloud, NULL, &fx_segmentation));
  static double sparse[3 * 40]; /* 40 points in a cube of 100 m: no plane */
  for (uint32_t i = 0; i < 120; ++i) sparse[i] = 25000 * noise(1000 + i);
  jalon_cloud* nothing = cloud_of(sparse, 40);
  MUST(jalon_segmenter_run(fx_segmenter, nothing, NULL, &fx_no_segments));
  jalon_cloud_release(nothing);
  MUST(jalon_segmentation_start(fx_cloud, NULL, &fx_start));
  MUST(jalon_segmentation_evaluate(fx_segmentation, fx_segmentation, NULL, NULL, &fx_evaluation));
  MUST(jalon_comparer_create(NULL, &fx_comparer));
  MUST(jalon_comparer_create("m3c2", &fx_m3c2));
  MUST(jalon_comparer_run(fx_comparer, fx_cloud, fx_cloud, NULL, &fx_comparison));
  MUST(jalon_registrar_create("targets", &fx_registrar));
  MUST(jalon_registrar_run_targets(fx_registrar, fx_targets, 8, fx_targets, 8, NULL,
                                   &fx_registration));
  MUST(jalon_comparison_regions(fx_comparison, NULL, NULL, &fx_changed, NULL));
  MUST(jalon_noise_law_from_json("{\"law\":\"weibull\",\"shape\":2,\"scale\":3}", &fx_law));
  MUST(jalon_modeller_create(NULL, &fx_modeller));
  MUST(jalon_modeller_run(fx_modeller, fx_cloud, fx_segmentation, NULL, &fx_model));
  MUST(jalon_model_evaluate(fx_model, fx_model, NULL, NULL, &fx_model_evaluation));
  const double corners[12] = {-2, 3, -2, 2, 3, -2, 2, 3, 2, -2, 3, 2};
  MUST(jalon_model_create_mesh(corners, JALON_FLOAT64, 4, 0, fx_triangles, 2, NULL, &fx_mesh));
  const double block[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t block_sides[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  MUST(jalon_model_create_mesh(block, JALON_FLOAT64, 4, 0, block_sides, 4, NULL, &fx_block));
  MUST(jalon_model_create_mesh(NULL, JALON_FLOAT64, 0, 0, NULL, 0, NULL, &fx_bare));
  MUST(jalon_scanner_create(NULL, &fx_scanner));
  MUST(jalon_scanner_add_station(fx_scanner, "tripod", &fx_identity));
}

/* Eight epochs from 1 to 128 s, those of fx_ranges, with and without sigmas. */
static void make_trajectories(void) {
  double positions[24], attitudes[24] = {0}, sigmas[24];
  for (int i = 0; i < 8; ++i) {
    positions[3 * i] = 5 * fx_ranges[i], positions[3 * i + 1] = 0, positions[3 * i + 2] = 2;
    for (int k = 0; k < 3; ++k) sigmas[3 * i + k] = 0.01 + 0.01 * k;
  }
  MUST(jalon_trajectory_create(fx_ranges, positions, attitudes, sigmas, sigmas, sigmas, 8, NULL,
                               NULL, &fx_trajectory));
  jalon_params* params;
  MUST(jalon_scanner_create("mobile", &fx_mobile));
  MUST(jalon_scanner_params(fx_mobile, &params));
  MUST(jalon_params_set_int64(params, "pulses", 20));
  MUST(jalon_params_set_double(params, "revolutions_per_s", 1));
  jalon_params_release(params);
  MUST(jalon_model_building_strips(fx_mesh, NULL, NULL, &fx_strips, NULL));
  MUST(jalon_trajectory_create(fx_ranges, positions, attitudes, NULL, NULL, NULL, 8, "EPSG:2154",
                               NULL, &fx_bare_trajectory));
}

/* A short drive through a street, its cloud and strips, and what comes of adjusting them. */
static void make_adjustment(void) {
  jalon_params *street, *adjust;
  MUST(jalon_params_create("drive_scenario", &street));
  MUST(jalon_params_set_double(street, "leg_m", 40));
  MUST(jalon_params_set_bool(street, "corner", 0));
  MUST(jalon_params_set_double(street, "revolutions_per_s", 10));
  MUST(jalon_params_set_int64(street, "pulses", 200));
  MUST(jalon_scene_drive_scenario(street, NULL, &fx_driven_strips, &fx_driven, &fx_driven_cloud,
                                  NULL, NULL));
  jalon_params_release(street);
  MUST(jalon_params_create("adjust", &adjust));
  MUST(jalon_params_set_bool(adjust, "covariance", 1));
  MUST(jalon_trajectory_adjust(fx_driven, fx_driven_cloud, fx_driven_strips, adjust, NULL,
                               &fx_adjustment));
  jalon_params_release(adjust);
  MUST(jalon_network_adjust(
      "from to direction zenith distance code\nA B 0 100 50 -\n"
      "A C 50 100 30 350\nB C 170 100 36.2 350\nB A 0 100 50 -\n",
      "id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n", NULL, NULL, &fx_network));
}

static void make_sections(void) {
  MUST(jalon_cloud_sections(fx_cloud, NULL, 0, NULL, NULL, &fx_sections));
}

static void make_files(void) {
  char made[200];
  snprintf(made, sizeof made, "%s/jalon_wild_XXXXXX", getenv("TMPDIR") ? getenv("TMPDIR") : "/tmp");
  char* whole = mkdtemp(made) != NULL ? realpath(made, NULL) : NULL;
  // Wild file names are relative ones: what they make shall go with the folder.
  if (whole == NULL || strlen(whole) >= sizeof folder || chdir(whole) != 0)
    must(-1, "no temporary folder");
  strcpy(folder, whole);
  free(whole);
  MUST(jalon_cloud_write(fx_cloud, fx_path("scan.las"), NULL, NULL));
  MUST(jalon_model_write(fx_mesh, fx_path("model.obj"), NULL, NULL));
  MUST(jalon_trajectory_write(fx_trajectory, fx_path("drive.txt"), NULL, NULL, NULL));
  FILE* m3c2 = fopen(fx_path("m3c2.txt"), "wb");
  if (m3c2 == NULL || fputs("M3C2VER=1\n", m3c2) < 0 || fclose(m3c2) != 0) exit(1);
}

void fx_begin(void) {
  for (int i = 0; i < kArrayItems; ++i) fx_indices[i] = (uint64_t)(i % 12);
  fx_long_text = malloc(70001);
  fx_deep_json = malloc(20001);
  memset(fx_long_text, 'a', 70000), fx_long_text[70000] = 0;
  memset(fx_deep_json, '[', 20000), fx_deep_json[20000] = 0;
  MUST(jalon_task_create(&fx_task));
  MUST(jalon_task_create(&fx_task_own));
  make_params();
  make_clouds();
  make_builders();
  make_workers();
  make_trajectories();
  make_adjustment();
  make_sections();
  make_files();
}

void fx_end(void) {
  DIR* d = opendir(folder);
  if (d != NULL) {
    for (struct dirent* entry; (entry = readdir(d)) != NULL;)
      if (entry->d_name[0] != '.') remove(fx_path(entry->d_name));
    closedir(d);
    if (chdir("/") != 0 || rmdir(folder) != 0) fprintf(stderr, "%s is left behind\n", folder);
  }
  for (int i = 0; i < made_options; ++i) jalon_params_release(options[i].params);
  jalon_cloud* clouds[] = {fx_cloud, fx_small,     fx_empty, fx_one,       fx_two,
                           fx_equal, fx_collinear, fx_far,   fx_nan_field, fx_ball};
  for (size_t i = 0; i < sizeof clouds / sizeof *clouds; ++i) jalon_cloud_release(clouds[i]);
  jalon_cloud_builder_release(fx_builder);
  jalon_cloud_builder_release(fx_builder_ready);
  jalon_fields_release(fx_fields);
  jalon_fields_release(fx_changed);
  jalon_model_release(fx_model);
  jalon_model_release(fx_mesh);
  jalon_model_release(fx_bare);
  jalon_model_release(fx_block);
  jalon_segmenter_release(fx_segmenter);
  jalon_segmentation_release(fx_segmentation);
  jalon_segmentation_release(fx_no_segments);
  jalon_segmentation_release(fx_start);
  jalon_evaluation_release(fx_evaluation);
  jalon_model_evaluation_release(fx_model_evaluation);
  jalon_modeller_release(fx_modeller);
  jalon_noise_law_release(fx_law);
  jalon_comparison_release(fx_comparison);
  jalon_registrar_release(fx_registrar);
  jalon_registration_release(fx_registration);
  jalon_comparer_release(fx_comparer);
  jalon_comparer_release(fx_m3c2);
  jalon_scanner_release(fx_scanner);
  jalon_scanner_release(fx_mobile);
  jalon_model_release(fx_strips);
  jalon_trajectory_release(fx_trajectory);
  jalon_trajectory_release(fx_bare_trajectory);
  jalon_trajectory_release(fx_driven);
  jalon_cloud_release(fx_driven_cloud);
  jalon_model_release(fx_driven_strips);
  jalon_adjustment_release(fx_adjustment);
  jalon_network_release(fx_network);
  jalon_sections_release(fx_sections);
  jalon_task_release(fx_task);
  jalon_task_release(fx_task_own);
  free(fx_long_text);
  free(fx_deep_json);
}
