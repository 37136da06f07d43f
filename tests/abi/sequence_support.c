/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Sequences of drawn calls: sequences [FIRST_SEED COUNT]. Each runs in a child process of its own on fresh fixtures, so
 * that a crash names its seed and every seed does the same each time. No crash, no hang; a failure is one line and
 * leaves its outputs alone. */
#include "sequence_support.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum { kMostCalls = 40, kMostPoints = 20000, kSeconds = 120 };

static uint64_t state;
static struct shared_note {
  char call[100], why[300];
  long calls;
} * note;

uint32_t draw(uint32_t n) {
  state += 0x9E3779B97F4A7C15u;
  uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return (uint32_t)(((z ^ (z >> 31)) >> 32) * n >> 32);
}

static void give_up(const char* why) {
  snprintf(note->why, sizeof note->why, "%s", why);
  _exit(1);
}

void call_begins(const char* name, int slots) {
  snprintf(note->call, sizeof note->call, "%s", name);
  ++note->calls;
  for (int i = 0; i < slots; ++i) memset(slot(i), kPoison, kSlotBytes);
}

void call_ends(jalon_status status, int slots, unsigned sized) {
  if (status == JALON_OK) return;
  const char* const line = jalon_last_error_message();
  if (status == JALON_ERROR_INTERNAL) give_up(line);
  if (line[0] == 0) give_up("a failure says nothing");
  for (const char* c = line; *c != 0; ++c)
    if ((unsigned char)*c < 0x20) give_up("a failure has more than one line");
  for (int i = 0; i < slots; ++i)
    if ((sized >> i & 1) == 0 && slot_written(i, kSlotBytes)) give_up("a failure wrote an output");
}

void drop_large_cloud(int slot_number) {
  jalon_cloud* cloud = NULL;
  uint64_t points = 0;
  if (!slot_written(slot_number, sizeof cloud)) return;
  memcpy(&cloud, slot(slot_number), sizeof cloud);
  if (cloud == NULL || jalon_cloud_count(cloud, &points) != JALON_OK || points <= kMostPoints)
    return;
  jalon_cloud_release(cloud);
  memset(slot(slot_number), kPoison, sizeof cloud);
}

static void run_sequence(uint64_t seed) {
  alarm(kSeconds);
  state = seed * 0xD1B54A32D192ED03u;
  const uint32_t calls = 1 + draw(kMostCalls);
  for (uint32_t i = 0; i < calls; ++i) make_drawn_call();
  release_the_living();
  _exit(0);
}

/* Whether the sequence ended as it should. */
static int is_good(uint64_t seed) {
  note->call[0] = note->why[0] = 0;
  fflush(NULL);
  const pid_t child = fork();
  if (child == 0) run_sequence(seed);
  int ended = 0;
  if (child < 0 || waitpid(child, &ended, 0) != child) return 0;
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0) return 1;
  printf("not ok - sequence %llu: %s: %s%d %s\n", (unsigned long long)seed, note->call,
         WIFSIGNALED(ended) ? "signal " : "exit ",
         WIFSIGNALED(ended) ? WTERMSIG(ended) : WEXITSTATUS(ended), note->why);
  return 0;
}

/* How many each run makes, the long one, and either under a sanitizer. */
static uint64_t usual_count(void) {
  const int is_long = getenv("JALON_FULL") != NULL;
  if (getenv("JALON_SANITIZED") != NULL) return is_long ? 20000 : 300;
  return is_long ? 200000 : 200;
}

int main(int count, char** arguments) {
  const uint64_t first = count > 2 ? strtoull(arguments[1], NULL, 10) : 1;
  const uint64_t sequences = count > 2 ? strtoull(arguments[2], NULL, 10) : usual_count();
  uint64_t failed = 0;
  note = mmap(NULL, sizeof *note, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (note == MAP_FAILED) return 1;
  fx_begin();
  for (uint64_t seed = first; seed < first + sequences; ++seed) failed += !is_good(seed);
  fx_end();
  printf("FIGURE sequences: %llu of %ld calls, %llu bad\n", (unsigned long long)sequences,
         note->calls, (unsigned long long)failed);
  printf("%d passed, %d failed, 0 skipped\n", failed == 0, failed != 0);
  return failed == 0 ? 0 : 1;
}
