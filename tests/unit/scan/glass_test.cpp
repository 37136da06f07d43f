// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "base/error.h"
#include "scan/truth.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Ids of the faces of parts of these classes.
std::set<uint32_t> ids_of(const Model& model, const std::set<std::string>& classes) {
  std::set<uint32_t> ids;
  for (const Face& face : model.faces)
    if (classes.contains(model.parts[face.part].part_class)) ids.insert(face.id);
  return ids;
}

std::map<uint32_t, size_t> points_of_faces(const Cloud& cloud) {
  std::map<uint32_t, size_t> out;
  for (const uint32_t id : values<uint32_t>(cloud, "face")) ++out[id];
  return out;
}

StaticSettings glass(double least, double most) {
  return {.surfaces = {.glass_return_min = least, .glass_return_max = most}};
}

}  // namespace

TEST_CASE("glass__returns_the_share_asked_for_and_lets_the_rest_through") {
  const Model model = scene("insa_surveyed");
  const auto panes = ids_of(model, {"glass"}), curtains = ids_of(model, {"curtain"});
  CHECK(panes.size() > 100);
  CHECK(curtains.size() > 30);
  const StaticSettings opaque = quiet_settings(0.004);
  const auto all = points_of_faces(scanned(model, opaque));
  const auto some = points_of_faces(scanned(model, quiet_settings(0.004, glass(0.3, 0.3))));
  size_t of_panes = 0, returned = 0, seen_curtains = 0;
  for (const auto& [id, n] : all) {
    const size_t now = some.contains(id) ? some.at(id) : 0;
    if (panes.contains(id)) of_panes += n, returned += now;
    else CHECK(now >= n);
  }
  CHECK(is_binomial(returned, of_panes, 0.3));
  for (const uint32_t id : curtains) {
    CHECK_FALSE(all.contains(id));
    seen_curtains += some.contains(id) ? some.at(id) : 0;
  }
  CHECK(seen_curtains > 1000);
  MESSAGE("FIGURE glass: " << returned << " of " << of_panes << " pulses returned, "
                           << seen_curtains << " on curtains behind");
}

TEST_CASE("glass__each_pane_has_its_own_share_between_the_limits") {
  const Model model = scene("insa_surveyed");
  const auto panes = ids_of(model, {"glass"});
  const auto all = points_of_faces(scanned(model, quiet_settings(0.002)));
  const auto some = points_of_faces(scanned(model, quiet_settings(0.002, glass(0.05, 0.3))));
  double least = 1, most = 0;
  for (const uint32_t id : panes) {
    if (!all.contains(id) || all.at(id) < 300) continue;
    const double n = static_cast<double>(all.at(id)),
                 share = some.contains(id) ? static_cast<double>(some.at(id)) / n : 0;
    const double five = 5 * std::sqrt(0.3 * 0.7 / n);
    CHECK(share > 0.05 - five);
    CHECK(share < 0.30 + five);
    least = std::min(least, share);
    most = std::max(most, share);
  }
  CHECK(least < 0.10);
  CHECK(most > 0.25);
}

TEST_CASE("glass__panes_of_windows_are_glass_and_leaves_of_doors_are_not") {
  const Model model = scene("facade");
  const auto all = points_of_faces(scanned(model, quiet_settings(0.01)));
  const auto none = points_of_faces(scanned(model, quiet_settings(0.01, glass(0, 0))));
  size_t gone = 0, kept = 0;
  for (const Face& face : model.faces) {
    if (model.parts[face.part].part_class != "pane" || !all.contains(face.id)) continue;
    const bool in_window = model.parts[model.parts[face.part].parent].part_class == "window";
    CHECK(none.contains(face.id) != in_window);
    (in_window ? gone : kept) += 1;
  }
  CHECK(gone == 19);
  CHECK(kept == 2);
}

TEST_CASE("glass__ghosts_appear_behind_panes_and_trees_and_cars_throw_shadows") {
  const Model with = scene("unwanted"), without = scene("surrounds", {{"glass_m", 0.02}});
  const auto ghosts = ids_of(with, {"ghost"});
  CHECK(ghosts.size() == 36);
  const ScanStation stations[] = {station_at({3, -14, 1.7}), station_at({9, -14, 1.7})};
  const Cloud cloud = scanned(with, quiet_settings(0.003, glass(0.05, 0.05)), stations);
  const auto ids = values<uint32_t>(cloud, "face");
  size_t behind = 0;
  for (size_t i = 0; i < cloud.size(); ++i)
    if (ghosts.contains(ids[i])) {
      ++behind;
      REQUIRE(cloud.point(i).y >= 0.8);
      REQUIRE(cloud.point(i).y <= 6);
    }
  CHECK(behind > 1000);
  // Opaque, so that both see the same but for what stands in front.
  const auto dark = points_of_faces(scanned(with, quiet_settings(0.003), stations));
  const auto light = points_of_faces(scanned(without, quiet_settings(0.003), stations));
  const double share = static_cast<double>(dark.at(1)) / static_cast<double>(light.at(1));
  MESSAGE("FIGURE unwanted: " << behind << " ghosts, " << 100 * (1 - share)
                              << " % of the wall in shadow");
  CHECK(share > 0.5);
  CHECK(share < 0.95);
}

TEST_CASE("glass__is_the_same_for_all_sub_rays_of_a_pulse") {
  // A pane before a wall, both wide: every pulse comes back from one of the two, whole.
  Model model = scene("sills");
  model.parts.push_back({"glass", "glass", kNoParent});
  Face face = model.faces[0];
  face.part = static_cast<uint32_t>(model.parts.size() - 1);
  face.id = 99;
  face.plane.offset += 0.1;
  std::vector<Vec3> ring{{0, -0.1, 0}, {10, -0.1, 0}, {10, -0.1, 6}, {0, -0.1, 6}};
  model.add_face(face, {ring});
  const auto first = static_cast<uint32_t>(model.vertices.size() - 4);
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangles.push_back({first, first + 2, first + 3});
  model.triangle_faces.insert(model.triangle_faces.end(), 2, 99);
  StaticSettings settings = glass(0.5, 0.5);
  settings.beam_diameter_m = 0.01;
  const ScanStation station = station_at({5, -10, 3});
  const Cloud cloud = scanned(model, quiet_settings(0.005, settings), {&station, 1});
  const auto segments = values<uint32_t>(cloud, "segment");
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.point(i);
    const bool inside = p.x > 0.1 && p.x < 9.9 && p.z > 0.1 && p.z < 5.9 && std::abs(p.z - 1) > 0.1;
    if (inside) REQUIRE(segments[i] != kNoSegment);
  }
  const auto counts = points_of_faces(cloud);
  CHECK(is_binomial(counts.at(99), counts.at(99) + counts.at(1), 0.5));
}

TEST_CASE("glass__refuses_limits_the_wrong_way_round") {
  CHECK_THROWS_AS(scanned(scene("facade"), quiet_settings(0.05, glass(0.5, 0.2))), Error);
}
