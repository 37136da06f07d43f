// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

#include "base/default_arithmetic.h"
#include "base/error.h"
#include "base/field.h"
#include "capi/support/handles.h"
#include "geometry/rigid_motion.h"
#include "jalon/status.h"

namespace jalon::capi {

/// Keeps the line for jalon_last_error_message and gives the code back. Never throws; long texts are cut.
jalon_status remember(Status status, const char* text) noexcept;
/// Turns the exception in flight into a status; only inside a catch block.
jalon_status remember_current() noexcept;

/// The one wall between C++ and the caller: every function with a status is argument checks + one call inside guard.
template <class F>
jalon_status guard(F&& body) noexcept {
  const DefaultArithmetic arithmetic;
  try {
    body();
    return JALON_OK;
  } catch (...) {
    return remember_current();
  }
}

/// NULL where something is needed: the name is the parameter's.
inline void require(const void* pointer, const char* name) {
  if (pointer == nullptr) fail(Status::kInvalidArgument, "%s is NULL", name);
}

inline ElementType require_type(int32_t type) {
  if (!is_element_type(type)) fail(Status::kInvalidArgument, "%d is no element type", type);
  return static_cast<ElementType>(type);
}

/// Strided input of count items of components elements: checks type, stride, overflow and NULL (allowed for count 0
/// only); returns the stride, packed when 0 was given.
size_t require_array(const void* data, int32_t type, uint64_t count, uint32_t components,
                     uint64_t stride_bytes, const char* name);

/// A valid UTF-8 text of at most 64 KiB (1 MiB for long ones), not NULL.
std::string require_text(const char* text, const char* name, size_t limit = 65536);

inline Transform from_c(const jalon_transform& t) {
  Transform out;
  for (size_t i = 0; i < 12; ++i) {
    if (!std::isfinite(t.m[i]))
      fail(Status::kInvalidArgument, "the transform holds a value that is not finite");
    out.m[i] = t.m[i];
  }
  return out;
}
/// Of a scanner: a rigid motion.
inline Transform require_pose(const jalon_transform& pose) {
  const Transform out = from_c(pose);
  require_rigid(out, "the pose");
  return out;
}
inline jalon_transform to_c(const Transform& t) {
  jalon_transform out;
  for (size_t i = 0; i < 12; ++i) out.m[i] = t.m[i];
  return out;
}
inline Vec3 from_c(const jalon_vec3& v) { return {v.x, v.y, v.z}; }
inline jalon_vec3 to_c(const Vec3& v) { return {v.x, v.y, v.z}; }
inline jalon_array_view view_of(const Column& column) {
  return {column.raw(), column.count(), column.info().components,
          static_cast<int32_t>(column.info().type),
          size_of(column.info().type) * column.info().components};
}

/// Runs body(Task&) under the caller's task (NULL = defaults): one call a task, cancel, progress, 1.0 at the end; gives
/// back what body gives. 1.0 means success, so whatever can fail belongs into body, making a handle included; outputs
/// are written after this returns:
///   *out = with_task(task, [&](Task& t) { return own(new_cloud(...)); }).release();
template <class F>
auto with_task(jalon_task* task, F&& body) {
  TaskUse use(task);
  try {
    if constexpr (std::is_void_v<decltype(body(use.task()))>) {
      body(use.task());
      use.task().finish();
    } else {
      auto made = body(use.task());
      use.task().finish();
      return made;
    }
  } catch (const std::bad_alloc&) {
    use.blame_memory_limit();
    throw;
  }
}

/// options of an operation: the caller's set, which must be of that operation, or the defaults.
ParamSet options_or_default(const jalon_params* options, const char* operation);

/// A new handle of a table.
jalon_fields* new_fields(FieldTable table);
jalon_cloud* new_cloud(Cloud cloud);

/// What a getter of a table does; table() gives it.
template <class Handle, class F>
jalon_status give_fields(const Handle* handle, const char* name, jalon_fields** out, F&& table) {
  return guard([&] {
    require(handle, name);
    require(out, "out");
    *out = new_fields(table());
  });
}
/// Releases handles made so far unless the whole call succeeds.
template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;
template <class T>
Owned<T> own(T* handle) noexcept {
  return {handle, [](T* h) { release(h); }};
}

}  // namespace jalon::capi
