// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/code_table.h"

// The two code tables of the master's thesis on feature codes for terrestrial laser scanning (University of Liege 2021,
// tables 2 and 3). Buildings are 300 to 305 in its survey and 100 to 105 in its table: both are known. Window 362 is in
// its survey alone; 415, a gutter with bends, is the linkage that it describes and gives no number.
namespace jalon {

const char* const kTargetCodeTable = R"({
 "name": "targets",
 "separator": "+",
 "codes": [
  {"from": 1, "name": "wall", "geometry": "wall_target", "class": 1},
  {"from": 2, "name": "door", "geometry": "door_target", "class": 2, "distance_m": 0.04},
  {"from": 3, "name": "windows", "geometry": "window_target", "class": 3, "distance_m": 0.04},
  {"from": 4, "name": "gutter", "geometry": "gutter_target", "class": 4},
  {"from": 99, "name": "target", "geometry": "ignored"}
 ]
})";

const char* const kSurveyCodeTable = R"({
 "name": "survey",
 "separator": "+",
 "modifiers": {"start": 2, "next": 4, "curve": 3, "close": 0, "offset": 8},
 "codes": [
  {"from": 100, "to": 105, "name": "building", "geometry": "prism", "class": 1},
  {"from": 300, "to": 305, "name": "building", "geometry": "prism", "class": 1},
  {"from": 350, "name": "door", "geometry": "two_corners", "class": 2, "distance_m": 0.04,
   "hinged": true},
  {"from": 351, "name": "door", "geometry": "three_points", "class": 2, "distance_m": 0.04,
   "hinged": true},
  {"from": 352, "name": "door", "geometry": "four_points", "class": 2, "distance_m": 0.04,
   "hinged": true},
  {"from": 355, "name": "door", "geometry": "outline", "class": 2, "distance_m": 0.04,
   "hinged": true},
  {"from": 360, "name": "window", "geometry": "two_corners", "class": 3, "distance_m": 0.03},
  {"from": 361, "name": "window", "geometry": "three_points", "class": 3, "distance_m": 0.03},
  {"from": 362, "name": "window", "geometry": "four_points", "class": 3, "distance_m": 0.03},
  {"from": 365, "name": "window", "geometry": "outline", "class": 3, "distance_m": 0.03},
  {"from": 408, "name": "gutter", "geometry": "centre", "class": 4},
  {"from": 409, "name": "gutter", "geometry": "edge", "class": 4},
  {"from": 410, "name": "gutter", "geometry": "top", "class": 4},
  {"from": 415, "name": "gutter", "geometry": "pipe", "class": 4},
  {"from": 921, "name": "station", "geometry": "ignored"},
  {"from": 999, "name": "reference point", "geometry": "ignored"}
 ]
})";

}  // namespace jalon
