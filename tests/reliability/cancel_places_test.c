/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Cancel at the 1st, 2nd, 3rd ... place where an operation, a reading or a writing asks whether to go on: the status is
 * the documented one, no output is written, no file is left, nothing is kept, and the same call with the same task then
 * gives what an undisturbed one gives. By turns the callback says stop and the task is told to cancel. By default a few
 * places of each job, spread over it; JALON_FULL=1 takes up to kMostPlaces. */
#include "file_jobs.h"
#include "stepped_clock.h"

#include "../bench/hostile_operations.h"
#include "allocation_faults.h"

enum { kOperationPoints = 1500, kMostPlaces = 60, kFewPlaces = 3, kPlacesPromised = 2400 };

static jalon_cloud* points;
static io_job files[kMostJobs];
static int file_count;

static const char* job_name(int job) {
  return job < kAllCount ? name_of(job) : files[job - kAllCount].file;
}
static int is_file(int job) { return job >= kAllCount; }
static int is_writing(int job) { return is_file(job) && !files[job - kAllCount].reads; }

/* However few the points, these take about a second: the long run's. */
static const char* const kSlow[] = {"map distance",         "map distance marching",
                                    "distance map",         "automatic registration",
                                    "coarse registration",  "icp",
                                    "diagnosis of changes", "regions of changes"};
static int is_slow(int job) {
  for (size_t i = 0; i < sizeof kSlow / sizeof *kSlow; ++i)
    if (strcmp(job_name(job), kSlow[i]) == 0) return 1;
  return 0;
}

/* ---- one run, stopped at a place or not at all ---- */

struct stop {
  long at, seen; /* the place; 0 = none */
  int by_task, is_done;
};

static int32_t stop_at_place(double fraction, const char* stage, void* user) {
  struct stop* const stop = user;
  (void)stage;
  if (fraction == 1.0) return 0; /* the call has succeeded */
  if (++stop->seen != stop->at) return 0;
  stop->is_done = 1;
  if (!stop->by_task) return 1;
  MUST(jalon_task_cancel(task));
  return 0;
}

/* What came of a run, with a hash of its output, and the blocks that it left alive. */
struct outcome {
  jalon_status status;
  uint64_t hash;
  long kept;
  int is_empty;
};

static long blocks(void) {
#ifdef CANNOT_REPLACE_MALLOC
  return 0;
#else
  return live_blocks();
#endif
}

static struct outcome run_until(int job, struct stop* stop) {
  struct outcome out = {JALON_OK, 0, 0, 1};
  const long before = blocks();
  made m = {NULL, NULL, NULL};
  MUST(jalon_task_reset(task));
  MUST(jalon_task_set_progress(task, stop_at_place, stop));
  if (is_file(job)) {
    read_hash = 0;
    out.status = files[job - kAllCount].run(path_in(folder, files[job - kAllCount].file));
    out.hash = read_hash;
  } else {
    out.status = operation_of(job)(points, task, &m);
    out.is_empty = m.cloud == NULL && m.fields == NULL && m.segmentation == NULL;
    if (out.status == JALON_OK) out.hash = hash_made(&m);
  }
  MUST(jalon_task_set_progress(task, NULL, NULL));
  release_made(&m);
  out.kept = blocks() - before;
  return out;
}

static struct outcome undisturbed(int job, long* places) {
  struct stop none = {0, 0, 0, 0};
  const struct outcome out = run_until(job, &none);
  *places = none.seen;
  return out;
}

/* ---- what must hold ---- */

static void expect_no_file(const char* what) {
  folder_state now;
  read_folder(folder, &now);
  if (now.count != 0) fail_msg("%s: %s is left", what, now.files[0].name);
  free_folder(&now);
}

static void stop_and_go_on(int job, long place, long places, const struct outcome* expected) {
  char what[120];
  snprintf(what, sizeof what, "%s, cancelled at place %ld of %ld", job_name(job), place, places);
  if (is_writing(job)) clear_folder(folder);
  /* Behind the last place nobody looks: there only the callback can say stop. */
  const int by_task = place % 2 == 1 && place < places;
  struct stop stop = {place, 0, by_task, 0};
  const struct outcome stopped = run_until(job, &stop);
  if (!stop.is_done) fail_msg("%s: there were only %ld", what, stop.seen);
  if (stopped.status != JALON_ERROR_CANCELLED)
    fail_msg("%s: %s: %s", what, jalon_status_name(stopped.status), jalon_last_error_message());
  expect_one_line();
  if (!stopped.is_empty) fail_msg("%s: wrote an output", what);
  if (is_writing(job)) expect_no_file(what);
  struct stop again = {place, 0, by_task, 0};
  if (stopped.kept > 0 && run_until(job, &again).kept > 0) /* twice: what a process keeps once */
    fail_msg("%s: %ld blocks are never freed", what, stopped.kept);
  long ignored = 0;
  const struct outcome after = undisturbed(job, &ignored);
  if (after.status != expected->status || after.hash != expected->hash)
    fail_msg("%s: then another result (%s)", what, jalon_status_name(after.status));
}

static long places_of(int job, long most) {
  long places = 0;
  if (is_file(job)) {
    clear_folder(folder);
    if (!is_writing(job)) /* the file of the writing before it */
      MUST(files[job - kAllCount - 1].run(path_in(folder, files[job - kAllCount].file)));
  } else {
    make_ready(points, job);
  }
  (void)undisturbed(job, &places); /* what a cloud keeps for later is there from now on */
  const struct outcome expected = undisturbed(job, &places);
  const long tried = places < most ? places : most;
  for (long k = 0; k < tried; ++k)
    stop_and_go_on(job, 1 + (2 * k + 1) * places / (2 * tried), places, &expected);
  return tried;
}

static void cancel__at_each_place_leaves_no_output_and_the_call_can_be_made_again(void** state) {
  (void)state;
  const long most = is_sanitized() ? 1 : is_full_run() ? kMostPlaces : kFewPlaces;
  long places = 0;
  int jobs = 0;
  MUST(jalon_task_set_threads(task, 1));
  for (int job = 0; job < kAllCount + file_count; ++job) {
    if (most < kMostPlaces && is_slow(job)) continue;
    const long tried = places_of(job, most);
    places += tried;
    jobs += tried > 0;
  }
  printf("FIGURE cancelled at %ld places of %d jobs\n", places, jobs);
  if (most == kMostPlaces) assert_true(places >= kPlacesPromised);
  assert_true(jobs >= 120);
}

static int begin(void** state) {
  const int status = make_scene(state);
  points = street_cloud(kOperationPoints, 12);
  file_count = all_jobs(files);
  return status;
}
static int end(void** state) {
  jalon_cloud_release(points);
  return drop_scene(state);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(cancel__at_each_place_leaves_no_output_and_the_call_can_be_made_again),
  };
  return cmocka_run_group_tests(tests, begin, end);
}
