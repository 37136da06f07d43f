/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* One call of each operation on each of the clouds that are hard on an index, for hostile.sh, which counts the
 * instructions within counted_call. Not a test by itself.
 *   counted_calls POINTS [OPERATION]      a name, or all; "names": prints them */
#include "../bench/hostile_operations.h"

/* Answers may be of any size: a call that wants more ends as out of memory. */
static const uint64_t kMost_bytes = (uint64_t)3 << 30;

/* In a function of its own, so that its instructions can be told from those of the rest. */
__attribute__((noinline)) jalon_status counted_call(operation run, const jalon_cloud* cloud,
                                                    jalon_task* task, made* out);
__attribute__((noinline)) jalon_status counted_call(operation run, const jalon_cloud* cloud,
                                                    jalon_task* task, made* out) {
  return run(cloud, task, out);
}

/* What is ordinary: points drawn on the faces of a box, with a millimetre of noise. A random cloud holds no surface:
 * what looks for some ends early there. */
static jalon_cloud* box_cloud(uint64_t n) {
  double* xyz = malloc((size_t)n * 24 + 24);
  if (xyz == NULL) fail_msg("no memory for %llu points", (unsigned long long)n);
  for (uint64_t i = 0; i < n; ++i) {
    double* p = xyz + 3 * i;
    draw(i, p);
    p[i % 3] = (double)(i / 3 % 2) + 0.002 * (p[i % 3] - 0.5);
  }
  jalon_cloud* cloud = cloud_of(xyz, n);
  free(xyz);
  return cloud;
}

/* Takes the cloud. */
static void count(int operation_number, const char* cloud_name, jalon_cloud* cloud) {
  jalon_task* task = NULL;
  made out = {NULL, NULL, NULL};
  make_ready(cloud, operation_number);
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 1));
  MUST(jalon_task_set_memory_limit(task, kMost_bytes));
  const operation run = operation_of(operation_number);
  const jalon_status status = counted_call(run, cloud, task, &out);
  printf("%s\t%s\t%s\t%llu\n", name_of(operation_number), cloud_name, jalon_status_name(status),
         (unsigned long long)answered_by(run, &out));
  fflush(stdout);
  release_made(&out);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

int main(int argc, char** argv) {
  const int only_names = argc > 1 && strcmp(argv[1], "names") == 0;
  const uint64_t n = argc > 1 ? (uint64_t)atof(argv[1]) : 10000;
  for (int k = 0; k < kAllCount; ++k) {
    if (only_names) printf("%s\n", name_of(k));
    if (only_names || !named(argc, argv, 2, name_of(k))) continue;
    count(k, "box", box_cloud(n));
    for (int c = 0; c < kHostileCount; ++c) count(k, kHostile[c].name, hostile_cloud(c, n));
  }
  return 0;
}
