/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Whether tasks count memory in this build; where not, says so for a test that is skipped. Behind support.h. */
#ifndef JALON_TEST_MEMORY_COUNTED_H
#define JALON_TEST_MEMORY_COUNTED_H

static inline int is_memory_counted(void) {
  jalon_task* probe = NULL;
  MUST(jalon_task_create(&probe));
  const jalon_status status = jalon_task_set_memory_limit(probe, 1);
  jalon_task_release(probe);
  if (status == JALON_ERROR_UNSUPPORTED) printf("skipped: %s\n", jalon_last_error_message());
  return status == JALON_OK;
}

#endif
