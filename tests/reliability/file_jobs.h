/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The writing and the reading of each format of the registry, and the reports, as jobs of one shape. */
#ifndef JALON_TEST_FILE_JOBS_H
#define JALON_TEST_FILE_JOBS_H

#include "folder_state.h"

enum { kJobPoints = 900, kMostJobs = 64 };

static jalon_cloud* cloud;
static jalon_model* model;
static jalon_segmentation* segmentation;
static jalon_task* task;
static char folder[300];

typedef struct io_job {
  char file[64];
  jalon_status (*run)(const char* path);
  int reads;
} io_job;

/* What the last reading gave. */
static uint64_t read_hash;

static jalon_status hash_of(jalon_bytes* bytes) {
  jalon_array_view view;
  const jalon_status status = jalon_bytes_view(bytes, &view);
  if (status == JALON_OK) read_hash = hash_bytes(14695981039346656037u, view.data, view.count);
  jalon_bytes_release(bytes);
  return status;
}
static jalon_status write_cloud(const char* path) {
  return jalon_cloud_write(cloud, path, NULL, task);
}
static jalon_status write_model(const char* path) {
  return jalon_model_write(model, path, NULL, task);
}
static jalon_status write_page(const char* path) {
  return jalon_report_write_html(segmentation, model, NULL, path, NULL, task);
}
static jalon_status write_json(const char* path) {
  return jalon_report_write_json(segmentation, model, NULL, path, NULL, task);
}
static jalon_status write_picture(const char* path) {
  return jalon_report_write_picture(segmentation, path, NULL, task);
}
static jalon_status read_cloud(const char* path) {
  jalon_cloud* out = NULL;
  jalon_bytes* bytes = NULL;
  jalon_status status = jalon_cloud_read(path, NULL, task, &out);
  if (status != JALON_OK && out != NULL) fail_msg("%s: an output beside an error", path);
  if (status == JALON_OK) status = jalon_cloud_to_bytes(out, task, &bytes);
  if (status == JALON_OK) status = hash_of(bytes);
  jalon_cloud_release(out);
  return status;
}
static jalon_status read_model(const char* path) {
  jalon_model* out = NULL;
  jalon_bytes* bytes = NULL;
  jalon_status status = jalon_model_read(path, NULL, task, &out);
  if (status != JALON_OK && out != NULL) fail_msg("%s: an output beside an error", path);
  if (status == JALON_OK) status = jalon_model_to_bytes(out, task, &bytes);
  if (status == JALON_OK) status = hash_of(bytes);
  jalon_model_release(out);
  return status;
}

/* ---- the jobs: what the registry of formats names, and the reports ---- */

static int add_job(io_job* jobs, int n, const char* stem, const char* extension, int reads,
                   jalon_status (*run)(const char* path)) {
  assert_true(n < kMostJobs);
  if (strcmp(extension, "ept.json") == 0) strcpy(jobs[n].file, "set/ept.json"); /* a folder */
  else snprintf(jobs[n].file, sizeof jobs[n].file, "%s.%s", stem, extension);
  jobs[n].run = run;
  jobs[n].reads = reads;
  return n + 1;
}

static int has(const char* abilities, const char* of, const char* ability) {
  const char* at = strstr(abilities, of);
  const char* next = at == NULL ? NULL : strstr(at, ",");
  const char* found = at == NULL ? NULL : strstr(at, ability);
  return found != NULL && (next == NULL || found < next);
}

static int all_jobs(io_job* jobs) {
  uint64_t formats = 0;
  int n = 0;
  MUST(jalon_format_count(&formats));
  for (uint64_t i = 0; i < formats; ++i) {
    const char *extensions = NULL, *abilities = NULL;
    char extension[32];
    MUST(jalon_format_info(i, NULL, &extensions, &abilities));
    snprintf(extension, sizeof extension, "%.*s", (int)strcspn(extensions, " ,"), extensions);
    const char* const shown = extension[0] == '.' ? extension + 1 : extension;
    if (has(abilities, "cloud", "write")) {
      n = add_job(jobs, n, "cloud", shown, 0, write_cloud);
      if (has(abilities, "cloud", "read")) n = add_job(jobs, n, "cloud", shown, 1, read_cloud);
    }
    if (has(abilities, "model", "write")) {
      n = add_job(jobs, n, "model", shown, 0, write_model);
      if (has(abilities, "model", "read")) n = add_job(jobs, n, "model", shown, 1, read_model);
    }
  }
  n = add_job(jobs, n, "page", "html", 0, write_page);
  n = add_job(jobs, n, "page", "json", 0, write_json);
  return add_job(jobs, n, "picture", "png", 0, write_picture);
}

/* ---- what they work on ---- */

static int make_scene(void** state) {
  (void)state;
  jalon_segmenter* segmenter = NULL;
  jalon_modeller* modeller = NULL;
  snprintf(folder, sizeof folder, "%s", temporary("file_jobs"));
  make_folder(folder);
  MUST(jalon_task_create(&task));
  cloud = street_cloud(kJobPoints, 11);
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  MUST(jalon_modeller_create("outlines", &modeller));
  MUST(jalon_modeller_run(modeller, cloud, segmentation, task, &model));
  jalon_modeller_release(modeller);
  jalon_segmenter_release(segmenter);
  return 0;
}

static int drop_scene(void** state) {
  (void)state;
  jalon_model_release(model);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  jalon_task_release(task);
  clear_folder(folder);
  return rmdir(folder);
}

#endif
