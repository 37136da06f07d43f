// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "segment/codes_methods.h"
#include "unit/segment/scenes.h"

namespace jalon::test {

inline const char* const kCodedHouse =
    "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n"
    "6;1;0.1;0;350\n7;2;0.1;2;350\n8;5;0.2;1;360\n9;7;0.2;2;360\n"
    "10;-0.05;4;0;408\n11;-0.09;4;0;409\n12;-0.05;4;2.8;410\n";

/// The front wall and its door, by a survey's codes.
inline Segmentation coded_house(const std::string& codes = kCodedHouse) {
  std::vector<Vec3> points;
  for (double x = 0.05; x < 10; x += 0.1)
    for (double z = 0.05; z < 3; z += 0.1) points.push_back({x, 0, z});
  for (double x = 1.125; x < 2; x += 0.1)
    for (double z = 0.125; z < 2; z += 0.2) points.push_back({x, 0.1, z});
  SurveyCodeSettings settings;
  settings.input.codes = codes;
  Task task;
  return segment_by_survey_codes(cloud_of(points), settings, task);
}

}  // namespace jalon::test
