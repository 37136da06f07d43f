// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/units/file_unit.h"

#include <memory>
#include <utility>

#include "base/parallel.h"
#include "formats/units/length_units.h"

namespace jalon {

double metres_of(FileUnit unit) {
  switch (unit) {
    case FileUnit::kFeet:
      return kFoot;
    case FileUnit::kUsSurveyFeet:
      return kUsFoot;
    case FileUnit::kMillimetres:
      return 1e-3;
    case FileUnit::kCentimetres:
      return 1e-2;
    case FileUnit::kAuto:
    case FileUnit::kMetres:
      break;
  }
  return 1;
}

Cloud in_metres(Cloud cloud, FileUnit unit, Task& task) {
  constexpr size_t kUnitGrain = size_t{1} << 17;  // coordinates a chunk: below a millisecond
  const double metres = metres_of(unit);
  if (metres == 1) return cloud;
  const std::span<const double> from = cloud.xyz();
  Buffer<double> to(from.size());
  parallel_for(task, from.size(), kUnitGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) to.data()[i] = from[i] * metres;
  });
  cloud.xyz_buffer = std::make_shared<Buffer<double>>(std::move(to));
  cloud.index = std::make_shared<IndexSlot>();
  for (Station& station : cloud.stations)
    if (station.has_pose)
      for (const size_t k : {3, 7, 11}) station.pose.m[k] *= metres;
  return cloud;
}

}  // namespace jalon
