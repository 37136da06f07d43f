// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/records.h"

#include <cmath>
#include <cstring>

#include "formats/files/endian.h"

namespace jalon::las {

namespace {

// row(i): the index in the cloud of the point of record i.

template <class Row>
void put_standard(const StandardColumn& standard, std::byte* records, size_t stride, Row row,
                  size_t n) {
  const Place& place = standard.place;
  std::byte* to = records + place.offset;
  visit(standard.column->info().type, [&](auto zero) {
    using T = decltype(zero);
    const T* from = static_cast<const T*>(standard.column->raw());
    if (place.bits != 0) {
      for (size_t i = 0; i < n; ++i)
        to[i * stride] |=
            static_cast<std::byte>(static_cast<unsigned>(from[row(i)]) << place.shift);
      return;
    }
    visit(place.type, [&](auto stored_zero) {
      using Stored = decltype(stored_zero);
      for (size_t i = 0; i < n; ++i) {
        if (place.factor != 1)
          store<Stored>(to + i * stride, static_cast<Stored>(std::nearbyint(
                                             static_cast<double>(from[row(i)]) / place.factor)));
        else store<Stored>(to + i * stride, static_cast<Stored>(from[row(i)]));
      }
    });
  });
}

template <class Row>
void put_extra(const ExtraColumn& extra, std::byte* records, size_t stride, Row row, size_t n) {
  const size_t components = extra.column->info().components;
  visit(extra.raw_type, [&](auto raw_zero) {
    using Raw = decltype(raw_zero);
    for (size_t i = 0; i < n; ++i)
      for (size_t c = 0; c < extra.components; ++c) {
        const size_t at = row(i) * components + extra.component + c;
        std::byte* to = records + i * stride + extra.offset + c * sizeof(Raw);
        if (extra.scaled) {
          const double value = static_cast<const double*>(extra.column->raw())[at];
          store<Raw>(to,
                     static_cast<Raw>(std::nearbyint((value - extra.shift[c]) / extra.scale[c])));
        } else {
          store<Raw>(to, static_cast<const Raw*>(extra.column->raw())[at]);
        }
      }
  });
}

template <class Row>
Tally put_rows(const Plan& plan, const Cloud& cloud, std::byte* records, Row row, size_t n) {
  const size_t stride = plan.record_bytes;
  const double* xyz = cloud.xyz().data();
  std::memset(records, 0, n * stride);
  Tally tally;
  for (size_t i = 0; i < n; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const int32_t steps = steps_of(plan, xyz[3 * row(i) + k], static_cast<int>(k));
      store<int32_t>(records + i * stride + 4 * k, steps);
      tally.min[k] = std::min<int64_t>(tally.min[k], steps);
      tally.max[k] = std::max<int64_t>(tally.max[k], steps);
    }
  for (const StandardColumn& standard : plan.standard)
    put_standard(standard, records, stride, row, n);
  for (const ExtraColumn& extra : plan.extra) put_extra(extra, records, stride, row, n);
  const unsigned mask = point_format(plan.format)->extended ? 15 : 7;
  for (size_t i = 0; i < n; ++i)
    ++tally.by_return[static_cast<unsigned>(records[i * stride + 14]) & mask];
  return tally;
}

}  // namespace

Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records, size_t first, size_t n) {
  return put_rows(
      plan, cloud, records, [first](size_t i) { return first + i; }, n);
}

Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records,
                 std::span<const uint32_t> points) {
  return put_rows(
      plan, cloud, records, [points](size_t i) { return size_t{points[i]}; }, points.size());
}

}  // namespace jalon::las
