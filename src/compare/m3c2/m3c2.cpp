// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/m3c2.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "base/text_number.h"
#include "cloud/operations.h"
#include "compare/m3c2/cylinder.h"
#include "compare/m3c2/normals.h"
#include "compare/summary.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 128;  // core points: some 100 us to 10 ms, by density

template <class T>
struct Output {
  std::shared_ptr<Column> column;
  T* values = nullptr;

  Output(const char* name, uint32_t components, const char* unit, const char* meaning, size_t n)
      : column(std::make_shared<Column>(
            FieldInfo{name, element_type_of<T>(), components, unit, meaning}, n)),
        values(column->template values<T>().data()) {}
};

/// The columns of the result, in the order they are shown in.
struct CoreColumns {
  Output<double> distance, lod;
  Output<uint8_t> significant, status;
  Output<double> normal, normal_radius;
  Output<uint32_t> count_reference, count_compared;
  Output<double> spread_reference, spread_compared;

  explicit CoreColumns(size_t n)
      : distance("distance", 1, "m", "from the reference to the compared surface along the normal",
                 n),
        lod("lod", 1, "m", "level of detection: distances up to it may be chance", n),
        significant("significant", 1, "", "1: the distance exceeds the level of detection", n),
        status("status", 1, "",
               "0 compared, 4 no points in the cylinder in a cloud, 5 too few points", n),
        normal("normal", 3, "", "unit vector along which the surfaces are compared", n),
        normal_radius("normal_radius", 1, "m", "radius of the ball that gave the normal; 0 if none",
                      n),
        count_reference("count_reference", 1, "", "points of the reference surface", n),
        count_compared("count_compared", 1, "", "points of the compared surface", n),
        spread_reference("spread_reference", 1, "m",
                         "of those points along the normal: a standard deviation", n),
        spread_compared("spread_compared", 1, "m", "the same of the compared surface", n) {}

  void set(size_t i, const CoreNormals::Normal& n, const CylinderResult& r) const {
    distance.values[i] = r.distance_m;
    lod.values[i] = r.lod_m;
    significant.values[i] = std::fabs(r.distance_m) > r.lod_m;
    status.values[i] = static_cast<uint8_t>(r.status);
    for (int c = 0; c < 3; ++c)
      normal.values[3 * i + static_cast<size_t>(c)] = n.known ? n.direction[c] : kNaN;
    normal_radius.values[i] = n.radius_m;
    count_reference.values[i] = r.reference.count;
    count_compared.values[i] = r.compared.count;
    spread_reference.values[i] = r.reference.position.spread_m;
    spread_compared.values[i] = r.compared.position.spread_m;
  }
  FieldTable table() const {
    FieldTable table;
    for (const auto& column :
         {distance.column, lod.column, significant.column, status.column, normal.column,
          normal_radius.column, count_reference.column, count_compared.column,
          spread_reference.column, spread_compared.column})
      table.set(column);
    return table;
  }
};

const CloudPtr& source_cloud(M3c2Settings::Source source, const CloudPtr& reference,
                             const CloudPtr& compared, const CloudPtr& core) {
  if (source == M3c2Settings::Source::kCore) return core;
  return source == M3c2Settings::Source::kCompared ? compared : reference;
}

// A micrometre: what the cells of subsampling are never smaller than.
constexpr double kLeastCoreSpacing_m = 1e-6;

CloudPtr core_points(const CloudPtr& cloud, double spacing_m, Task& task) {
  if (spacing_m == 0) return cloud;
  if (spacing_m < kLeastCoreSpacing_m)
    fail(Status::kInvalidArgument, "core_spacing_m is %s m; 0 (every point) or 1e-06 m and more",
         text_of(spacing_m).c_str());
  const SubsampleSettings thinning{.cell_m = spacing_m, .keep = Keep::kNearest};
  return std::make_shared<const Cloud>(subsampled(*cloud, thinning, task));
}

FieldTable summary_of(const CoreColumns& columns, size_t n, Task& task) {
  FieldTable summary = summarise({columns.distance.values, n}, {columns.status.values, n}, task);
  uint64_t significant = 0;
  double sum = 0;
  for (size_t i = 0; i < n; ++i) {
    significant += columns.significant.values[i];
    if (columns.status.values[i] == 0) sum += columns.lod.values[i];
  }
  const double compared = summary.require("compared").number(0);
  add_value<uint64_t>(summary, "significant", "",
                      "core points whose distance exceeds the level of detection", significant);
  add_value<double>(summary, "mean_lod", "m", "mean level of detection of the compared core points",
                    compared > 0 ? sum / compared : kNaN);
  return summary;
}

/// What core points tell, one after the other. Those of a crowd, some hundred roundings of a cylinder apart, would look
/// at all of it each and learn the same: the first tells for those that follow it.
class CoreMeasurer {
 public:
  CoreMeasurer(const CoreNormals& normals, const CylinderComparer& cylinders, double radius_m)
      : normals_(normals),
        cylinders_(cylinders),
        same_place_m_(kSamePlace * radius_m),
        normal_work_(normals.work()),
        work_(cylinders.work()) {}

  void measure(size_t core_point, const Vec3& centre) {
    const bool is_there = is_measured_ && is_same_place(centre);
    if (is_there && normals_.is_of_place()) return;
    const CoreNormals::Normal own = normals_.at(core_point, normal_work_);
    if (is_there && own.direction == normal.direction && own.known == normal.known) return;
    normal = own;
    result = normal.known ? cylinders_.at(centre, normal.direction, work_) : CylinderResult{};
    centre_ = centre;
    is_measured_ = true;
  }

  CoreNormals::Normal normal;
  CylinderResult result;

 private:
  static constexpr double kSamePlace = 0x1p-44;  // of the cylinder's radius

  bool is_same_place(const Vec3& centre) const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::fabs(centre[axis] - centre_[axis]) <= same_place_m_)) return false;
    return true;
  }

  const CoreNormals& normals_;
  const CylinderComparer& cylinders_;
  const double same_place_m_;
  CoreNormals::Work normal_work_;
  CylinderComparer::Work work_;
  bool is_measured_ = false;
  Vec3 centre_;
};

/// Steps 1 to 4 of Lague, Brodu & Leroux (2013) at every core point, in the order of the curve, so that neighbours find
/// their points in the cache. The columns are made behind the indices, when what those take to be made is given back.
CoreColumns measure(const M3c2Settings& settings, const CloudPtr& reference,
                    const CloudPtr& compared, const CloudPtr& core, Task& task) {
  const CoreNormals normals(
      settings, source_cloud(settings.normals_from, reference, compared, core), core, task);
  const CylinderComparer cylinders(settings, reference, compared, task);
  const auto core_tree = core->octree(task);
  const auto order = core_tree->order();
  CoreColumns columns(core->size());
  ProgressSpan span(task, 0.2, 1, "cylinders");
  parallel_for(task, core->size(), kGrain, [&](size_t begin, size_t end) {
    CoreMeasurer measurer(normals, cylinders, settings.cylinder_radius_m);
    for (size_t position = begin; position < end; ++position) {
      // A cylinder may hold most of the cloud.
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      const size_t i = order[position];
      measurer.measure(i, core->point(i));
      columns.set(i, measurer.normal, measurer.result);
    }
  });
  return columns;
}

}  // namespace

Comparison compare_m3c2(const CloudPtr& reference, const CloudPtr& compared,
                        const M3c2Settings& settings, Task& task) {
  settings.check();
  const CloudPtr& source = source_cloud(settings.core_from, reference, compared, reference);
  if (source->size() == 0)
    fail(Status::kInsufficientData, "the cloud that gives the core points is empty");
  CloudPtr core;
  {
    ProgressSpan span(task, 0, 0.1, "core points");
    core = core_points(source, settings.core_spacing_m, task);
  }
  ProgressSpan span(task, 0.1, 1);
  return compare_m3c2_core(reference, compared, core, settings, task);
}

Comparison compare_m3c2_core(const CloudPtr& reference, const CloudPtr& compared,
                             const CloudPtr& core, const M3c2Settings& settings, Task& task) {
  if (reference->size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  if (core->size() == 0) fail(Status::kInsufficientData, "there are no core points");
  settings.check();
  const CoreColumns columns = measure(settings, reference, compared, core, task);
  Comparison made;
  made.cloud = core;
  made.points = columns.table();
  made.summary = summary_of(columns, core->size(), task);
  return made;
}

}  // namespace jalon
