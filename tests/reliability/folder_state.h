/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* All files of a folder with their bytes, and the folders in it: names that end with "/", before what they hold. */
#ifndef JALON_TEST_FOLDER_STATE_H
#define JALON_TEST_FOLDER_STATE_H

#include "support.h"

#include <dirent.h>
#include <sys/stat.h>

enum { kMostFiles = 16 };

typedef struct file_state {
  char name[256];
  char* data;
  size_t bytes;
} file_state;

typedef struct folder_state {
  file_state files[kMostFiles];
  int count;
} folder_state;

static inline const char* path_in(const char* folder, const char* name) {
  static char path[4][600];
  static int turn;
  turn = (turn + 1) % 4;
  snprintf(path[turn], sizeof path[turn], "%.300s/%.256s", folder, name);
  return path[turn];
}

static inline void make_folder(const char* folder) { assert_true(mkdir(folder, 0700) == 0); }

static inline int is_folder_name(const char* name) {
  return name[0] != 0 && name[strlen(name) - 1] == '/';
}

static inline void read_inside(const char* folder, const char* inside, folder_state* out) {
  DIR* const all = opendir(path_in(folder, inside));
  assert_non_null(all);
  for (const struct dirent* e; (e = readdir(all)) != NULL;) {
    if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0) continue;
    assert_true(out->count < kMostFiles);
    file_state* const file = &out->files[out->count++];
    struct stat state;
    char name[256];
    snprintf(name, sizeof name, "%.120s%.120s", inside, e->d_name);
    memcpy(file->name, name, sizeof name);
    assert_int_equal(lstat(path_in(folder, file->name), &state), 0);
    if (S_ISDIR(state.st_mode)) {
      strcat(file->name, "/");
      file->bytes = 0;
      file->data = calloc(1, 1);
      read_inside(folder, strcat(name, "/"), out);
    } else {
      file->data = content_of(path_in(folder, file->name), &file->bytes);
    }
    assert_non_null(file->data);
  }
  closedir(all);
}

static inline void read_folder(const char* folder, folder_state* out) {
  out->count = 0;
  read_inside(folder, "", out);
}

static inline void free_folder(folder_state* state) {
  for (int i = 0; i < state->count; ++i) free(state->files[i].data);
  state->count = 0;
}

static inline void clear_folder(const char* folder) {
  folder_state state;
  read_folder(folder, &state);
  for (int i = state.count; i-- > 0;) remove(path_in(folder, state.files[i].name));
  free_folder(&state);
}

static inline void restore_folder(const char* folder, const folder_state* state) {
  for (int i = 0; i < state->count; ++i) {
    if (is_folder_name(state->files[i].name)) {
      make_folder(path_in(folder, state->files[i].name));
      continue;
    }
    FILE* const f = fopen(path_in(folder, state->files[i].name), "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(state->files[i].data, 1, state->files[i].bytes, f),
                     state->files[i].bytes);
    fclose(f);
  }
}

static inline const file_state* file_of(const folder_state* state, const char* name) {
  for (int i = 0; i < state->count; ++i)
    if (strcmp(state->files[i].name, name) == 0) return &state->files[i];
  return NULL;
}

static inline int same_file(const file_state* a, const file_state* b) {
  return a->bytes == b->bytes && memcmp(a->data, b->data, a->bytes) == 0;
}

#endif
