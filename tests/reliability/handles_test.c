/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Each kind of handle made, used and given back, over and over: the process stays as large as it was. 10 000 cycles of
 * each in the long run. tests/style/signposts.py holds the kinds against the headers. */
#include "support.h"

#define OK(call) MUST(call)
#include "drive.h"
#include "process_size.h"

enum {
  kWarmCycles = 100, /* at least: what a process makes once, arenas of its threads among it */
  kMostKeptBytes =
      16 << 10, /* of malloc's own lists of free pieces; a handle that each cycle keeps is more */
  kWide = 12,
  kPoints = 12 * kWide,
  kDrivePoints = 500 /* the first of a drive that locate it */
};
static const double kSpacing_m = 0.02;

static int cycles(void) { return is_full_run() ? 10000 : is_sanitized() ? 20 : 500; }

/* What the handles are made of. */
static struct {
  double xyz[3 * kPoints];
  jalon_cloud* cloud;
  jalon_segmentation* segmentation;
  jalon_model* mesh;
  jalon_comparer* comparer;
  jalon_registrar* registrar;
  jalon_target targets[3], moved[3];
  Drive drive;
  jalon_cloud* seen;
  jalon_params* sections;
  jalon_task* task;
} of;

static void use_fields(jalon_fields* fields) {
  uint64_t columns = 0;
  MUST(jalon_fields_count(fields, &columns));
  assert_true(columns > 0);
  jalon_fields_release(fields);
}

static void cloud_cycle(void) {
  jalon_cloud* cloud = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_create(of.xyz, JALON_FLOAT64, kPoints, 0, 0, &cloud));
  MUST(jalon_cloud_prepare(cloud, of.task));
  MUST(jalon_cloud_points(cloud, &view));
  jalon_cloud_release(cloud);
}
static void builder_cycle(void) {
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_builder_create(0, &builder));
  MUST(jalon_cloud_builder_append_points(builder, of.xyz, JALON_FLOAT64, kPoints, 0));
  MUST(jalon_cloud_builder_seal(builder, &cloud));
  jalon_cloud_builder_release(builder);
  jalon_cloud_release(cloud);
}
static void fields_cycle(void) {
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_cells(of.cloud, 2, of.task, &fields));
  use_fields(fields);
}
static void task_cycle(void) {
  jalon_task* task = NULL;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 2));
  MUST(jalon_task_cancel(task));
  jalon_task_release(task);
}
static void params_cycle(void) {
  jalon_params* params = NULL;
  const char* json = NULL;
  MUST(jalon_params_create("normals", &params));
  MUST(jalon_params_from_json(params, "{\"k\": 20, \"viewpoint\": [3, 2, 1]}"));
  MUST(jalon_params_to_json(params, &json));
  jalon_params_release(params);
}
static void bytes_cycle(void) {
  jalon_bytes* bytes = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_to_bytes(of.cloud, of.task, &bytes));
  MUST(jalon_bytes_view(bytes, &view));
  jalon_bytes_release(bytes);
}
static void segmenter_cycle(void) {
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  jalon_segmenter_release(segmenter);
  jalon_params_release(params);
}
static void segmentation_cycle(void) {
  jalon_segmentation *start = NULL, *picked = NULL;
  jalon_fields* segments = NULL;
  MUST(jalon_segmentation_start(of.cloud, of.task, &start));
  MUST(jalon_segmentation_pick(start, JALON_PRIMITIVE_PLANE, of.xyz, 1, NULL, of.task, &picked));
  MUST(jalon_segmentation_segments(picked, &segments));
  use_fields(segments);
  jalon_segmentation_release(start);
  jalon_segmentation_release(picked);
}
static void evaluation_cycle(void) {
  jalon_evaluation* evaluation = NULL;
  jalon_fields* totals = NULL;
  MUST(jalon_segmentation_evaluate(of.segmentation, of.segmentation, NULL, of.task, &evaluation));
  MUST(jalon_evaluation_totals(evaluation, &totals));
  use_fields(totals);
  jalon_evaluation_release(evaluation);
}
static void modeller_cycle(void) {
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  jalon_modeller_release(modeller);
  jalon_params_release(params);
}
static jalon_model* square(void) {
  static const double corners[12] = {0, 0, 0, 8, 0, 0, 8, 0, 8, 0, 0, 8};
  static const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  jalon_model* mesh = NULL;
  MUST(jalon_model_create_mesh(corners, JALON_FLOAT64, 4, 0, triangles, 2, NULL, &mesh));
  return mesh;
}
static void model_cycle(void) {
  jalon_model* const mesh = square();
  jalon_fields* faces = NULL;
  MUST(jalon_model_faces(mesh, &faces));
  use_fields(faces);
  jalon_model_release(mesh);
}
static void model_evaluation_cycle(void) {
  jalon_model_evaluation* evaluation = NULL;
  jalon_fields* totals = NULL;
  MUST(jalon_model_evaluate(of.mesh, of.mesh, NULL, of.task, &evaluation));
  MUST(jalon_model_evaluation_totals(evaluation, &totals));
  use_fields(totals);
  jalon_model_evaluation_release(evaluation);
}
static void comparer_cycle(void) {
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  MUST(jalon_comparer_create("m3c2", &comparer));
  MUST(jalon_comparer_params(comparer, &params));
  jalon_comparer_release(comparer);
  jalon_params_release(params);
}
static void comparison_cycle(void) {
  jalon_comparison* comparison = NULL;
  jalon_fields* points = NULL;
  MUST(jalon_comparer_run(of.comparer, of.cloud, of.cloud, of.task, &comparison));
  MUST(jalon_comparison_points(comparison, &points));
  use_fields(points);
  jalon_comparison_release(comparison);
}
static void registrar_cycle(void) {
  jalon_registrar* registrar = NULL;
  jalon_params* params = NULL;
  MUST(jalon_registrar_create("icp", &registrar));
  MUST(jalon_registrar_params(registrar, &params));
  jalon_registrar_release(registrar);
  jalon_params_release(params);
}
static void registration_cycle(void) {
  jalon_registration* registration = NULL;
  jalon_fields* residuals = NULL;
  MUST(jalon_registrar_run_targets(of.registrar, of.targets, 3, of.moved, 3, of.task,
                                   &registration));
  MUST(jalon_registration_residuals(registration, &residuals));
  use_fields(residuals);
  jalon_registration_release(registration);
}
static void scanner_cycle(void) {
  const jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  jalon_scanner* scanner = NULL;
  MUST(jalon_scanner_create(NULL, &scanner));
  MUST(jalon_scanner_add_station(scanner, "a station with a rather long name", &pose));
  jalon_scanner_release(scanner);
}
static void sections_cycle(void) {
  jalon_sections* sections = NULL;
  jalon_fields* vertices = NULL;
  MUST(jalon_cloud_sections(of.cloud, NULL, 0, of.sections, of.task, &sections));
  MUST(jalon_sections_vertices(sections, &vertices));
  use_fields(vertices);
  jalon_sections_release(sections);
}
static void trajectory_cycle(void) {
  static const double times[2] = {10, 11}, positions[6] = {0, 0, 40, 5, 0, 40}, turns[6] = {0};
  jalon_trajectory* trajectory = NULL;
  jalon_fields* epochs = NULL;
  MUST(jalon_trajectory_create(times, positions, turns, NULL, NULL, NULL, 2, "EPSG:2154", NULL,
                               &trajectory));
  MUST(jalon_trajectory_epochs(trajectory, &epochs));
  use_fields(epochs);
  jalon_trajectory_release(trajectory);
}
static void adjustment_cycle(void) {
  jalon_adjustment* adjustment = NULL;
  jalon_fields* summary = NULL;
  MUST(jalon_trajectory_adjust(of.drive.trajectory, of.seen, of.drive.model, NULL, of.task,
                               &adjustment));
  MUST(jalon_adjustment_summary(adjustment, &summary));
  use_fields(summary);
  jalon_adjustment_release(adjustment);
}
static void network_cycle(void) {
  static const char nails[] = "id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n";
  static const char sights[] =
      "from to direction zenith distance\nA B 0 100 50\nA C 50 100 30\nB C 159.57 100 35.76\n";
  jalon_network* network = NULL;
  jalon_fields* points = NULL;
  MUST(jalon_network_adjust(sights, nails, NULL, NULL, &network));
  MUST(jalon_network_points(network, &points));
  use_fields(points);
  jalon_network_release(network);
}
static void noise_law_cycle(void) {
  jalon_noise_law* law = NULL;
  const char* json = NULL;
  MUST(jalon_noise_law_from_json("{\"law\": \"weibull\", \"shape\": 2, \"scale\": 0.005}", &law));
  MUST(jalon_noise_law_json(law, &json));
  jalon_noise_law_release(law);
}

static const struct {
  const char* handle;
  void (*cycle)(void);
} kHandles[] = {
    {"jalon_cloud", cloud_cycle},           {"jalon_cloud_builder", builder_cycle},
    {"jalon_fields", fields_cycle},         {"jalon_task", task_cycle},
    {"jalon_params", params_cycle},         {"jalon_bytes", bytes_cycle},
    {"jalon_segmenter", segmenter_cycle},   {"jalon_segmentation", segmentation_cycle},
    {"jalon_evaluation", evaluation_cycle}, {"jalon_modeller", modeller_cycle},
    {"jalon_model", model_cycle},           {"jalon_model_evaluation", model_evaluation_cycle},
    {"jalon_comparer", comparer_cycle},     {"jalon_comparison", comparison_cycle},
    {"jalon_registrar", registrar_cycle},   {"jalon_registration", registration_cycle},
    {"jalon_scanner", scanner_cycle},       {"jalon_sections", sections_cycle},
    {"jalon_trajectory", trajectory_cycle}, {"jalon_adjustment", adjustment_cycle},
    {"jalon_network", network_cycle},       {"jalon_noise_law", noise_law_cycle},
};
enum { kHandleCount = sizeof kHandles / sizeof *kHandles };

static void handles__made_used_and_given_back_keep_no_memory(void** state) {
  long most_kept = 0, most_grown = 0;
  (void)state;
  for (int kind = 0; kind < kHandleCount; ++kind) {
    const int warm = cycles() / 10 > kWarmCycles || is_sanitized() ? cycles() / 10 : kWarmCycles;
    for (int i = 0; i < warm; ++i) kHandles[kind].cycle();
    const long before = resident_kib(), allocated = allocated_bytes();
    for (int i = 0; i < cycles(); ++i) kHandles[kind].cycle();
    const long grown = resident_kib() - before, kept = allocated_bytes() - allocated;
    if (grown > most_grown) most_grown = grown;
    if (kept > most_kept) most_kept = kept;
    if (!is_sanitized() && (grown > kMostGrowthKib || kept > kMostKeptBytes))
      fail_msg("%d cycles of %s: %ld KiB more, %ld bytes of them allocated", cycles(),
               kHandles[kind].handle, grown, kept);
  }
  printf(
      "FIGURE handles: %d cycles of each of %d kinds, at most %ld KiB more, %ld bytes of them "
      "allocated\n",
      cycles(), (int)kHandleCount, most_grown, most_kept);
}

static int make_all(void** state) {
  static const char* const names[3] = {"A", "B", "C"};
  static const double at[9] = {0, 0, 0, 9, 0, 1, 8, 7, 2};
  static uint64_t first[kDrivePoints];
  (void)state;
  for (int i = 0; i < kPoints; ++i) /* a piece of a wall */
    of.xyz[3 * i] = kSpacing_m * (i % kWide), of.xyz[3 * i + 2] = kSpacing_m * (i / kWide);
  MUST(jalon_task_create(&of.task));
  MUST(jalon_task_set_threads(of.task, 1));
  MUST(jalon_cloud_create(of.xyz, JALON_FLOAT64, kPoints, 0, 0, &of.cloud));
  jalon_segmentation* start = NULL;
  MUST(jalon_segmentation_start(of.cloud, NULL, &start));
  MUST(jalon_segmentation_pick(start, JALON_PRIMITIVE_PLANE, of.xyz, 1, NULL, NULL,
                               &of.segmentation));
  jalon_segmentation_release(start);
  of.mesh = square();
  MUST(jalon_comparer_create("distance", &of.comparer));
  MUST(jalon_registrar_create("targets", &of.registrar));
  for (int i = 0; i < 3; ++i) {
    of.targets[i].name = names[i];
    of.targets[i].xyz.x = at[3 * i], of.targets[i].xyz.y = at[3 * i + 1];
    of.targets[i].xyz.z = at[3 * i + 2];
    of.moved[i] = of.targets[i];
    of.moved[i].xyz.x += 2;
  }
  MUST(jalon_params_create("sections", &of.sections));
  MUST(jalon_params_set_double(of.sections, "step_m", 0.1));
  of.drive = drive_of(1);
  for (uint64_t i = 0; i < kDrivePoints; ++i) first[i] = i;
  MUST(jalon_cloud_select(of.drive.cloud, first, kDrivePoints, NULL, &of.seen));
  return 0;
}
static int drop_all(void** state) {
  (void)state;
  jalon_cloud_release(of.cloud), jalon_cloud_release(of.seen);
  jalon_segmentation_release(of.segmentation);
  jalon_model_release(of.mesh);
  jalon_comparer_release(of.comparer);
  jalon_registrar_release(of.registrar);
  jalon_params_release(of.sections);
  release_drive(&of.drive);
  jalon_task_release(of.task);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(handles__made_used_and_given_back_keep_no_memory)};
  return cmocka_run_group_tests(tests, make_all, drop_all);
}
