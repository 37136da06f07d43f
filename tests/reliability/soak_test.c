/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Eight hours of a host, counted in jobs and not by the clock: drawn jobs of the whole surface on clouds of drawn
 * sizes, with drawn numbers of threads, some of them cancelled, some refused. The process stays as large as it was,
 * and no call says what it should not. */
#include "allocation_scenarios.h"

#include "operations.h"
#include "process_size.h"
#include "small_input.h"

enum {
  kHours = 8,
  kJobs = 60,
  kLongJobs = 25000,
  kSanitizedJobs = 12,
  kLeastCalls = 5 /* of a job */,
  kSizes = 4,
  kMostMib = 8
};

static int jobs_an_hour(void) {
  return is_full_run() ? kLongJobs : is_sanitized() ? kSanitizedJobs : kJobs;
}

static uint64_t drawn(uint64_t* at, uint64_t below) {
  return (uint64_t)(uniform(99, (*at)++) * (double)below);
}

static jalon_cloud* clouds[kSizes];
static const uint64_t sizes[kSizes] = {3, 40, 300, 900};

static jalon_status
    usual[kOperationCount]
         [kSizes]; /* what an operation says of a cloud, the first time and ever after */

static void run_operation(uint64_t* at, jalon_task* task) {
  const uint64_t i = drawn(at, kOperationCount), size = drawn(at, kSizes);
  const int cancelled = drawn(at, 10) == 0;
  made out = {NULL, NULL, NULL};
  MUST(jalon_task_set_threads(task, 1 + (uint32_t)drawn(at, 3)));
  if (cancelled) MUST(jalon_task_cancel(task));
  const jalon_status status = kOperations[i].run(clouds[size], task, &out);
  if (status != usual[i][size] && !(cancelled && status == JALON_ERROR_CANCELLED))
    fail_msg("%s of %d points: %s", kOperations[i].name, (int)sizes[size],
             jalon_last_error_message());
  MUST(jalon_task_reset(task));
  release_made(&out);
}

static void run_scenario(uint64_t* at) {
  const uint64_t job = drawn(at, kScenarioCount);
  if (kScenarios[job].run() != JALON_OK)
    fail_msg("%s: %s", kScenarios[job].name, jalon_last_error_message());
}

static void run_refused(uint64_t* at) {
  static const char* const wrong[] = {"{\"min_points\": -1}", "{\"nothing\": 1}", "[",
                                      "{\"probability\": 2}"};
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  jalon_cloud* cloud = NULL;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  if (jalon_params_from_json(params, wrong[drawn(at, 4)]) == JALON_OK)
    fail_msg("wrong parameters were taken");
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_read("/no/such/file.las", NULL, NULL, &cloud));
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

static void soak__eight_hours_of_drawn_jobs_keep_no_memory(void** state) {
  (void)state;
  uint64_t at = 0, results = 0;
  long resident[kHours], allocated[kHours];
  jalon_task* task = NULL;
  MUST(jalon_task_create(&task));
  for (int i = 0; i < kSizes; ++i) clouds[i] = street_cloud(sizes[i], 21);
  for (uint64_t i = 0; i < kOperationCount * kSizes; ++i) {
    made out = {NULL, NULL, NULL};
    const jalon_status status = kOperations[i / kSizes].run(clouds[i % kSizes], task, &out);
    assert_true(status != JALON_ERROR_INTERNAL && status != JALON_ERROR_OUT_OF_MEMORY);
    usual[i / kSizes][i % kSizes] = status;
    results += status == JALON_OK;
    release_made(&out);
  }
  assert_true(results > kOperationCount * kSizes / 2);
  for (int job = 0; job < kScenarioCount; ++job) MUST(kScenarios[job].run());
  for (int hour = 0; hour < kHours; ++hour) {
    for (int job = 0; job < jobs_an_hour(); ++job) {
      const uint64_t kind = drawn(&at, 8);
      if (kind == 0) run_refused(&at);
      else if (kind < 3) run_scenario(&at);
      else run_operation(&at, task);
    }
    forget_both_ways();
    resident[hour] = resident_kib();
    allocated[hour] = allocated_bytes();
  }
  long most = 0;
  for (int hour = 1; hour < kHours; ++hour)
    most = resident[hour] - resident[0] > most ? resident[hour] - resident[0] : most;
  const long slope = (resident[kHours - 1] - resident[1]) / (kHours - 2);
  printf(
      "FIGURE soak: %d hours of %d jobs, %d calls at least, at most %ld KiB above the first hour, "
      "%ld KiB an hour; %ld bytes more allocated\n",
      (int)kHours, jobs_an_hour(), kHours * jobs_an_hour() * kLeastCalls, most, slope,
      allocated[kHours - 1] - allocated[0]);
  for (int i = 0; i < kSizes; ++i) jalon_cloud_release(clouds[i]);
  jalon_task_release(task);
  if (is_sanitized()) return;
  assert_true(most <= kMostMib * 1024);
  assert_true(slope < 1024);
}

static int make_input(void** state) {
  (void)state;
  return make_small_input("soak");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(soak__eight_hours_of_drawn_jobs_keep_no_memory),
  };
  return cmocka_run_group_tests_name("soak", tests, make_input, drop_input);
}
