/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#ifndef JALON_FUZZ_SEEDS_H
#define JALON_FUZZ_SEEDS_H

#include <stddef.h>

/* A seed of a target; first: a byte before it, none where it is negative. */
void put(const char* target, const char* name, int first, const void* data, size_t bytes);
/* Each word on a line of its own. */
void put_lines(const char* target, const char* name, const char* words, size_t bytes);

void write_seed_texts(void);

#endif
