// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/place_values.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace jalon {

namespace {

constexpr size_t kFewOnPlace = 64;                 // points that are looked at one by one
constexpr size_t kSortedAtOnce = size_t{1} << 15;  // about 2 ms

}  // namespace

PlaceValues::PlaceValues(const ValuedPoints& valued, Task& task) : values_(valued.values) {
  size_t last = 0;
  for (size_t first = 0; first < valued.size(); first = last) {
    last = valued.tree->end_of_place(first);
    if (last - first > kFewOnPlace) add_place(first, last, task);
  }
}

void PlaceValues::add_place(size_t first, size_t last, Task& task) {
  if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
  places_.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(last), sorted_.size()});
  std::vector<double> own(values_.begin() + static_cast<ptrdiff_t>(first),
                          values_.begin() + static_cast<ptrdiff_t>(last));
  if (own.size() > kSortedAtOnce) own = sorted_values(std::move(own), task);
  else std::sort(own.begin(), own.end());
  double sum = 0;
  for (const double value : own) {
    sorted_.push_back(value);
    sums_.push_back(sum);
    sum += value;
  }
  // The sum of all stands behind the last value.
  sorted_.push_back(kNaN);
  sums_.push_back(sum);
}

const PlaceValues::Place* PlaceValues::whole_place(const Octree::PlaceGroup& group) const {
  if (group.last - group.first <= kFewOnPlace) return nullptr;
  const auto at =
      std::lower_bound(places_.begin(), places_.end(), group.first,
                       [](const Place& place, uint32_t first) { return place.first < first; });
  const bool is_whole = at != places_.end() && at->first == group.first && at->last == group.last;
  return is_whole ? &*at : nullptr;
}

PlaceValues::Part PlaceValues::within(const Octree::PlaceGroup& group, double from,
                                      double most) const {
  Part out;
  if (const Place* place = whole_place(group)) {
    const auto begin = sorted_.begin() + static_cast<ptrdiff_t>(place->at),
               end = begin + (place->last - place->first);
    const auto low =
        std::partition_point(begin, end, [&](double v) { return v < from && from - v > most; });
    const auto high = std::partition_point(low, end, [&](double v) { return v - from <= most; });
    out.count = static_cast<size_t>(high - low);
    out.sum = sums_[static_cast<size_t>(high - sorted_.begin())] -
              sums_[static_cast<size_t>(low - sorted_.begin())] -
              static_cast<double>(out.count) * from;
    return out;
  }
  for (uint32_t i = group.first; i < group.last; ++i) {
    const double difference = values_[i] - from;
    if (!(std::abs(difference) <= most)) continue;
    ++out.count;
    out.sum += difference;
  }
  return out;
}

}  // namespace jalon
