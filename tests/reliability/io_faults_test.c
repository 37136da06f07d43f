/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Faults of the disk are ordinary errors: in a reading or writing of each format the 1st, 2nd, 3rd ... call to the
 * operating system fails once with EIO or ENOSPC, is interrupted, or transfers half. What is interrupted or short goes
 * on and gives the same bytes; what fails says so in one line, and the old file is whole, of a format of many files
 * all of them. By default at most kShallow faults a job, spread over its calls; JALON_FULL=1 takes every one. */
#include "support.h"

#include "file_jobs.h"
#include "io_faults.h"
#include "process_size.h"

#ifdef __SANITIZE_THREAD__
#define CANNOT_REPLACE_CALLS 1 /* the sanitizer has its own */
#endif

enum { kShallow = 48 };

/* ---- one fault ---- */

static const char old_text[] = "what stood here before\n";

/* A data set that is a folder of its own stands or falls as a whole. */
static int is_of_many(const io_job* job) { return strchr(job->file, '/') != NULL; }

static void put_old(const io_job* job, const folder_state* whole) {
  for (int i = 0; i < whole->count; ++i) {
    const char* const name = whole->files[i].name;
    if (!is_of_many(job) && strcmp(name, job->file) != 0) continue;
    if (is_folder_name(name)) make_folder(path_in(folder, name));
    else write_text(path_in(folder, name), old_text);
  }
}

/* The folder before a job: of a writing, the old file or none; of a reading, the whole file. */
static void put_before(const io_job* job, const folder_state* whole, int with_old) {
  clear_folder(folder);
  if (job->reads) restore_folder(folder, whole);
  else if (with_old) put_old(job, whole);
}

static jalon_status faulted(const io_job* job, enum fault fault, long at, long* met) {
  arm(fault, at);
  const jalon_status status = job->run(path_in(folder, job->file));
  disarm();
  *met = io_faults_met;
  return status;
}

/* Every file is as the undisturbed job leaves it, or as it was; nothing else lies there. */
static void expect_whole_files(const io_job* job, const folder_state* whole, int with_old,
                               jalon_status status, const char* what) {
  folder_state now;
  read_folder(folder, &now);
  for (int i = 0; i < now.count; ++i) {
    const file_state* const expected = file_of(whole, now.files[i].name);
    const int is_new = expected != NULL && same_file(expected, &now.files[i]);
    const int stood = is_of_many(job) || strcmp(now.files[i].name, job->file) == 0;
    const int is_old = with_old && stood && now.files[i].bytes == strlen(old_text) &&
                       memcmp(now.files[i].data, old_text, now.files[i].bytes) == 0;
    if (!is_new && !(is_old && status != JALON_OK))
      fail_msg("%s: %s is neither old nor whole", what, now.files[i].name);
    if (is_of_many(job) && !job->reads && status != JALON_OK && !is_old &&
        !is_folder_name(now.files[i].name))
      fail_msg("%s: %s is there though it failed", what, now.files[i].name);
  }
  const int left = job->reads || with_old ? whole->count : 0;
  if (is_of_many(job) && status != JALON_OK && now.count != left)
    fail_msg("%s: failed and left %d of %d files", what, now.count, left);
  if (status == JALON_OK && now.count != whole->count)
    fail_msg("%s: succeeded with %d of %d files", what, now.count, whole->count);
  if (with_old && file_of(&now, job->file) == NULL) fail_msg("%s: the old file is gone", what);
  free_folder(&now);
}

static void expect_ordinary(const io_job* job, const folder_state* whole, uint64_t hash,
                            enum fault fault, long at, int with_old) {
  char what[200];
  long met = 0;
  snprintf(what, sizeof what, "%s %s, call %ld, %s", job->reads ? "read" : "write", job->file, at,
           fault_names[fault]);
  put_before(job, whole, with_old);
  const int descriptors = open_descriptors();
  const jalon_status status = faulted(job, fault, at, &met);
  if (status != JALON_OK) {
    if (met == 0 || fault == kEintr || fault == kShort)
      fail_msg("%s: %s: %s", what, jalon_status_name(status), jalon_last_error_message());
    if (status != JALON_ERROR_IO && status != JALON_ERROR_NOT_FOUND)
      fail_msg("%s: gave %s: %s", what, jalon_status_name(status), jalon_last_error_message());
    expect_one_line();
  } else if (io_lost_sync) {
    fail_msg("%s: succeeded though the disk did not take the file", what);
  } else if (job->reads && read_hash != hash) {
    fail_msg("%s: succeeded with other content", what);
  }
  if (open_descriptors() != descriptors) fail_msg("%s: a descriptor stays open", what);
  expect_whole_files(job, whole, with_old, status, what);
}

/* ---- all faults of a job ---- */

static long faults_of(const io_job* job, long* calls_of_all) {
  folder_state whole;
  long met = 0, faults = 0;
  clear_folder(folder);
  if (job->reads) /* the file of the writing before it */
    MUST((job[-1].run)(path_in(folder, job->file)));
  MUST(faulted(job, kNoFault, 0, &met));
  const long calls = io_calls;
  const uint64_t hash = read_hash;
  read_folder(folder, &whole);
  const long step = is_full_run() ? 1 : (calls * (kFaults - 1) + kShallow - 1) / kShallow;
  for (long k = 0; k < calls * (kFaults - 1); k += step < 1 ? 1 : step, ++faults) {
    const enum fault fault = (enum fault)(1 + k % (kFaults - 1));
    expect_ordinary(job, &whole, hash, fault, 1 + k / (kFaults - 1), !job->reads && k % 3 != 0);
  }
  clear_folder(folder);
  if (job->reads) restore_folder(folder, &whole);
  MUST(job->run(path_in(folder, job->file))); /* as if nothing had been */
  free_folder(&whole);
  *calls_of_all += calls;
  return faults;
}

static void io__every_fault_is_an_error_or_nothing_and_leaves_whole_files(void** state) {
  (void)state;
#ifdef CANNOT_REPLACE_CALLS
  skip();
#else
  static io_job jobs[kMostJobs];
  const int n = all_jobs(jobs);
  long faults = 0, calls = 0;
  for (int j = 0; j < n; ++j) faults += faults_of(&jobs[j], &calls);
  printf("FIGURE io faults: %ld in %d jobs of %ld calls\n", faults, n, calls);
  assert_true(n >= 25);
  assert_true(faults >= 500);
#endif
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(io__every_fault_is_an_error_or_nothing_and_leaves_whole_files),
  };
  return cmocka_run_group_tests(tests, make_scene, drop_scene);
}
