/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What is done to the bytes of every kind of object: brought back, cut, damaged, damaged and sealed anew. */
#ifndef JALON_TEST_BYTES_SUPPORT_H
#define JALON_TEST_BYTES_SUPPORT_H

#include "support.h"

enum { kBytesHeader = 32, kBytesMiB = 1 << 20 };

/* A kind of object; handles as void*, since the calls are alike. */
typedef struct object_kind {
  const char* name;
  void* (*make)(void);
  jalon_status (*write)(void* object, jalon_bytes** out);
  jalon_status (*read)(const uint8_t* bytes, uint64_t count, void** out);
  void (*look)(void* object); /* at all there is; NULL: nothing beside writing it again */
  void (*release)(void* object);
} object_kind;

#define KIND_CALLS(noun, to_arguments, from_arguments)                                         \
  static jalon_status noun##_write(void* object, jalon_bytes** out) {                          \
    return jalon_##noun##_to_bytes(object to_arguments, out);                                  \
  }                                                                                            \
  static jalon_status noun##_read(const uint8_t* bytes, uint64_t count, void** out) {          \
    jalon_##noun* made = NULL;                                                                 \
    const jalon_status status = jalon_##noun##_from_bytes(bytes, count from_arguments, &made); \
    *out = made;                                                                               \
    return status;                                                                             \
  }                                                                                            \
  static void noun##_release(void* object) { jalon_##noun##_release(object); }
#define NO_TASK
#define NULL_TASK , NULL

/* The object's bytes as memory of the caller's. */
static inline uint8_t* bytes_of(const object_kind* kind, void* object, size_t* count) {
  jalon_bytes* written = NULL;
  jalon_array_view view;
  MUST(kind->write(object, &written));
  MUST(jalon_bytes_view(written, &view));
  assert_int_equal(view.type, JALON_UINT8);
  assert_true(view.components == 1 && view.stride_bytes == 1);
  uint8_t* copy = malloc((size_t)view.count);
  assert_non_null(copy);
  memcpy(copy, view.data, (size_t)view.count);
  *count = (size_t)view.count;
  jalon_bytes_release(written);
  return copy;
}

/* CRC-32 of ISO 3309, bit by bit. */
static inline uint32_t crc_of(uint32_t crc, const uint8_t* bytes, size_t count) {
  crc = ~crc;
  for (size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

static inline void put_little(uint8_t* at, uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) at[i] = (uint8_t)(value >> 8 * i);
}

/* Length and checksum as jalon/bytes.h tells them, whatever stands between. */
static inline void seal_anew(uint8_t* bytes, size_t count) {
  put_little(bytes + 16, count - kBytesHeader, 8);
  uint32_t sum = crc_of(0, bytes, 24);
  for (size_t at = kBytesHeader; at < count; at += kBytesMiB) {
    const size_t left = count - at;
    uint8_t part[4];
    put_little(part, crc_of(0, bytes + at, left < kBytesMiB ? left : kBytesMiB), 4);
    sum = crc_of(sum, part, 4);
  }
  put_little(bytes + 24, sum, 4);
}

static inline void refused_bytes(const object_kind* kind, const uint8_t* bytes, size_t count,
                                 jalon_status expected, const char* what, uint64_t where) {
  void* made = NULL;
  const jalon_status status = kind->read(bytes, count, &made);
  if (status != expected)
    fail_msg("%s, %s %llu: \"%s\", not \"%s\" (%s)", kind->name, what, (unsigned long long)where,
             jalon_status_name(status), jalon_status_name(expected), jalon_last_error_message());
  assert_null(made);
  expect_one_line();
}

/* Written, read and written again it is the same. */
static inline void comes_back(const object_kind* kind) {
  size_t count = 0, again_count = 0;
  void *object = kind->make(), *back = NULL;
  uint8_t* bytes = bytes_of(kind, object, &count);
  MUST(kind->read(bytes, count, &back));
  uint8_t* again = bytes_of(kind, back, &again_count);
  assert_int_equal(count, again_count);
  assert_memory_equal(bytes, again, count);
  if (kind->look != NULL) kind->look(back);
  free(again);
  free(bytes);
  kind->release(back);
  kind->release(object);
}

/* Cut anywhere, or with bytes behind the end, they are refused; so they are with any bit turned. */
static inline void damage_is_told(const object_kind* kind) {
  size_t count = 0;
  void* object = kind->make();
  uint8_t* bytes = bytes_of(kind, object, &count);
  const size_t step =
      1 + count / 1000; /* behind the first 2000, where the counts of small objects stand */
  for (size_t cut = 0; cut < count; cut += cut < 2000 ? 1 : step) {
    uint8_t* part = malloc(cut + 1); /* so that a sanitizer sees the end */
    memcpy(part, bytes, cut);
    refused_bytes(kind, part, cut, JALON_ERROR_FORMAT, "cut at byte", cut);
    free(part);
  }
  uint8_t* longer = malloc(count + 1);
  memcpy(longer, bytes, count);
  longer[count] = 0;
  refused_bytes(kind, longer, count + 1, JALON_ERROR_FORMAT, "longer than", count);
  free(longer);
  for (uint64_t i = 0; i < 1000; ++i) {
    const size_t bit =
        i < 8 * kBytesHeader ? (size_t)i : (size_t)(uniform(11, i) * 8 * (double)count);
    bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
    refused_bytes(kind, bytes, count, JALON_ERROR_FORMAT, "bit", bit);
    bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
  }
  free(bytes);
  kind->release(object);
}

/* Made up to look whole, they are refused or give an object that can be looked at. Gives how many were refused. */
static inline int made_up_is_survived(const object_kind* kind, uint64_t seed, int tries) {
  static const uint64_t kWild[] = {
      0, 1, UINT64_MAX, (uint64_t)1 << 63, (uint64_t)1 << 61, UINT32_MAX, (uint64_t)INT64_MAX / 24};
  size_t count = 0;
  void* object = kind->make();
  uint8_t *bytes = bytes_of(kind, object, &count), *trial = malloc(count);
  int refused = 0;
  for (int t = 0; t < tries; ++t) {
    const uint64_t draw = seed * 1000003 + (uint64_t)t;
    size_t length = count;
    memcpy(trial, bytes, count);
    const int changes = 1 + (int)(3 * uniform(draw, 0));
    for (int c = 0; c < changes; ++c) {
      const uint64_t k = 10 * (uint64_t)(c + 1);
      const size_t payload = count - kBytesHeader;
      size_t at = kBytesHeader + (size_t)(uniform(draw, k) * (double)payload);
      if (uniform(draw, k + 1) < 0.5)
        at = kBytesHeader + (size_t)(uniform(draw, k) * (payload < 400 ? (double)payload : 400));
      if (uniform(draw, k + 2) < 0.4 && at + 8 <= count)
        put_little(trial + at, kWild[(size_t)(uniform(draw, k + 3) * 7)], 8);
      else trial[at] = (uint8_t)(256 * uniform(draw, k + 4));
    }
    if (uniform(draw, 1) < 0.1)
      length = kBytesHeader + (size_t)(uniform(draw, 2) * (double)(count - kBytesHeader));
    seal_anew(trial, length);
    uint8_t* exact = malloc(length);
    memcpy(exact, trial, length);
    void* made = NULL;
    const jalon_status status = kind->read(exact, length, &made);
    if (status == JALON_OK) {
      size_t again = 0;
      free(bytes_of(kind, made, &again));
      if (kind->look != NULL) kind->look(made);
      kind->release(made);
    } else {
      if (status != JALON_ERROR_FORMAT)
        fail_msg("%s, try %d: %s: %s", kind->name, t, jalon_status_name(status),
                 jalon_last_error_message());
      expect_one_line();
      ++refused;
    }
    free(exact);
  }
  free(trial);
  free(bytes);
  kind->release(object);
  return refused;
}

/* Of a later release, of another kind, and no bytes at all. */
static inline void strangers_are_told(const object_kind* kind, const object_kind* other) {
  size_t count = 0;
  void* object = kind->make();
  uint8_t* bytes = bytes_of(kind, object, &count);
  refused_bytes(other, bytes, count, JALON_ERROR_INVALID_ARGUMENT, "as another kind than", 0);
  put_little(bytes + 8, 2, 4);
  seal_anew(bytes, count);
  refused_bytes(kind, bytes, count, JALON_ERROR_UNSUPPORTED, "layout", 2);
  assert_non_null(strstr(jalon_last_error_message(), "layout 2"));
  put_little(bytes + 8, 0, 4);
  seal_anew(bytes, count);
  refused_bytes(kind, bytes, count, JALON_ERROR_FORMAT, "layout", 0);
  refused_bytes(kind, (const uint8_t*)"a text, but of more than 32 bytes", 33, JALON_ERROR_FORMAT,
                "a text", 0);
  refused_bytes(kind, NULL, 0, JALON_ERROR_INVALID_ARGUMENT, "NULL", 0);
  refused_bytes(kind, bytes, UINT64_MAX, JALON_ERROR_INVALID_ARGUMENT, "count", UINT64_MAX);
  free(bytes);
  kind->release(object);
}

#endif
