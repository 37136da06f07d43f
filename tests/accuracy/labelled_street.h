// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Real street facades whose doors and windows were labelled by hand (columns x y z intensity class instance).
#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <string>

#include "base/text_number.h"
#include "cloud/cloud.h"
#include "wall_truth.h"

namespace jalon::test {

enum StreetClass { kStreetWall = 1, kStreetDoor = 2, kStreetWindow = 3 };

struct LabelledStreet {
  CloudPtr cloud;
  std::vector<std::array<int, 2>> labels;  ///< class and instance of each point

  /// Empty where the folder is absent.
  explicit LabelledStreet(const std::string& name) {
    std::ifstream file(std::string(JALON_SHARED_DATA) + "/facades/" + name);
    std::vector<Vec3> points;
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      std::array<double, 6> values{};
      size_t from = 0;
      for (double& value : values) {
        const size_t to = std::min(line.find_first_of(" \r", from), line.size());
        if (!parse_number(std::string_view(line).substr(from, to - from), value)) return;
        from = to + 1;
      }
      points.push_back({values[0], values[1], values[2]});
      labels.push_back({static_cast<int>(values[4]), static_cast<int>(values[5])});
    }
    if (points.empty()) return;
    Buffer<double> xyz(3 * points.size());
    for (size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
    cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  }

  /// The rectangle of each door and window in the wall's axes, from 1 % to 99 % of its points along each axis, where it
  /// is as large as this.
  std::vector<Drawn> openings(const WallAxes& axes, double least_m2) const {
    std::map<std::array<int, 2>, std::array<std::vector<double>, 2>> places;
    for (size_t i = 0; i < labels.size(); ++i) {
      if (labels[i][0] != kStreetDoor && labels[i][0] != kStreetWindow) continue;
      const Vec2 p = axes.project(cloud->point(i));
      places[labels[i]][0].push_back(p.u);
      places[labels[i]][1].push_back(p.v);
    }
    std::vector<Drawn> out;
    for (auto& [label, place] : places) {
      std::array<Vec2, 2> range;  // 1 % and 99 % of u, then of v
      for (size_t a = 0; a < 2; ++a) {
        std::sort(place[a].begin(), place[a].end());
        const auto last = static_cast<double>(place[a].size() - 1);
        range[a] = {place[a][static_cast<size_t>(0.01 * last + 0.5)],
                    place[a][static_cast<size_t>(0.99 * last + 0.5)]};
      }
      if ((range[0].v - range[0].u) * (range[1].v - range[1].u) < least_m2) continue;
      Drawn& opening = out.emplace_back();
      opening.part_class =
          (label[0] == kStreetDoor ? "door " : "window ") + std::to_string(label[1]);
      opening.corners = {{range[0].u, range[1].u},
                         {range[0].v, range[1].u},
                         {range[0].v, range[1].v},
                         {range[0].u, range[1].v}};
      opening.region = {{{opening.corners}}};
    }
    return out;
  }
};

}  // namespace jalon::test
