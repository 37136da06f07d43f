// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <numbers>

#include "base/error.h"
#include "spatial/triangles/tree.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model one_triangle() {
  Model model;
  model.vertices = {{-1, 5, 0}, {1, 5, 0}, {0, 5, 2}};
  model.triangles = {{0, 1, 2}};
  model.triangle_faces = {7};
  return model;
}

}  // namespace

TEST_CASE("static_scan__noise_free_points_lie_on_their_face") {
  for (const char* name : {"facade", "street", "room", "box", "surrounds", "strips"}) {
    CAPTURE(name);
    const Model model = scene(name);
    const auto faces = faces_by_id(model);
    const Cloud cloud = scanned(model, quiet_settings(0.01));
    const auto ids = values<uint32_t>(cloud, "face");
    const auto range = values<float>(cloud, "range");
    CHECK(same_bits(cloud.xyz(), values<double>(cloud, "true_xyz")));
    REQUIRE(cloud.size() > 5000);
    size_t curved = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Vec3 p = cloud.point(i);
      REQUIRE(std::abs(norm(p - station_of(cloud, i)->pose.translation()) -
                       static_cast<double>(range[i])) < 1e-5);
      const auto found = faces.find(ids[i]);
      if (found == faces.end()) {
        ++curved;
        continue;
      }
      REQUIRE(std::abs(found->second.front()->plane.distance(p)) < 1e-10);
      REQUIRE(std::any_of(found->second.begin(), found->second.end(),
                          [&](const Face* face) { return is_inside(model, *face, p, 1e-9); }));
    }
    CHECK((std::string(name) == "street" ? curved > 500 : curved == 0));
  }
}

TEST_CASE("static_scan__sees_nothing_behind_a_surface") {
  const Model model = scene("street");
  const Cloud cloud = scanned(model, quiet_settings(0.02));
  size_t checked = 0;
  for (size_t i = 0; i < cloud.size(); i += 101, ++checked) {
    const Vec3 eye = station_of(cloud, i)->pose.translation(), d = cloud.point(i) - eye;
    for (const auto& [ia, ib, ic] : model.triangles) {  // Moeller & Trumbore 1997
      const Vec3 a = model.vertices[ia], e1 = model.vertices[ib] - a, e2 = model.vertices[ic] - a;
      const Vec3 p = cross(d, e2), s = eye - a, q = cross(s, e1);
      const double determinant = dot(e1, p);
      if (std::abs(determinant) < 1e-12) continue;
      const double u = dot(s, p) / determinant, v = dot(d, q) / determinant,
                   t = dot(e2, q) / determinant;
      REQUIRE_FALSE((u > 1e-9 && v > 1e-9 && u + v < 1 - 1e-9 && t > 0 && t < 1 - 1e-9));
    }
  }
  CHECK(checked > 200);
}

TEST_CASE("static_scan__noise_has_the_deviations_asked_for") {
  const Model model = scene("facade");
  const auto faces = faces_by_id(model);
  const double range_noise = 0.003, angle_noise = 1e-4;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    StaticSettings params = quiet_settings(0.008);
    params.range_noise_m = range_noise;
    params.angle_noise_rad = angle_noise;
    params.seed = seed;
    const Cloud cloud = scanned(model, params);
    const auto ids = values<uint32_t>(cloud, "face");
    // Distance to the true plane over its deviation by error propagation of eq. 1.1: standard normal.
    double sum = 0, squares = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Plane& plane = faces.at(ids[i]).front()->plane;
      const Vec3 ray = true_point(cloud, i) - station_of(cloud, i)->pose.translation();
      const double r = norm(ray);
      const Vec3 d = ray / r;
      const double c = std::hypot(d.x, d.y);
      const Vec3 by_h{d.y, -d.x, 0}, by_v{-d.z * d.x / c, -d.z * d.y / c, c};
      const auto squared = [](double x) { return x * x; };
      const double variance = squared(range_noise * dot(plane.normal, d)) +
                              squared(angle_noise * r) * (squared(dot(plane.normal, by_h)) +
                                                          squared(dot(plane.normal, by_v)));
      const double z = plane.distance(cloud.point(i)) / std::sqrt(variance);
      sum += z;
      squares += z * z;
    }
    const double n = static_cast<double>(cloud.size());
    MESSAGE("seed " << seed << ": " << cloud.size() << " points, mean " << sum / std::sqrt(n)
                    << " and chi2 " << (squares - n) / std::sqrt(2 * n)
                    << " in standard deviations of each");
    CHECK(std::abs(sum) < 4 * std::sqrt(n));
    CHECK(std::abs(squares - n) < 4 * std::sqrt(2 * n));
  }
}

TEST_CASE("static_scan__point_noise_is_the_same_in_all_directions") {
  const Model model = scene("room");
  StaticSettings params = quiet_settings(0.01);
  params.point_noise_m = 0.003;
  const Cloud cloud = scanned(model, params);
  Vec3 squares;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 d = (cloud.point(i) - true_point(cloud, i)) / 0.003;
    squares += Vec3{d.x * d.x, d.y * d.y, d.z * d.z};
  }
  const double n = static_cast<double>(cloud.size());
  for (int a = 0; a < 3; ++a) CHECK(std::abs(squares[a] - n) < 4 * std::sqrt(2 * n));
}

TEST_CASE("static_scan__loses_and_spoils_the_shares_asked_for") {
  const Model model = scene("facade");
  const size_t all = scanned(model, quiet_settings(0.005)).size();
  for (const std::string place : {"ray", "box"}) {
    using Place = StaticSettings::OutlierPlace;
    const StaticSettings params =
        quiet_settings(0.005, {.dropout = 0.1,
                               .outliers = 0.05,
                               .outlier_place = place == "box" ? Place::kBox : Place::kRay});
    const Cloud cloud = scanned(model, params);
    CHECK(is_binomial(cloud.size(), all, 0.9));
    const auto ids = values<uint32_t>(cloud, "face");
    const auto spoilt = static_cast<size_t>(std::count(ids.begin(), ids.end(), kNoFace));
    CHECK(is_binomial(spoilt, cloud.size(), 0.05));
    MESSAGE(place << ": " << cloud.size() << " of " << all << " points, " << spoilt << " outliers");
    Box3 box;
    for (const Vec3& v : model.vertices) box.add(v);
    const Task::Hooks hooks;
    Task task(hooks);
    const auto tree = TriangleTree::build(model.vertices, model.triangles, task);
    Vec3 mean;
    for (size_t i = 0; i < cloud.size(); ++i) {
      if (ids[i] != kNoFace) continue;
      const Vec3 p = cloud.point(i), eye = station_of(cloud, i)->pose.translation();
      mean += p;
      CHECK(p == true_point(cloud, i));
      CHECK(norm(p - eye) == doctest::Approx(values<float>(cloud, "range")[i]));
      if (place == "box") REQUIRE(box.contains(p));
      else REQUIRE_FALSE(tree->occluded({eye, p - eye, 0, 1 - 1e-9}));
    }
    mean = mean / static_cast<double>(spoilt);
    if (place == "box")
      for (int a = 0; a < 3; ++a)
        CHECK(std::abs(mean[a] - (box.min[a] + box.max[a]) / 2) <
              5 * (box.max[a] - box.min[a]) / std::sqrt(12.0 * static_cast<double>(spoilt)));
  }
  StaticSettings none = quiet_settings(0.02, {.dropout = 1.0});
  CHECK(scanned(model, none).size() == 0);
}

TEST_CASE("static_scan__adds_the_national_grid_exactly") {
  const Model model = scene("facade");
  const auto run = [&](double e, double n, double h, bool noisy) {
    StaticSettings params =
        noisy ? StaticSettings{.horizontal_step_rad = 0.01, .vertical_step_rad = 0.01}
              : quiet_settings(0.01);
    params.offset_m = {e, n, h};
    return scanned(model, params);
  };
  const Vec3 offset{652000.125, 6861000.5, 35};
  for (const bool noisy : {false, true}) {
    const Cloud local = run(0, 0, 0, noisy), grid = run(offset.x, offset.y, offset.z, noisy);
    REQUIRE(grid.size() == local.size());
    for (size_t i = 0; i < local.size(); ++i) {
      REQUIRE(grid.point(i) == local.point(i) + offset);
      REQUIRE(true_point(grid, i) == true_point(local, i) + offset);
    }
    for (size_t s = 0; s < 2; ++s)
      CHECK(grid.stations[s].pose.translation() == local.stations[s].pose.translation() + offset);
  }
}

TEST_CASE("static_scan__of_a_model_shifted_by_whole_metres_is_shifted_exactly") {
  Model model = scene("facade");
  for (Vec3& v : model.vertices)
    v = Vec3{std::nearbyint(v.x * 0x1p20), std::nearbyint(v.y * 0x1p20),
             std::nearbyint(v.z * 0x1p20)} *
        0x1p-20;
  const Vec3 shift{652000, 6861000, 35};
  Model far = model;
  for (Vec3& v : far.vertices) v += shift;
  StaticSettings params = StaticSettings{
      .horizontal_step_rad = 0.01, .vertical_step_rad = 0.01, .coordinate_step_m = 0x1p-20};
  const ScanStation here[] = {station_at({5, -13, 1.75}), station_at({17, -12, 1.5})};
  const ScanStation there[] = {station_at(Vec3{5, -13, 1.75} + shift),
                               station_at(Vec3{17, -12, 1.5} + shift)};
  const Cloud a = scanned(model, params, here), b = scanned(far, params, there);
  REQUIRE(a.size() == b.size());
  REQUIRE(a.size() > 10000);
  for (size_t i = 0; i < a.size(); ++i) REQUIRE(b.point(i) - shift == a.point(i));
}

TEST_CASE("static_scan__gives_the_same_bits_on_any_number_of_threads_and_others_for_another_seed") {
  const Model model = scene("street");
  StaticSettings params = StaticSettings{.horizontal_step_rad = 0.01,
                                         .vertical_step_rad = 0.01,
                                         .point_noise_m = 0.001,
                                         .dropout = 0.02,
                                         .outliers = 0.02};
  params.incidence_angle = true;
  const Cloud one = scanned(model, params, {}, 1);
  CHECK(one.size() > 50000);
  CHECK(same_clouds(one, scanned(model, params, {}, 2)));
  CHECK(same_clouds(one, scanned(model, params, {}, 7)));
  // More noise changes neither what is lost nor what is spoilt.
  params.range_noise_m = 0.02;
  const Cloud noisier = scanned(model, params);
  REQUIRE(noisier.size() == one.size());
  const auto a = values<uint32_t>(one, "face"), b = values<uint32_t>(noisier, "face");
  CHECK(std::equal(a.begin(), a.end(), b.begin()));
  CHECK_FALSE(same_bits(one.xyz(), noisier.xyz()));
  params.seed = 2;
  CHECK(scanned(model, params).size() != one.size());
}

TEST_CASE("static_scan__turns_with_its_pose_and_follows_the_polar_equation") {
  // A scanner turned by a right angle looks along its own +Y, which is the world's -X.
  const Model room = scene("room");
  ScanStation station;
  station.name = "turned";
  station.pose.m = {0, -1, 0, 3, 1, 0, 0, 2, 0, 0, 1, 1.5};
  StaticSettings params = quiet_settings(0.01, {.horizontal_from_rad = 0,
                                                .horizontal_to_rad = 0.005,
                                                .vertical_from_rad = 0,
                                                .vertical_to_rad = 0});
  const Cloud cloud = scanned(room, params, {&station, 1});
  REQUIRE(cloud.size() == 1);
  CHECK(norm(cloud.point(0) - Vec3{0, 2, 1.5}) < 1e-12);
  CHECK(cloud.stations[0].name == "turned");
  params.horizontal_from_rad =
      std::numbers::pi / 2;  // clockwise: +X of the scanner, +Y of the world
  params.horizontal_to_rad = std::numbers::pi / 2;
  const Cloud side = scanned(room, params, {&station, 1});
  REQUIRE(side.size() == 1);
  CHECK(norm(side.point(0) - Vec3{3, 5, 1.5}) < 1e-12);
}

TEST_CASE("static_scan__covers_its_field_of_view_once") {
  const Model room = scene("room");
  const ScanStation station = station_at({3, 2.5, 1.4});
  const double step = 2 * std::numbers::pi / 360;
  const StaticSettings params = quiet_settings(step, {.vertical_from_rad = -std::numbers::pi / 2});
  const Cloud cloud = scanned(room, params, {&station, 1});
  CHECK(cloud.size() == 360 * 181);  // the full circle without a double column, both poles
  StaticSettings rows = params;
  rows.order = StaticSettings::Order::kRows;
  const Cloud by_rows = scanned(room, rows, {&station, 1});
  REQUIRE(by_rows.size() == cloud.size());
  CHECK(by_rows.point(0) == cloud.point(0));
  for (size_t i = 0; i < 360; i += 7)
    for (size_t j = 0; j < 181; j += 5)
      REQUIRE(by_rows.point(j * 360 + i) == cloud.point(i * 181 + j));
  StaticSettings near = params;
  near.min_range_m = 2;
  near.max_range_m = 3;
  const Cloud shell = scanned(room, near, {&station, 1});
  CHECK(shell.size() > 100);
  for (const float r : values<float>(shell, "range")) REQUIRE((r >= 2 && r <= 3));
}

TEST_CASE("static_scan__tells_the_incidence_angle") {
  StaticSettings params = quiet_settings(0.02);
  params.incidence_angle = true;
  const Model room = scene("room");
  const auto faces = faces_by_id(room);
  const Cloud cloud = scanned(room, params);
  for (size_t i = 0; i < cloud.size(); i += 11) {
    const Vec3 d = normalized(cloud.point(i) - station_of(cloud, i)->pose.translation());
    const double expected =
        std::acos(-dot(d, faces.at(values<uint32_t>(cloud, "face")[i]).front()->plane.normal));
    REQUIRE(std::abs(static_cast<double>(values<float>(cloud, "incidence_angle")[i]) - expected) <
            1e-6);
  }
}

TEST_CASE("static_scan__of_poor_models_and_places_ends_in_a_cloud_or_a_clear_error") {
  const ScanStation origin = station_at({0, 0, 1});
  const StaticSettings params = quiet_settings(0.05);
  const Cloud none = scanned(Model{}, params, {&origin, 1});
  CHECK(none.size() == 0);
  CHECK(none.fields.require("face").count() == 0);
  CHECK(none.stations.size() == 1);
  CHECK(scanned(Model{}, params).stations.empty());
  CHECK(scanned(one_triangle(), params, {&origin, 1}).size() > 10);

  Model point = one_triangle();
  point.vertices[1] = point.vertices[2] = point.vertices[0];
  CHECK(scanned(point, params, {&origin, 1}).size() == 0);

  const ScanStation in_wall = station_at({0, 5, 0.5});
  CHECK_NOTHROW(scanned(one_triangle(), params, {&in_wall, 1}));
  const ScanStation far_away = station_at({1e8, 1e8, 1e8});
  CHECK(scanned(one_triangle(), params, {&far_away, 1}).size() == 0);

  Model broken = one_triangle();
  broken.triangles[0][2] = 3;
  CHECK_THROWS_AS(scanned(broken, params, {&origin, 1}), Error);
  broken = one_triangle();
  broken.vertices[0].x = std::nan("");
  CHECK_THROWS_AS(scanned(broken, params, {&origin, 1}), Error);
  ScanStation bent = origin;
  bent.pose.m[0] = 2;
  CHECK_THROWS_AS(scanned(one_triangle(), params, {&bent, 1}), Error);
  const auto refused = [&](const StaticSettings& settings) {
    CHECK_THROWS_AS(scanned(one_triangle(), quiet_settings(0.05, settings), {&origin, 1}), Error);
  };
  refused({.min_range_m = 10, .max_range_m = 5});
  refused({.horizontal_from_rad = 1, .horizontal_to_rad = 0});
  StaticSettings two = params;
  two.offset_m = {1, 2};
  CHECK_THROWS_AS(scanned(one_triangle(), two, {&origin, 1}), Error);
  StaticSettings fine = params;
  fine.horizontal_step_rad = 1e-6;
  fine.vertical_step_rad = 1e-6;
  CHECK_THROWS_AS(scanned(one_triangle(), fine, {&origin, 1}), Error);  // 1.6e13 rays
}

TEST_CASE("static_scan__stops_at_a_cancel_and_reports_no_further") {
  using Clock = std::chrono::steady_clock;
  struct Host {
    std::atomic<bool> cancel{false};
    Clock::time_point when;
    double last = 0;
    bool grew = true;
    int after_cancel = 0;
  } host;
  Task::Hooks hooks;
  hooks.cancel = &host.cancel;
  hooks.progress_user = &host;
  hooks.progress = [](double fraction, const char*, void* user) {
    auto& h = *static_cast<Host*>(user);
    h.grew = h.grew && fraction >= h.last;
    h.last = fraction;
    if (h.cancel) ++h.after_cancel;
    else if (fraction > 0.2) h.cancel = true, h.when = Clock::now();
    return 0;
  };
  Task task(hooks);
  StaticSettings params = StaticSettings{};
  params.horizontal_step_rad = 1e-3;
  params.vertical_step_rad = 1e-3;
  Status status = Status::kOk;
  try {
    scan_static(scene("street"), {}, params, task);
  } catch (const Error& error) {
    status = error.status();
  }
  const double waited = std::chrono::duration<double>(Clock::now() - host.when).count();
  CHECK(status == Status::kCancelled);
  CHECK(host.grew);
  CHECK(host.last > 0.2);
  CHECK(host.last < 1);
  CHECK(host.after_cancel == 0);
  MESSAGE("FIGURE static scan: stopped " << 1e3 * waited << " ms after the cancel");
}

TEST_CASE("static_scan__default_facade_has_at_least_500_000_points") {
  using Clock = std::chrono::steady_clock;
  const Model model = scene("facade");
  for (const unsigned threads : {1u, 2u}) {
    const auto start = Clock::now();
    const Cloud cloud = scanned(model, StaticSettings{}, {}, threads);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    CHECK(cloud.size() >= 500000);
    CHECK(cloud.stations.size() == 2);
    const double rays = 2.0 * 3927 * 1637;
    MESSAGE(cloud.size() << " points from " << rays << " rays in " << seconds << " s with "
                         << threads << " threads: " << 1e-6 * rays / seconds
                         << " M rays/s, all included");
  }
}
