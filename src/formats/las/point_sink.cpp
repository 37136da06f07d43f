// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/point_sink.h"

#include <utility>

#include "formats/files/endian.h"

namespace jalon::las {

namespace {

template <class T>
void copy_whole(const Extraction& e, const std::byte* records, size_t stride, size_t n,
                size_t first) {
  T* out = static_cast<T*>(e.column->raw()) + first;
  const std::byte* from = records + e.offset;
  for (size_t i = 0; i < n; ++i) out[i] = load<T>(from + i * stride);
}

void copy_bits(const Extraction& e, const std::byte* records, size_t stride, size_t n,
               size_t first) {
  auto* out = static_cast<uint8_t*>(e.column->raw()) + first;
  const std::byte* from = records + e.offset;
  const unsigned mask = (1u << e.bits) - 1;
  for (size_t i = 0; i < n; ++i)
    out[i] = static_cast<uint8_t>((static_cast<unsigned>(from[i * stride]) >> e.shift) & mask);
}

template <class T>
void copy_angle(const Extraction& e, const std::byte* records, size_t stride, size_t n,
                size_t first) {
  auto* out = static_cast<float*>(e.column->raw()) + first;
  const std::byte* from = records + e.offset;
  for (size_t i = 0; i < n; ++i) out[i] = static_cast<float>(load<T>(from + i * stride) * e.factor);
}

// Several components, or a scaled dimension.
template <class T>
void copy_components(const Extraction& e, const std::byte* records, size_t stride, size_t n,
                     size_t first) {
  const size_t components = e.column->info().components;
  for (size_t i = 0; i < n; ++i)
    for (size_t c = 0; c < components; ++c) {
      const T raw = load<T>(records + i * stride + e.offset + c * sizeof(T));
      const size_t at = (first + i) * components + c;
      if (e.scale != nullptr)
        static_cast<double*>(e.column->raw())[at] =
            static_cast<double>(raw) * e.scale[c] + e.move[c];
      else static_cast<T*>(e.column->raw())[at] = raw;
    }
}

Extraction extraction_of(const Dimension& dimension, size_t count) {
  Extraction e;
  e.column = std::make_shared<Column>(dimension.field, count);
  e.offset = static_cast<size_t>(dimension.place.offset);
  e.shift = dimension.place.shift;
  e.bits = dimension.place.bits;
  e.factor = dimension.place.factor;
  if (e.bits != 0) e.run = copy_bits;
  else if (dimension.field.type != dimension.place.type)
    e.run = dimension.place.type == ElementType::kInt8 ? copy_angle<int8_t> : copy_angle<int16_t>;
  else e.run = visit(dimension.place.type, [](auto zero) { return &copy_whole<decltype(zero)>; });
  return e;
}

Extraction extraction_of(const ExtraDimension& dimension, size_t extra_offset, size_t count) {
  Extraction e;
  e.column = std::make_shared<Column>(dimension.field, count);
  e.offset = extra_offset + dimension.offset;
  if (dimension.scaled) {
    e.scale = dimension.scale;
    e.move = dimension.shift;
  }
  const bool plain = !dimension.scaled && dimension.field.components == 1;
  e.run = visit(dimension.raw_type, [&](auto zero) {
    return plain ? &copy_whole<decltype(zero)> : &copy_components<decltype(zero)>;
  });
  return e;
}

}  // namespace

Vec3 place_of(const Header& header, const Vec3& unit, const std::byte* record) {
  return {(load<int32_t>(record) * header.scale.x + header.offset.x) * unit.x,
          (load<int32_t>(record + 4) * header.scale.y + header.offset.y) * unit.y,
          (load<int32_t>(record + 8) * header.scale.z + header.offset.z) * unit.z};
}

PointSink::PointSink(const Header& header, const Vec3& unit, const std::vector<Dimension>& standard,
                     const std::vector<ExtraDimension>& extra, size_t count)
    : header_(header), unit_(unit), xyz_(3 * count) {
  for (const Dimension& dimension : standard)
    extractions_.push_back(extraction_of(dimension, count));
  for (const ExtraDimension& dimension : extra)
    extractions_.push_back(extraction_of(dimension, point_format(header.format)->bytes, count));
}

void PointSink::put(const std::byte* records, size_t n, size_t first) {
  const size_t stride = header_.record_bytes;
  double* out = xyz_.data() + 3 * first;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 p = place_of(header_, unit_, records + i * stride);
    out[3 * i] = p.x;
    out[3 * i + 1] = p.y;
    out[3 * i + 2] = p.z;
  }
  for (const Extraction& e : extractions_) e.run(e, records, stride, n, first);
}

Cloud PointSink::cloud() {
  Cloud cloud = make_cloud(std::move(xyz_));
  for (Extraction& e : extractions_)
    cloud.fields.set(
        std::move(e.column));  // an extra dimension replaces the standard one of its name
  return cloud;
}

}  // namespace jalon::las
