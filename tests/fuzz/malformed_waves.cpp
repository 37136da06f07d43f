// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// LAZ with wave packets: no file of others has a place among the shared ones, so ours is the seed.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "jalon/jalon.h"
#include "malformed_files.h"

namespace malformed {

namespace {

constexpr size_t kPoints = 400;

// One value a point, that changes from point to point and is no multiple of what precedes it.
template <class T>
bool set(jalon_cloud* cloud, const char* name, int32_t type) {
  std::vector<T> values(kPoints);
  for (size_t i = 0; i < kPoints; ++i) values[i] = static_cast<T>(i * i % 251);
  return jalon_cloud_set_field(cloud, name, values.data(), type, 1, kPoints, 0, nullptr, nullptr) ==
         JALON_OK;
}

}  // namespace

std::string laz_with_waves(const char* las_version) {
  std::vector<double> xyz;
  for (size_t i = 0; i < kPoints; ++i)
    for (const size_t step : {size_t{1}, size_t{7}, size_t{13}})
      xyz.push_back(0.01 * static_cast<double>(i * step % 97));
  std::string folder = (std::filesystem::temp_directory_path() / "jalon-waves-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return "";
  const std::string path = folder + "/seed.laz";
  jalon_cloud* cloud = nullptr;
  jalon_params* options = nullptr;
  std::string bytes;
  if (jalon_cloud_create(xyz.data(), JALON_FLOAT64, kPoints, 0, 0, &cloud) == JALON_OK &&
      set<uint8_t>(cloud, "wavepacket_index", JALON_UINT8) &&
      set<uint64_t>(cloud, "wavepacket_offset", JALON_UINT64) &&
      set<uint32_t>(cloud, "wavepacket_size", JALON_UINT32) &&
      set<float>(cloud, "return_point_wave_location", JALON_FLOAT32) &&
      set<float>(cloud, "x_t", JALON_FLOAT32) && set<float>(cloud, "y_t", JALON_FLOAT32) &&
      set<float>(cloud, "z_t", JALON_FLOAT32) &&
      jalon_params_create("write", &options) == JALON_OK &&
      jalon_params_set_string(options, "las_version", las_version) == JALON_OK &&
      jalon_cloud_write(cloud, path.c_str(), options, nullptr) == JALON_OK) {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  jalon_params_release(options);
  jalon_cloud_release(cloud);
  std::filesystem::remove_all(folder);
  return bytes;
}

}  // namespace malformed
