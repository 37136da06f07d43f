// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/coded_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "segment/codes/notes.h"
#include "segment/labels/from_labels.h"
#include "segment/labels/given_segment.h"
#include "segment/result/point_columns.h"

namespace jalon {

namespace {

constexpr size_t kCodedPointsPerChunk = 1 << 16;
constexpr double kFarFromCloud_m =
    10;  // a wrong digit of a coordinate, not a station beside the scan
constexpr const char* kObjectField = "jalon:object";  // for a moment, on a copy of the cloud

std::vector<uint64_t> points_of(std::span<const uint32_t> object_of_point, size_t objects) {
  std::vector<uint64_t> points(objects, 0);
  for (const uint32_t object : object_of_point)
    if (object != 0) ++points[object - 1];
  return points;
}

// ASPRS LAS 1.4 knows buildings (6); doors, windows and gutters are among its user's classes (64 on).
int64_t class_in(ClassScheme scheme, int64_t number) {
  constexpr int64_t kUnclassified = 1, kBuilding = 6, kFirstOfUsers = 64;
  if (scheme == ClassScheme::kTable) return number;
  if (number == 0) return kUnclassified;
  return number == 1 ? kBuilding : std::min<int64_t>(kFirstOfUsers + number - 2, 255);
}

std::shared_ptr<Column> class_column(std::span<const uint32_t> object_of_point,
                                     const CodedObjects& objects, ClassScheme scheme, Task& task) {
  std::vector<uint8_t> class_of{static_cast<uint8_t>(class_in(scheme, 0))};
  for (const CodedObject& object : objects.objects)
    class_of.push_back(static_cast<uint8_t>(class_in(scheme, object.row.class_code)));
  FieldInfo info{"classification", ElementType::kUint8, 1, "", "class of the point's coded object"};
  auto column = std::make_shared<Column>(std::move(info), object_of_point.size());
  const auto out = column->values<uint8_t>();
  parallel_for(task, object_of_point.size(), kCodedPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out[i] = class_of[object_of_point[i]];
  });
  return column;
}

// A building and a grown gutter are no plane; a pipe is the cylinder that was measured.
void describe(const CodedObject& object, const Vec3& origin, const Cloud& cloud, Segment& segment,
              Task& task) {
  const bool is_grown = object.row.geometry == CodeGeometry::kGutterTarget;
  if (object.shape.kind != CodeShape::Kind::kPrism && object.shape.kind != CodeShape::Kind::kPipe &&
      !is_grown)
    return;
  const uint64_t n = segment.point_count();
  const uint32_t label = segment.label;
  const int64_t source = segment.source_label;
  segment = describe_given({cloud, {}, {}}, 0, task);
  segment.label = label;
  segment.source_label = source;
  segment.fit.n = n;
  if (object.shape.kind != CodeShape::Kind::kPipe) return;
  segment.type = PrimitiveType::kCylinder;
  const Vec3 foot = object.shape.axis[0] + origin, end = object.shape.axis[1] + origin;
  segment.cylinder.cylinder = {0.5 * (foot + end), normalized(end - foot), object.shape.radius_m};
  segment.cylinder.length_m = segment.length_u_m = norm(end - foot);
  segment.cylinder.n = n;
  segment.cylinder.sigma = kNaN;  // measured with the codes, not from the points
  segment.cylinder.covariance.fill(kNaN);
}

double outside(const Box3& box, const Vec3& p) {
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = std::max({0.0, box.min[axis] - p[axis], p[axis] - box.max[axis]});
  return norm(out);
}

Cloud with_column(const Cloud& cloud, ColumnPtr column) {
  Cloud out = cloud;
  out.fields.set(std::move(column));
  return out;
}

}  // namespace

void warn_of_empty(const Cloud& cloud, std::span<const uint32_t> object_of_point, CodedObjects& all,
                   Task& task) {
  const std::vector<uint64_t> points = points_of(object_of_point, all.objects.size());
  const Box3 box = bounds(cloud, task);
  for (size_t i = 0; i < points.size(); ++i) {
    const CodedObject& object = all.objects[i];
    const CodedPoint* farthest = nullptr;
    double most = kFarFromCloud_m;
    for (const CodedPoint& p : object.points)
      if (const double d = outside(box, p.position); d > most) {
        most = d;
        farthest = &p;
      }
    if (farthest != nullptr)
      all.warnings.push_back({farthest->line, object.name,
                              "point " + farthest->id + " lies " +
                                  std::to_string(static_cast<int64_t>(most)) +
                                  " m outside the cloud"});
    const bool is_target = object.row.geometry >= CodeGeometry::kWallTarget;
    const bool has_space = is_target || object.shape.kind != CodeShape::Kind::kNone;
    if (points[i] == 0 && object.row.class_code != 0 && has_space)
      all.warnings.push_back(
          {object.points.front().line, object.name, "holds no point of the cloud"});
    else if (points[i] < kFewestDrawnPoints && is_target)
      all.warnings.push_back({object.points.front().line, object.name,
                              "holds " + std::to_string(points[i]) +
                                  (points[i] == 1 ? " point" : " points") +
                                  " of the cloud, too few to be drawn"});
  }
  std::stable_sort(all.warnings.begin(), all.warnings.end(),
                   [](const CodeWarning& a, const CodeWarning& b) { return a.line < b.line; });
  for (const CodeWarning& w : all.warnings)
    task.log(Task::kWarning, "code list, line %zu: %s: %s", w.line, w.object.c_str(),
             w.text.c_str());
}

Segmentation coded_segmentation(const CloudPtr& cloud, std::vector<uint32_t> object_of_point,
                                const CodedObjects& all, const CodeInput& input, const char* method,
                                Task& task) {
  const std::vector<uint64_t> points = points_of(object_of_point, all.objects.size());
  auto objects = std::make_shared<Column>(FieldInfo{kObjectField, ElementType::kUint32, 1, "", ""},
                                          object_of_point.size());
  std::copy(object_of_point.begin(), object_of_point.end(), objects->values<uint32_t>().begin());
  LabelSettings settings;
  settings.facade_frame = false;  // several buildings, in any direction
  Segmentation out = segmentation_from_labels(
      std::make_shared<const Cloud>(with_column(*cloud, std::move(objects))), kObjectField,
      settings, task);
  out.cloud = std::make_shared<const Cloud>(
      with_column(*cloud, class_column(object_of_point, all, input.classes, task)));
  std::vector<uint32_t> labels(all.objects.size(), 0);
  for (Segment& segment : out.segments) {
    const auto object = static_cast<size_t>(segment.source_label - 1);
    describe(all.objects[object], all.origin, *cloud, segment, task);
    labels[object] = segment.label;
  }
  add_point_columns(out, {}, task);
  std::map<int64_t, uint64_t> classes;
  uint64_t rest = object_of_point.size();
  for (size_t i = 0; i < points.size(); ++i) {
    classes[class_in(input.classes, all.objects[i].row.class_code)] += points[i];
    rest -= points[i];
  }
  classes[class_in(input.classes, 0)] += rest;
  out.notes_json = coded_notes(method, all, labels, points, classes);
  return out;
}

}  // namespace jalon
