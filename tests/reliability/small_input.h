/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the small jobs of allocation_scenarios.h work on: points, a task, a folder of their own. */
#ifndef JALON_TEST_SMALL_INPUT_H
#define JALON_TEST_SMALL_INPUT_H

#include "allocation_scenarios.h"

#include "folder_state.h"

static inline int make_small_input(const char* name) {
  snprintf(small_folder, sizeof small_folder, "%s", temporary(name));
  make_folder(small_folder);
  street_points(small_xyz, kSmall, 12, 0, 0);
  MUST(jalon_task_create(&small_task));
  return 0;
}
static inline int drop_input(void** state) {
  (void)state;
  jalon_task_release(small_task);
  return rmdir(small_folder);
}

#endif
