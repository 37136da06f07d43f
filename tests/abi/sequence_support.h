/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the generated drawn_calls.c stands on: the draws, the judgement of a call, and for each kind of handle the list
 * of those that are alive. */
#ifndef SEQUENCE_SUPPORT_H
#define SEQUENCE_SUPPORT_H

#include "wild_support.h"

enum { kMostAlive = 8 };

/* A number below n, from the sequence's seed. */
uint32_t draw(uint32_t n);
/* The name is told when something goes wrong in the call or after it. */
void call_begins(const char* name, int slots);
/* sized: a bit for each slot whose start the caller wrote. */
void call_ends(jalon_status status, int slots, unsigned sized);

/* A cloud that was just made is given back where it would make each later call a long one: a map
 * of distances has millions of points. */
void drop_large_cloud(int slot_number);

/* Generated. */
void make_drawn_call(void);
void release_the_living(void);

#define LIVING(kind)                                                                      \
  static kind* alive_##kind[kMostAlive];                                                  \
  static uint32_t count_##kind;                                                           \
  __attribute__((unused)) static inline kind* drawn_##kind(kind* fixture) {               \
    return count_##kind > 0 && draw(3) != 0 ? alive_##kind[draw(count_##kind)] : fixture; \
  }                                                                                       \
  static inline void give_back_##kind(uint32_t i) {                                       \
    kind##_release(alive_##kind[i]);                                                      \
    alive_##kind[i] = alive_##kind[--count_##kind];                                       \
  }                                                                                       \
  static inline void keep_handle_##kind(kind* handle) {                                   \
    if (count_##kind == kMostAlive) give_back_##kind(draw(kMostAlive));                   \
    alive_##kind[count_##kind++] = handle;                                                \
  }                                                                                       \
  static inline void keep_##kind(int i) {                                                 \
    kind* handle;                                                                         \
    memcpy(&handle, slot(i), sizeof handle);                                              \
    if (slot_written(i, sizeof handle) && handle != NULL) keep_handle_##kind(handle);     \
  }                                                                                       \
  static inline void retain_or_release_##kind(void) {                                     \
    if (count_##kind == 0) return;                                                        \
    const uint32_t i = draw(count_##kind);                                                \
    if (draw(2) != 0) give_back_##kind(i);                                                \
    else keep_handle_##kind(kind##_retain(alive_##kind[i]));                              \
  }                                                                                       \
  static inline void release_all_##kind(void) {                                           \
    while (count_##kind > 0) give_back_##kind(count_##kind - 1);                          \
  }

#endif
