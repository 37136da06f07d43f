// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_targets.h"

#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "e57_page.h"
#include "jalon/jalon.h"

namespace fuzz {

namespace {

/// A failure is one line that says something.
void expect(jalon_status status) {
  if (status == JALON_OK) return;
  const char* const line = jalon_last_error_message();
  if (line[0] == 0 || status == JALON_ERROR_INTERNAL) {
    std::fprintf(stderr, "status %d: %s\n", status, line);
    std::abort();
  }
}

/// The file that every input is written to; in memory where the system has such a folder.
std::string file_with(const char* extension, const uint8_t* data, size_t size) {
  static const std::string stem =
      (::access("/dev/shm", W_OK) == 0 ? "/dev/shm/jalon_fuzz_" : "/tmp/jalon_fuzz_") +
      std::to_string(::getpid());
  const std::string path = stem + "." + extension;
  FILE* const out = std::fopen(path.c_str(), "wb");
  if (out == nullptr || std::fwrite(data, 1, size, out) != size) std::abort();
  std::fclose(out);
  return path;
}

jalon_task* one_thread() {
  static jalon_task* task = nullptr;
  if (task == nullptr &&
      (jalon_task_create(&task) != JALON_OK || jalon_task_set_threads(task, 1) != JALON_OK))
    std::abort();
  return task;
}

void read_cloud(const char* extension, const uint8_t* data, size_t size) {
  const std::string path = file_with(extension, data, size);
  jalon_cloud* cloud = nullptr;
  expect(jalon_cloud_read(path.c_str(), nullptr, one_thread(), &cloud));
  jalon_cloud_release(cloud);
  ::unlink(path.c_str());
}

void read_model(const char* extension, const uint8_t* data, size_t size) {
  const std::string path = file_with(extension, data, size);
  jalon_model* model = nullptr;
  expect(jalon_model_read(path.c_str(), nullptr, one_thread(), &model));
  jalon_model_release(model);
  ::unlink(path.c_str());
}

template <const char* kExtension>
void cloud_file(const uint8_t* data, size_t size) {
  read_cloud(kExtension, data, size);
}
// Whole, and by the nodes that a box touches.
void copc_file(const uint8_t* data, size_t size) {
  read_cloud("copc.laz", data, size);
  static jalon_params* options = nullptr;
  constexpr double kBox[6] = {-1, -1, -1, 1, 1, 1};
  if (options == nullptr && (jalon_params_create("read", &options) != JALON_OK ||
                             jalon_params_set_doubles(options, "box", kBox, 6) != JALON_OK))
    std::abort();
  const std::string path = file_with("copc.laz", data, size);
  jalon_cloud* cloud = nullptr;
  expect(jalon_cloud_read(path.c_str(), options, one_thread(), &cloud));
  jalon_cloud_release(cloud);
  ::unlink(path.c_str());
}

template <const char* kExtension>
void model_file(const uint8_t* data, size_t size) {
  read_model(kExtension, data, size);
}

void read_trajectory(const char* extension, const uint8_t* data, size_t size) {
  const std::string path = file_with(extension, data, size);
  jalon_trajectory* trajectory = nullptr;
  expect(jalon_trajectory_read(path.c_str(), nullptr, nullptr, one_thread(), &trajectory));
  jalon_trajectory_release(trajectory);
  ::unlink(path.c_str());
}
void trajectory_text(const uint8_t* data, size_t size) { read_trajectory("csv", data, size); }
void trajectory_sbet(const uint8_t* data, size_t size) { read_trajectory("sbet", data, size); }

template <class Handle>
void from_bytes(jalon_status (*make)(const uint8_t*, uint64_t, jalon_task*, Handle**),
                void (*release)(Handle*), const uint8_t* data, size_t size) {
  Handle* out = nullptr;
  expect(make(data, size, one_thread(), &out));
  release(out);
}
template <class Handle>
void from_bytes(jalon_status (*make)(const uint8_t*, uint64_t, Handle**), void (*release)(Handle*),
                const uint8_t* data, size_t size) {
  Handle* out = nullptr;
  expect(make(data, size, &out));
  release(out);
}

/// The first byte tells of which kind.
void bytes_of_objects(const uint8_t* data, size_t size) {
  if (size == 0) return;
  const uint8_t* const from = data + 1;
  const size_t n = size - 1;
  switch (data[0] % 9) {
    case 0:
      return from_bytes(jalon_cloud_from_bytes, jalon_cloud_release, from, n);
    case 1:
      return from_bytes(jalon_fields_from_bytes, jalon_fields_release, from, n);
    case 2:
      return from_bytes(jalon_params_from_bytes, jalon_params_release, from, n);
    case 3:
      return from_bytes(jalon_model_from_bytes, jalon_model_release, from, n);
    case 4:
      return from_bytes(jalon_segmentation_from_bytes, jalon_segmentation_release, from, n);
    case 5:
      return from_bytes(jalon_comparison_from_bytes, jalon_comparison_release, from, n);
    case 6:
      return from_bytes(jalon_registration_from_bytes, jalon_registration_release, from, n);
    case 7:
      return from_bytes(jalon_evaluation_from_bytes, jalon_evaluation_release, from, n);
    default:
      return from_bytes(jalon_model_evaluation_from_bytes, jalon_model_evaluation_release, from, n);
  }
}

/// The first byte tells which table of parameters, the rest is text.
void json_of_params(const uint8_t* data, size_t size) {
  static const char* const operations[] = {"normals", "subsample", "read",  "write",
                                           "scene",   "outliers",  "report"};
  if (size == 0) return;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  jalon_params* params = nullptr;
  const auto of = data[0] % (sizeof operations / sizeof *operations);
  if (jalon_params_create(operations[of], &params) != JALON_OK) return;
  expect(jalon_params_from_json(params, text.c_str()));
  jalon_params_release(params);
}

void json_of_laws(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  jalon_noise_law* law = nullptr;
  expect(jalon_noise_law_from_json(text.c_str(), &law));
  jalon_noise_law_release(law);
}

constexpr char kLas[] = "las", kLaz[] = "laz", kE57[] = "e57", kPly[] = "ply", kPcd[] = "pcd",
               kPtx[] = "ptx", kPts[] = "pts", kXyz[] = "xyz", kCsv[] = "csv", kObj[] = "obj",
               kStl[] = "stl", kCity[] = "city.json", kDxf[] = "dxf";

void mend_pages(std::string& bytes) {
  constexpr size_t kPage = 1024;
  for (size_t page = 0; (page + 1) * kPage <= bytes.size(); ++page) renew_checksum(bytes, page);
}

constexpr Target kTargets[] = {
    {"las", cloud_file<kLas>, nullptr},
    {"laz", cloud_file<kLaz>, nullptr},
    {"copc.laz", copc_file, nullptr},
    {"e57", cloud_file<kE57>, mend_pages},
    {"ply", cloud_file<kPly>, nullptr},
    {"ply_model", model_file<kPly>, nullptr},
    {"pcd", cloud_file<kPcd>, nullptr},
    {"ptx", cloud_file<kPtx>, nullptr},
    {"pts", cloud_file<kPts>, nullptr},
    {"xyz", cloud_file<kXyz>, nullptr},
    {"csv", cloud_file<kCsv>, nullptr},
    {"obj", model_file<kObj>, nullptr},
    {"stl", model_file<kStl>, nullptr},
    {"city.json", model_file<kCity>, nullptr},
    {"dxf", model_file<kDxf>, nullptr},
    {"trajectory_text", trajectory_text, nullptr},
    {"trajectory_sbet", trajectory_sbet, nullptr},
    {"bytes", bytes_of_objects, nullptr},
    {"params", json_of_params, nullptr},
    {"law", json_of_laws, nullptr},
};

}  // namespace

const Target* target(size_t i) {
  return i < sizeof kTargets / sizeof *kTargets ? &kTargets[i] : nullptr;
}

const Target* find_target(const std::string& name) {
  for (const Target& t : kTargets)
    if (name == t.name) return &t;
  return nullptr;
}

}  // namespace fuzz
