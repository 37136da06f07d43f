// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/methods.h"

#include <doctest/doctest.h>

#include "base/settings_json.h"
#include "segment/codes_methods.h"
#include "segment/hough_settings.h"
#include "segment/profile_settings.h"
#include "segment/raster_settings.h"
#include "segment/scan_line_settings.h"
#include "segment/split_settings.h"
#include "segment/triangle_settings.h"
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
constexpr const char* kRaster =
    "{\"projection\": \"given\", \"direction\": [1, 0, 0], \"returns\": \"median\", "
    "\"grey_bits\": 8, \"seed_pixels\": 5}";
constexpr const char* kProfiles =
    "{\"axes\": \"direction\", \"direction\": [0, 1, 0], \"step_m\": 0.2, \"thickness_m\": 0.1, "
    "\"gap_m\": 0.3, \"line_tolerance_m\": 0.01, \"angle_rad\": 0.2}";
constexpr const char* kTriangles =
    "{\"network\": \"grid\", \"search_m\": 0.2, \"angle_rad\": 0.3, \"k\": 12, \"pixel_m\": 0.1}";
constexpr const char* kSplit = "{\"angle_rad\": 0.3, \"least_cell_m\": 0.1}";
constexpr const char* kHough =
    "{\"angle_step_rad\": 0.1, \"distance_step_m\": 0.1, \"votes\": \"all\", \"voters\": 5000}";
constexpr const char* kScanLines =
    "{\"line_tolerance_m\": 0.01, \"gap_m\": 0.5, \"line_points\": 6}";
constexpr const char* kTargetCodes = "{\"codes\": \"1;0;0;0;1\", \"wall_draws\": 40}";
constexpr const char* kSurveyCodes =
    "{\"codes\": \"1;0;0;0;360\\n2;1;1;1;360\", \"classes\": \"asprs\", \"inward_m\": 0.3}";

}  // namespace

TEST_CASE("segment_methods__settings_tell_the_parameters_they_came_from") {
  for (const SegmentMethod& method : segment_methods()) {
    CAPTURE(method.owner);
    const std::string name = method.name;
    const auto check = [&]<class Settings>(const char* some_set) {
      for (const char* json : {"{}", some_set}) {
        ParamSet params(method.owner, method.rows());
        params.from_json(json);
        CHECK(settings_json(method.rows(), settings_from<Settings>(params)) == params.to_json());
      }
    };
    if (name == "ransac") check.operator()<RansacSettings>(kRansac);
    if (name == "region_growing") check.operator()<GrowingSettings>(kGrowing);
    if (name == "raster_growing") check.operator()<RasterSettings>(kRaster);
    if (name == "profiles") check.operator()<ProfileSettings>(kProfiles);
    if (name == "triangle_growing") check.operator()<TriangleSettings>(kTriangles);
    if (name == "split_merge") check.operator()<SplitSettings>(kSplit);
    if (name == "hough") check.operator()<HoughSettings>(kHough);
    if (name == "scan_lines") check.operator()<ScanLineSettings>(kScanLines);
    if (name == "target_codes") check.operator()<TargetCodeSettings>(kTargetCodes);
    if (name == "survey_codes") check.operator()<SurveyCodeSettings>(kSurveyCodes);
  }
}

TEST_CASE("segment_methods__result_tells_the_parameters_of_its_method") {
  auto cloud = std::make_shared<Cloud>(*cloud_of(facade_scene(200, 1).points));
  Station station;  // scan_lines asks for one
  station.has_pose = true;
  station.pose.m[3] = 5;
  station.pose.m[7] = -12;
  station.count = cloud->size();
  cloud->stations.push_back(station);
  for (const SegmentMethod& method : segment_methods()) {
    CAPTURE(method.owner);
    const ParamSet params(method.owner, method.rows());
    Task task;
    CHECK(method.run(cloud, params, task).parameters_json == params.to_json());
  }
}
