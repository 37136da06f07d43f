/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Small files whose headers tell counts that they cannot hold, made of good ones. */
#ifndef JALON_TEST_LYING_FILES_H
#define JALON_TEST_LYING_FILES_H

#include "support.h"

typedef struct {
  char* bytes;
  size_t count;
} content;

static inline content good_file(const char* path, uint64_t points) {
  content c = {NULL, 0};
  double xyz[60];
  for (int i = 0; i < 60; ++i) xyz[i] = 0.5 * i;
  jalon_cloud* cloud = cloud_of(xyz, points);
  const jalon_status status = jalon_cloud_write(cloud, path, NULL, NULL);
  jalon_cloud_release(cloud);
  if (status == JALON_OK) c.bytes = content_of(path, &c.count);
  return c;
}

static inline void write_file(const char* path, const char* bytes, size_t count) {
  FILE* file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, count, file), count);
  fclose(file);
}

/* Little-endian, as all headers here. */
static inline void put_number(content c, size_t at, uint64_t value, size_t bytes) {
  assert_true(at + bytes <= c.count);
  for (size_t i = 0; i < bytes; ++i) c.bytes[at + i] = (char)(value >> (8 * i) & 255);
}
static inline uint64_t number_at(content c, size_t at, size_t bytes) {
  uint64_t value = 0;
  assert_true(at + bytes <= c.count);
  for (size_t i = 0; i < bytes; ++i) value |= (uint64_t)(unsigned char)c.bytes[at + i] << (8 * i);
  return value;
}

/* The file with the text behind the first `key` up to `end` replaced. */
static inline content with_text(content c, const char* key, char end, const char* text) {
  const size_t length = strlen(key), more = strlen(text);
  content out = {NULL, 0};
  for (size_t at = 0; at + length <= c.count; ++at) {
    if (memcmp(c.bytes + at, key, length) != 0) continue;
    size_t from = at + length, to = from;
    while (to < c.count && c.bytes[to] != end) ++to;
    out.bytes = malloc(c.count + more + 1);
    assert_non_null(out.bytes);
    memcpy(out.bytes, c.bytes, from);
    memcpy(out.bytes + from, text, more);
    memcpy(out.bytes + from + more, c.bytes + to, c.count - to);
    out.count = c.count - (to - from) + more;
    return out;
  }
  fail_msg("no \"%s\" in the file", key);
  return out;
}

/* E57 (ASTM E2807): pages of 1 024 bytes, the last four of each a CRC-32C of the others, big-endian; without them
 * the text of the file is where its header tells. */
enum { kE57Page = 1024, kE57Held = 1020 };
static inline uint32_t crc32c(const char* bytes, size_t count) {
  uint32_t crc = UINT32_MAX;
  for (size_t i = 0; i < count; ++i) {
    crc ^= (unsigned char)bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82F63B78u : 0);
  }
  return ~crc;
}
static inline content without_checksums(content c) {
  content out = {malloc(c.count), 0};
  for (size_t at = 0; at + kE57Page <= c.count; at += kE57Page, out.count += kE57Held)
    memcpy(out.bytes + out.count, c.bytes + at, kE57Held);
  return out;
}
static inline content with_checksums(content c) {
  const size_t pages = (c.count + kE57Held - 1) / kE57Held;
  content out = {calloc(pages, kE57Page), pages * kE57Page};
  for (size_t page = 0; page < pages; ++page) {
    char* to = out.bytes + page * kE57Page;
    const size_t from = page * kE57Held, rest = c.count - from;
    memcpy(to, c.bytes + from, rest < kE57Held ? rest : kE57Held);
    if (page == 0) put_number(out, 16, pages * kE57Page, 8); /* length of the file */
    const uint32_t crc = crc32c(to, kE57Held);
    for (int i = 0; i < 4; ++i) to[kE57Held + i] = (char)(crc >> (24 - 8 * i) & 255);
  }
  return out;
}
/* The XML is the end of the file, so it may grow. */
static inline content with_xml(content file, const char* key, const char* text) {
  content plain = without_checksums(file);
  const size_t xml = (size_t)number_at(plain, 24, 8), length = (size_t)number_at(plain, 32, 8);
  plain.count = xml - 4 * (xml / kE57Page) + length; /* less what fills the last page */
  content changed = with_text(plain, key, '"', text);
  put_number(changed, 32, length + changed.count - plain.count, 8);
  content out = with_checksums(changed);
  free(plain.bytes), free(changed.bytes);
  return out;
}

#endif
