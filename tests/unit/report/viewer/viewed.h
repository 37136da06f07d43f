// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/viewer/scene.h"
#include "unit/formats/files/inflated.h"

/// Packed points read back as viewer.js does.
namespace viewed {

using namespace jalon;

struct Reader {
  std::string bytes;
  size_t points = 0, at = 0;

  std::vector<uint32_t> numbers(size_t width, bool is_plain = false) {
    std::vector<uint32_t> out(points);
    uint32_t value = 0;
    const auto byte = [&](size_t i) {
      return static_cast<uint32_t>(static_cast<unsigned char>(bytes[i]));
    };
    for (size_t i = 0; i < points; ++i) {
      const uint32_t z = byte(at + i) | (width == 2 ? byte(at + points + i) << 8 : 0);
      value = (is_plain ? 0 : value) + ((z >> 1) ^ (~(z & 1) + 1));
      out[i] = value &= width == 2 ? 0xffff : 0xff;
    }
    at += width * points;
    return out;
  }
};

inline CloudPtr random_cloud(size_t n, uint64_t seed, const Vec3& centre, double size_m) {
  RandomStream random(seed, 1);
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < 3 * n; ++i)
    xyz[i] = centre[static_cast<int>(i % 3)] + size_m * (random.uniform() - 0.5);
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

}  // namespace viewed
