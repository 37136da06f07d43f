// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>

#include "model/part_classes.h"
#include "modelling/facade/assembly.h"
#include "scan/facade_truth.h"
#include "unit/modelling/facade_scenes.h"
#include "unit/modelling/model_checks.h"
#include "unit/modelling/random_facades.h"

using namespace facades;

namespace {

struct Tally {
  size_t faces = 0, solids = 0, openings = 0, faults = 0;
  double flatness_m = 0;
  std::string first_fault;

  void add(const Model& model) {
    for (const Face& face : model.faces) {
      ++faces;
      flatness_m = std::max(flatness_m, checks::flatness(model, face));
      note(checks::ring_fault(model, face), model.parts[face.part].name);
    }
    for (const Solid& solid : model.solids) {
      ++solids;
      note(checks::solid_fault(model, solid), model.parts[solid.part].name);
    }
    for (const Part& part : model.parts) openings += part_class::is_opening(part.part_class);
  }
  void note(const std::string& fault, const std::string& where) {
    if (fault.empty()) return;
    if (faults++ == 0) first_fault = where + ": " + fault;
  }
};

Model assembled(RandomFacade& facade, const AssemblySetting& setting, size_t& shared_corners) {
  Task task;
  const Segmentation segmentation = facade.segmentation();
  std::vector<VectorPlane> planes = facade.planes();
  std::vector<SharedCorner> shared = join_planes(planes, segmentation.segments, {}, task);
  FacadePlan plan = plan_facades(segmentation, std::move(planes), {}, task);
  shared_corners += shared.size();
  plan.shared = std::move(shared);
  return assemble_facades(segmentation, std::move(plan), setting, task);
}

}  // namespace

TEST_CASE(
    "facade: assembled from 1000 random plans all faces are plane, no ring meets itself, all "
    "solids "
    "are closed") {
  const uint64_t count = std::getenv("JALON_SANITIZED") != nullptr ? 60 : 1000;
  Tally tally;
  size_t shared = 0;
  for (uint64_t seed = 1; seed <= count; ++seed) {
    RandomFacade facade(seed);
    const AssemblySetting kinds[] = {{}, {true, false, 0.3}, {true, true, 0.2}};
    const Model model = assembled(facade, kinds[seed % 3], shared);
    const size_t before = tally.faults;
    tally.add(model);
    if (tally.faults > before && before == 0)
      MESSAGE("facade " << seed << ": " << tally.first_fault);
  }
  MESSAGE("FIGURE random facades: " << count << ", " << tally.faces << " faces, " << tally.openings
                                    << " openings, " << tally.solids << " solids, " << tally.faults
                                    << " faults, out of plane at most " << 1e12 * tally.flatness_m
                                    << " pm, " << shared << " vertices of several planes");
  CHECK(shared > count);
  CHECK(tally.faults == 0);
  CHECK(tally.flatness_m < 1e-9);
  CHECK(tally.openings > 2 * count);
  CHECK(tally.solids >= count / 2);
}

TEST_CASE("facade: corners carry the covariance of their edges and planes") {
  // Edges of the random facades are certain to 3 mm, their planes to a tenth of a millimetre.
  size_t corners = 0, known = 0, near = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    RandomFacade facade(seed);
    size_t shared = 0;
    const Model model = assembled(facade, {}, shared);
    REQUIRE(model.vertex_covariances.size() == model.vertices.size());
    for (const Face& face : model.faces) {
      if (model.parts[face.part].part_class != "wall") continue;
      const Vec3 level = normalized(cross({0, 0, 1}, face.plane.normal));
      for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r)
        for (uint64_t c = model.rings[r].first; c < model.rings[r].first + model.rings[r].count;
             ++c) {
          ++corners;
          const auto& k = model.vertex_covariances[model.corners[c]];
          if (!std::isfinite(k[0])) continue;
          ++known;
          const double along = level.x * (k[0] * level.x + k[1] * level.y) +
                               level.y * (k[3] * level.x + k[4] * level.y);
          near += std::fabs(std::sqrt(along) - 0.003) < 0.0003;
        }
    }
  }
  MESSAGE("FIGURE facade covariances: " << known << " of " << corners << " corners, " << near
                                        << " as their edges");
  CHECK(corners > 500);
  CHECK(known == corners);
  CHECK(near > 0.9 * static_cast<double>(corners));
}

TEST_CASE("facade: the checks see a bent face, a ring that meets itself, an open solid") {
  Model model;
  model.parts.push_back({"wall", "wall", kNoParent});
  Face face;
  const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  model.add_face(face, {square, {{1, 1, 0}, {1, 1.5, 0}, {1.5, 1, 0}}});
  CHECK(checks::ring_fault(model, model.faces[0]).empty());
  model.add_face(face, {{{0, 0, 0}, {2, 0, 0}, {2, 2, 1e-6}, {0, 2, 0}}});
  CHECK(checks::flatness(model, model.faces[0]) == 0);
  CHECK(checks::flatness(model, model.faces[1]) > 1e-7);
  model.add_face(face, {{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2.5, 0}}});
  CHECK(!checks::ring_fault(model, model.faces[2]).empty());
  model.add_face(face, {square, {{1, 1, 0}, {1, 1.5, 0}, {2.5, 1, 0}}});
  CHECK(checks::ring_fault(model, model.faces[3]) == "rings meet");
  // An arc that bulges into an opening: only its chord is clear of it.
  model.add_face(face, {square, {{0.5, 0.3, 0}, {1, 1, 0}, {1.5, 0.3, 0}}});
  CHECK(checks::ring_fault(model, model.faces[4]).empty());
  model.sagittas.assign(model.corners.size(), 0);
  model.sagittas[model.rings[model.faces[4].first_ring].first] = -0.5;
  CHECK(checks::ring_fault(model, model.faces[4]) == "rings meet");
  model.solids.push_back({0, 0, 1});
  CHECK(!checks::solid_fault(model, model.solids[0]).empty());
}

TEST_CASE("facade: models of scanned scenes are sound, as surfaces and as solids") {
  for (const char* scene : {"arches", "facade", "lycee", "insa_surveyed"}) {
    if (std::getenv("JALON_SANITIZED") != nullptr && std::string(scene) != "lycee") continue;
    CAPTURE(scene);
    const std::string json = std::string("{\"name\":\"") + scene + "\"}";
    const Scan scan(json.c_str(), "{\"horizontal_step_rad\":0.002,\"vertical_step_rad\":0.002}");
    Tally tally;
    for (const char* options : {"{}", "{\"solids\":true}"})
      tally.add(facade_of(scan.segmentation, options));
    CAPTURE(tally.first_fault);
    CHECK(tally.faults == 0);
    CHECK(tally.flatness_m < 1e-9);
    CHECK(tally.solids > 0);
  }
}

namespace {

// A facade by rules, measured from where a surveyor would stand: the whole chain, nothing given to it.
Segmentation scanned_by_rules(uint64_t seed) {
  Task task;
  SceneSettings settings{.name = SceneName::kGrammar, .seed = seed};
  settings.grammar.spacing_m = 0.04;
  const SceneSurvey survey = scene_survey(settings);
  const auto cloud = std::make_shared<const Cloud>(
      scan_static(build_scene(settings, task), survey.stations, survey.scanner, task));
  return segment_ransac(cloud, RansacSettings{}, task);
}

}  // namespace

TEST_CASE("facade: models of scanned facades by rules are sound, as surfaces and as solids") {
  const uint64_t count = std::getenv("JALON_SANITIZED") != nullptr ? 1
                         : std::getenv("JALON_FULL") != nullptr    ? 40
                                                                   : 4;
  Tally all;
  for (uint64_t seed = 1; seed <= count; ++seed) {
    CAPTURE(seed);
    const Segmentation segmentation = scanned_by_rules(seed);
    for (const char* options : {"{}", "{\"solids\":true}"}) {
      CAPTURE(std::string(options));
      Tally one;
      one.add(facade_of(segmentation, options));
      CAPTURE(one.first_fault);
      CHECK(one.faults == 0);
      CHECK(one.openings > 0);
      all.faces += one.faces, all.openings += one.openings, all.solids += one.solids;
      all.faults += one.faults, all.flatness_m = std::max(all.flatness_m, one.flatness_m);
    }
  }
  MESSAGE("FIGURE scanned facades by rules: "
          << count << " twice, " << all.faces << " faces, " << all.openings << " openings, "
          << all.solids << " solids, " << all.faults << " faults, out of plane at most "
          << 1e12 * all.flatness_m << " pm");
  CHECK(all.flatness_m < 1e-9);
  CHECK(all.solids >= count);
}
