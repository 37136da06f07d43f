// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Files of clouds, models and trajectories, and those that stand beside them.
#include <sys/stat.h>
#include <unistd.h>

#include "e57_page.h"
#include "harness.h"
#include "readers.h"

namespace fuzz {

namespace {

jalon_params* with_text(const char* operation, const char* name, const char* value) {
  jalon_params* options = nullptr;
  must(jalon_params_create(operation, &options));
  must(jalon_params_set_string(options, name, value));
  return options;
}

void read_from(const std::string& path, const jalon_params* options) {
  jalon_cloud* cloud = nullptr;
  succeeds(jalon_cloud_read(path.c_str(), options, one_thread(), &cloud));
  jalon_cloud_release(cloud);
}

void cloud_from(const std::string& path, const jalon_params* options = nullptr) {
  read_from(path, options);
  ::unlink(path.c_str());
}

const jalon_params* small_box() {
  constexpr double kBox[6] = {-1, -1, -1, 1, 1, 1};
  static jalon_params* options = nullptr;
  if (options == nullptr) {
    must(jalon_params_create("read", &options));
    must(jalon_params_set_doubles(options, "box", kBox, 6));
  }
  return options;
}

void trajectory_from(const std::string& path, const char* sigma_path = nullptr) {
  jalon_trajectory* trajectory = nullptr;
  succeeds(jalon_trajectory_read(path.c_str(), sigma_path, nullptr, one_thread(), &trajectory));
  jalon_trajectory_release(trajectory);
  ::unlink(path.c_str());
}

}  // namespace

void read_cloud(const char* extension, const uint8_t* data, size_t size) {
  cloud_from(file_with(extension, data, size));
}

void read_copc(const uint8_t* data, size_t size) {
  read_cloud("copc.laz", data, size);
  cloud_from(file_with("copc.laz", data, size), small_box());
}

void read_ept(const uint8_t* data, size_t size) {
  static const char* const names[] = {"ept/ept.json", "ept/ept-hierarchy/0-0-0-0.json",
                                      "ept/ept-hierarchy/1-0-0-0.json", "ept/ept-data/0-0-0-0.bin",
                                      "ept/ept-data/1-0-0-0.bin"};
  for (const char* const folder : {"ept", "ept/ept-hierarchy", "ept/ept-data"})
    ::mkdir(place_of(folder).c_str(), 0777);
  std::string index;
  for (const char* const name : names) {
    const std::string text = take_text(data, size, '\0');
    const std::string path = file_with(name, text.data(), text.size());
    if (index.empty()) index = path;
  }
  read_from(index, nullptr);
  read_from(index, small_box());
  for (const char* const name : names) ::unlink(place_of(name).c_str());
  for (const char* const folder : {"ept/ept-data", "ept/ept-hierarchy", "ept"})
    ::rmdir(place_of(folder).c_str());
}

void read_model(const char* extension, bool as_faces, const uint8_t* data, size_t size) {
  static jalon_params* const faces = with_text("read", "polygons", "faces");
  const std::string path = file_with(extension, data, size);
  jalon_model* model = nullptr;
  succeeds(jalon_model_read(path.c_str(), as_faces ? faces : nullptr, one_thread(), &model));
  jalon_model_release(model);
  ::unlink(path.c_str());
}

void read_text_columns(const uint8_t* data, size_t size) {
  jalon_params* options = nullptr;
  must(jalon_params_create("read", &options));
  const std::string columns = take_text(data, size, '\n');
  if (succeeds(jalon_params_set_string(options, "columns", columns.c_str())))
    cloud_from(file_with("xyz", data, size), options);
  jalon_params_release(options);
}

void read_stations(const uint8_t* data, size_t size) {
  static constexpr char kPoints[] = "1 2 3\n1 2 4\n1 2 5\n1 2 6\n2 2 3\n2 2 4\n2 2 5\n2 2 6\n";
  const std::string beside = file_with("stations.json", data, size);
  cloud_from(file_with("xyz", kPoints, sizeof kPoints - 1));
  ::unlink(beside.c_str());
}

void read_trajectory_text(const uint8_t* data, size_t size) {
  trajectory_from(file_with("csv", data, size));
}

void read_trajectory_sbet(const uint8_t* data, size_t size) {
  trajectory_from(file_with("sbet", data, size));
}

void read_smrmsg(const uint8_t* data, size_t size) {
  constexpr size_t kEpochs = 3, kFields = 17;  // an SBET file that its sigmas go with
  double records[kEpochs * kFields];
  for (size_t i = 0; i < kEpochs * kFields; ++i) records[i] = 0.01 * static_cast<double>(i);
  const std::string sigmas = file_with("smrmsg", data, size);
  trajectory_from(file_with("sbet", records, sizeof records), sigmas.c_str());
  ::unlink(sigmas.c_str());
}

void read_m3c2_file(const uint8_t* data, size_t size) {
  static jalon_comparer* const comparer = [] {
    jalon_comparer* out = nullptr;
    must(jalon_comparer_create("m3c2", &out));
    return out;
  }();
  const std::string path = file_with("txt", data, size);
  succeeds(jalon_comparer_read_m3c2_file(comparer, path.c_str(), one_thread()));
  ::unlink(path.c_str());
}

void mend_pages(std::string& bytes) {
  constexpr size_t kPage = 1024;
  for (size_t page = 0; (page + 1) * kPage <= bytes.size(); ++page) renew_checksum(bytes, page);
}

}  // namespace fuzz
