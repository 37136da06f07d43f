// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/methods.h"

#include <doctest/doctest.h>

#include "base/settings_json.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kRansac =
    "{\"min_points\": 70, \"sampling\": \"global\", \"draws\": 900, "
    "\"primitives\": \"planes+cylinders\", "
    "\"orientation_order\": \"vertical parallel\", \"facade_frame\": false}";
constexpr const char* kGrowing =
    "{\"normals\": \"field\", \"k\": 20, \"gap_m\": 0.3, \"merge_gap_m\": 0.1}";

}  // namespace

TEST_CASE("segment_methods__settings_tell_the_parameters_they_came_from") {
  for (const SegmentMethod& method : segment_methods()) {
    CAPTURE(method.owner);
    const bool ransac = std::string(method.name) == "ransac";
    for (const char* json : {"{}", ransac ? kRansac : kGrowing}) {
      ParamSet params(method.owner, method.rows());
      params.from_json(json);
      const std::string told =
          ransac ? settings_json(method.rows(), settings_from<RansacSettings>(params))
                 : settings_json(method.rows(), settings_from<GrowingSettings>(params));
      CHECK(told == params.to_json());
    }
  }
}

TEST_CASE("segment_methods__result_tells_the_parameters_of_its_method") {
  const CloudPtr cloud = cloud_of(facade_scene(200, 1).points);
  for (const SegmentMethod& method : segment_methods()) {
    CAPTURE(method.owner);
    const ParamSet params(method.owner, method.rows());
    Task task;
    CHECK(method.run(cloud, params, task).parameters_json == params.to_json());
  }
}
