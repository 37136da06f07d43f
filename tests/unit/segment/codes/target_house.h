// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "segment/codes_methods.h"
#include "unit/segment/scenes.h"

namespace jalon::test {

/// A front wall of 10 x 3 m on y = 0 with a door, two windows, a gutter before it, ground and a strip of roof above a
/// gap; what each point is: the classes of the text.
struct TargetHouse {
  std::vector<Vec3> points;
  std::vector<uint8_t> truth;
  std::string targets =
      "1;0.5;0;0.4;1\n2;1.5;0.12;0.5;2\n3;4.5;0.2;1.3;3\n4;8.5;0.2;1.3;3\n5;9.7;-0.19;1.1;4\n"
      "6;5;-2;1;99\n";

  explicit TargetHouse(double door_depth = 0.12) {
    const auto within = [](double a, double low, double high) { return a > low && a < high; };
    for (int i = 0; i < 500; ++i)
      for (int k = 0; k < 150; ++k) {
        const double x = 0.01 + 0.02 * i, z = 0.01 + 0.02 * k;
        if (within(x, 1, 2) && z < 2) add({x, door_depth, z}, 2);
        else if ((within(x, 4, 6) || within(x, 7, 9)) && within(z, 1, 2)) add({x, 0.2, z}, 3);
        else add({x, 0.002 * std::fabs(std::sin(31.0 * x)), z}, 1);
      }
    for (int i = 0; i < 200; ++i) {
      for (int k = 0; k < 5; ++k) add({0.05 * i, 0, 3.4 + 0.02 * k}, 0);
      for (int k = 1; k < 60; ++k) add({0.05 * i, -0.05 * k, 0}, 0);
    }
    for (int k = 0; k < 187; ++k)
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / 24;
        add({9.7 + 0.04 * std::cos(angle), -0.15 + 0.04 * std::sin(angle), 0.02 + 0.015 * k}, 4);
      }
  }
  void add(const Vec3& p, uint8_t what) {
    points.push_back(p);
    truth.push_back(what);
  }

  Segmentation coded(const std::string& list, const Vec3& shift = {}, unsigned threads = 0) const {
    TargetCodeSettings settings;
    settings.input.codes = list;
    Task task(Task::Hooks{.threads = threads});
    return segment_by_target_codes(cloud_of(points, shift), settings, task);
  }
  /// Points of a class that were given another class.
  size_t confused(const Segmentation& s, uint8_t truly, uint8_t given) const {
    const auto classes = s.cloud->fields.require("classification").values<uint8_t>();
    size_t count = 0;
    for (size_t i = 0; i < truth.size(); ++i) count += truth[i] == truly && classes[i] == given;
    return count;
  }
  size_t of(uint8_t what) const {
    return static_cast<size_t>(std::count(truth.begin(), truth.end(), what));
  }
};

/// The text of the notes' warning about an object; "" without any.
inline std::string warned(const Segmentation& s, const std::string& object) {
  const auto notes = nlohmann::json::parse(s.notes_json);
  for (const auto& w : notes["warnings"])
    if (w["object"] == object) return w["text"];
  return "";
}

}  // namespace jalon::test
