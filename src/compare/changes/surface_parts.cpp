// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/surface_parts.h"

#include <array>
#include <bitset>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/parallel.h"
#include "compare/detection/found_stations.h"
#include "compare/visibility/depth_map.h"

namespace jalon {

namespace {

constexpr int kHalfWindow = 2;  // cells to either side: five rows of points at least
// Of the window: wholly beside the place, so that it need not reach over an edge there.
constexpr int kShift = kHalfWindow + 1;
// Rows and columns of cells that a plane is told from: two rows always lie in one.
constexpr size_t kLeastLines = 3;
// Scatter beyond so many times the noise is shape: that of 15 points or more is known to a fifth.
constexpr double kShape = 1.25;
constexpr double kAgreed = 0.5;  // of the places where two regions meet

constexpr size_t kLeastFlat = 15;  // points of a region that tells its own plane
// Deviations from such a plane: 99.7 % of its points are within. Of a surface that only crosses it, this share of
// those within five times as many.
constexpr double kOfPlane = 3, kAbout = 5, kByCrossing = 1 / kAbout;
// Standard deviations of their number by chance; neighbours are not independent.
constexpr double kSure = 5;

// How far a place lies off the plane of a region that is flat, in standard deviations; NaN: no plane is told there. Of
// n points that scatter by s about it, with variances l1, l2 along it, the plane has at (u, v) from their mean the
// variance s^2 (1 + u^2 / l1 + v^2 / l2) / n (Draper and Smith 1998, 1.4). Two rows of different stations that cross
// tell one, a straight row does not.
double off_plane(const ChangeRegion& region, const Vec3& place, double noise_m) {
  const auto& [values, axes] = region.axes;
  const auto n = static_cast<double>(region.indices.size());
  if (region.indices.size() < kLeastFlat || values[0] > kShape * kShape * noise_m * noise_m)
    return kNaN;
  const Vec3 from = place - region.centroid;
  const double u = dot(from, axes[1]), v = dot(from, axes[2]);
  const double of_plane = (1 + u * u / values[1] + v * v / values[2]) / n;
  if (!(of_plane <= 1)) return kNaN;  // less sure than one of its points
  return std::abs(dot(from, axes[0])) / std::sqrt(values[0] * (1 + of_plane));
}

struct Meeting {
  size_t places = 0, agreed = 0;
  size_t in_plane = 0, about_plane = 0;  ///< of a region that is flat, points of the other

  Meeting& operator+=(const Meeting& other) {
    places += other.places, agreed += other.agreed;
    in_plane += other.in_plane, about_plane += other.about_plane;
    return *this;
  }
  void add_off(double off) {
    in_plane += off <= kOfPlane ? 1 : 0;
    about_plane += off <= kAbout * kOfPlane ? 1 : 0;
  }
  bool is_one_plane() const {
    const auto n = static_cast<double>(about_plane);
    const double by_chance = std::sqrt(n * kByCrossing * (1 - kByCrossing));
    return static_cast<double>(in_plane) > n * kByCrossing + kSure * by_chance;
  }
  bool is_one_surface() const {
    return static_cast<double>(agreed) >= kAgreed * static_cast<double>(places) || is_one_plane();
  }
};

/// What a station saw of an epoch's changed points.
class StationView {
 public:
  StationView(const Epoch& epoch, const Cloud& cloud, const Station& station, Task& task)
      : epoch_(epoch),
        cloud_(cloud),
        noise_m_(epoch.comparison->summary.require("noise").number(0)) {
    DepthSettings settings;
    settings.rule = CellRule::kNearest;
    settings.fill_passes = 0;
    map_ = DepthMap::build(cloud, station, {}, settings, task);
  }

  // Asks for all regions that are next to a changed point.
  void meet(uint32_t point, std::map<RegionPair, Meeting>& out) const {
    constexpr std::array<std::pair<int, int>, 5> kBeside{
        {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    AngularGrid::Place place;
    if (!map_.grid().locate(map_.sighting(cloud_.point(point)), place)) return;
    const uint32_t label = epoch_.regions.labels[point];
    for (const auto& [columns, rows] : kBeside) {
      const uint32_t other = changed_at(place, columns, rows);
      if (other == kNoPoint || epoch_.regions.labels[other] == label) continue;
      Meeting& meeting = out[std::minmax(label, epoch_.regions.labels[other])];
      ++meeting.places;
      meeting.agreed += are_in_plane({point, other}, place) ? 1 : 0;
      meeting.add_off(off_plane(region_of(point), cloud_.point(other), noise_m_));
      meeting.add_off(off_plane(region_of(other), cloud_.point(point), noise_m_));
    }
  }

 private:
  // The changed point of a cell beside a place.
  uint32_t changed_at(const AngularGrid::Place& place, int columns, int rows) const {
    const AngularGrid& grid = map_.grid();
    const int64_t row = int64_t{place.row} + rows;
    int64_t column = int64_t{place.column} + columns;
    if (grid.is_closed) column = (column + grid.columns) % grid.columns;
    if (row < 0 || row >= grid.rows || column < 0 || column >= grid.columns) return kNoPoint;
    const uint32_t point =
        map_.cell(static_cast<uint32_t>(column), static_cast<uint32_t>(row)).point;
    return point != kNoPoint && epoch_.regions.labels[point] != 0 ? point : kNoPoint;
  }

  const ChangeRegion& region_of(uint32_t point) const {
    return epoch_.regions.regions[epoch_.regions.labels[point] - 1];
  }

  using Two = std::array<uint32_t, 2>;
  // Two points and the changed ones about a place.
  bool are_in_plane(const Two& points, const AngularGrid::Place& place) const {
    for (int rows = -kShift; rows <= kShift; ++rows)
      for (int columns = -kShift; columns <= kShift; ++columns)
        if (is_plane(points, place, columns, rows)) return true;
    return false;
  }

  bool is_plane(const Two& points, const AngularGrid::Place& place, int columns, int rows) const {
    Moments moments;
    moments.reference = cloud_.point(points[0]);
    for (const uint32_t point : points) moments.add(cloud_.point(point));
    std::bitset<2 * kHalfWindow + 1> has_column, has_row;
    for (int j = -kHalfWindow; j <= kHalfWindow; ++j)
      for (int i = -kHalfWindow; i <= kHalfWindow; ++i) {
        const uint32_t other = changed_at(place, columns + i, rows + j);
        if (other == kNoPoint) continue;
        has_column.set(static_cast<size_t>(i + kHalfWindow));
        has_row.set(static_cast<size_t>(j + kHalfWindow));
        if (other != points[0] && other != points[1]) moments.add(cloud_.point(other));
      }
    PlaneFit fit;
    return has_column.count() >= kLeastLines && has_row.count() >= kLeastLines &&
           fit_plane(moments, fit) && fit.sigma <= kShape * noise_m_;
  }

  const Epoch& epoch_;
  const Cloud& cloud_;
  double noise_m_;
  DepthMap map_;
};

}  // namespace

std::vector<RegionPair> parts_of_one_surface(const Epoch& epoch, Task& task) {
  if (epoch.regions.regions.size() < 2) return {};
  const CloudPtr cloud = with_found_stations(epoch.comparison->cloud, task);
  std::vector<const Station*> stations;
  for (const Station& station : cloud->stations)
    if (station.has_pose && station.count > 0) stations.push_back(&station);
  std::vector<std::map<RegionPair, Meeting>> seen(stations.size());
  parallel_chunks(task, stations.size(), [&](size_t k) {
    const StationView view(epoch, *cloud, *stations[k], task);
    for (uint64_t i = stations[k]->first; i < stations[k]->first + stations[k]->count; ++i)
      if (epoch.regions.labels[i] != 0) view.meet(static_cast<uint32_t>(i), seen[k]);
  });
  std::map<RegionPair, Meeting> meetings;
  for (const auto& of_station : seen)
    for (const auto& [pair, meeting] : of_station) meetings[pair] += meeting;
  std::vector<RegionPair> out;
  for (const auto& [pair, meeting] : meetings)
    if (meeting.is_one_surface()) out.push_back(pair);
  return out;
}

}  // namespace jalon
