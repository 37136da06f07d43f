// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/from_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/json_writer.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/statistics.h"
#include "segment/labels/given_segment.h"
#include "segment/labels/key_counts.h"
#include "segment/labels/label_groups.h"
#include "segment/labels/whole_numbers.h"
#include "segment/result/facade.h"
#include "segment/result/point_columns.h"

namespace jalon {

namespace {

constexpr size_t kFromLabelsPointsPerChunk = 1 << 15;

// Which row (1-based) a key has: by falling number of points, ties by value.
class Rows {
 public:
  explicit Rows(std::vector<KeyCount> counts)
      : counts_(std::move(counts)), row_(counts_.size()), by_row_(counts_.size()) {
    if (counts_.size() >= std::numeric_limits<uint32_t>::max())
      fail(Status::kLimit, "%zu different labels; a segmentation has at most 4294967294",
           counts_.size());
    for (size_t i = 0; i < by_row_.size(); ++i) by_row_[i] = static_cast<uint32_t>(i);
    std::stable_sort(by_row_.begin(), by_row_.end(),
                     [&](uint32_t a, uint32_t b) { return counts_[a].count > counts_[b].count; });
    for (size_t i = 0; i < by_row_.size(); ++i) row_[by_row_[i]] = static_cast<uint32_t>(i + 1);
  }
  size_t size() const { return counts_.size(); }
  int64_t label(size_t row) const { return WholeNumbers::value_of(counts_[by_row_[row - 1]].key); }
  uint32_t row(uint64_t key) const {
    const auto at = std::lower_bound(counts_.begin(), counts_.end(), key,
                                     [](const KeyCount& c, uint64_t k) { return c.key < k; });
    return row_[static_cast<size_t>(at - counts_.begin())];
  }

 private:
  std::vector<KeyCount> counts_;  // ascending by key
  std::vector<uint32_t> row_, by_row_;
};

std::shared_ptr<Column> label_column(const WholeNumbers& field, const Rows& rows, size_t n,
                                     Task& task) {
  auto column = make_label_column(n);
  const auto labels = column->values<uint32_t>();
  parallel_for(task, n, kFromLabelsPointsPerChunk, [&](size_t begin, size_t end) {
    std::vector<uint64_t> keys(end - begin);
    field.keys(begin, end, keys.data());
    uint64_t last = kNoKey;
    uint32_t row = 0;
    for (size_t i = begin; i < end; ++i) {
      const uint64_t key = keys[i - begin];
      if (key != last) row = key == kNoKey ? 0 : rows.row(key);
      last = key;
      labels[i] = row;
    }
  });
  return column;
}

std::string parameters_text(std::string_view field, double pixel_m) {
  JsonWriter json;
  json.begin_object().name("method").value("labels").name("label_field").value(field);
  json.name("pixel_m").value(pixel_m);
  return json.end_object().take();
}

constexpr auto kLabelRows = setting_rows(
    doubles_row<&LabelSettings::noise_labels>(
        "noise_labels", -kWholeDoubles, kWholeDoubles, "1", "",
        "Values of the field that mean no segment; the scanner's \"face\" has 4294967295 for "
        "outliers."),
    number_row<&LabelSettings::pixel_m>(
        "pixel_m", 0, 100, "m", "",
        "Edge of a raster pixel for the area; 0 = so that a pixel holds four points on "
        "average."),
    number_row<&LabelSettings::orientation_tolerance_rad>(
        "orientation_tolerance_rad", 1e-4, 0.785398, "rad", "",
        "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
    bool_row<&LabelSettings::facade_frame>(
        "facade_frame", "",
        "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the "
        "identity."));

}  // namespace

std::span<const ParamRow> labels_rows() { return kLabelRows; }

// 1. count the labels; 2. number them by size; 3. fit each segment; 4. normals, orientation classes, facade frame.
Segmentation segmentation_from_labels(const CloudPtr& cloud, std::string_view field,
                                      const LabelSettings& settings, Task& task) {
  const WholeNumbers labels(cloud->fields.require(field), settings.noise_labels);
  Segmentation out;
  out.cloud = cloud;
  out.parameters_json = parameters_text(field, settings.pixel_m);
  const size_t n = cloud->size();
  const Rows rows = [&] {
    ProgressSpan span(task, 0, 0.2, "counting labels");
    return Rows(count_keys(
        task, n, [&](size_t begin, size_t end, uint64_t* keys) { labels.keys(begin, end, keys); }));
  }();
  ProgressSpan span(task, 0.2, 1, "fitting planes");
  {
    ProgressSpan inner(task, 0, 0.2);
    out.labels = label_column(labels, rows, n, task);
  }
  const auto dense = out.labels->values<uint32_t>();
  const Vec3 origin = local_origin(*cloud, task);
  const LabelGroups groups = [&] {
    ProgressSpan inner(task, 0.2, 0.4);
    return LabelGroups(dense, rows.size(), task);
  }();
  {
    ProgressSpan inner(task, 0.4, 0.9);
    out.segments.resize(rows.size());
    groups.for_each(task, [&](uint32_t row) {
      Segment& segment = out.segments[row - 1];
      segment = describe_given({*cloud, groups.of(row), origin}, settings.pixel_m, task);
      segment.label = row;
      segment.source_label = rows.label(row);
    });
  }
  ProgressSpan inner(task, 0.9, 1);
  const FacadeContext context{*cloud, origin, settings.orientation_tolerance_rad,
                              settings.facade_frame};
  turn_normals(context, dense, out.segments, task);
  classify(context, out.segments);
  out.T_facade_world = facade_transform(context, out.segments);
  for (Segment& segment : out.segments)
    if (!segment.has_plane()) segment.orientation = Orientation::kNone;
  add_point_columns(out, origin, task);
  for (Segment& segment : out.segments)
    if (segment.has_plane()) shift_origin(segment.fit, origin);
  return out;
}

}  // namespace jalon
