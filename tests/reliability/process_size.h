/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What a process takes, by the files of /proc: included behind CMocka. */
#ifndef JALON_TEST_PROCESS_SIZE_H
#define JALON_TEST_PROCESS_SIZE_H

#include <dirent.h>
#include <malloc.h>
#include <stdio.h>
#include <unistd.h>

enum { kMostGrowthKib = 1024 }; /* of a process that does the same again and again */

/* Entries of a folder, "." and ".." among them; 0 where there is none. */
static inline int entries_of(const char* folder) {
  int n = 0;
  DIR* const all = opendir(folder);
  while (all != NULL && readdir(all) != NULL) ++n;
  if (all != NULL) closedir(all);
  return n;
}
static inline int open_descriptors(void) { return entries_of("/proc/self/fd"); }

static inline long resident_kib(void) {
  long pages = 0, resident = 0;
  FILE* const f = fopen("/proc/self/statm", "r");
  if (f == NULL || fscanf(f, "%ld %ld", &pages, &resident) != 2) fail_msg("no memory figures");
  fclose(f);
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

/* What was asked of malloc and not given back: it tells a handle that is kept, which is far below a page. 0 where the
 * C library does not say, or a sanitizer has an allocator of its own. */
static inline long allocated_bytes(void) {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 all = mallinfo2();
  return (long)(all.uordblks + all.hblkhd);
#else
  return 0;
#endif
}

#endif
