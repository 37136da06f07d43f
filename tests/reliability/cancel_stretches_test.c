/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* How long a cancel may have to wait: the longest stretch of processor time between two places where an operation asks
 * whether to go on, by one thread, on five million points. What an operation's job prepares comes before its first look
 * and does not count. Printed, not asserted: it is the machine's as much as ours. A few looks within chunks of work
 * call no host and are not seen: the true stretches are no longer than these. A cancel at any moment waits until the
 * next look: the share of moments with a longer wait than promised is told too. With JALON_FULL=1, of those
 * that are named, or of all. */
#include "stepped_clock.h"

#include "../bench/hostile_operations.h"
#include "file_jobs.h"

enum { kStretchPoints = 5000000 };
static const double kLong_s = 0.1;

struct stretches {
  double last_s, longest_s;
  double whole_s, late_s; /* of all stretches, and of their moments that are too far from the end */
  long looks;
  jalon_status status;
};

static int32_t note_look(double fraction, const char* stage, void* user) {
  struct stretches* const seen = user;
  const double stretch_s = thread_s() - seen->last_s;
  (void)fraction, (void)stage;
  if (seen->looks++ > 0) {
    if (stretch_s > seen->longest_s) seen->longest_s = stretch_s;
    if (stretch_s > kLong_s) seen->late_s += stretch_s - kLong_s;
    seen->whole_s += stretch_s;
  }
  seen->last_s = thread_s();
  return 0;
}

/* Of those to try: names, "operations" or "files"; none: all. A file is read where it was written before. */
static int argument_count;
static char** arguments;
static int is_wanted(const char* group, const char* name) {
  for (int i = 1; i < argument_count; ++i)
    if (strcmp(arguments[i], group) == 0 || strcmp(arguments[i], name) == 0) return 1;
  return argument_count < 2;
}

/* A task of one thread whose looks are noted. */
static jalon_task* noting_task(struct stretches* seen) {
  jalon_task* made_task = NULL;
  MUST(jalon_task_create(&made_task));
  MUST(jalon_task_set_threads(made_task, 1));
  MUST(jalon_task_set_progress(made_task, note_look, seen));
  return made_task;
}

/* A busy machine adds to a stretch (fresh pages, another's caches), and to another one each time. */
enum { kMostTries = 3 };

static struct stretches once_of(const jalon_cloud* points, int which) {
  struct stretches seen = {0, 0, 0, 0, 0, JALON_OK};
  made out = {NULL, NULL, NULL};
  make_ready(points, which);
  jalon_task* const noting = noting_task(&seen);
  seen.status = operation_of(which)(points, noting, &out);
  release_made(&out);
  jalon_task_release(noting);
  return seen;
}

static struct stretches stretches_of(const jalon_cloud* points, int which) {
  struct stretches least = once_of(points, which);
  for (int i = 1; i < kMostTries && least.longest_s > kLong_s; ++i) {
    const struct stretches seen = once_of(points, which);
    if (seen.longest_s < least.longest_s) least = seen;
  }
  return least;
}

/* The dearest of what was tried. */
struct worst {
  const char *longest, *latest;
  double longest_s, late;
  int many, tried;
};

static void add_to(struct worst* worst, const char* name, const struct stretches* seen) {
  const double late = seen->whole_s > 0 ? seen->late_s / seen->whole_s : 0;
  /* A street may hold nothing that an operation works on. */
  if (seen->status == JALON_OK && seen->looks == 0)
    fail_msg("%s never asks whether to go on", name);
  ++worst->tried;
  if (seen->longest_s > worst->longest_s) worst->longest_s = seen->longest_s, worst->longest = name;
  if (late > worst->late) worst->late = late, worst->latest = name;
  if (seen->longest_s <= kLong_s) return;
  ++worst->many;
  printf("    %-24s %6.0f ms of %ld looks, %.2f %% of the moments too far from one\n", name,
         1e3 * seen->longest_s, seen->looks, 1e2 * late);
}
static void tell(const struct worst* worst, const char* what) {
  printf(
      "FIGURE stretches without a look, %d %s on %d points: %d above %.0f ms, longest %.0f ms "
      "(%s), the least of %d tries where one was above; "
      "a cancel waits longer at %.2f %% of the moments at most (%s)\n",
      worst->tried, what, kStretchPoints, worst->many, 1e3 * kLong_s, 1e3 * worst->longest_s,
      worst->longest, kMostTries, 1e2 * worst->late, worst->latest);
}

static void cancel__waits_for_no_long_stretch(void** state) {
  (void)state;
  if (!is_full_run() || is_sanitized()) skip();
  jalon_cloud* const points = street_cloud(kStretchPoints, 10);
  struct worst worst = {"", "", 0, 0, 0, 0};
  for (int i = 0; i < kAllCount; ++i) {
    if (!is_wanted("operations", name_of(i))) continue;
    const struct stretches seen = stretches_of(points, i);
    add_to(&worst, name_of(i), &seen);
  }
  tell(&worst, "operations");
  jalon_cloud_release(points);
}

/* Of any number of files: those of a tiled set are hundreds. */
static void empty_folder(const char* path) {
  DIR* const all = opendir(path);
  char inside[600];
  assert_non_null(all);
  for (const struct dirent* e; (e = readdir(all)) != NULL;) {
    struct stat state;
    if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0) continue;
    snprintf(inside, sizeof inside, "%.300s/%.256s", path, e->d_name);
    assert_int_equal(lstat(inside, &state), 0);
    if (S_ISDIR(state.st_mode)) empty_folder(inside);
    assert_int_equal(remove(inside), 0);
  }
  closedir(all);
}

static void cancel__of_a_file_waits_for_no_long_stretch(void** state) {
  if (!is_full_run() || is_sanitized()) skip();
  io_job jobs[kMostJobs];
  char names[kMostJobs][80];
  struct worst worst = {"", "", 0, 0, 0, 0};
  make_scene(state);
  jalon_cloud* const small = cloud;
  jalon_task* const scene_task = task;
  cloud = street_cloud(kStretchPoints, 10);
  const int count = all_jobs(jobs);
  for (int i = 0; i < count; ++i) {
    snprintf(names[i], sizeof names[i], "%s %.60s", jobs[i].reads ? "read" : "write", jobs[i].file);
    if (!is_wanted("files", names[i])) continue;
    struct stretches seen = {0, 0, 0, 0, 0, JALON_OK};
    if (!jobs[i].reads) empty_folder(folder);
    task = noting_task(&seen);
    seen.status = jobs[i].run(path_in(folder, jobs[i].file));
    jalon_task_release(task);
    if (seen.status == JALON_OK) add_to(&worst, names[i], &seen);
  }
  tell(&worst, "files");
  jalon_cloud_release(cloud);
  cloud = small;
  task = scene_task;
  empty_folder(folder);
  drop_scene(state);
}

int main(int argc, char** argv) {
  argument_count = argc;
  arguments = argv;
  const struct CMUnitTest tests[] = {cmocka_unit_test(cancel__waits_for_no_long_stretch),
                                     cmocka_unit_test(cancel__of_a_file_waits_for_no_long_stretch)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
