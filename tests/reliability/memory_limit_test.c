/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A task's memory limit in each long operation and in the files of each format: what needs more is refused with a line
 * that says so, what needs less is done, and the process takes no more than the limit. */
#include "operations.h"

#include "file_jobs.h"
#include "memory_counted.h"

enum {
  kOperationPoints = 2000,
  kLargePoints = 20000,
  kLargePointsFull = 500000,
  kRounding = 1 << 16, /* blocks are larger than what was asked for */
  kTrueSlackKib = 8 << 10
};
enum {
  kScratch = 1 << 20
}; /* of a thread that was not there, or not at once, when the peak was taken */

/* Of what is needed, before a call is refused whose need is told beforehand: messages and tables. */
static const double kForetoldTaken = 0.01;

static jalon_cloud* small;
static io_job files[kMostJobs];
static int file_count;

static const char* name_of(int job) {
  return job < kOperationCount ? kOperations[job].name : files[job - kOperationCount].file;
}
static jalon_status run(int job) {
  if (job >= kOperationCount) {
    const io_job* const file = &files[job - kOperationCount];
    return file->run(path_in(folder, file->file));
  }
  made m = {NULL, NULL, NULL};
  const jalon_status status = kOperations[job].run(small, task, &m);
  release_made(&m);
  return status;
}
/* Within a limit, with the peak of the job's last call. */
static jalon_status run_within(int job, uint64_t limit, uint64_t* peak) {
  MUST(jalon_task_set_memory_limit(task, limit));
  const jalon_status status = run(job);
  MUST(jalon_task_memory_peak(task, peak));
  return status;
}
/* A limit that all calls of the job are done within. */
static uint64_t needed_by(int job) {
  uint64_t needed = 0, peak = 0;
  MUST(run_within(job, UINT64_MAX, &needed));
  while (run_within(job, needed, &peak) == JALON_ERROR_OUT_OF_MEMORY) needed += needed / 8 + 4096;
  return needed;
}

static void memory_limit__below_what_a_call_needs_is_refused_in_words(void** state) {
  (void)state;
  int refused[4] = {0}, done[4] = {0}, jobs = 0;
  const int percent[4] = {1, 10, 50, 90};
  MUST(jalon_task_set_threads(task, 1));
  for (int job = 0; job < kOperationCount + file_count; ++job) {
    uint64_t peak = 0;
    MUST(jalon_task_set_memory_limit(task, 0));
    if (job >= kOperationCount && !files[job - kOperationCount].reads) clear_folder(folder);
    MUST(run(job)); /* what a cloud keeps for later is there from now on */
    const uint64_t needed = needed_by(job);
    ++jobs;
    for (int k = 0; k < 4; ++k) {
      const uint64_t limit = needed / 100 * (uint64_t)percent[k];
      if (limit == 0) continue;
      const jalon_status status = run_within(job, limit, &peak);
      if (peak > limit + kRounding)
        fail_msg("%s: %llu of %llu bytes", name_of(job), (unsigned long long)peak,
                 (unsigned long long)limit);
      if (status == JALON_OK) ++done[k];
      else if (status != JALON_ERROR_OUT_OF_MEMORY)
        fail_msg("%s at %d %%: %s", name_of(job), percent[k], jalon_last_error_message());
      else if (strstr(jalon_last_error_message(), "memory limit is") == NULL)
        fail_msg("%s at %d %%: \"%s\"", name_of(job), percent[k], jalon_last_error_message());
      else ++refused[k];
    }
    if (run_within(job, needed + kRounding, &peak) != JALON_OK)
      fail_msg("%s with all it needs: %s", name_of(job), jalon_last_error_message());
  }
  for (int k = 0; k < 4; ++k)
    printf("FIGURE memory limit of %d %%: %d of %d jobs refused, %d done with less\n", percent[k],
           refused[k], jobs, done[k]);
  assert_true(jobs >= 70);
  fflush(stdout);
  assert_true(refused[0] >= jobs * 9 / 10 && refused[2] >= jobs * 9 / 10);
}

/* What is known of the points' number alone, of a cloud whose index is not made yet. */
static jalon_status op_transform(const jalon_cloud* cloud_in, jalon_task* with, made* out) {
  const jalon_transform quarter_turn = {{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}};
  return jalon_cloud_transform(cloud_in, &quarter_turn, with, &out->cloud);
}
static jalon_status op_order(const jalon_cloud* cloud_in, jalon_task* with, made* out) {
  return jalon_cloud_order(cloud_in, with, &out->fields);
}
static jalon_status op_inverted(const jalon_cloud* cloud_in, jalon_task* with, made* out) {
  MUST(own_handle(cloud_in, &out->cloud));
  MUST(jalon_cloud_compute_normals(out->cloud, NULL, NULL));
  return jalon_cloud_invert_normals(out->cloud, with);
}
static const struct {
  const char* name;
  operation run;
} kForetold[] = {
    {"prepare", op_prepare},   {"normals", op_normals},     {"normals quadric", op_quadric},
    {"features", op_features}, {"outliers", op_outliers},   {"duplicates", op_duplicates},
    {"random", op_random},     {"append", op_append},       {"covariances", op_covariances},
    {"order", op_order},       {"transform", op_transform}, {"inverted normals", op_inverted},
};
enum { kForetoldCount = sizeof kForetold / sizeof *kForetold };

static jalon_status foretold_within(int which, uint64_t limit, uint64_t* peak) {
  jalon_cloud* fresh = NULL;
  made m = {NULL, NULL, NULL};
  MUST(own_handle(small, &fresh));
  MUST(jalon_task_set_memory_limit(task, limit));
  const jalon_status status = kForetold[which].run(fresh, task, &m);
  MUST(jalon_task_memory_peak(task, peak));
  release_made(&m);
  jalon_cloud_release(fresh);
  return status;
}

static void memory_limit__refuses_what_can_be_foretold_before_it_is_taken(void** state) {
  (void)state;
  const int percent[4] = {1, 10, 50, 90};
  double most_taken = 0;
  jalon_cloud* const kept = small;
  MUST(jalon_task_set_threads(task, 1));
  const uint64_t points[] = {100000, 1000000};
  for (size_t n = 0; n < (is_full_run() ? sizeof points / sizeof *points : 1); ++n) {
    small = street_cloud(points[n], 12);
    for (int i = 0; i < kForetoldCount; ++i) {
      uint64_t needed = 0, peak = 0;
      MUST(foretold_within(i, UINT64_MAX, &needed));
      for (int k = 0; k < 4; ++k) {
        const jalon_status status = foretold_within(i, needed / 100 * (uint64_t)percent[k], &peak);
        const double taken = (double)peak / (double)needed;
        if (status != JALON_ERROR_OUT_OF_MEMORY ||
            strstr(jalon_last_error_message(), "memory limit is") == NULL)
          fail_msg("%s at %d %%: %d \"%s\"", kForetold[i].name, percent[k], status,
                   jalon_last_error_message());
        if (taken > kForetoldTaken)
          fail_msg("%s at %d %%: %.1f %% was taken before", kForetold[i].name, percent[k],
                   1e2 * taken);
        if (taken > most_taken) most_taken = taken;
      }
      if (foretold_within(i, needed + kRounding, &peak) != JALON_OK)
        fail_msg("%s with all it needs: %s", kForetold[i].name, jalon_last_error_message());
    }
    jalon_cloud_release(small);
  }
  small = kept;
  printf("FIGURE memory limit: %d operations refused at once, with at most %.2f %% of it taken\n",
         kForetoldCount, 1e2 * most_taken);
}

static long peak_resident_kib(void) {
  char line[200];
  long kib = -1;
  FILE* const f = fopen("/proc/self/status", "r");
  while (f != NULL && fgets(line, sizeof line, f) != NULL)
    if (sscanf(line, "VmHWM: %ld", &kib) == 1) break;
  if (f != NULL) fclose(f);
  return kib;
}
static int forget_peak(void) {
  FILE* const f = fopen("/proc/self/clear_refs", "w");
  if (f == NULL) return 0;
  const int written = fputs("5", f) >= 0;
  return fclose(f) == 0 && written;
}

static void memory_limit__is_kept_by_the_process(void** state) {
  (void)state;
#if defined(__SANITIZE_ADDRESS__)
  skip();
#endif
  if (!forget_peak()) skip();
  jalon_cloud* const large = street_cloud(is_full_run() ? kLargePointsFull : kLargePoints, 21);
  jalon_cloud* const kept = small;
  long worst = -1000000;
  small = large;
  MUST(jalon_task_set_threads(task, 2));
  for (int job = 0; job < kOperationCount; ++job) {
    uint64_t peak = 0;
    MUST(run_within(job, UINT64_MAX, &peak));
    for (int part = 1; part <= 2; ++part) { /* half, and all with what other threads may need */
      const uint64_t limit =
          part == 1 ? peak / 2 : peak + (peak / 4 > kScratch ? peak / 4 : kScratch);
      uint64_t used = 0;
      assert_true(forget_peak());
      const long before = peak_resident_kib();
      const jalon_status status = run_within(job, limit, &used);
      const long more = peak_resident_kib() - before - (long)(limit >> 10);
      if (part == 2 && status != JALON_OK)
        fail_msg("%s: %s", name_of(job), jalon_last_error_message());
      if (more > worst) worst = more;
      if (more > kTrueSlackKib) fail_msg("%s takes %ld KiB more", name_of(job), more);
    }
  }
  printf("FIGURE memory limit: the process takes at most %ld KiB more than it\n", worst);
  small = kept;
  jalon_cloud_release(large);
}

static int begin(void** state) {
  const int status = make_scene(state);
  small = street_cloud(kOperationPoints, 12);
  file_count = all_jobs(files);
  return status;
}
static int end(void** state) {
  jalon_cloud_release(small);
  return drop_scene(state);
}

int main(void) {
  if (!is_memory_counted()) return 77;
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(memory_limit__below_what_a_call_needs_is_refused_in_words),
      cmocka_unit_test(memory_limit__refuses_what_can_be_foretold_before_it_is_taken),
      cmocka_unit_test(memory_limit__is_kept_by_the_process)};
  return cmocka_run_group_tests(tests, begin, end);
}
