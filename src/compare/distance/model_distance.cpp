// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Method "distance" with a model as reference:
//   1. the model as triangles, each with the face or mesh triangle that it is of;
//   2. a tree over them (spatial/triangle_nearest);
//   3. the nearest triangle of each point, points in the order of their octree;
//   4. what that says of the whole and of each part.

#include "compare/distance/model_distance.h"

#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "compare/distance/model_surface.h"
#include "compare/distance/part_statistics.h"
#include "compare/summary.h"
#include "spatial/triangles/nearest.h"

namespace jalon {

namespace {

constexpr size_t kModelDistanceGrain = 1 << 15;
constexpr uint8_t kInTolerance = 1, kOffTolerance = 0, kNotJudged = 2;

// What is asked for and only clouds can give is refused, not passed over.
void require_for_models(const DistanceSettings& settings) {
  const auto refuse = [](const char* name, const char* instead) {
    fail(Status::kUnsupported, "parameter \"%s\" is for a reference cloud; with a model %s", name,
         instead);
  };
  if (settings.visibility != DistanceSettings::VisibleFrom::kAnywhere)
    refuse("visibility", "leave it at none: nothing tells from where the model was seen");
  if (settings.local_model != LocalModelKind::kNone)
    refuse("local_model", "leave it at none: its faces are the surface");
  if (settings.sampling_error) refuse("sampling_error", "leave it off: surfaces have no sampling");
  if (settings.hausdorff)
    refuse(
        "hausdorff",
        "take points on it (jalon_model_sample) and compare these with the cloud for the way back");
}

template <class T>
struct NewColumn {
  std::shared_ptr<Column> column;
  T* values;

  NewColumn(const char* name, const char* unit, const char* meaning, size_t points)
      : column(std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), 1, unit, meaning},
                                        points)),
        values(column->template values<T>().data()) {}
};

/// One row a compared point.
class ModelColumns {
 public:
  ModelColumns(size_t points, const DistanceSettings& settings)
      : is_signed_(settings.is_signed),
        distance_("distance", "m", "from the model; negative behind it", points),
        status_("status", "", "0 compared, 4 nothing within max_distance_m", points),
        face_("face", "",
              "row of the model's faces that is nearest; 4294967295 = a triangle of its mesh",
              points),
        triangle_("triangle", "",
                  "row of the model's triangles that is nearest; 4294967295 = a face", points),
        part_("part", "", "row of the model's parts; 4294967295 = none", points),
        side_("side", "",
              "0 certain, 1 at a border of the surface, 2 where triangles run opposite ways around",
              settings.is_signed ? points : 0) {
    if (!settings.differences) return;
    for (const char* name : {"difference_x", "difference_y", "difference_z"})
      differences_.emplace_back(name, "m", "from the foot on the model to the point", points);
  }

  void set(size_t i, const TriangleAnswer& answer, const ModelSurface& surface) {
    const bool found = answer.triangle != kNoFace;
    const auto source =
        found ? surface.source(answer.triangle) : ModelSurface::Source{kNoFace, kNoFace, kNoPart};
    distance_.values[i] = answer.is_behind ? -answer.distance : answer.distance;
    status_.values[i] =
        static_cast<uint8_t>(found ? CompareStatus::kCompared : CompareStatus::kNothingNear);
    face_.values[i] = source.face;
    triangle_.values[i] = source.triangle;
    part_.values[i] = source.part;
    if (is_signed_) side_.values[i] = static_cast<uint8_t>(answer.side);
    for (size_t a = 0; a < differences_.size(); ++a)
      differences_[a].values[i] = found ? answer.from_foot[static_cast<int>(a)] : kNaN;
  }
  void attach(FieldTable& table) const {
    for (const auto& column :
         {distance_.column, status_.column, face_.column, triangle_.column, part_.column})
      table.set(column);
    if (is_signed_) table.set(side_.column);
    for (const auto& difference : differences_) table.set(difference.column);
  }
  std::span<const double> distances() const { return distance_.column->values<double>(); }
  std::span<const uint8_t> statuses() const { return status_.column->values<uint8_t>(); }
  std::span<const uint32_t> parts() const { return part_.column->values<uint32_t>(); }
  std::span<const uint8_t> sides() const { return side_.column->values<uint8_t>(); }

 private:
  bool is_signed_;
  NewColumn<double> distance_;
  NewColumn<uint8_t> status_;
  NewColumn<uint32_t> face_, triangle_, part_;
  NewColumn<uint8_t> side_;
  std::vector<NewColumn<double>> differences_;  ///< three, or none
};

uint64_t count_of(std::span<const uint8_t> values, uint8_t value, Task& task) {
  return parallel_reduce(task, values.size(), kModelDistanceGrain, uint64_t{0},
                         [&](size_t begin, size_t end) {
                           uint64_t sum = 0;
                           for (size_t i = begin; i < end; ++i) sum += values[i] == value ? 1 : 0;
                           return sum;
                         });
}

/// Step 3.
void measure(const ModelSurface& surface, const NearestTriangles& tree, const Cloud& compared,
             const Octree& octree, const DistanceSettings& settings, ModelColumns& columns,
             Task& task) {
  tree.for_each(compared.xyz(), octree.order(), settings.limit_m(),
                {settings.is_signed, settings.differences}, task,
                [&](uint32_t i, const TriangleAnswer& answer) { columns.set(i, answer, surface); });
}

void add_sides(const ModelColumns& columns, FieldTable& summary, Task& task) {
  const auto count = [&](TriangleSide side) {
    return count_of(columns.sides(), static_cast<uint8_t>(side), task);
  };
  add_value<uint64_t>(summary, "at_border", "",
                      "points nearest to a border of the surface: sign as if it went on",
                      count(TriangleSide::kBorder));
  add_value<uint64_t>(summary, "inconsistent", "",
                      "points nearest to where triangles run opposite ways around",
                      count(TriangleSide::kInconsistent));
}

/// Column and summary of the check against the tolerance (5.3.1).
void judge(const ModelColumns& columns, double tolerance_m, Comparison& made, Task& task) {
  const auto distances = columns.distances();
  const NewColumn<uint8_t> within("within_tolerance", "",
                                  "1 at most tolerance_m from the model, 0 farther, 2 no distance",
                                  distances.size());
  parallel_for(task, distances.size(), kModelDistanceGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      within.values[i] = std::isnan(distances[i])                ? kNotJudged
                         : std::abs(distances[i]) <= tolerance_m ? kInTolerance
                                                                 : kOffTolerance;
  });
  const auto judged = within.column->values<uint8_t>();
  const uint64_t good = count_of(judged, kInTolerance, task),
                 bad = count_of(judged, kOffTolerance, task);
  made.points.set(within.column);
  add_value<uint64_t>(made.summary, "within_tolerance", "",
                      "points at most tolerance_m from the model", good);
  add_value<double>(made.summary, "tolerance_share", "1",
                    "share of the compared points within tolerance_m",
                    static_cast<double>(good) / static_cast<double>(good + bad));
}

/// Step 4.
void sum_up(const ModelColumns& columns, const Model& model, const DistanceSettings& settings,
            Comparison& made, Task& task) {
  made.summary = summarise(columns.distances(), columns.statuses(), task);
  const double least = made.summary.require("minimum").number(0),
               most = made.summary.require("maximum").number(0);
  add_value<double>(made.summary, "maximum_absolute", "m",
                    "largest distance on either side: directed Hausdorff distance",
                    std::max(std::abs(least), std::abs(most)));
  if (settings.is_signed) add_sides(columns, made.summary, task);
  if (settings.tolerance_m > 0) judge(columns, settings.tolerance_m, made, task);
  if (!model.parts.empty())
    made.parts = part_statistics(columns.distances(), columns.parts(), model.parts.size(),
                                 settings.tolerance_m, task);
}

}  // namespace

Comparison compare_with_model(const ModelPtr& reference, const CloudPtr& compared,
                              const DistanceSettings& settings, Task& task) {
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  require_for_models(settings);
  const ModelSurface surface(*reference, settings.chord_error_m, task);
  // The octree first: what it takes to make it is given back before the rest is there.
  std::shared_ptr<const Octree> octree;
  {
    const ProgressSpan span(task, 0, 0.15, "index of the compared cloud");
    octree = compared->octree(task);
  }
  std::shared_ptr<const NearestTriangles> tree;
  {
    const ProgressSpan span(task, 0.15, 0.4, "index of the model");
    tree = NearestTriangles::build(surface.vertices(), surface.triangles(), task);
  }
  ModelColumns columns(compared->size(), settings);
  {
    const ProgressSpan span(task, 0.4, 0.9, "nearest triangles");
    measure(surface, *tree, *compared, *octree, settings, columns, task);
  }
  const ProgressSpan span(task, 0.9, 1, "statistics");
  Comparison made;
  made.cloud = compared;
  columns.attach(made.points);
  sum_up(columns, *reference, settings, made, task);
  return made;
}

}  // namespace jalon
