// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/polygon_input.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Corners = std::vector<std::vector<double>>;
using Axis3 = std::array<double, 3>;

Failure unfit(const std::string& source, const std::string& why) {
  return {JALON_ERROR_INVALID_ARGUMENT, source + ": " + why};
}

Axis3 step_of(const std::vector<double>& a, const std::vector<double>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Axis3 cross_of(const Axis3& a, const Axis3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot_of(const Axis3& a, const Axis3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Twice the area of a polygon as a vector along its normal (Newell), about its first corner.
Axis3 area_vector(const Corners& corners) {
  Axis3 sum{};
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Axis3 more =
        cross_of(step_of(corners[i], corners[0]), step_of(corners[i + 1], corners[0]));
    for (size_t k = 0; k < 3; ++k) sum[k] += more[k];
  }
  return sum;
}

CutPolygon in_plan(const Corners& corners) {
  CutPolygon out{{}, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}};
  for (const auto& corner : corners) out.uv.insert(out.uv.end(), corner.begin(), corner.end());
  return out;
}

// Axes: u level, w the normal on whose side the corners run anticlockwise.
CutPolygon in_space(const Corners& corners, const std::string& source) {
  Axis3 w = area_vector(corners);
  const double size = std::sqrt(dot_of(w, w));
  double longest = 0;
  for (const auto& corner : corners) {
    const Axis3 d = step_of(corner, corners[0]);
    longest = std::max(longest, std::sqrt(dot_of(d, d)));
  }
  constexpr double kFlat = 1e-6;  // of the square of its length: corners on one line
  if (!(size > kFlat * longest * longest)) throw unfit(source, "the corners lie on one line");
  for (double& x : w) x /= size;
  Axis3 u = std::fabs(w[2]) < 0.999 ? Axis3{-w[1], w[0], 0} : Axis3{1, 0, 0};
  const double along = dot_of(u, w);
  for (size_t k = 0; k < 3; ++k) u[k] -= along * w[k];
  const double length = std::sqrt(dot_of(u, u));
  for (double& x : u) x /= length;
  const Axis3 v = cross_of(w, u);
  CutPolygon out{{}, {}};
  // Heights count from the mean of the corners' own.
  double height = 0;
  const Axis3 origin{corners[0][0], corners[0][1], corners[0][2]};
  for (const auto& corner : corners) {
    const Axis3 d = step_of(corner, corners[0]);
    out.uv.insert(out.uv.end(), {dot_of(u, d), dot_of(v, d)});
    height += dot_of(w, d) / static_cast<double>(corners.size());
  }
  const Axis3 rows[3] = {u, v, w};
  for (size_t r = 0; r < 3; ++r) {
    for (size_t k = 0; k < 3; ++k) out.T_prism_world.m[4 * r + k] = rows[r][k];
    out.T_prism_world.m[4 * r + 3] = -dot_of(rows[r], origin) - (r == 2 ? height : 0);
  }
  return out;
}

CutPolygon polygon_of(const Corners& corners, const std::string& source) {
  const size_t numbers = corners.empty() ? 0 : corners[0].size();
  for (const auto& corner : corners)
    if (corner.size() != numbers || (numbers != 2 && numbers != 3))
      throw unfit(source, "every corner needs two numbers (x y, in plan) or three (x y z)");
  if (corners.size() < 3)
    throw unfit(source, std::to_string(corners.size()) + " corners; a polygon needs 3");
  return numbers == 2 ? in_plan(corners) : in_space(corners, source);
}

}  // namespace

CutPolygon parse_cut_polygon(const std::string& text) {
  Corners corners;
  for (size_t at = 0; at < text.size();) {
    const size_t stop = std::min(text.find(';', at), text.size());
    const std::string corner = text.substr(at, stop - at);
    size_t end = 0;
    std::vector<double> numbers = leading_numbers(corner, end);
    if (end != corner.size())
      throw unfit("--polygon", "\"" + corner.substr(end) + "\" is no number");
    if (!numbers.empty()) corners.push_back(std::move(numbers));
    at = stop + 1;
  }
  return polygon_of(corners, "--polygon");
}

CutPolygon read_cut_polygon(const std::string& path) {
  Corners corners;
  for (NumberLine& line : read_number_lines(path)) corners.push_back(std::move(line.numbers));
  return polygon_of(corners, path);
}

}  // namespace jalon::cli
