// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <fstream>
#include <iterator>

#include "e57_page.h"
#include "malformed_files.h"

namespace malformed {

namespace {

// "" where it is absent.
std::string shared_bytes(const std::string& name) {
  std::ifstream file(std::string(JALON_SHARED_DATA) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class T>
T number_at(const std::string& bytes, size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);  // little-endian machines only
  return value;
}

// The four bytes at this place at their limits.
void add_limits(std::vector<File>& out, const std::string& seed, size_t at, const char* name) {
  for (const uint32_t value : {0u, 1u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
    std::string bytes = seed;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    out.push_back({name, bytes});
  }
}

void add_laz(std::vector<File>& out, const std::string& seed) {
  if (seed.empty()) return;
  const size_t points = number_at<uint32_t>(seed, 96), table = number_at<uint32_t>(seed, points);
  for (size_t end = 0; end < seed.size(); end += end < points + 64 ? 5 : 151)
    out.push_back({"cut.laz", seed.substr(0, end)});
  // Counts of the header, the record of the compressor, the first chunk, the chunk table.
  for (const size_t at : {size_t{96}, size_t{100}, size_t{104}, size_t{105}, size_t{107}})
    add_limits(out, seed, at, "header.laz");
  for (size_t at = number_at<uint16_t>(seed, 94); at < points + 96; at += 3)
    add_limits(out, seed, at, "record.laz");
  for (size_t at = table; at + 4 <= seed.size(); ++at) add_limits(out, seed, at, "table.laz");
  for (size_t at = points + 96; at < table; at += 97) add_limits(out, seed, at, "points.laz");
}

}  // namespace

std::vector<File> laz_files() {
  std::vector<File> out;
  add_laz(out, shared_bytes("las/simple.laz"));
  for (const char* version : {"auto", "1.4"}) add_laz(out, laz_with_waves(version));
  add_laz(out, laz_with_layers());
  return out;
}

std::vector<File> e57_files() {
  std::vector<File> out;
  const std::string seed = shared_bytes("e57/A_B.e57");
  if (seed.empty()) return out;
  for (size_t end = 0; end < seed.size(); end += 64)
    out.push_back({"cut.e57", seed.substr(0, end)});
  for (size_t at = 8; at + 4 <= seed.size(); at += at < 1024 ? 4 : 9) {
    if (at % 1024 >= 1017) continue;
    const size_t first = out.size();
    add_limits(out, seed, at, "limits.e57");
    for (const char digit : {'9', '-', '<'}) {
      std::string bytes = seed;
      bytes[at] = digit;
      out.push_back({"digit.e57", bytes});
    }
    for (size_t i = first; i < out.size(); ++i) renew_checksum(out[i].bytes, at / 1024);
  }
  return out;
}

}  // namespace malformed
