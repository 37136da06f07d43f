// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace bench {

/// What a point of format 0 or 3 has besides its place.
struct Attributes {
  uint16_t intensity = 0;
  uint8_t classification = 0;
  int8_t scan_angle_deg = 0;
  uint16_t source = 0;
  double time_s = 0;
  uint16_t rgb[3] = {};
};

/// Made up from the point's number: noise to whoever packs them in another order than this one.
inline Attributes made_up(size_t i) {
  Attributes made;
  made.intensity = static_cast<uint16_t>(i * 2654435761u >> 16);
  made.classification = static_cast<uint8_t>(i % 7);
  made.scan_angle_deg = static_cast<int8_t>(static_cast<int>(i % 60) - 30);
  made.source = static_cast<uint16_t>(1 + i % 3);
  made.time_s = 100000.0 + 1e-6 * static_cast<double>(i);
  for (size_t k = 0; k < 3; ++k) made.rgb[k] = static_cast<uint16_t>((i + 37 * k) * 40503u);
  return made;
}

/// Writes packed xyz as LAS 1.2 in point format 0 or 3, coordinates to 0.1 mm, of(i) the other attributes of a point.
/// A writer of its own, so that the files that Jalon and LASzip read are neither's work. True when all went well.
template <class AttributesOf>
bool write_las(const std::string& path, uint8_t point_format, const std::vector<double>& xyz,
               AttributesOf&& of) {
  constexpr double kScale_m = 0.0001;
  constexpr size_t kHeaderBytes = 227;
  const size_t record_bytes = point_format == 3 ? 34 : 20;
  const size_t count = xyz.size() / 3;
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  for (size_t i = 0; i < xyz.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], xyz[i]);
    high[i % 3] = std::max(high[i % 3], xyz[i]);
  }
  std::vector<uint8_t> bytes(kHeaderBytes + record_bytes * count);
  const auto put = [&](size_t offset, auto value) {
    std::memcpy(&bytes[offset], &value, sizeof value);
  };
  std::memcpy(&bytes[0], "LASF", 4);
  put(24, uint8_t{1});
  put(25, uint8_t{2});
  std::memcpy(&bytes[26], "SYNTHETIC", 9);
  std::memcpy(&bytes[58], "street_scene", 12);
  put(90, uint16_t{1});
  put(92, uint16_t{2026});
  put(94, static_cast<uint16_t>(kHeaderBytes));
  put(96, static_cast<uint32_t>(kHeaderBytes));
  put(104, point_format);
  put(105, static_cast<uint16_t>(record_bytes));
  put(107, static_cast<uint32_t>(count));
  put(111, static_cast<uint32_t>(count));
  for (size_t k = 0; k < 3; ++k) {
    put(131 + 8 * k, kScale_m);
    put(179 + 16 * k, high[k]);
    put(187 + 16 * k, low[k]);
  }
  for (size_t i = 0; i < count; ++i) {
    const size_t at = kHeaderBytes + record_bytes * i;
    const Attributes all = of(i);
    for (size_t k = 0; k < 3; ++k)
      put(at + 4 * k, static_cast<int32_t>(std::llround(xyz[3 * i + k] / kScale_m)));
    put(at + 12, all.intensity);
    put(at + 14, uint8_t{0x09});  // return 1 of 1
    put(at + 15, all.classification);
    put(at + 16, all.scan_angle_deg);
    put(at + 18, all.source);
    if (point_format == 3) {
      put(at + 20, all.time_s);
      for (size_t k = 0; k < 3; ++k) put(at + 28 + 2 * k, all.rgb[k]);
    }
  }
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return std::fclose(file) == 0 && written;
}

inline bool write_las(const std::string& path, uint8_t point_format,
                      const std::vector<double>& xyz) {
  return write_las(path, point_format, xyz, made_up);
}

}  // namespace bench
