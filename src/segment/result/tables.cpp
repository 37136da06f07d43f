// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/tables.h"

#include <algorithm>
#include <array>

#include "base/numbers.h"

namespace jalon {

namespace {

// A column of one row a segment; value(segment, component).
template <class T, class F>
ColumnPtr segment_column(const Segmentation& s, const char* name, uint32_t components,
                         const char* unit, const char* meaning, F&& value) {
  FieldInfo info{name, element_type_of<T>(), components, unit, meaning};
  auto column = std::make_shared<Column>(std::move(info), s.segments.size());
  const auto out = column->template values<T>();
  for (size_t i = 0; i < s.segments.size(); ++i)
    for (uint32_t k = 0; k < components; ++k)
      out[i * components + k] = static_cast<T>(value(s.segments[i], k));
  return column;
}

template <class F>
ColumnPtr vector_column(const Segmentation& s, const char* name, const char* unit,
                        const char* meaning, F&& vector) {
  return segment_column<double>(s, name, 3, unit, meaning, [&](const Segment& segment, uint32_t k) {
    return vector(segment)[static_cast<int>(k)];
  });
}

template <class F>
ColumnPtr length_column(const Segmentation& s, const char* name, const char* unit,
                        const char* meaning, F&& length) {
  return segment_column<double>(s, name, 1, unit, meaning,
                                [&](const Segment& segment, uint32_t) { return length(segment); });
}

// What a segment's type lacks is NaN.
constexpr Vec3 kUnknownVector{kNaN, kNaN, kNaN};

template <size_t kCount>
std::array<double, kCount> unknown_matrix() {
  std::array<double, kCount> out;
  out.fill(kNaN);
  return out;
}

Vec3 normal_of(const Segment& s) {
  if (s.type == PrimitiveType::kSphere) return kUnknownVector;
  return s.is_plane() ? s.fit.plane.normal : s.cylinder.cylinder.direction;
}

Vec3 axis_u_of(const Segment& s) { return s.is_plane() ? s.fit.axis_u : normal_of(s); }

Vec3 centroid_of(const Segment& s) {
  if (s.type == PrimitiveType::kSphere) return s.sphere.sphere.centre;
  return s.is_plane() ? s.fit.centroid : s.cylinder.cylinder.point;
}

double radius_of(const Segment& s) {
  if (s.type == PrimitiveType::kSphere) return s.sphere.sphere.radius;
  return s.is_plane() ? kNaN : s.cylinder.cylinder.radius;
}

std::array<double, 16> covariance_of(const Segment& s) {
  if (s.type == PrimitiveType::kSphere) return s.sphere.covariance;
  return s.is_plane() ? s.fit.covariance : unknown_matrix<16>();
}

std::array<double, 49> cylinder_covariance_of(const Segment& s) {
  return s.type == PrimitiveType::kCylinder ? s.cylinder.covariance : unknown_matrix<49>();
}

}  // namespace

FieldTable point_table(const Segmentation& segmentation) {
  FieldTable table;
  table.set(segmentation.labels);
  table.set(segmentation.residuals);
  table.set(segmentation.orientations);
  return table;
}

size_t plane_count(const std::vector<Segment>& segments) {
  return static_cast<size_t>(std::count_if(segments.begin(), segments.end(),
                                           [](const Segment& s) { return s.is_plane(); }));
}

FieldTable segment_table(const Segmentation& s) {
  using P = Segment;
  FieldTable table;
  table.set(segment_column<uint32_t>(s, "label", 1, "", "label of its points",
                                     [](const P& p, uint32_t) { return p.label; }));
  table.set(segment_column<int64_t>(
      s, "source_label", 1, "", "its value in the field it was made from, else its label",
      [](const P& p, uint32_t) { return p.source_label != 0 ? p.source_label : p.label; }));
  table.set(segment_column<uint8_t>(s, "type", 1, "", "1 plane, 2 sphere, 3 cylinder",
                                    [](const P& p, uint32_t) { return p.type; }));
  table.set(segment_column<uint8_t>(
      s, "orientation", 1, "",
      "1 parallel to the facade, 2 vertical, 3 horizontal, 4 inclined, 0 no plane",
      [](const P& p, uint32_t) { return p.orientation; }));
  table.set(segment_column<uint64_t>(s, "inliers", 1, "points", "number of its points",
                                     [](const P& p, uint32_t) { return p.point_count(); }));
  table.set(vector_column(s, "normal", "",
                          "plane: unit normal, toward the viewer; cylinder: axis direction",
                          normal_of));
  table.set(length_column(s, "offset", "m", "normal . p = offset (planes)",
                          [](const P& p) { return p.is_plane() ? p.fit.plane.offset : kNaN; }));
  table.set(vector_column(
      s, "centroid", "m",
      "plane: mean of its core points; sphere: centre; cylinder: point of the axis at mid height",
      centroid_of));
  table.set(length_column(s, "radius", "m", "of a sphere or cylinder", radius_of));
  table.set(vector_column(
      s, "axis_u", "", "plane: direction of largest extent; cylinder: axis direction", axis_u_of));
  table.set(vector_column(s, "axis_v", "", "normal x axis_u (planes)",
                          [](const P& p) { return p.is_plane() ? p.fit.axis_v : kUnknownVector; }));
  table.set(length_column(s, "sigma", "m", "standard deviation of the distances of its core points",
                          [](const P& p) { return p.sigma_m(); }));
  table.set(length_column(s, "area", "m2", "occupied raster pixels",
                          [](const P& p) { return p.area_m2; }));
  table.set(length_column(s, "length_u", "m", "extent along axis_u",
                          [](const P& p) { return p.length_u_m; }));
  table.set(length_column(s, "length_v", "m",
                          "plane: extent along axis_v; cylinder: arc around the axis",
                          [](const P& p) { return p.length_v_m; }));
  table.set(segment_column<uint8_t>(
      s, "front_source", 1, "", "side of the normal: 1 by stations, 2 by evidence, 0 by convention",
      [](const P& p, uint32_t) { return p.front_source; }));
  table.set(segment_column<double>(s, "front_confidence", 1, "",
                                   "probability that the viewer was on the normal's side",
                                   [](const P& p, uint32_t) { return p.front_confidence; }));
  table.set(segment_column<double>(
      s, "covariance", 16, "",
      "plane: of nx, ny, nz, offset, rank 3; sphere: of centre and radius; row by row",
      [](const P& p, uint32_t k) { return covariance_of(p)[k]; }));
  table.set(segment_column<double>(
      s, "cylinder_covariance", 49, "", "of axis point, direction and radius; row by row, rank 5",
      [](const P& p, uint32_t k) { return cylinder_covariance_of(p)[k]; }));
  return table;
}

}  // namespace jalon
