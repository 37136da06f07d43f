// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "capi/support/guard.h"
#include "cloud/operations.h"

namespace jalon::capi {

/// Puts a changed copy in place of a handle's cloud; others that look at the old one keep it.
inline void replace(jalon_cloud* handle, Cloud cloud) {
  handle->cloud = std::make_shared<const Cloud>(std::move(cloud));
}

/// Two clouds out at once, each only if wanted: nothing is handed out unless both are made.
struct CloudPair {
  Owned<jalon_cloud> first{nullptr, jalon_cloud_release}, second{nullptr, jalon_cloud_release};
  void hand_out(jalon_cloud** a, jalon_cloud** b) {
    if (a != nullptr) *a = first.release();
    if (b != nullptr) *b = second.release();
  }
};
/// The points where the mask is 1, and those where it is 0.
CloudPair split_by_mask(const Cloud& cloud, std::span<const uint8_t> mask, bool want_ones,
                        bool want_zeros, Task& task);

/// Name, type and texts of a field as the caller gave them; unit and meaning may be NULL.
FieldInfo require_field_info(const char* name, int32_t type, uint32_t components, const char* unit,
                             const char* meaning);
/// CRS texts (WKT) may be longer than other texts.
constexpr size_t kLongText = size_t{1} << 20;
/// 0 or JALON_CLOUD_DROP_INVALID; true for the latter.
bool require_flags(uint32_t flags);
/// Packed doubles from strided memory of any type.
void load_coordinates(const void* xyz, ElementType type, size_t count, size_t stride_bytes,
                      double* out);
/// The indices of the points whose three coordinates are finite.
std::vector<uint64_t> finite_points(std::span<const double> xyz);

}  // namespace jalon::capi
