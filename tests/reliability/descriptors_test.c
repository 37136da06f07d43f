/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What fails to open, read or write leaves no descriptor behind, and what is open is not handed to other programs. */
#include "folder_state.h"
#include "process_size.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>

enum { kTurns = 1000 };

static char folder[300];

static void refuse_all(const jalon_cloud* cloud, const char* const* names, int count, int turn) {
  jalon_cloud* read = NULL;
  jalon_model* model = NULL;
  const char* const name = names[turn % count];
  if (jalon_cloud_read(path_in(folder, name), NULL, NULL, &read) == JALON_OK)
    fail_msg("%s was read", name);
  if (jalon_model_read(path_in(folder, "broken.obj"), NULL, NULL, &model) == JALON_OK)
    fail_msg("broken.obj was read");
  if (jalon_cloud_read(path_in(folder, "none.las"), NULL, NULL, &read) == JALON_OK ||
      jalon_cloud_write(cloud, path_in(folder, "none/cloud.las"), NULL, NULL) == JALON_OK ||
      jalon_cloud_write(cloud, folder, NULL, NULL) == JALON_OK)
    fail_msg("what cannot be opened was");
}

/* Files that cannot become as large as they must: what fails is open already. */
static void refuse_to_grow(const jalon_cloud* cloud) {
  static const char* const names[] = {"c.las", "c.laz", "c.e57", "c.ply", "c.xyz", "c.pcd"};
  struct rlimit usual, small;
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
  small = usual;
  small.rlim_cur = 16;
  void (*const before)(int) = signal(SIGXFSZ, SIG_IGN);
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
    if (jalon_cloud_write(cloud, path_in(folder, names[i]), NULL, NULL) != JALON_ERROR_IO) {
      setrlimit(RLIMIT_FSIZE, &usual);
      fail_msg("%s was written", names[i]);
    }
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
  signal(SIGXFSZ, before);
}

static void descriptors__of_three_thousand_failures_are_closed(void** state) {
  (void)state;
  static const char* const names[] = {"broken.las", "broken.laz", "broken.e57", "broken.ply",
                                      "broken.pcd", "broken.ptx", "broken.pts", "broken.xyz"};
  const int count = sizeof names / sizeof *names;
  jalon_cloud* const cloud = street_cloud(100, 1);
  for (int i = 0; i < count; ++i) write_text(path_in(folder, names[i]), "not this kind of file\n");
  write_text(path_in(folder, "broken.obj"), "f 1 2 3\n");
  refuse_all(cloud, names, count, 0);
  const int before = open_descriptors();
  for (int i = 0; i < kTurns; ++i) refuse_all(cloud, names, count, i);
  refuse_to_grow(cloud);
  assert_int_equal(open_descriptors(), before);
  jalon_cloud_release(cloud);
}

/* Looks at the descriptors of the folder's files while another thread has them open. */
static int unmarked, seen, is_over;
static void look_at_descriptors(void) {
  for (int k = 3; k < 64; ++k) {
    char link[64], target[300];
    snprintf(link, sizeof link, "/proc/self/fd/%d", k);
    const ssize_t n = readlink(link, target, sizeof target - 1);
    if (n <= 0 || strncmp(target, folder, strlen(folder)) != 0) continue;
    const int flags = fcntl(k, F_GETFD);
    if (flags < 0) continue; /* closed meanwhile */
    ++seen;
    if (!(flags & FD_CLOEXEC)) ++unmarked;
  }
}
static void* keep_looking(void* unused) {
  while (!__atomic_load_n(&is_over, __ATOMIC_ACQUIRE)) look_at_descriptors();
  return unused;
}

static void descriptors__of_open_files_are_not_inherited(void** state) {
  (void)state;
  static const char* const names[] = {"c.las", "c.laz", "c.e57", "c.ply", "c.xyz", "c.pcd"};
  enum { kTurnsOfFiles = 5 };
  jalon_cloud* const cloud = street_cloud(20000, 2);
  pthread_t watcher;
  unmarked = seen = is_over = 0;
  assert_int_equal(pthread_create(&watcher, NULL, keep_looking, NULL), 0);
  for (size_t i = 0; i < kTurnsOfFiles * (sizeof names / sizeof *names); ++i) {
    const char* const name = names[i % (sizeof names / sizeof *names)];
    jalon_cloud* back = NULL;
    MUST(jalon_cloud_write(cloud, path_in(folder, name), NULL, NULL));
    MUST(jalon_cloud_read(path_in(folder, name), NULL, NULL, &back));
    jalon_cloud_release(back);
  }
  __atomic_store_n(&is_over, 1, __ATOMIC_RELEASE);
  pthread_join(watcher, NULL);
  jalon_cloud_release(cloud);
  printf("FIGURE descriptors: open files looked at %d times\n", seen);
  assert_true(seen > 0);
  assert_int_equal(unmarked, 0);
}

static int make_own_folder(void** state) {
  (void)state;
  snprintf(folder, sizeof folder, "%s", temporary("descriptors"));
  make_folder(folder);
  return 0;
}
static int drop_own_folder(void** state) {
  (void)state;
  clear_folder(folder);
  return rmdir(folder);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(descriptors__of_three_thousand_failures_are_closed),
      cmocka_unit_test(descriptors__of_open_files_are_not_inherited),
  };
  return cmocka_run_group_tests(tests, make_own_folder, drop_own_folder);
}
