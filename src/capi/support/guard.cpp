// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/guard.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

#include "base/whole_utf8.h"
#include "capi/support/operations.h"

namespace jalon::capi {

namespace {

constexpr size_t kMessageBytes = 1024;
thread_local char last_message[kMessageBytes] = "";

static_assert(static_cast<int32_t>(Status::kInvalidArgument) == JALON_ERROR_INVALID_ARGUMENT);
static_assert(static_cast<int32_t>(Status::kOutOfMemory) == JALON_ERROR_OUT_OF_MEMORY);
static_assert(static_cast<int32_t>(Status::kCancelled) == JALON_ERROR_CANCELLED);
static_assert(static_cast<int32_t>(Status::kNotFound) == JALON_ERROR_NOT_FOUND);
static_assert(static_cast<int32_t>(Status::kInsufficientData) == JALON_ERROR_INSUFFICIENT_DATA);
static_assert(static_cast<int32_t>(Status::kDegenerate) == JALON_ERROR_DEGENERATE);
static_assert(static_cast<int32_t>(Status::kIo) == JALON_ERROR_IO);
static_assert(static_cast<int32_t>(Status::kFormat) == JALON_ERROR_FORMAT);
static_assert(static_cast<int32_t>(Status::kUnsupported) == JALON_ERROR_UNSUPPORTED);
static_assert(static_cast<int32_t>(Status::kCallback) == JALON_ERROR_CALLBACK);
static_assert(static_cast<int32_t>(Status::kBusy) == JALON_ERROR_BUSY);
static_assert(static_cast<int32_t>(Status::kLimit) == JALON_ERROR_LIMIT);
static_assert(static_cast<int32_t>(Status::kInternal) == JALON_ERROR_INTERNAL);
static_assert(static_cast<int32_t>(ElementType::kInt8) == JALON_INT8);
static_assert(static_cast<int32_t>(ElementType::kUint64) == JALON_UINT64);
static_assert(static_cast<int32_t>(ElementType::kFloat32) == JALON_FLOAT32);
static_assert(static_cast<int32_t>(ElementType::kFloat64) == JALON_FLOAT64);
static_assert(element_type_of<float>() == ElementType::kFloat32 &&
              element_type_of<uint8_t>() == ElementType::kUint8);
static_assert(element_type_of<int64_t>() == ElementType::kInt64 &&
              element_type_of<uint32_t>() == ElementType::kUint32);

}  // namespace

const char* last_error_text() noexcept { return last_message; }

jalon_status remember(Status status, const char* text) noexcept {
  const size_t n = copy_whole_utf8(text, last_message, kMessageBytes - 1);
  last_message[n] = 0;
  for (size_t i = 0; i < n; ++i)  // one line, whatever a file name holds
    if (static_cast<unsigned char>(last_message[i]) < 0x20) last_message[i] = ' ';
  return static_cast<jalon_status>(status);
}

jalon_status remember_current() noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return remember(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    return remember(Status::kOutOfMemory, "out of memory");
  } catch (const std::length_error&) {
    return remember(Status::kOutOfMemory, "out of memory: more elements than an array can hold");
  } catch (const std::exception& error) {
    char text[kMessageBytes + kMostUtf8Bytes];
    std::snprintf(text, sizeof text, "internal error: %s", error.what());
    return remember(Status::kInternal, text);
  } catch (...) {
    return remember(Status::kInternal, "internal error of an unknown kind");
  }
}

size_t require_array(const void* data, int32_t type, uint64_t count, uint32_t components,
                     uint64_t stride_bytes, const char* name) {
  const uint64_t element = size_of(require_type(type));
  const uint64_t item = element * components;
  if (stride_bytes == 0) stride_bytes = item;
  if (stride_bytes < element)
    fail(Status::kInvalidArgument, "%s: a stride of %llu bytes is less than one element", name,
         static_cast<unsigned long long>(stride_bytes));
  if (count == 0) return stride_bytes;
  require(data, name);
  if (count >
      static_cast<uint64_t>(std::numeric_limits<ptrdiff_t>::max()) / std::max(stride_bytes, item))
    fail(Status::kInvalidArgument, "%s: %llu items do not fit the address space", name,
         static_cast<unsigned long long>(count));
  return stride_bytes;
}

namespace {

// What of a text comes after its first bytes that are valid UTF-8.
std::string_view after_utf8(std::string_view text) {
  while (!text.empty()) {
    const size_t bytes = utf8_character_bytes(text);
    if (bytes == 0) break;
    text.remove_prefix(bytes);
  }
  return text;
}

[[noreturn]] void refuse_bytes(std::string_view text, size_t at, const char* name) {
  if (text.find('\n') == std::string_view::npos)
    fail(Status::kInvalidArgument, "%s is not valid UTF-8", name);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  fail(Status::kInvalidArgument, "%s is not valid UTF-8 in line %td", name, line);
}

}  // namespace

std::string require_text(const char* text, const char* name, size_t limit) {
  require(text, name);
  const size_t size = ::strnlen(text, limit + 1);
  if (size > limit) fail(Status::kInvalidArgument, "%s is longer than %zu bytes", name, limit);
  if (const size_t rest = after_utf8({text, size}).size(); rest > 0)
    refuse_bytes({text, size}, size - rest, name);
  return {text, size};
}

jalon_fields* new_fields(FieldTable table) {
  auto handle = std::make_unique<jalon_fields>();
  handle->table = std::move(table);
  return handle.release();
}

jalon_cloud* new_cloud(Cloud cloud) {
  auto handle = std::make_unique<jalon_cloud>();
  handle->cloud = std::make_shared<const Cloud>(std::move(cloud));
  return handle.release();
}

}  // namespace jalon::capi
