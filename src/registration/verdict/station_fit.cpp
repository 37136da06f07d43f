// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/station_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace jalon {

namespace {

constexpr size_t kSearched = 150;    // of the search over all stations
constexpr size_t kMostPlaces = 500;  // their mean deviation is sure to 3 %; places differ by tens
constexpr size_t kLeastPlaces = 30;
constexpr int kStations = 2000;  // of the search
constexpr int kMostAcross = 24;  // of them along one axis
constexpr double kBeyond = 0.2;  // of the box, on each side
// Things are scanned from outside: directions evenly all round, at distances from the middle of the box in half
// diagonals.
constexpr int kDirections = 150;
constexpr double kDistances[] = {1.5, 2.5, 4, 7, 12};
constexpr size_t kDescents = 8;  // from the best places: a narrow room has many poor minima
constexpr int kSteps = 30;
constexpr double kMostDeviation = 2;  // outliers count for no more
constexpr double kLeastFitCosine = 1e-3;

class DensityLaw {
 public:
  DensityLaw(std::span<const DensityPlace> places, Spreading spreading, size_t most)
      : spreading_(spreading) {
    const size_t stride = places.size() / most + 1;
    for (size_t i = 0; i < places.size(); i += stride)
      if (places[i].spacing_m > 0) places_.push_back(places[i]);
    logs_.resize(places_.size());
  }
  size_t size() const { return places_.size(); }
  Box3 box() const {
    Box3 out;
    for (const DensityPlace& s : places_) out.add(s.place);
    return out;
  }
  double spread_at(const Vec3& station) {
    for (size_t i = 0; i < places_.size(); ++i) {
      const DensityPlace& s = places_[i];
      const Vec3 d = s.place - station;
      const double range2 = std::max(squared_norm(d), 1e-12), range = std::sqrt(range2);
      const double cosine = std::max(std::abs(dot(s.normal, d)) / range, kLeastFitCosine);
      double area = range2 / cosine;  // that a point stands for
      if (spreading_ == Spreading::kEvenAngles)
        area *= std::sqrt(
            std::max((d.x * d.x + d.y * d.y) / range2, kLeastFitCosine * kLeastFitCosine));
      logs_[i] = std::log(area / (s.spacing_m * s.spacing_m));
    }
    const auto middle = logs_.begin() + static_cast<ptrdiff_t>(logs_.size() / 2);
    std::nth_element(logs_.begin(), middle, logs_.end());
    const double centre = *middle;
    double sum = 0;
    for (const double log : logs_) sum += std::min(std::abs(log - centre), kMostDeviation);
    return sum / static_cast<double>(logs_.size());
  }

 private:
  Spreading spreading_;
  std::vector<DensityPlace> places_;
  std::vector<double> logs_;
};

// A grid of about kStations places of cells that are as long as wide, over the box and beyond.
std::vector<Vec3> places_in(const Box3& box) {
  const Vec3 size = (box.max - box.min) * (1 + 2 * kBeyond),
             from = box.min - (box.max - box.min) * kBeyond;
  double step = std::cbrt(std::max(size.x * size.y * size.z, 1e-9) / kStations);
  step = std::max(step, std::max({size.x, size.y, size.z}) / kMostAcross);
  std::vector<Vec3> out;
  const auto count = [&](double length) { return std::max(3, static_cast<int>(length / step)); };
  const int nx = count(size.x), ny = count(size.y), nz = count(size.z);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k)
        out.push_back({from.x + size.x * (i + 0.5) / nx, from.y + size.y * (j + 0.5) / ny,
                       from.z + size.z * (k + 0.5) / nz});
  return out;
}

// Points of a Fibonacci lattice (Gonzalez 2010) on spheres about the box.
void add_outside(const Box3& box, std::vector<Vec3>& places) {
  const Vec3 middle = (box.min + box.max) * 0.5;
  const double half_m = 0.5 * norm(box.max - box.min);
  const double golden_rad = std::numbers::pi * (3 - std::sqrt(5.0));
  for (const double distance : kDistances)
    for (int i = 0; i < kDirections; ++i) {
      const double z = 1 - (2 * i + 1.0) / kDirections, flat = std::sqrt(1 - z * z);
      places.push_back(middle +
                       Vec3{flat * std::cos(golden_rad * i), flat * std::sin(golden_rad * i), z} *
                           (distance * half_m));
    }
}

// Steps along the axes, halved when none helps.
StationFit descend(DensityLaw& law, StationFit from, double step_m) {
  for (int i = 0; i < kSteps; ++i) {
    StationFit best = from;
    for (int axis = 0; axis < 3; ++axis)
      for (const double way : {-step_m, step_m}) {
        Vec3 place = from.place;
        place[axis] += way;
        const double spread = law.spread_at(place);
        if (spread < best.spread) best = {place, spread};
      }
    if (best.spread < from.spread) from = best;
    else step_m *= 0.5;
  }
  return from;
}

}  // namespace

StationFit fit_station(std::span<const DensityPlace> places, Spreading spreading, Task& task) {
  constexpr StationFit kNoFit{{0, 0, 0}, std::numeric_limits<double>::infinity()};
  DensityLaw law(places, spreading, kMostPlaces), few(places, spreading, kSearched);
  if (law.size() < kLeastPlaces || few.size() < kLeastPlaces) return kNoFit;
  // 1. Everywhere in the box and about it.
  const Box3 box = law.box();
  std::vector<StationFit> found;
  std::vector<Vec3> stations = places_in(box);
  add_outside(box, stations);
  for (const Vec3& place : stations) {
    if (found.size() % 64 == 0) task.checkpoint(0);
    found.push_back({place, few.spread_at(place)});
  }
  // 2. Downhill from the best, in steps that suit how far off they are.
  const size_t most = std::min(kDescents, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<ptrdiff_t>(most), found.end(),
                    [](const StationFit& a, const StationFit& b) { return a.spread < b.spread; });
  const Vec3 size = box.max - box.min, middle = (box.min + box.max) * 0.5;
  StationFit best = kNoFit;
  for (size_t i = 0; i < most; ++i) {
    task.checkpoint(0);
    const double across_m = std::max({size.x, size.y, size.z, norm(found[i].place - middle)});
    found[i].spread = law.spread_at(found[i].place);
    const StationFit fit = descend(law, found[i], 0.5 * across_m / kMostAcross);
    if (fit.spread < best.spread) best = fit;
  }
  return best;
}

}  // namespace jalon
