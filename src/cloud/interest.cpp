// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "base/setting_rows.h"
#include "cloud/facade_plane.h"
#include "cloud/operations.h"
#include "cloud/statistics.h"
#include "spatial/raster.h"

namespace jalon {

namespace {

constexpr size_t kInterestGrain = 1 << 15;

struct SlabPoint {
  uint32_t index;
  Vec2 position;  // along the facade, up
};

/// Step 2: the points in the slab about the plane, with their places in it, in order.
std::vector<SlabPoint> points_in_slab(const Cloud& cloud, const FacadePlane& facade, double front_m,
                                      double back_m, Task& task) {
  const size_t chunks = (cloud.size() + kInterestGrain - 1) / kInterestGrain;
  std::vector<std::vector<SlabPoint>> parts(chunks);
  parallel_for(task, cloud.size(), kInterestGrain, [&](size_t begin, size_t end) {
    auto& part = parts[begin / kInterestGrain];
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i) - facade.origin;
      const double s = facade.plane.distance(p);
      if (s >= -back_m && s <= front_m)
        part.push_back({static_cast<uint32_t>(i), {dot(p, facade.along), dot(p, facade.up)}});
    }
  });
  std::vector<SlabPoint> all;
  serial_for(task, parts.size(), 1,
             [&](size_t k, size_t) { all.insert(all.end(), parts[k].begin(), parts[k].end()); });
  return all;
}

/// Step 3: the largest connected region of the slab's image, and the regions within the gap.
std::vector<uint8_t> largest_entity(const Cloud& cloud, const std::vector<SlabPoint>& slab,
                                    double pixel_m, double gap_m, Task& task) {
  std::vector<uint8_t> mask(cloud.size(), 0);
  if (slab.empty()) return mask;
  std::vector<Vec2> flat(slab.size());
  parallel_for(task, slab.size(), kInterestGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) flat[i] = slab[i].position;
  });
  const auto reach = static_cast<uint32_t>(std::min(4096.0, std::round(gap_m / pixel_m)));
  const Raster raster = rasterise(flat, pixel_m);
  const Regions regions = label_regions(raster);
  Raster largest = raster;
  for (size_t p = 0; p < raster.size(); ++p) largest.pixels[p] = regions.labels[p] == 1;
  const Raster near = dilated(largest, reach);
  std::vector<uint8_t> wanted(regions.count() + 1, 0);
  for (size_t p = 0; p < raster.size(); ++p)
    if (near.pixels[p]) wanted[regions.labels[p]] = 1;
  parallel_for(task, slab.size(), kInterestGrain, [&](size_t begin, size_t end) {
    for (const SlabPoint& point : std::span(slab).subspan(begin, end - begin))
      if (wanted[regions.labels[raster.pixel_of(point.position)]]) mask[point.index] = 1;
  });
  return mask;
}

/// Step 4 (optional): drops what lies on or under the horizontal plane at the facade's foot, but
/// for the facade's own layer.
void remove_ground(const Cloud& cloud, const FacadePlane& facade, double tolerance_m, uint64_t seed,
                   Task& task, std::vector<uint8_t>& mask) {
  GroundPlane ground;
  if (!find_ground(cloud, facade, tolerance_m, seed, task, ground)) return;
  parallel_for(task, cloud.size(), kInterestGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i) - facade.origin;
      if (std::fabs(facade.plane.distance(p)) > tolerance_m &&
          ground.plane.distance(p) <= tolerance_m)
        mask[i] = 0;
    }
  });
}

Viewpoint viewpoint_of(const std::vector<double>& p, const Cloud& cloud) {
  if (p.size() == 3) return {true, {p[0], p[1], p[2]}};
  if (!p.empty())
    fail(Status::kInvalidArgument, "viewpoint has %zu numbers; it needs x, y, z", p.size());
  for (const Station& station : cloud.stations)
    if (station.has_pose && station.count > 0) return {true, station.pose.translation()};
  return {};
}

}  // namespace

std::span<const ParamRow> interest_rows() {
  using S = InterestSettings;
  static constexpr auto kRows = setting_rows(
      number_row<&S::distance_tolerance_m>(
          "distance_tolerance_m", 1e-6, 1e3, "m", "",
          "Half-thickness of the layer that counts for the main vertical plane"),
      number_row<&S::vertical_tolerance_rad>("vertical_tolerance_rad", 0, 0.8, "rad", "",
                                             "Largest lean of the main plane from the vertical"),
      number_row<&S::front_m>("front_m", 0, 1e3, "m", "",
                              "Depth kept in front of the main plane, toward the scanner: at least "
                              "the deepest projection (cornice, balcony)"),
      number_row<&S::back_m>("back_m", 0, 1e3, "m", "",
                             "Depth kept behind the main plane: at least the deepest reveal"),
      number_row<&S::pixel_m>("pixel_m", 1e-3, 1e3, "m", "",
                              "Pixel edge of the image in the plane in which the largest entity is "
                              "sought: 1.5 to 3 times the point spacing"),
      number_row<&S::gap_m>(
          "gap_m", 0, 1e3, "m", "",
          "Entities within this distance of the largest one, in the plane, stay with it"),
      bool_row<&S::remove_ground>("remove_ground", "",
                                  "Also drop the points of the horizontal plane at the foot"),
      doubles_row<&S::viewpoint>("viewpoint", -1e9, 1e9, "m", "",
                                 "Where the scanner stood (x, y, z), to tell front from back; "
                                 "empty = the stations, else the side with more points"),
      integer_row<&S::seed>("seed", 0, 0x1p53, "", "", "Seed of the random draws"));
  return kRows;
}

std::vector<uint8_t> points_of_interest(const Cloud& cloud, const InterestSettings& settings,
                                        Task& task) {
  const Viewpoint viewpoint = viewpoint_of(settings.viewpoint, cloud);
  const double tolerance_m = settings.distance_tolerance_m;
  if (cloud.size() >= 0xffffffffu) fail(Status::kLimit, "more than 2^32 - 2 points");
  FacadePlane facade;
  {
    ProgressSpan span(task, 0, 0.6, "main plane");
    facade = find_facade_plane(cloud, tolerance_m, settings.vertical_tolerance_rad, viewpoint,
                               settings.seed, task);
  }
  std::vector<SlabPoint> slab;
  {
    ProgressSpan span(task, 0.6, 0.8, "slab");
    slab = points_in_slab(cloud, facade, settings.front_m, settings.back_m, task);
  }
  ProgressSpan span(task, 0.8, 1, "largest entity");
  std::vector<uint8_t> mask = largest_entity(cloud, slab, settings.pixel_m, settings.gap_m, task);
  if (settings.remove_ground) remove_ground(cloud, facade, tolerance_m, settings.seed, task, mask);
  return mask;
}

}  // namespace jalon
