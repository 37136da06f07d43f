// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distances between clouds at the sizes of Girardeau-Montaut 2006: tables 2.2 and 2.3 (T4, T5), table 8 of annex E
// (T9). Both indexes are included, which the printed times are without.
#include <algorithm>
#include <span>

#include "bench/rolling_ground.h"
#include "bench/thesis.h"
#include "compare/distance/distance.h"
#include "compare/preview/preview.h"

using namespace jalon;
using namespace jalon::bench;
using namespace jalon::test;

namespace {

struct Pair {
  CloudPtr reference, compared;
  std::string text;
};
Pair pair_of(size_t reference, size_t compared) {
  return {earthworks(reference, 1, false), earthworks(compared, 2, true),
          std::to_string(reference) + " / " + std::to_string(compared) + " points"};
}

CloudPtr without_index(const CloudPtr& cloud) {
  Cloud copy = *cloud;
  copy.index = std::make_shared<IndexSlot>();
  return std::make_shared<const Cloud>(std::move(copy));
}

/// The best of three runs.
template <class Run>
double seconds_of(const Pair& pair, Run run) {
  double best = 1e9;
  for (int turn = 0; turn < 3; ++turn) {
    const auto reference = without_index(pair.reference), compared = without_index(pair.compared);
    Task task(one_thread());
    best = std::min(best, processor_seconds([&] { run(reference, compared, task); }));
  }
  return best;
}

struct Row {
  size_t reference, compared;
  double printed_s;
};

void distances(const char* name, std::span<const Row> rows, const DistanceSettings& settings) {
  Table table(name);
  for (const Row& row : rows) {
    const Pair pair = pair_of(row.reference, row.compared);
    table.add(pair.text,
              seconds_of(pair, [&](const CloudPtr& a, const CloudPtr& b,
                                   Task& task) { compare_distance(a, b, settings, task); }),
              row.printed_s);
  }
  table.close();
}

struct PreviewRow {
  size_t reference, compared;
  double octrees, mean, angle, recursive, nearest;
  int level;
};

/// Each preview and search builds both trees again; the thesis gives the trees once and the rest beyond them.
void previews(const PreviewRow& row, Table& table) {
  const Pair pair = pair_of(row.reference, row.compared);
  using Measure = PreviewSettings::Measure;
  const double octrees = seconds_of(pair, [](const CloudPtr& a, const CloudPtr& b, Task& task) {
    a->octree(task);
    b->octree(task);
  });
  const auto preview = [&](const PreviewSettings& settings) {
    return seconds_of(pair, [&](const CloudPtr& a, const CloudPtr& b,
                                Task& task) { compare_preview(a, b, settings, task); }) -
           octrees;
  };
  const double nearest = seconds_of(pair, [](const CloudPtr& a, const CloudPtr& b,
                                             Task& task) { compare_distance(a, b, {}, task); }) -
                         octrees;
  const double mean = preview({Measure::kMean, row.level}),
               angle = preview({Measure::kPlaneAngle, row.level}),
               recursive = preview({Measure::kPlaneAngle, row.level, 10});
  std::printf(
      "FIGURE T9, %s, s (printed): octrees %.3f (%.2f), mean %.3f (%.2f), angle of planes %.3f "
      "(%.2f), recursive %.3f "
      "(%.2f), nearest %.3f (%.2f)\n",
      pair.text.c_str(), octrees, row.octrees, mean, row.mean, angle, row.angle, recursive,
      row.recursive, nearest, row.nearest);
  table.add(pair.text, octrees + mean + angle + recursive + nearest,
            row.octrees + row.mean + row.angle + row.recursive + row.nearest);
}

}  // namespace

int main() {
  const Row plain[] = {{177171, 171380, 1.83},
                       {220931, 171380, 5.58},
                       {764665, 177171, 4.32},
                       {220931, 177171, 5.14},
                       {177171, 764665, 16.91}};
  distances("T4", plain, {});
  const Row modelled[] = {{609804, 837125, 29.47},
                          {146352, 292389, 10.46}};  // row 1 of T5 contradicts T4
  distances("T5 Delaunay", modelled, {.local_model = LocalModelKind::kDelaunay});
  Table table("T9");
  previews({170000, 765000, 1.25, 2.21, 0.11, 0.47, 7.07, 5}, table);
  previews({850000, 612000, 1.76, 14.97, 0.19, 1.33, 21.38, 6}, table);
  table.close();
}
