// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What is done with clouds that nobody has measured: points in one place or at the end of all numbers.
#include <iterator>

#include "harness.h"
#include "readers.h"

namespace fuzz {

namespace {

constexpr uint64_t kMostPoints = 500;  // the rest is time

template <auto kReduce>
void reduce(const jalon_cloud* cloud) {
  jalon_cloud* out = nullptr;
  succeeds(kReduce(cloud, nullptr, one_thread(), &out, nullptr));
  jalon_cloud_release(out);
}

/// On a copy: these add fields.
template <auto kCompute>
void compute(const jalon_cloud* cloud) {
  jalon_cloud* copy = nullptr;
  must(jalon_cloud_copy(cloud, &copy));
  succeeds(kCompute(copy, nullptr, one_thread()));
  jalon_cloud_release(copy);
}

jalon_status connect(jalon_cloud* cloud, const jalon_params* options, jalon_task* task) {
  uint64_t components = 0;
  return jalon_cloud_compute_components(cloud, options, task, &components);
}

void compare_with_itself(const jalon_cloud* cloud) {
  static jalon_comparer* const comparer = [] {
    jalon_comparer* out = nullptr;
    must(jalon_comparer_create("distance", &out));
    return out;
  }();
  jalon_comparison* out = nullptr;
  succeeds(jalon_comparer_run(comparer, cloud, cloud, one_thread(), &out));
  jalon_comparison_release(out);
}

void segment(const jalon_cloud* cloud, size_t method) {
  const char* const* names = nullptr;
  uint64_t count = 0;
  must(jalon_segmenter_methods(&names, &count));
  jalon_segmenter* segmenter = nullptr;
  jalon_segmentation* out = nullptr;
  must(jalon_segmenter_create(names[method % count], &segmenter));
  succeeds(jalon_segmenter_run(segmenter, cloud, one_thread(), &out));
  jalon_segmentation_release(out);
  jalon_segmenter_release(segmenter);
}

constexpr void (*kOperations[])(const jalon_cloud*) = {reduce<jalon_cloud_subsample>,
                                                       reduce<jalon_cloud_remove_outliers>,
                                                       compute<jalon_cloud_compute_normals>,
                                                       compute<jalon_cloud_compute_features>,
                                                       compute<connect>,
                                                       compare_with_itself};

}  // namespace

void run_clouds(const uint8_t* data, size_t size) {
  if (size == 0) return;
  jalon_cloud* cloud = nullptr;
  uint64_t points = 0;
  if (!succeeds(jalon_cloud_from_bytes(data + 1, size - 1, one_thread(), &cloud))) return;
  must(jalon_cloud_count(cloud, &points));
  if (points <= kMostPoints) {
    if (data[0] < std::size(kOperations)) kOperations[data[0]](cloud);
    else segment(cloud, data[0] - std::size(kOperations));
  }
  jalon_cloud_release(cloud);
}

}  // namespace fuzz
