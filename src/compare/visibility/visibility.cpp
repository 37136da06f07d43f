// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kVisibilityGrain = 1 << 13;  // points a chunk: about 1 ms

/// All points belong to stations with poses: an unknown viewpoint could have seen anything.
void require_stations(const Cloud& cloud) {
  uint64_t covered = 0;
  for (const Station& station : cloud.stations) {
    if (station.count > 0 && !station.has_pose)
      fail(Status::kInvalidArgument,
           "station \"%.100s\" of the reference has no pose; visibility needs it",
           station.name.c_str());
    covered += station.count;
  }
  if (covered < cloud.size())
    fail(Status::kInvalidArgument,
         "%llu points of the reference belong to no station; visibility needs to know from "
         "where they were seen",
         static_cast<unsigned long long>(cloud.size() - covered));
}

}  // namespace

VisibilityTest::VisibilityTest(const Cloud& reference, const DepthSettings& settings, Task& task)
    : settings_(settings) {
  settings.check();
  require_stations(reference);
  const Vec3 second_centre = settings.second_centre();
  std::vector<Vec3> centres{{}};
  if (squared_norm(second_centre) > 0) centres.push_back(second_centre);
  maps_each_ = centres.size();
  std::vector<const Station*> stations;
  for (const Station& station : reference.stations)
    if (station.count > 0) stations.push_back(&station);
  maps_.resize(stations.size() * maps_each_);
  // Much of a map is made by one thread.
  const ProgressSpan span(task, 0, 1, "depth maps");
  parallel_chunks(task, maps_.size(), [&](size_t k) {
    maps_[k] = DepthMap::build(reference, *stations[k / maps_each_], centres[k % maps_each_],
                               settings, task);
  });
}

Visibility VisibilityTest::from_map(const DepthMap& map, const Sighting& s,
                                    uint32_t* occluder) const {
  AngularGrid::Place place;
  if (!map.grid().locate(s, place)) return Visibility::kOutOfField;
  if (settings_.max_range_m > 0 && s.range_m >= settings_.max_range_m)
    return Visibility::kOutOfRange;
  const double surface = map.surface_range_m(place);
  if (surface == 0) {
    if (settings_.empty_is_free()) return Visibility::kVisible;
  } else if (s.range_m <= surface * settings_.margin_factor + settings_.margin_m) {
    return Visibility::kVisible;
  }
  if (occluder != nullptr) *occluder = map.cell(place).point;
  return Visibility::kHidden;
}

Visibility VisibilityTest::label(const Vec3& p, uint32_t* occluder) const {
  Visibility best = Visibility::kOutOfField;
  if (occluder != nullptr) *occluder = kNoPoint;
  for (size_t m = 0; m < maps_.size(); m += maps_each_) {
    // Both optical centres must see it.
    uint32_t hides = kNoPoint;
    Visibility here = from_map(maps_[m], maps_[m].sighting(p), &hides);
    for (size_t k = 1; k < maps_each_ && here == Visibility::kVisible; ++k)
      here = std::max(here, from_map(maps_[m + k], maps_[m + k].sighting(p), &hides));
    if (here < best) {
      best = here;
      if (occluder != nullptr) *occluder = hides;
    }
    if (best == Visibility::kVisible) break;
  }
  return best;
}

double VisibilityTest::spacing_m(const Vec3& p) const {
  double best = std::numeric_limits<double>::infinity();
  for (size_t m = 0; m < maps_.size(); m += maps_each_) {
    const Sighting s = maps_[m].sighting(p);
    AngularGrid::Place place;
    if (from_map(maps_[m], s, nullptr) != Visibility::kVisible || !maps_[m].grid().locate(s, place))
      continue;
    const double spacing = maps_[m].spacing_m(place);
    if (spacing > 0) best = std::min(best, spacing);
  }
  return std::isinf(best) ? kNaN : best;
}

void VisibilityTest::label(std::span<const double> xyz, std::span<uint8_t> out) const {
  std::fill(out.begin(), out.end(), static_cast<uint8_t>(Visibility::kOutOfField));
  SightingBlock blocks[2];
  for (size_t m = 0; m < maps_.size(); m += maps_each_) {
    for (size_t k = 0; k < maps_each_; ++k) maps_[m + k].sight(xyz, blocks[k]);
    for (size_t i = 0; i < out.size(); ++i) {
      if (out[i] == static_cast<uint8_t>(Visibility::kVisible)) continue;
      Visibility here = from_map(maps_[m], blocks[0][i], nullptr);
      if (maps_each_ == 2 && here == Visibility::kVisible)
        here = from_map(maps_[m + 1], blocks[1][i], nullptr);
      out[i] = std::min(out[i], static_cast<uint8_t>(here));
    }
  }
}

std::vector<uint8_t> visibility_labels(const VisibilityTest& test, const Cloud& cloud, Task& task) {
  std::vector<uint8_t> labels(cloud.size());
  parallel_for(task, labels.size(), kVisibilityGrain, [&](size_t begin, size_t end) {
    for (size_t first = begin; first < end; first += SightingBlock::kPoints) {
      const size_t n = std::min(end - first, SightingBlock::kPoints);
      test.label(cloud.xyz().subspan(3 * first, 3 * n), std::span(labels).subspan(first, n));
    }
  });
  return labels;
}

Cloud with_visibility(const Cloud& reference, const Cloud& cloud, const DepthSettings& settings,
                      Task& task) {
  const auto labels = [&] {
    const auto test = [&] {
      const ProgressSpan span(task, 0, 0.5);
      return VisibilityTest(reference, settings, task);
    }();
    const ProgressSpan span(task, 0.5, 1, "visibility");
    return visibility_labels(test, cloud, task);
  }();
  Cloud out = cloud;
  out.fields.set(
      make_column<uint8_t>({"visibility", ElementType::kUint8, 1, "",
                            "0 visible, 1 hidden, 2 out of range, 3 out of the field of view"},
                           labels));
  return out;
}

}  // namespace jalon
