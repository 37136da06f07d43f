// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/files/endian.h"
#include "formats/las/layout.h"

namespace jalon::test {

template <class T>
void put_at(std::string& bytes, size_t offset, T value) {
  if (bytes.size() < offset + sizeof value) bytes.resize(offset + sizeof value, '\0');
  store<T>(bytes.data() + offset, value);
}
template <class T>
T get_at(const std::string& bytes, size_t offset) {
  return offset + sizeof(T) <= bytes.size() ? load<T>(bytes.data() + offset) : T{};
}

/// A LAS file as other programs write it: the tables of ASPRS LAS 1.4 R15, byte by byte.
struct LasBytes {
  unsigned minor = 2, format = 0;
  uint16_t record_bytes = 20;
  double scale = 0.01, offset = 0;
  std::vector<las::Record> vlrs, evlrs;
  std::string points;  ///< whole records

  /// A record of zeros with these three integers; where it begins in `points`.
  size_t add_point(int32_t x, int32_t y, int32_t z) {
    const size_t begin = points.size();
    points.resize(begin + record_bytes, '\0');
    put_at(points, begin, x);
    put_at(points, begin + 4, y);
    put_at(points, begin + 8, z);
    return begin;
  }

  size_t header_size() const { return minor == 4 ? 375 : minor == 3 ? 235 : 227; }

  std::string bytes() const {
    std::string out(header_size(), '\0');
    out.replace(0, 4, "LASF");
    out[24] = 1;
    out[25] = static_cast<char>(minor);
    out[104] = static_cast<char>(format);
    put_at(out, 94, static_cast<uint16_t>(header_size()));
    put_at(out, 100, static_cast<uint32_t>(vlrs.size()));
    put_at(out, 105, record_bytes);
    for (size_t k = 0; k < 3; ++k) {
      put_at(out, 131 + 8 * k, scale);
      put_at(out, 155 + 8 * k, offset);
    }
    for (const las::Record& record : vlrs) append(out, record);
    const uint64_t count = points.size() / record_bytes;
    put_at(out, 96, static_cast<uint32_t>(out.size()));
    if (format < 6) put_at(out, 107, static_cast<uint32_t>(count));
    if (minor == 4) put_at(out, 247, count);
    out += points;
    if (!evlrs.empty()) {
      put_at(out, 235, static_cast<uint64_t>(out.size()));
      put_at(out, 243, static_cast<uint32_t>(evlrs.size()));
    }
    for (const las::Record& record : evlrs) append(out, record);
    return out;
  }

 private:
  static void append(std::string& out, const las::Record& record) {
    out.append(reinterpret_cast<const char*>(record.bytes.data()), record.bytes.size());
  }
};

/// A record with the longer header of those behind the points.
inline las::Record extended_record(const std::string& user, uint16_t id, const std::string& data) {
  std::string bytes(las::kEvlrHeader, '\0');
  bytes.replace(2, user.size(), user);
  put_at(bytes, 18, id);
  put_at(bytes, 20, static_cast<uint64_t>(data.size()));
  bytes += data;
  std::vector<std::byte> raw(bytes.size());
  for (size_t i = 0; i < raw.size(); ++i) raw[i] = static_cast<std::byte>(bytes[i]);
  return las::record_of(raw, las::kEvlrHeader);
}

/// Descriptors side by side as the record that describes the extra bytes.
inline las::Record extra_bytes_record(const std::vector<std::vector<std::byte>>& descriptors) {
  std::vector<std::byte> data;
  for (const auto& one : descriptors) data.insert(data.end(), one.begin(), one.end());
  return las::make_record(las::kSpecUser, las::kExtraBytes, "", data.data(), data.size());
}

}  // namespace jalon::test
