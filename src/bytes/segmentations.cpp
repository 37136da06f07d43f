// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/segmentations.h"

#include <algorithm>
#include <cmath>

#include "bytes/clouds.h"
#include "bytes/tables.h"
#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr KnownColumn kLabelColumns[] = {{"label", ElementType::kUint32, 1, true},
                                         {"residual", ElementType::kFloat32, 1, true},
                                         {"orientation", ElementType::kUint8, 1, true}};

template <Maybe<Segment> T>
auto segment_members(T& s) {
  return std::tie(s.label, s.source_label, s.type, s.orientation, s.fit, s.sphere, s.cylinder,
                  s.area_m2, s.length_u_m, s.length_v_m, s.front_source, s.front_confidence);
}
constexpr size_t kLeastSegmentBytes =
    least_bytes_of(std::type_identity<decltype(segment_members(std::declval<Segment&>()))>{});

bool is_unit(const Vec3& v) {
  constexpr double kTolerance = 1e-6;  // as of the rigid motions that the interface takes
  return std::abs(norm(v) - 1) <= kTolerance;
}

bool is_possible(const Segment& s) {
  if (s.type < PrimitiveType::kPlane || s.type > PrimitiveType::kCylinder) return false;
  if (s.orientation > Orientation::kInclined) return false;
  if (s.front_source > FrontSource::kEvidence) return false;
  if (s.has_plane())
    return is_unit(s.fit.plane.normal) && is_unit(s.fit.axis_u) && is_unit(s.fit.axis_v) &&
           is_finite(s.fit.centroid);
  if (s.type == PrimitiveType::kSphere)
    return is_finite(s.sphere.sphere.centre) && std::isfinite(s.sphere.sphere.radius);
  const Cylinder& cylinder = s.cylinder.cylinder;
  return s.is_plane() || (is_finite(cylinder.point) && is_unit(cylinder.direction) &&
                          std::isfinite(cylinder.radius));
}

std::vector<Segment> read_segments(ByteReader& reader) {
  std::vector<Segment> segments(reader.count(kLeastSegmentBytes));
  for (size_t i = 0; i < segments.size(); ++i) {
    Segment& segment = segments[i];
    std::apply([&](auto&... member) { (reader.item(member), ...); }, segment_members(segment));
    if (segment.label != i + 1) reader.refuse("segment %zu has the label %u", i, segment.label);
    if (!is_possible(segment))
      reader.refuse("segment %zu is no plane, sphere or cylinder that there can be", i);
  }
  return segments;
}

}  // namespace

void write_segmentation(ByteWriter& writer, const Segmentation& segmentation) {
  write_cloud(writer, *segmentation.cloud);
  FieldTable points;
  for (const ColumnPtr& column :
       {segmentation.labels, segmentation.residuals, segmentation.orientations})
    points.set(column);
  write_table(writer, points);
  writer.item(static_cast<uint64_t>(segmentation.segments.size()));
  for (const Segment& segment : segmentation.segments)
    std::apply([&](const auto&... member) { (writer.item(member), ...); },
               segment_members(segment));
  writer.item(segmentation.T_facade_world);
  writer.item(segmentation.parameters_json);
  if (!segmentation.notes_json.empty()) writer.item(segmentation.notes_json);
}

Segmentation read_segmentation(ByteReader& reader, Task& task) {
  Segmentation out;
  out.cloud = std::make_shared<const Cloud>(read_cloud(reader, task));
  const FieldTable points = read_table(reader, task);
  require_known(reader, points, kLabelColumns);
  require_rows(reader, points, "labels", out.cloud->size());
  out.labels = points.find_shared("label");
  out.residuals = points.find_shared("residual");
  out.orientations = points.find_shared("orientation");
  out.segments = read_segments(reader);
  const auto labels = out.labels->values<uint32_t>();
  if (std::any_of(labels.begin(), labels.end(),
                  [&](uint32_t label) { return label > out.segments.size(); }))
    reader.refuse("a point has the label of a segment that is not there");
  const auto classes = out.orientations->values<uint8_t>();
  constexpr auto kLastClass = static_cast<uint8_t>(Orientation::kInclined);
  if (std::any_of(classes.begin(), classes.end(), [](uint8_t c) { return c > kLastClass; }))
    reader.refuse("a point has an orientation that is none");
  reader.item(out.T_facade_world);
  if (!is_rigid(out.T_facade_world)) reader.refuse("the facade's frame is no rigid motion");
  reader.item(out.parameters_json);
  if (reader.has_more()) reader.item(out.notes_json);
  return out;
}

}  // namespace jalon
