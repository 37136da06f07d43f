// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Texts that are given to functions: parameters, laws, observations, codes, notes.
#include <unistd.h>

#include "harness.h"
#include "readers.h"

namespace fuzz {

namespace {

/// Two walls and the ground between them, a point every quarter of a metre.
jalon_cloud* make_corner() {
  constexpr int kSide = 16;
  double xyz[3 * kSide * kSide * 3];
  size_t n = 0;
  for (int wall = 0; wall < 3; ++wall)
    for (int i = 0; i < kSide; ++i)
      for (int k = 0; k < kSide; ++k)
        for (int axis = 0; axis < 3; ++axis)
          xyz[n++] = 0.25 * (axis == wall ? 0 : axis == (wall + 1) % 3 ? i : k);
  jalon_cloud* out = nullptr;
  must(jalon_cloud_create(xyz, JALON_FLOAT64, n / 3, 0, 0, &out));
  return out;
}

const jalon_cloud* corner() {
  static jalon_cloud* const cloud = make_corner();
  return cloud;
}

jalon_segmenter* by_codes(const char* method) {
  jalon_segmenter* out = nullptr;
  must(jalon_segmenter_create(method, &out));
  return out;
}

}  // namespace

void read_params(const uint8_t* data, size_t size) {
  static const uint64_t operations = [] {
    uint64_t n = 0;
    must(jalon_params_operation_count(&n));
    return n;
  }();
  if (size == 0) return;
  const std::string text(data + 1, data + size);
  const char* operation = nullptr;
  jalon_params* params = nullptr;
  must(jalon_params_operation_name(data[0] % operations, &operation));
  must(jalon_params_create(operation, &params));
  const char* json = nullptr;
  if (succeeds(jalon_params_from_json(params, text.c_str())))
    must(jalon_params_to_json(params, &json));
  jalon_params_release(params);
}

void read_law(const uint8_t* data, size_t size) {
  const std::string text(data, data + size);
  jalon_noise_law* law = nullptr;
  succeeds(jalon_noise_law_from_json(text.c_str(), &law));
  jalon_noise_law_release(law);
}

void read_network(const uint8_t* data, size_t size) {
  // The covariance of each point costs as much as there are unknowns: seconds of chains that are longer.
  constexpr size_t kMostBytes = 8192;
  if (size > kMostBytes) return;
  const std::string observations = take_text(data, size, '\0');
  const std::string points(data, data + size);
  jalon_network* network = nullptr;
  succeeds(jalon_network_adjust(observations.c_str(), points.empty() ? nullptr : points.c_str(),
                                nullptr, one_thread(), &network));
  jalon_network_release(network);
}

void read_codes(const uint8_t* data, size_t size) {
  static jalon_segmenter* const methods[] = {by_codes("survey_codes"), by_codes("target_codes")};
  if (size == 0) return;
  const jalon_segmenter* const method = methods[data[0] % 2];
  ++data, --size;
  const std::string codes = take_text(data, size, '\0');
  const std::string table(data, data + size);
  jalon_segmenter* own = nullptr;
  jalon_params* params = nullptr;
  jalon_segmentation* segmentation = nullptr;
  must(jalon_segmenter_copy(method, &own));
  must(jalon_segmenter_params(own, &params));
  if (succeeds(jalon_params_set_string(params, "codes", codes.c_str())) &&
      succeeds(jalon_params_set_string(params, "table", table.c_str())))
    succeeds(jalon_segmenter_run(own, corner(), one_thread(), &segmentation));
  jalon_segmentation_release(segmentation);
  jalon_params_release(params);
  jalon_segmenter_release(own);
}

void read_notes(const uint8_t* data, size_t size) {
  static jalon_segmentation* const segmentation = [] {
    jalon_segmentation* out = nullptr;
    must(jalon_segmentation_start(corner(), one_thread(), &out));
    return out;
  }();
  const std::string notes(data, data + size), path = place_of("json");
  succeeds(jalon_report_write_json(segmentation, nullptr, notes.c_str(), path.c_str(), nullptr,
                                   one_thread()));
  ::unlink(path.c_str());
}

}  // namespace fuzz
