// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Fills against what an eye has to tell from them: order by lightness, sides by hue, text by contrast (WCAG 2.1).
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "report/elevation/colours.h"
#include "report/sheet/svg_parts.h"

using namespace jalon;

namespace {

std::array<double, 3> channels_of(const std::string& colour) {
  REQUIRE(colour.size() == 7);
  REQUIRE(colour[0] == '#');
  std::array<double, 3> out{};
  for (size_t k = 0; k < 3; ++k) out[k] = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16);
  return out;
}

// Relative luminance of sRGB.
double luminance(const std::string& colour) {
  const auto channels = channels_of(colour);
  const double weights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double c = channels[k] / 255;
    sum += weights[k] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

// n groups: `front` in front of the main plane, it, and the others behind, as the drawing ranks them.
ElevationFaces groups_on_sides(size_t front, size_t n) {
  ElevationFaces out;
  for (size_t i = 0; i < n; ++i) {
    DepthGroup group;
    group.side = i < front ? -1 : i == front ? 0 : 1;
    group.rank = i < front ? front - 1 - i : i == front ? 0 : i - front - 1;
    out.groups.push_back(group);
  }
  return out;
}

}  // namespace

TEST_CASE("colours__of_depth_grow_darker_from_near_to_far_and_differ") {
  for (size_t n = 1; n <= kMaxDepthGroups; ++n) {
    const ElevationFaces faces = groups_on_sides(0, n);
    for (size_t i = 1; i < n; ++i) {
      CAPTURE(n);
      CAPTURE(i);
      CHECK(luminance(group_colour(faces, i, ElevationColours::kDepth)) <
            0.95 * luminance(group_colour(faces, i - 1, ElevationColours::kDepth)));
    }
  }
}

TEST_CASE("colours__of_sides_are_red_before_and_green_behind_stronger_outward") {
  for (size_t front = 0; front < kMaxDepthGroups; ++front) {
    const ElevationFaces faces = groups_on_sides(front, kMaxDepthGroups);
    std::set<std::string> seen;
    for (size_t i = 0; i < kMaxDepthGroups; ++i) {
      CAPTURE(front);
      CAPTURE(i);
      const std::string colour = group_colour(faces, i, ElevationColours::kSides);
      seen.insert(colour);
      const auto [red, green, blue] = channels_of(colour);
      if (i < front) CHECK((red > green && red > blue));
      if (i > front) CHECK((green > red && green > blue));
      if (i == front || i + 1 == kMaxDepthGroups) continue;
      const std::string next = group_colour(faces, i + 1, ElevationColours::kSides);
      if (i + 1 == front) continue;
      CHECK((luminance(colour) < luminance(next)) == (i < front));
    }
    CHECK(seen.size() == kMaxDepthGroups);
  }
}

TEST_CASE("colours__text_on_every_fill_can_be_read") {
  std::vector<std::string> fills{kSlantedFill};
  for (const auto colours :
       {ElevationColours::kSides, ElevationColours::kDepth, ElevationColours::kNone})
    for (size_t n = 1; n <= kMaxDepthGroups; ++n)
      for (size_t i = 0; i < n; ++i)
        fills.push_back(group_colour(groups_on_sides(n / 2, n), i, colours));
  for (const std::string& fill : fills) {
    CAPTURE(fill);
    CHECK(contrast(fill, is_dark(fill) ? "#ffffff" : kInk) >= 3);  // large and graphic text
  }
  CHECK(group_colour(groups_on_sides(1, 3), 2, ElevationColours::kNone) == "#ffffff");
  CHECK(is_dark("#000000"));
  CHECK(!is_dark("#ffffff"));
  CHECK(!is_dark("none"));
}

TEST_CASE("colours__of_windows_doors_and_other_openings_differ_on_paper") {
  const std::set<std::string> lines{opening_colour("window"), opening_colour("door"),
                                    opening_colour("opening")};
  CHECK(lines.size() == 3);
  for (const std::string& line : lines) CHECK(contrast(line, "#ffffff") >= 4.5);
  CHECK(std::string(opening_colour("gate")) == opening_colour("opening"));
}
