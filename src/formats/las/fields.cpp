// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/fields.h"

#include <algorithm>
#include <utility>

namespace jalon::las {

namespace {

using enum ElementType;

constexpr double kAngleStep = 0.006;  // degrees, of formats 6-10
constexpr const char* kExactSuffix = "_exact";

Dimension whole(const char* name, ElementType type, int offset, const char* unit,
                const char* meaning) {
  return {{name, type, 1, unit, meaning}, {type, offset}};
}

// A dimension of the core behind the intensity, and where it lies in formats 0-5 and in formats 6-10 (offset -1: not
// there).
struct CoreDimension {
  const char* name;
  ElementType type;
  const char *unit, *meaning;
  Place old_place, extended_place;
};

// ASPRS LAS 1.4 R15, tables 7 and 15.
constexpr CoreDimension kCore[] = {
    {"return_number",
     kUint8,
     "",
     "number of this return, from 1",
     {kUint8, 14, 0, 3},
     {kUint8, 14, 0, 4}},
    {"number_of_returns",
     kUint8,
     "",
     "returns of the pulse",
     {kUint8, 14, 3, 3},
     {kUint8, 14, 4, 4}},
    {"scan_direction",
     kUint8,
     "",
     "1: the mirror moved to the left",
     {kUint8, 14, 6, 1},
     {kUint8, 15, 6, 1}},
    {"edge_of_flight_line",
     kUint8,
     "",
     "1: last point of a scan line",
     {kUint8, 14, 7, 1},
     {kUint8, 15, 7, 1}},
    {"classification", kUint8, "", "ASPRS class", {kUint8, 15, 0, 5}, {kUint8, 16}},
    {"synthetic", kUint8, "", "1: not from a laser pulse", {kUint8, 15, 5, 1}, {kUint8, 15, 0, 1}},
    {"key_point", kUint8, "", "1: model key point", {kUint8, 15, 6, 1}, {kUint8, 15, 1, 1}},
    {"withheld", kUint8, "", "1: deleted", {kUint8, 15, 7, 1}, {kUint8, 15, 2, 1}},
    {"overlap",
     kUint8,
     "",
     "1: in the overlap of two flight lines",
     {kUint8, -1},
     {kUint8, 15, 3, 1}},
    {"scanner_channel", kUint8, "", "scanner head", {kUint8, -1}, {kUint8, 15, 4, 2}},
    {"scan_angle",
     kFloat32,
     "deg",
     "angle of the pulse across track",
     {kInt8, 16},
     {kInt16, 18, 0, 0, kAngleStep}},
    {"user_data", kUint8, "", "", {kUint8, 17}, {kUint8, 17}},
    {"point_source_id", kUint16, "", "flight line or station", {kUint16, 18}, {kUint16, 20}},
};

// In the order of the record.
void add_core(bool extended, std::vector<Dimension>& out) {
  const auto first = static_cast<ptrdiff_t>(out.size());
  for (const CoreDimension& row : kCore) {
    const Place& place = extended ? row.extended_place : row.old_place;
    if (place.offset >= 0) out.push_back({{row.name, row.type, 1, row.unit, row.meaning}, place});
  }
  std::sort(out.begin() + first, out.end(), [](const Dimension& a, const Dimension& b) {
    return std::pair(a.place.offset, a.place.shift) < std::pair(b.place.offset, b.place.shift);
  });
}

}  // namespace

std::vector<Dimension> dimensions(unsigned format_id) {
  const PointFormat& format = *point_format(format_id);
  std::vector<Dimension> out;
  out.push_back(whole("intensity", kUint16, 12, "", "strength of the return"));
  add_core(format.extended, out);
  if (format.gps >= 0) out.push_back(whole("gps_time", kFloat64, format.gps, "s", "GPS time"));
  if (format.rgb >= 0) {
    out.push_back(whole("red", kUint16, format.rgb, "", ""));
    out.push_back(whole("green", kUint16, format.rgb + 2, "", ""));
    out.push_back(whole("blue", kUint16, format.rgb + 4, "", ""));
  }
  if (format.nir >= 0) out.push_back(whole("nir", kUint16, format.nir, "", "near infrared"));
  if (format.wave >= 0) {
    const int at = format.wave;
    out.push_back(whole(kWaveNames[0], kUint8, at, "", "descriptor of the wave packet"));
    out.push_back(whole(kWaveNames[1], kUint64, at + 1, "byte", "where the wave packet lies"));
    out.push_back(whole(kWaveNames[2], kUint32, at + 9, "byte", "length of the wave packet"));
    out.push_back(
        whole(kWaveNames[3], kFloat32, at + 13, "ps", "of the return in the wave packet"));
    out.push_back(whole(kWaveNames[4], kFloat32, at + 17, "", "direction of the wave packet"));
    out.push_back(whole(kWaveNames[5], kFloat32, at + 21, "", "direction of the wave packet"));
    out.push_back(whole(kWaveNames[6], kFloat32, at + 25, "", "direction of the wave packet"));
  }
  return out;
}

std::string exact_name(const std::string& field) { return field + kExactSuffix; }

std::string field_of_exact(unsigned format_id, const std::string& name) {
  for (const Dimension& dimension : dimensions(format_id))
    if (name == exact_name(dimension.field.name)) return dimension.field.name;
  return name;
}

}  // namespace jalon::las
