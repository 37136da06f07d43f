// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "jalon/jalon.h"
#include "malformed_files.h"

namespace malformed {

namespace {

constexpr size_t kInfo = 375 + 54,
                 kEntry = 32;  // of the record's data; of an entry of the hierarchy

// A wall of so many points as COPC; "" where LAZ was not built.
std::string seed_of(size_t points) {
  std::vector<double> xyz;
  for (size_t i = 0; i < points; ++i) {
    const size_t row = i / 160, column = i % 160;
    for (const double value : {0.1 * static_cast<double>(column),
                               0.001 * static_cast<double>(i % 7), 0.1 * static_cast<double>(row)})
      xyz.push_back(value);
  }
  std::string folder = (std::filesystem::temp_directory_path() / "jalon-copc-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return "";
  const std::string path = folder + "/seed.copc.laz";
  jalon_cloud* cloud = nullptr;
  std::string bytes;
  if (jalon_cloud_create(xyz.data(), JALON_FLOAT64, points, 0, 0, &cloud) == JALON_OK &&
      jalon_cloud_write(cloud, path.c_str(), nullptr, nullptr) == JALON_OK) {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  jalon_cloud_release(cloud);
  std::filesystem::remove_all(folder);
  return bytes;
}

template <class T>
std::string with(std::string bytes, size_t at, T value) {  // little-endian machines only
  bytes.replace(at, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

// A page that names itself, over and over, at the end of the file: as large as the rest.
std::string with_pages(const std::string& seed, uint64_t step) {
  std::string bytes = seed;
  const uint64_t page = bytes.size(), count = seed.size() / kEntry;
  for (uint64_t i = 0; i < count; ++i) {
    const int32_t key[4] = {0, 0, 0, 0};
    const uint64_t offset = page + i * step;
    const int32_t tail[2] = {static_cast<int32_t>((count - (step == 0 ? 0 : i)) * kEntry), -1};
    bytes.append(reinterpret_cast<const char*>(key), sizeof key);
    bytes.append(reinterpret_cast<const char*>(&offset), sizeof offset);
    bytes.append(reinterpret_cast<const char*>(tail), sizeof tail);
  }
  return with(with(bytes, kInfo + 40, page), kInfo + 48, count * kEntry);
}

}  // namespace

std::vector<File> copc_files() {
  std::vector<File> out;
  const std::string seed = seed_of(16000);
  if (seed.empty()) return out;
  const auto add = [&](const char* name, const std::string& bytes) {
    out.push_back({std::string(name) + ".copc.laz", bytes});
  };
  uint64_t page = 0;
  std::memcpy(&page, seed.data() + kInfo + 40, sizeof page);
  for (size_t end = 0; end < seed.size(); end += end < 1200 ? 31 : 4001)
    add("cut", seed.substr(0, end));
  for (size_t end = page; end < seed.size(); end += 3) add("cut", seed.substr(0, end));
  for (size_t at = kInfo; at < kInfo + 72; at += 8)
    for (const uint64_t value :
         {uint64_t{0}, uint64_t{1}, ~uint64_t{0}, uint64_t{1} << 63, (uint64_t{1} << 63) - 1,
          uint64_t{0x7FF8} << 48, uint64_t{0x7FEF} << 48, uint64_t{1} << 52})
      add("info", with(seed, at, value));
  for (size_t at = page; at + 4 <= seed.size(); at += 4)
    for (const uint32_t value :
         {0u, 1u, 31u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu, static_cast<uint32_t>(page)})
      add("entry", with(seed, at, value));
  for (const uint64_t step : {0, 32, 64}) add("pages", with_pages(seed, step));
  // All entries are the first one; all promise what the header promises too.
  std::string same = seed, many = with(seed, 247, ~uint64_t{0});
  for (size_t at = page; at + kEntry <= seed.size(); at += kEntry) {
    same.replace(at, kEntry, seed, page, kEntry);
    many = with(many, at + 28, uint32_t{0x7FFFFFFF});
  }
  add("same", same);
  add("many", many);
  return out;
}

}  // namespace malformed
