// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las_fields.h"

namespace jalon::las {

namespace {

using enum ElementType;

constexpr double kAngleStep = 0.006;  // degrees, of formats 6-10

Dimension whole(const char* name, ElementType type, int offset, const char* unit,
                const char* meaning) {
  return {{name, type, 1, unit, meaning}, {type, offset}};
}
Dimension bits(const char* name, int offset, int shift, int count, const char* meaning) {
  return {{name, kUint8, 1, "", meaning}, {kUint8, offset, shift, count}};
}

void add_core(std::vector<Dimension>& out) {
  out.push_back(bits("return_number", 14, 0, 3, "number of this return, from 1"));
  out.push_back(bits("number_of_returns", 14, 3, 3, "returns of the pulse"));
  out.push_back(bits("scan_direction", 14, 6, 1, "1: the mirror moved to the left"));
  out.push_back(bits("edge_of_flight_line", 14, 7, 1, "1: last point of a scan line"));
  out.push_back(bits("classification", 15, 0, 5, "ASPRS class"));
  out.push_back(bits("synthetic", 15, 5, 1, "1: not from a laser pulse"));
  out.push_back(bits("key_point", 15, 6, 1, "1: model key point"));
  out.push_back(bits("withheld", 15, 7, 1, "1: deleted"));
  out.push_back(
      {{"scan_angle", kFloat32, 1, "deg", "angle of the pulse across track"}, {kInt8, 16}});
  out.push_back(whole("user_data", kUint8, 17, "", ""));
  out.push_back(whole("point_source_id", kUint16, 18, "", "flight line or station"));
}

void add_extended_core(std::vector<Dimension>& out) {
  out.push_back(bits("return_number", 14, 0, 4, "number of this return, from 1"));
  out.push_back(bits("number_of_returns", 14, 4, 4, "returns of the pulse"));
  out.push_back(bits("synthetic", 15, 0, 1, "1: not from a laser pulse"));
  out.push_back(bits("key_point", 15, 1, 1, "1: model key point"));
  out.push_back(bits("withheld", 15, 2, 1, "1: deleted"));
  out.push_back(bits("overlap", 15, 3, 1, "1: in the overlap of two flight lines"));
  out.push_back(bits("scanner_channel", 15, 4, 2, "scanner head"));
  out.push_back(bits("scan_direction", 15, 6, 1, "1: the mirror moved to the left"));
  out.push_back(bits("edge_of_flight_line", 15, 7, 1, "1: last point of a scan line"));
  out.push_back(whole("classification", kUint8, 16, "", "ASPRS class"));
  out.push_back(whole("user_data", kUint8, 17, "", ""));
  out.push_back({{"scan_angle", kFloat32, 1, "deg", "angle of the pulse across track"},
                 {kInt16, 18, 0, 0, kAngleStep}});
  out.push_back(whole("point_source_id", kUint16, 20, "", "flight line or station"));
}

}  // namespace

std::vector<Dimension> dimensions(unsigned format_id) {
  const PointFormat& format = *point_format(format_id);
  std::vector<Dimension> out;
  out.push_back(whole("intensity", kUint16, 12, "", "strength of the return"));
  format.extended ? add_extended_core(out) : add_core(out);
  if (format.gps >= 0) out.push_back(whole("gps_time", kFloat64, format.gps, "s", "GPS time"));
  if (format.rgb >= 0) {
    out.push_back(whole("red", kUint16, format.rgb, "", ""));
    out.push_back(whole("green", kUint16, format.rgb + 2, "", ""));
    out.push_back(whole("blue", kUint16, format.rgb + 4, "", ""));
  }
  if (format.nir >= 0) out.push_back(whole("nir", kUint16, format.nir, "", "near infrared"));
  if (format.wave >= 0) {
    const int at = format.wave;
    out.push_back(whole("wavepacket_index", kUint8, at, "", "descriptor of the wave packet"));
    out.push_back(
        whole("wavepacket_offset", kUint64, at + 1, "byte", "where the wave packet lies"));
    out.push_back(whole("wavepacket_size", kUint32, at + 9, "byte", "length of the wave packet"));
    out.push_back(whole("return_point_wave_location", kFloat32, at + 13, "ps",
                        "of the return in the wave packet"));
    out.push_back(whole("x_t", kFloat32, at + 17, "", "direction of the wave packet"));
    out.push_back(whole("y_t", kFloat32, at + 21, "", "direction of the wave packet"));
    out.push_back(whole("z_t", kFloat32, at + 25, "", "direction of the wave packet"));
  }
  return out;
}

}  // namespace jalon::las
