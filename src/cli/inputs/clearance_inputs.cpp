// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/clearance_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::json;
using Vector = std::array<double, 3>;

[[noreturn]] void malformed(const std::string& path, const std::string& why) {
  throw Failure{JALON_ERROR_FORMAT, path + ": " + why};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// False for no direction at all.
bool normalise(Vector& v) {
  const double n = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(n > 0) || !std::isfinite(n)) return false;
  for (double& c : v) c /= n;
  return true;
}

jalon_transform pose_of(const Vector& x, const Vector& y, const Vector& z, const Vector& at) {
  jalon_transform t;
  for (size_t i = 0; i < 3; ++i) {
    t.m[4 * i] = x[i], t.m[4 * i + 1] = y[i], t.m[4 * i + 2] = z[i], t.m[4 * i + 3] = at[i];
  }
  return t;
}

// The frame whose z is given: any turn about it serves a cylinder.
jalon_transform along(Vector z, const Vector& at) {
  if (!normalise(z)) z = {0, 0, 1};
  Vector x = std::abs(z[0]) < 0.9 ? cross({1, 0, 0}, z) : cross({0, 1, 0}, z);
  normalise(x);
  return pose_of(x, cross(z, x), z, at);
}

[[noreturn]] void refuse_piece(const std::string& why) { throw Failure{JALON_ERROR_FORMAT, why}; }

// name: of the entry, for the message.
Vector three_of(const Json& value, const char* name) {
  const bool is_three = value.is_array() && value.size() == 3 &&
                        std::ranges::all_of(value, [](const Json& c) { return c.is_number(); });
  if (!is_three) refuse_piece("\"" + std::string(name) + "\" needs three numbers");
  return value.get<Vector>();
}

double number_of(const Json& piece, const char* name) {
  const auto found = piece.find(name);
  if (found == piece.end() || !found->is_number())
    refuse_piece("\"" + std::string(name) + "\" needs a number");
  return found->get<double>();
}

void add_hull(const Json& points, Gauge& gauge, jalon_gauge_piece& piece) {
  if (!points.is_array()) refuse_piece("\"points\" needs an array of points");
  piece.kind = JALON_GAUGE_HULL, piece.first = gauge.hull_points.size() / 3;
  for (const Json& point : points)
    for (const double c : three_of(point, "points")) gauge.hull_points.push_back(c);
  piece.count = points.size();
}

void add_piece(const Json& json, Gauge& gauge) {
  if (!json.is_object()) refuse_piece("it is no object");
  jalon_gauge_piece piece{};
  const std::string type = json.contains("type") && json["type"].is_string() ? json["type"] : "";
  const Vector at = json.contains("at") ? three_of(json["at"], "at") : Vector{0, 0, 0};
  piece.frame = json.contains("axis") ? along(three_of(json["axis"], "axis"), at)
                                      : pose_of({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, at);
  if (type == "box") {
    const Vector size = three_of(json.value("size", Json()), "size");
    piece.kind = JALON_GAUGE_BOX, piece.size = {size[0], size[1], size[2]};
  } else if (type == "sphere") {
    piece.kind = JALON_GAUGE_SPHERE, piece.size.x = number_of(json, "radius");
  } else if (type == "cylinder") {
    piece.kind = JALON_GAUGE_CYLINDER;
    piece.size = {number_of(json, "radius"), 0, number_of(json, "length")};
  } else if (type == "hull") {
    add_hull(json.value("points", Json()), gauge, piece);
  } else {
    refuse_piece("\"" + type + "\" is no type of piece: box, sphere, cylinder, hull");
  }
  gauge.pieces.push_back(piece);
}

jalon_transform turned_pose(const double* v, const std::string& path) {
  double x = v[3], y = v[4], z = v[5], w = v[6];
  const double n = std::sqrt(x * x + y * y + z * z + w * w);
  if (!(n > 0)) malformed(path, "a quaternion of zeros");
  x /= n, y /= n, z /= n, w /= n;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), v[0],
           2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), v[1],
           2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), v[2]}};
}

// x along the path, y level, z up.
std::vector<jalon_transform> along_path(const std::vector<Vector>& places) {
  std::vector<jalon_transform> poses;
  Vector x{1, 0, 0}, y{0, 1, 0};
  for (size_t i = 0; i < places.size(); ++i) {
    Vector ahead = minus(places[std::min(i + 1, places.size() - 1)], places[i > 0 ? i - 1 : 0]);
    if (normalise(ahead)) x = ahead;
    Vector level = cross({0, 0, 1}, x);
    if (normalise(level)) y = level;  // straight up: as it was
    poses.push_back(pose_of(x, y, cross(x, y), places[i]));
  }
  return poses;
}

}  // namespace

Gauge read_gauge(const std::string& path) {
  const Json json = Json::parse(read_text_file(path), nullptr, false);
  if (!json.is_object() || !json.contains("pieces") || !json["pieces"].is_array())
    malformed(path, "no JSON object with an array \"pieces\"");
  Gauge gauge;
  for (const Json& piece : json["pieces"]) try {
      add_piece(piece, gauge);
    } catch (const Failure& failure) {
      malformed(path, "piece " + std::to_string(gauge.pieces.size()) + ": " + failure.text);
    }
  return gauge;
}

std::vector<jalon_transform> read_trajectory(const std::string& path) {
  std::vector<jalon_transform> poses;
  std::vector<Vector> places;
  size_t width = 0;
  for (const auto& [line, v] : read_number_lines(path)) {
    if (width == 0) width = v.size();
    if (v.size() != width || (width != 3 && width != 7 && width != 8 && width != 12))
      malformed(path + ", line " + std::to_string(line),
                std::to_string(v.size()) + " numbers; all lines have 3, or 7, 8 or 12");
    if (width == 3) places.push_back({v[0], v[1], v[2]});
    if (width == 7 || width == 8) poses.push_back(turned_pose(v.data() + (width - 7), path));
    if (width == 12) {
      jalon_transform pose;
      std::copy(v.begin(), v.end(), pose.m);
      poses.push_back(pose);
    }
  }
  if (width == 3) poses = along_path(places);
  if (poses.empty()) malformed(path, "no line of numbers in it, so no pose");
  return poses;
}

}  // namespace jalon::cli
