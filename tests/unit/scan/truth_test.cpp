// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <cstdlib>
#include <set>
#include <thread>

#include "base/error.h"
#include "base/random.h"
#include "scan/truth.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Processor time of this process: what a busy machine does beside it does not count.
double processor_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr double kLeast_m2 = 0.05;

Truth truth_of(const Model& model, double least_m2 = kLeast_m2) {
  Task task;
  return find_truth(model, least_m2, task);
}

/// Two triangles a rectangle of the plane z = height.
void add_rectangle(Model& model, double x0, double x1, double y0, double y1, double height = 0,
                   double slope = 0) {
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    model.vertices.push_back({x, y, height + slope * x});
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangles.push_back({first, first + 2, first + 3});
  model.triangle_faces.insert(model.triangle_faces.end(), 2,
                              static_cast<uint32_t>(model.triangles.size() / 2));
}

}  // namespace

TEST_CASE("truth__joins_what_shares_an_edge_or_touches_and_nothing_else") {
  struct Case {
    const char* what;
    double x0, x1, y0, y1, height, slope;
    size_t planes;
  };
  const Case cases[] = {
      {"shares an edge", 2, 4, 0, 3, 0, 0, 1},
      {"touches part of an edge", 2, 4, 1, 2, 0, 0, 1},
      {"touches a corner", 2, 4, 3, 5, 0, 0, 1},
      {"overlaps", 1, 4, 1, 2, 0, 0, 1},
      {"lies inside", 0.5, 1, 0.5, 1, 0, 0, 1},
      {"a gap of 0.05 mm", 2.00005, 4, 0, 3, 0, 0, 1},
      {"a gap of 1 mm", 2.001, 4, 0, 3, 0, 0, 2},
      {"0.05 mm higher", 2, 4, 0, 3, 0.00005, 0, 1},
      {"1 mm higher", 2, 4, 0, 3, 0.001, 0, 2},
      {"tilted by 0.01 degrees", 2, 4, 0, 3, -2 * 1.745e-4, 1.745e-4, 2},
      {"far away", 20, 40, 0, 3, 0, 0, 2},
  };
  for (const Case& c : cases)
    for (const double far : {0.0, 6861000.0}) {
      CAPTURE(c.what);
      Model model;
      add_rectangle(model, 0, 2, 0, 3);
      add_rectangle(model, c.x0, c.x1, c.y0, c.y1, c.height, c.slope);
      for (Vec3& v : model.vertices) v.y += far;
      const Truth truth = truth_of(model);
      CHECK(truth.planes.size() == c.planes);
      CHECK(truth.triangle_segments[0] == 1);
      CHECK(truth.triangle_segments[1] == 1);
      CHECK(truth.triangle_segments[3] == c.planes);
    }
}

TEST_CASE("truth__counts_areas_and_leaves_out_small_groups") {
  Model model;
  add_rectangle(model, 0, 0.2, 0, 0.2);  // 0.04 m2
  add_rectangle(model, 5, 5.2, 0, 0.2);  // 0.04 and, touching it, 0.02 m2
  add_rectangle(model, 5.2, 5.4, 0, 0.1);
  add_rectangle(model, 9, 10, 0, 1);
  const Truth truth = truth_of(model);
  REQUIRE(truth.planes.size() == 2);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(0.06).scale(0));
  CHECK(truth.planes[0].face == 2);
  CHECK(truth.planes[1].area_m2 == doctest::Approx(1));
  CHECK(truth.triangle_segments == std::vector<uint32_t>{0, 0, 1, 1, 1, 1, 2, 2});
  CHECK(truth_of(model, 0).planes.size() == 3);
  CHECK(truth_of(Model{}).planes.empty());
}

TEST_CASE("truth__of_a_long_chain_of_patches_is_one_plane") {
  Model model;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      add_rectangle(model, i, i + 1, j + 0.5 * (i % 2), j + 1 + 0.5 * (i % 2));
  const Truth truth = truth_of(model);
  REQUIRE(truth.planes.size() == 1);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(1600));
}

TEST_CASE("truth__of_two_sided_faces_joins_those_that_meet_along_a_part_of_an_edge") {
  Model model;
  for (int side = 0; side < 2; ++side) {
    add_rectangle(model, 0, 1, 0, 1);
    add_rectangle(model, 1, 2, 0.3, 0.7);
  }
  const Truth truth = truth_of(model);
  REQUIRE(truth.planes.size() == 1);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(2 * 1.4));
}

TEST_CASE("truth__of_many_large_plates_one_above_the_other_takes_little_memory") {
  Model model;
  for (int k = 0; k < 5000; ++k) add_rectangle(model, 0, 100, 0, 100, 0.01 * k);
  CHECK(truth_of(model).planes.size() == 5000);
}

TEST_CASE("truth__of_a_large_mesh_stops_at_a_cancel_whenever_it_comes") {
  const uint32_t side = std::getenv("JALON_SANITIZED") != nullptr ? 300 : 1000;
  Model mesh;
  RandomStream random(1, 0);
  for (uint32_t k = 0; k < side * side; ++k)
    mesh.vertices.push_back({0.1 * (k % side), 0.1 * (k / side), random.uniform()});
  for (uint32_t k = 0; k + side < side * side; ++k)
    if (k % side + 1 < side) {
      mesh.triangles.push_back({k, k + 1, k + 1 + side});
      mesh.triangles.push_back({k, k + 1 + side, k + side});
    }
  mesh.triangle_faces.assign(mesh.triangles.size(), 1);
  double worst_ms = 0;
  int stopped = 0;
  for (int after_ms = 5; after_ms < 5000; after_ms *= 2) {
    std::atomic<bool> cancel{false};
    double cancelled_ms = 0;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
      cancelled_ms = processor_ms();
      cancel = true;
    });
    Task::Hooks hooks;
    hooks.cancel = &cancel;
    Task task(hooks);
    bool is_done = true;
    try {
      find_truth(mesh, kLeast_m2, task);
    } catch (const Error& error) {
      is_done = false;
      CHECK(error.status() == Status::kCancelled);
    }
    const double end_ms = processor_ms();
    other.join();
    if (is_done) break;
    ++stopped;
    worst_ms = std::max(worst_ms, end_ms - cancelled_ms);
  }
  MESSAGE("FIGURE " << mesh.triangles.size() << " triangles: " << stopped << " cancels, worst "
                    << worst_ms << " ms of processor");
  CHECK(stopped > 0);
}

TEST_CASE("truth__of_a_mesh_does_not_depend_on_shared_vertices_or_the_number_of_threads") {
  // A roof of two planes in small triangles, beside a rough field: with shared vertices, and as loose triangles.
  constexpr uint32_t kSide = 80;
  Model mesh, loose;
  RandomStream random(1, 0);
  for (uint32_t j = 0; j < kSide; ++j)
    for (uint32_t i = 0; i < kSide; ++i)
      mesh.vertices.push_back(
          {0.1 * i, 0.1 * j, j < 40 ? 0.05 * std::abs(20.0 - j) : 0.95 + 0.1 * random.uniform()});
  for (uint32_t j = 0; j + 1 < kSide; ++j)
    for (uint32_t i = 0; i + 1 < kSide; ++i) {
      const uint32_t a = j * kSide + i;
      mesh.triangles.push_back({a, a + 1, a + 1 + kSide});
      mesh.triangles.push_back({a, a + 1 + kSide, a + kSide});
    }
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<uint32_t>(loose.vertices.size());
    for (const uint32_t v : t) loose.vertices.push_back(mesh.vertices[v]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  mesh.triangle_faces.assign(mesh.triangles.size(), 1);
  loose.triangle_faces = mesh.triangle_faces;
  const Truth truth = truth_of(mesh);
  REQUIRE(truth.planes.size() == 2);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(20 * 0.1 * 7.9 * std::sqrt(1.25)));
  CHECK(truth.planes[1].area_m2 == doctest::Approx(19 * 0.1 * 7.9 * std::sqrt(1.25)));
  CHECK(truth_of(loose).triangle_segments == truth.triangle_segments);
  for (const unsigned threads : {1u, 2u, 7u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    CHECK(find_truth(mesh, kLeast_m2, task).triangle_segments == truth.triangle_segments);
  }
}

TEST_CASE("truth__leaves_out_curved_surfaces_of_scenes_but_takes_every_triangle_of_a_mesh") {
  const Model street = scene("street");
  const auto faces = faces_by_id(street);
  const Truth truth = truth_of(street);
  for (size_t t = 0; t < street.triangles.size(); ++t)
    if (!faces.contains(street.triangle_faces[t]))
      REQUIRE(truth.triangle_segments[t] == kNoSegment);
  // The 28 planes of the measurements without the six of glass, whose panes stand apart.
  const auto large = std::count_if(truth.planes.begin(), truth.planes.end(),
                                   [](const TruePlane& p) { return p.area_m2 > 2; });
  CHECK(large == 1 + 6 + 15);

  Model cube = scene("box");
  cube.faces.clear();
  CHECK(truth_of(cube).planes.size() == 6);  // five sides and the ground
}

TEST_CASE("truth__adds_up_to_the_area_of_the_faces_and_gives_their_planes") {
  for (const char* name : {"facade", "street", "insa", "lycee", "arches", "residence"}) {
    CAPTURE(name);
    const Model model = scene(name);
    const auto faces = faces_by_id(model);
    const Truth truth = truth_of(model, 0);
    double of_faces = 0, of_planes = 0;
    for (const Face& face : model.faces) of_faces += face.area_m2;
    for (const TruePlane& p : truth.planes) {
      of_planes += p.area_m2;
      const Plane& plane = faces.at(p.face).front()->plane;
      REQUIRE(norm(p.plane.normal - plane.normal) < 1e-9);
      REQUIRE(std::abs(p.plane.offset - plane.offset) < 1e-9);
    }
    CHECK(of_planes == doctest::Approx(of_faces).scale(0).epsilon(1e-9));
    for (size_t t = 0; t < model.triangles.size(); ++t)
      if (const uint32_t s = truth.triangle_segments[t]; s != kNoSegment)
        for (const uint32_t v : model.triangles[t])
          REQUIRE(std::abs(truth.planes[s - 1].plane.distance(model.vertices[v])) < 1e-6);
  }
}
