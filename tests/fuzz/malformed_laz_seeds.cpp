// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// LAZ of the point formats that no file among the shared ones has, so that ours is the seed: with wave packets, and
// those whose attributes are layers of their own.
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

bool set_waves(jalon_cloud* cloud) {
  return set<uint8_t>(cloud, "wavepacket_index", JALON_UINT8) &&
         set<uint64_t>(cloud, "wavepacket_offset", JALON_UINT64) &&
         set<uint32_t>(cloud, "wavepacket_size", JALON_UINT32) &&
         set<float>(cloud, "return_point_wave_location", JALON_FLOAT32) &&
         set<float>(cloud, "x_t", JALON_FLOAT32) && set<float>(cloud, "y_t", JALON_FLOAT32) &&
         set<float>(cloud, "z_t", JALON_FLOAT32);
}

// set_fields(cloud): whether all were set. "" where it cannot be written.
template <class SetFields>
std::string laz_with(const char* las_version, SetFields&& set_fields) {
  std::vector<double> xyz;
  for (size_t i = 0; i < kPoints; ++i)
    for (const size_t step : {size_t{1}, size_t{7}, size_t{13}})
      xyz.push_back(0.01 * static_cast<double>(i * step % 97));
  std::string folder = (std::filesystem::temp_directory_path() / "jalon-laz-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return "";
  const std::string path = folder + "/seed.laz";
  jalon_cloud* cloud = nullptr;
  jalon_params* options = nullptr;
  std::string bytes;
  if (jalon_cloud_create(xyz.data(), JALON_FLOAT64, kPoints, 0, 0, &cloud) == JALON_OK &&
      set_fields(cloud) && jalon_params_create("write", &options) == JALON_OK &&
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

}  // namespace

std::string laz_with_waves(const char* las_version) { return laz_with(las_version, set_waves); }

std::string laz_with_layers() {
  return laz_with("1.4", [](jalon_cloud* cloud) {
    bool is_set = set<double>(cloud, "gps_time", JALON_FLOAT64) &&
                  set<float>(cloud, "scan_angle", JALON_FLOAT32) &&
                  set<uint16_t>(cloud, "own", JALON_UINT16);
    for (const char* name : {"intensity", "point_source_id", "red", "green", "blue", "nir"})
      is_set = is_set && set<uint16_t>(cloud, name, JALON_UINT16);
    for (const char* name : {"classification", "user_data"})
      is_set = is_set && set<uint8_t>(cloud, name, JALON_UINT8);
    return is_set;
  });
}

}  // namespace malformed
