/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What fails to open, read or write leaves no descriptor behind, and what is open is not handed to other programs. */
#include "folder_state.h"

#include <errno.h>
#include <fcntl.h>

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
  assert_int_equal(open_descriptors(), before);
  jalon_cloud_release(cloud);
}

/* Every descriptor above the standard ones is marked; called while a file is read. */
static int unmarked, seen;
static int32_t look_at_descriptors(double done, const char* step, void* user) {
  (void)user, (void)done, (void)step;
  for (int k = 3; k < 64; ++k) {
    char link[64], target[300];
    snprintf(link, sizeof link, "/proc/self/fd/%d", k);
    const ssize_t n = readlink(link, target, sizeof target - 1);
    if (n <= 0 || strncmp(target, folder, strlen(folder)) != 0) continue;
    ++seen;
    const int flags = fcntl(k, F_GETFD);
    if (flags >= 0 && !(flags & FD_CLOEXEC)) ++unmarked;
  }
  return 0;
}

static void descriptors__of_open_files_are_not_inherited(void** state) {
  (void)state;
  static const char* const names[] = {"c.las", "c.laz", "c.e57", "c.ply", "c.xyz", "c.pcd"};
  jalon_cloud* const cloud = street_cloud(200000, 2);
  jalon_task* task = NULL;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_progress(task, look_at_descriptors, NULL));
  unmarked = seen = 0;
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
    jalon_cloud* back = NULL;
    MUST(jalon_cloud_write(cloud, path_in(folder, names[i]), NULL, task));
    MUST(jalon_cloud_read(path_in(folder, names[i]), NULL, task, &back));
    jalon_cloud_release(back);
  }
  jalon_task_release(task);
  jalon_cloud_release(cloud);
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
