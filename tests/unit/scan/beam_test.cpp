// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "scan/pulse.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kBeam_m = 0.010, kDivergence_rad = 2e-4;

/// A panel of 2 x 2 m, 0.2 m before a wall, and further left one 3 m before it; seen from the origin, 10 m away.
Model panels() {
  Model model;
  const auto add = [&](double x0, double x1, double y, double z0, double z1, uint32_t id) {
    const auto first = static_cast<uint32_t>(model.vertices.size());
    for (const auto& [x, z] : {std::pair{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}})
      model.vertices.push_back({x, y, z});
    model.triangles.push_back({first, first + 1, first + 2});
    model.triangles.push_back({first, first + 2, first + 3});
    model.triangle_faces.insert(model.triangle_faces.end(), 2, id);
  };
  add(-6, 6, 10, -4, 4, 1);
  add(0, 2, 9.8, -1, 1, 2);
  add(-3, -1, 7, -1, 1, 3);
  return model;
}

const ScanStation kOrigin = station_at({0, 0, 0});

/// The panels fill the view.
StaticSettings line_settings(double step_rad, const StaticSettings& more = {}) {
  StaticSettings params = quiet_settings(step_rad, more);
  params.horizontal_from_rad = -0.6;
  params.horizontal_to_rad = 0.6;
  params.vertical_from_rad = -0.42;
  params.vertical_to_rad = 0.42;
  return params;
}

StaticSettings beam_settings(double step_rad, const StaticSettings& more = {}) {
  StaticSettings params = line_settings(step_rad, more);
  params.beam_diameter_m = kBeam_m;
  params.beam_divergence_rad = kDivergence_rad;
  return params;
}

/// Distance of a point, projected from the origin, to the nearest border of the wall or a panel.
double to_border(const Vec3& p) {
  double nearest = 1e9;
  for (const auto& [x0, x1, y, z] :
       {std::array{0.0, 2.0, 9.8, 1.0}, {-3.0, -1.0, 7.0, 1.0}, {-6.0, 6.0, 10.0, 4.0}}) {
    const Vec3 q = p * (y / p.y);
    const double dx = std::max(x0 - q.x, q.x - x1), dz = std::max(-z - q.z, q.z - z);
    const double d = std::max(dx, dz) <= 0 ? -std::max(dx, dz)
                                           : std::hypot(std::max(dx, 0.0), std::max(dz, 0.0));
    nearest = std::min(nearest, d);
  }
  return nearest;
}

std::map<std::pair<long, long>, size_t> by_direction(const Cloud& cloud) {
  std::map<std::pair<long, long>, size_t> out;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.point(i);
    out[{std::lround(1e6 * std::atan2(p.x, p.y)), std::lround(1e6 * std::asin(p.z / norm(p)))}] = i;
  }
  return out;
}

}  // namespace

TEST_CASE("beam__mixes_at_edges_within_the_resolution_and_nowhere_else") {
  const Model model = panels();
  const Cloud line = scanned(model, line_settings(0.0007), {&kOrigin, 1});
  const Cloud beam = scanned(model, beam_settings(0.0007), {&kOrigin, 1});
  const auto lines = by_direction(line);
  const auto segments = values<uint32_t>(beam, "segment"), faces = values<uint32_t>(beam, "face");
  size_t mixed = 0, changed = 0;
  const double reach = kBeam_m / 2 + 10.5 * kDivergence_rad / 2;
  for (const auto& [direction, i] : by_direction(beam)) {
    const Vec3 p = beam.point(i);
    const auto other = lines.find(direction);
    if (segments[i] == kNoSegment) {
      ++mixed;
      // Between panel and wall on its ray, and so of no plane; only the panel 0.2 m before the wall mixes with it.
      CHECK(p.y > 9.8);
      CHECK(p.y < 10);
      CHECK(p.x > -0.01);
      CHECK((faces[i] == 1 || faces[i] == 2));
      CHECK(to_border(p) <= reach * 1.01);
    } else if (to_border(p) > reach * 1.2) {
      REQUIRE(other != lines.end());
      REQUIRE(line.point(other->second) == p);
    } else if (other != lines.end() && line.point(other->second).y - p.y > 2) {
      ++changed;  // the first return of a beam that the nearer panel cuts
    }
  }
  MESSAGE("FIGURE " << mixed << " mixed pixels of " << beam.size() << " points, " << changed
                    << " first returns beside the axis");
  CHECK(mixed > 500);
  CHECK(changed > 100);
}

TEST_CASE("beam__mixes_in_a_strip_of_its_width_along_a_border") {
  // A narrow view of the right border of the panel before the wall: about 1 m of it, 10 m away.
  constexpr double kStep = 4e-6;
  constexpr size_t kRows = 11;
  StaticSettings params = beam_settings(kStep);
  params.vertical_step_rad = 0.01;
  params.horizontal_from_rad = 0.195;
  params.horizontal_to_rad = 0.208;
  params.vertical_from_rad = -0.05;
  params.vertical_to_rad = 0.05;
  const Cloud beam = scanned(panels(), params, {&kOrigin, 1});
  const auto segments = values<uint32_t>(beam, "segment");
  const auto mixed = static_cast<double>(std::count(segments.begin(), segments.end(), kNoSegment));
  const double range = std::hypot(2.0, 9.8), strip = mixed / kRows * kStep * range;
  // Rims of the outermost sub-rays: root mean square radius of the outer ring, the nearest 15 degrees off the border.
  const double width =
      2 * (kBeam_m / 2 + range * kDivergence_rad / 2) * std::sqrt(13.0 / 19.0) * std::cos(0.2618);
  MESSAGE("FIGURE mixed strip " << 1000 * strip << " mm wide, the sub-rays " << 1000 * width);
  CHECK(std::abs(strip - width) < 0.01 * width);
}

TEST_CASE("beam__with_a_finer_range_resolution_returns_the_first_or_the_last_surface") {
  const Model model = panels();
  const StaticSettings fine{.range_resolution_m = 0.05};
  using Echo = StaticSettings::Echo;
  const auto count_behind = [&](Echo echo) {
    StaticSettings options = fine;
    options.echo = echo;
    const Cloud cloud = scanned(model, beam_settings(0.001, options), {&kOrigin, 1});
    const auto segments = values<uint32_t>(cloud, "segment");
    size_t behind = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      REQUIRE(segments[i] != kNoSegment);
      behind += segments[i] == 1;
    }
    return behind;
  };
  const size_t first = count_behind(Echo::kFirst), strongest = count_behind(Echo::kStrongest),
               last = count_behind(Echo::kLast);
  CHECK(first < strongest);
  CHECK(strongest < last);
}

TEST_CASE("beam__without_a_width_or_sub_rays_is_a_line") {
  const Model model = scene("facade");
  const Cloud line = scanned(model, line_settings(0.01));
  CHECK(line.size() > 1000);
  CHECK(same_clouds(line, scanned(model, line_settings(0.01, {.beam_rings = 5}))));
  StaticSettings params = beam_settings(0.01, {.beam_rings = 0});
  CHECK(same_clouds(line, scanned(model, params)));
}

TEST_CASE("beam__of_a_scene_lies_on_its_faces_but_for_mixed_pixels") {
  const Model model = scene("insa_surveyed");
  const auto faces = faces_by_id(model);
  StaticSettings params = quiet_settings(0.004, {.instrument = StaticSettings::Instrument::kGx});
  const Cloud cloud = scanned(model, params);
  const auto ids = values<uint32_t>(cloud, "face"), segments = values<uint32_t>(cloud, "segment");
  const auto range = values<float>(cloud, "range");
  size_t mixed = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const double distance =
        std::abs(faces.at(ids[i]).front()->plane.distance(true_point(cloud, i)));
    if (segments[i] == kNoSegment) ++mixed;
    else
      REQUIRE(distance <
              30e-6 * static_cast<double>(range[i]));  // a beam cut by a border: within its radius
  }
  MESSAGE("FIGURE gx on insa_surveyed: " << mixed << " of " << cloud.size()
                                         << " pixels are mixed or of small faces");
  CHECK(mixed > 0);
  CHECK(mixed < cloud.size() / 20);
}
