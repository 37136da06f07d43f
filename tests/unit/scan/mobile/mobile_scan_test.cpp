// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/mobile_scan.h"

#include <doctest/doctest.h>

#include <set>

#include "model/buildings/building_tree.h"
#include "scan/mobile/street_drive.h"

using namespace jalon;

namespace {

struct StripStreet {
  BuildingTree tree;
  Model strips;
  Trajectory drive;
};

StripStreet strip_street() {
  const StreetDrive street = street_drive({});
  BuildingSettings settings;
  settings.touch_m = 2;
  Task task;
  StripStreet made{building_tree(street.model, settings, task), {}, street.trajectory};
  made.strips = strip_model(made.tree);
  return made;
}

// A plane scanner across the way ahead, looking a little forward.
MobileSettings across() {
  MobileSettings settings;
  settings.mount.boresight_rad = {0, std::numbers::pi / 2, 0.4};
  settings.mount.lever_arm_m = {0.5, 0.2, 1.8};
  settings.revolutions_per_s = 10, settings.pulses = 400;
  return settings;
}

std::span<const uint32_t> ids(const Cloud& cloud, const char* name) {
  return cloud.fields.require(name).values<uint32_t>();
}

}  // namespace

TEST_CASE("scan_mobile__of_a_street_of_strips__lies_on_the_strips_that_it_names") {
  const StripStreet street = strip_street();
  Task task;
  const Cloud cloud = scan_mobile(street.strips, street.drive, across(), task);
  CHECK(cloud.size() > 30000);
  const auto strip = ids(cloud, "strip"), facade = ids(cloud, "facade"),
             block = ids(cloud, "block"), face = ids(cloud, "face");
  const auto range = cloud.fields.require("range").values<double>();
  const auto origin = cloud.fields.require("beam_origin").values<double>();
  const auto way = cloud.fields.require("beam_direction").values<float>();
  std::set<uint32_t> seen;
  size_t from_behind = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    REQUIRE(strip[i] < street.tree.strips.size());
    const BuildingStrip& s = street.tree.strips[strip[i]];
    const BuildingFacade& f = street.tree.facades[s.facade];
    CHECK(face[i] == strip[i]);
    CHECK(facade[i] == s.facade);
    CHECK(block[i] == street.tree.block_of(f));
    CHECK(std::fabs(dot(f.normal, cloud.point(i)) - f.offset_m) < 1e-9);
    const double along = dot(f.along(), cloud.point(i));
    CHECK(along > s.from_m - 1e-9);
    CHECK(along < s.to_m + 1e-9);
    from_behind += f.normal.x * way[3 * i] + f.normal.y * way[3 * i + 1] > 0;
    CHECK(norm(cloud.point(i) - Vec3{origin[3 * i], origin[3 * i + 1], origin[3 * i + 2]}) ==
          doctest::Approx(range[i]));
    seen.insert(strip[i]);
  }
  // The scanner looks ahead: what stands beside the start is not passed. Fronts without houses are seen
  // from behind through the gaps between blocks.
  CHECK(seen.size() + 4 >= street.tree.strips.size());
  CHECK(from_behind < cloud.size() / 50);
}

TEST_CASE("scan_mobile__georeferenced_again__gives_the_same_points") {
  const StripStreet street = strip_street();
  Task task;
  MobileSettings settings = across();
  settings.noise_range_m = 0.005, settings.noise_angle_rad = 1e-4;
  const Cloud cloud = scan_mobile(street.strips, street.drive, settings, task);
  const auto values = [&](const char* name) { return cloud.fields.require(name).values<double>(); };
  const Cloud again =
      georeferenced(street.drive, {values("time"), values("range"), values("theta"), values("phi")},
                    settings.mount, task);
  CHECK(std::equal(cloud.xyz().begin(), cloud.xyz().end(), again.xyz().begin()));
  // Noise: 5 mm along the beam.
  const auto truth = values("true_xyz");
  const auto way = cloud.fields.require("beam_direction").values<float>();
  double sum2 = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 e = cloud.point(i) - Vec3{truth[3 * i], truth[3 * i + 1], truth[3 * i + 2]};
    const double along = e.x * way[3 * i] + e.y * way[3 * i + 1] + e.z * way[3 * i + 2];
    sum2 += along * along;
  }
  CHECK(std::sqrt(sum2 / static_cast<double>(cloud.size())) ==
        doctest::Approx(0.005).epsilon(0.02).scale(0));
}

TEST_CASE("scan_mobile__with_any_number_of_threads__gives_the_same_bits") {
  const StripStreet street = strip_street();
  MobileSettings settings = across();
  settings.noise_range_m = 0.01;
  Task::Hooks one, three;
  one.threads = 1, three.threads = 3;
  Task a(one), b(three);
  const Cloud single = scan_mobile(street.strips, street.drive, settings, a),
              many = scan_mobile(street.strips, street.drive, settings, b);
  REQUIRE(single.size() == many.size());
  CHECK(std::equal(single.xyz().begin(), single.xyz().end(), many.xyz().begin()));
}

TEST_CASE("scan_mobile__with_a_rotating_head__sends_a_fan_of_beams") {
  const StripStreet street = strip_street();
  MobileSettings settings;
  settings.beams = 16, settings.fan_rad = 0.5, settings.revolutions_per_s = 2, settings.pulses = 90;
  settings.mount.lever_arm_m = {0, 0, 2};
  Task task;
  const Cloud cloud = scan_mobile(street.strips, street.drive, settings, task);
  const auto phi = cloud.fields.require("phi").values<double>();
  std::set<double> levels(phi.begin(), phi.end());
  CHECK(levels.size() == 16);
  CHECK(*levels.rbegin() - *levels.begin() == doctest::Approx(0.5));
}

TEST_CASE("scan_mobile__of_a_mesh_without_strips__has_no_numbers_for_them") {
  StreetDriveSettings closed;
  closed.closed = true;
  const StreetDrive street = street_drive(closed);
  Task task;
  MobileSettings settings = across();
  settings.pulses = 100, settings.max_range_m = 12;
  const Cloud cloud = scan_mobile(street.model, street.trajectory, settings, task);
  REQUIRE(cloud.size() > 1000);
  for (size_t i = 0; i < cloud.size(); ++i) {
    CHECK(ids(cloud, "strip")[i] == ~0u);
    CHECK(ids(cloud, "face")[i] < street.model.faces.size());
  }
  const auto range = cloud.fields.require("range").values<double>();
  CHECK(*std::max_element(range.begin(), range.end()) <= 12);
}
