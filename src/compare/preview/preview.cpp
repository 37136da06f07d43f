// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/preview/preview.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "compare/preview/cell_planes.h"
#include "compare/preview/homologous_cells.h"
#include "compare/summary.h"
#include "spatial/neighbours/nearest.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

constexpr auto kRows = setting_rows(
    choice_row<&PreviewSettings::measure>(
        "measure", "mean|minimum|maximum|plane_angle", "",
        "Value of a cell: mean, least or largest distance of its compared points from the "
        "reference points in it, or the angle between the least-squares planes of both, which "
        "sees tilts and not shifts."),
    integer_row<&PreviewSettings::level>(
        "level", 1, 12, "", "",
        "Level of the cells: the cube around both clouds is halved so many times. Movements "
        "should be smaller than a cell."),
    integer_row<&PreviewSettings::last_level>(
        "last_level", 0, 12, "", "",
        "Above level: all levels from level to this one, and each point keeps its least value. 0 "
        "= one level."));

// Pairs that share a hand-over to a thread.
constexpr size_t kGroupPoints = size_t{1} << 13;

using Measure = PreviewSettings::Measure;

// Both clouds in one cube, and the nearest reference point of each compared one wherever it lies (sorted positions).
struct Scene {
  std::shared_ptr<const Octree> reference, compared;
  Buffer<uint32_t> nearest;
  Buffer<double> squared;
};

// The clouds keep the trees on their own cubes: what is made from these must not depend on what was done before.
Scene scene_of(const Cloud& reference, const Cloud& compared, bool with_nearest, Task& task) {
  Scene scene;
  Box3 box = bounds(reference, task);
  box += bounds(compared, task);
  const Cube cube = enclosing_cube(box);
  {
    ProgressSpan span(task, 0, 0.4, "index of the reference");
    scene.reference = Octree::build(reference.xyz(), cube, task);
  }
  {
    ProgressSpan span(task, 0.4, 0.7, "index of the compared cloud");
    scene.compared = Octree::build(compared.xyz(), cube, task);
  }
  if (!with_nearest) return scene;
  ProgressSpan span(task, 0.7, 1, "nearest points");
  scene.nearest = Buffer<uint32_t>(compared.size());
  scene.squared = Buffer<double>(compared.size());
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  for_each_nearest(*scene.reference, *scene.compared, kNoLimit, task, [&](const NearestBatch& b) {
    std::copy_n(b.nearest, b.count, scene.nearest.data() + b.first);
    std::copy_n(b.squared, b.count, scene.squared.data() + b.first);
  });
  return scene;
}

// Distance of a compared point from the nearest reference point of the cell: the nearest of all if it lies there.
double distance_in_cell(const Scene& scene, const CellPair& pair, size_t position) {
  const size_t nearest = scene.nearest[position];
  if (nearest >= pair.reference_first && nearest < pair.reference_first + pair.reference_count)
    return std::sqrt(scene.squared[position]);
  const Vec3 p = scene.compared->local(position);
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < pair.reference_count; ++i)
    least = std::min(least, squared_norm(scene.reference->local(pair.reference_first + i) - p));
  return std::sqrt(least);
}

double cell_distance(const Scene& scene, const CellPair& pair, Measure measure) {
  double sum = 0, least = std::numeric_limits<double>::infinity(), most = 0;
  for (size_t i = 0; i < pair.compared_count; ++i) {
    const double d = distance_in_cell(scene, pair, pair.compared_first + i);
    sum += d;
    least = std::min(least, d);
    most = std::max(most, d);
  }
  if (measure == Measure::kMinimum) return least;
  return measure == Measure::kMaximum ? most : sum / static_cast<double>(pair.compared_count);
}

// Strategies 1 and 2: one value for each pair of cells, the least over the levels for each point (sorted positions).
void measure_level(const Scene& scene, int level, Measure measure, std::span<double> values,
                   Task& task) {
  const auto pairs = homologous_cells(*scene.reference, *scene.compared, level, task);
  const auto groups = groups_of(pairs.size(), kGroupPoints, [&](size_t p) {
    return pairs[p].reference_count + pairs[p].compared_count;
  });
  parallel_chunks(task, groups.size() - 1, [&](size_t g) {
    for (size_t p = groups[g]; p < std::min(groups[g + 1], pairs.size()); ++p) {
      const double value = measure == Measure::kPlaneAngle
                               ? plane_angle(*scene.reference, *scene.compared, level, pairs[p])
                               : cell_distance(scene, pairs[p], measure);
      if (value != value) continue;
      for (size_t i = 0; i < pairs[p].compared_count; ++i) {
        double& to = values[pairs[p].compared_first + i];
        to = to != to ? value : std::min(to, value);
      }
    }
  });
}

// Numbers of angles under names of their own: the summary's are distances.
FieldTable angle_summary(const FieldTable& summary) {
  FieldTable out;
  for (const ColumnPtr& column : summary) {
    FieldInfo info = column->info();
    if (info.unit != "m") {
      out.set(column);
      continue;
    }
    info.name = "angle_" + info.name;
    info.unit = "rad";
    info.meaning = "of the angles between the planes";
    const double value[] = {column->number(0)};
    out.set(make_column<double>(std::move(info), value));
  }
  return out;
}

// Values in the tree's order to columns in the caller's.
Comparison comparison_of(const CloudPtr& compared, std::span<const double> values,
                         std::span<const uint32_t> order, bool angles, Task& task) {
  const size_t n = values.size();
  FieldInfo info{"distance", ElementType::kFloat64, 1, "m", "of the cell"};
  if (angles) info.name = "plane_angle", info.unit = "rad";
  auto value = std::make_shared<Column>(std::move(info), n);
  auto status = std::make_shared<Column>(
      FieldInfo{"status", ElementType::kUint8, 1, "", "0 compared, 4 no reference in the cell"}, n);
  const auto to = value->values<double>();
  const auto labels = status->values<uint8_t>();
  parallel_for(task, n, size_t{1} << 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      to[order[i]] = values[i];
      const bool without = values[i] != values[i];
      labels[order[i]] =
          static_cast<uint8_t>(without ? CompareStatus::kNothingNear : CompareStatus::kCompared);
    }
  });
  Comparison made;
  made.cloud = compared;
  made.summary = summarise(to, labels, task);
  if (angles) made.summary = angle_summary(made.summary);
  made.points.set(std::move(value));
  made.points.set(std::move(status));
  return made;
}

}  // namespace

std::span<const ParamRow> preview_rows() { return kRows; }

Comparison compare_preview(const CloudPtr& reference, const CloudPtr& compared,
                           const PreviewSettings& settings, Task& task) {
  if (reference->size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  const bool angles = settings.measure == Measure::kPlaneAngle;
  const int first = settings.level, last = std::max(first, settings.last_level);
  Scene scene;
  {
    ProgressSpan span(task, 0, 0.6);
    scene = scene_of(*reference, *compared, !angles, task);
  }
  Buffer<double> values(compared->size());
  std::fill(values.begin(), values.end(), kNaN);
  for (int level = first; level <= last; ++level) {
    const double steps = last - first + 1;
    ProgressSpan span(task, 0.6 + 0.35 * (level - first) / steps,
                      0.6 + 0.35 * (level + 1 - first) / steps, "cells");
    measure_level(scene, level, settings.measure, {values.data(), values.size()}, task);
  }
  return comparison_of(compared, {values.data(), values.size()}, scene.compared->order(), angles,
                       task);
}

}  // namespace jalon
