// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/tables.h"

namespace jalon {

namespace {

// A column of one row a segment; value(segment, component).
template <class T, class F>
ColumnPtr segment_column(const Segmentation& s, const char* name, uint32_t components, const char* unit,
                         const char* meaning, F&& value) {
  FieldInfo info{name, element_type_of<T>(), components, unit, meaning};
  auto column = std::make_shared<Column>(std::move(info), s.segments.size());
  const auto out = column->template values<T>();
  for (size_t i = 0; i < s.segments.size(); ++i)
    for (uint32_t k = 0; k < components; ++k) out[i * components + k] = static_cast<T>(value(s.segments[i], k));
  return column;
}

template <class F>
ColumnPtr vector_column(const Segmentation& s, const char* name, const char* unit, const char* meaning, F&& vector) {
  return segment_column<double>(s, name, 3, unit, meaning, [&](const PlaneSegment& segment, uint32_t k) {
    return vector(segment)[static_cast<int>(k)];
  });
}

template <class F>
ColumnPtr length_column(const Segmentation& s, const char* name, const char* unit, const char* meaning, F&& length) {
  return segment_column<double>(s, name, 1, unit, meaning,
                                [&](const PlaneSegment& segment, uint32_t) { return length(segment); });
}

}  // namespace

FieldTable point_table(const Segmentation& segmentation) {
  FieldTable table;
  table.set(segmentation.labels);
  table.set(segmentation.residuals);
  table.set(segmentation.orientations);
  return table;
}

FieldTable segment_table(const Segmentation& s) {
  using P = PlaneSegment;
  FieldTable table;
  table.set(segment_column<uint32_t>(s, "label", 1, "", "label of its points",
                                     [](const P& p, uint32_t) { return p.label; }));
  table.set(segment_column<uint8_t>(s, "orientation", 1, "",
                                    "1 parallel to the facade, 2 vertical, 3 horizontal, 4 inclined",
                                    [](const P& p, uint32_t) { return p.orientation; }));
  table.set(segment_column<uint64_t>(s, "inliers", 1, "points", "number of its points",
                                     [](const P& p, uint32_t) { return p.fit.n; }));
  table.set(vector_column(s, "normal", "", "unit normal, toward the station where known",
                          [](const P& p) { return p.fit.plane.normal; }));
  table.set(length_column(s, "offset", "m", "normal . p = offset", [](const P& p) { return p.fit.plane.offset; }));
  table.set(vector_column(s, "centroid", "m", "mean of its core points", [](const P& p) { return p.fit.centroid; }));
  table.set(vector_column(s, "axis_u", "", "direction of largest extent", [](const P& p) { return p.fit.axis_u; }));
  table.set(vector_column(s, "axis_v", "", "normal x axis_u", [](const P& p) { return p.fit.axis_v; }));
  table.set(length_column(s, "sigma", "m", "standard deviation of the distances of its core points",
                          [](const P& p) { return p.fit.sigma; }));
  table.set(length_column(s, "area", "m2", "occupied raster pixels", [](const P& p) { return p.area_m2; }));
  table.set(length_column(s, "length_u", "m", "extent along axis_u", [](const P& p) { return p.length_u_m; }));
  table.set(length_column(s, "length_v", "m", "extent along axis_v", [](const P& p) { return p.length_v_m; }));
  table.set(segment_column<double>(s, "covariance", 16, "", "of nx, ny, nz, offset; row by row, rank 3",
                                   [](const P& p, uint32_t k) { return p.fit.covariance[k]; }));
  return table;
}

}  // namespace jalon
