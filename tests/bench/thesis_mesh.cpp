// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distances of clouds from meshes at the sizes of Girardeau-Montaut 2006, table 2.1.
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "bench/thesis.h"
#include "compare/distance/model_distance.h"
#include "compare/distance/model_sample.h"

using namespace jalon;
using namespace jalon::bench;

namespace {

constexpr double kNoise_m = 0.002;

/// A plant room: 20 beams, 60 pipes of 3 to 30 cm and 5 tanks with 8 to 12 facets, in bands
/// along their axes. Exactly so many triangles: bands as long as it takes.
class PlantMesh {
 public:
  PlantMesh(size_t triangles, bool with_all_pipes) {
    RandomStream random(4, 0);
    std::vector<Tube> tubes;
    for (int i = 0; i < 85; ++i) {
      const Vec3 foot{1 + 10 * random.uniform(), 1 + 6 * random.uniform(), 4 * random.uniform()};
      const int axis = static_cast<int>(random.below(3));
      const double radius = i < 60   ? 0.03 + 0.27 * random.uniform() * random.uniform()
                            : i < 80 ? 0.15
                                     : 0.8;
      const double length = i < 80 ? 1 + 3 * random.uniform() : 1.5;
      tubes.push_back({foot, axis, radius, length,
                       i < 60   ? 8 + static_cast<uint32_t>(i % 5)
                       : i < 80 ? 4u
                                : 12u});
    }
    if (!with_all_pipes) tubes.erase(tubes.begin() + 50, tubes.begin() + 55);
    uint32_t facets = 0;
    for (const Tube& tube : tubes) facets += tube.facets;
    const auto bands = static_cast<uint32_t>(triangles / (2 * facets) + 1);
    for (const Tube& tube : tubes) add(tube, bands);
    model_.triangles.resize(triangles);
    model_.triangle_faces.resize(triangles, 0);
  }
  Model take() { return std::move(model_); }

 private:
  struct Tube {
    Vec3 foot;
    int axis;
    double radius, length;
    uint32_t facets;
  };
  void add(const Tube& tube, uint32_t bands) {
    const auto first = static_cast<uint32_t>(model_.vertices.size());
    for (uint32_t b = 0; b <= bands; ++b)
      for (uint32_t f = 0; f < tube.facets; ++f) {
        const double turn = 2 * std::numbers::pi * f / tube.facets;
        Vec3 p = tube.foot;
        p[tube.axis] += tube.length * b / bands;
        p[(tube.axis + 1) % 3] += tube.radius * std::cos(turn);
        p[(tube.axis + 2) % 3] += tube.radius * std::sin(turn);
        model_.vertices.push_back(p);
      }
    for (uint32_t b = 0; b < bands; ++b)
      for (uint32_t f = 0; f < tube.facets; ++f) {
        const uint32_t next = (f + 1) % tube.facets, here = first + b * tube.facets,
                       there = here + tube.facets;
        model_.triangles.push_back({here + f, here + next, there + next});
        model_.triangles.push_back({here + f, there + next, there + f});
      }
  }
  Model model_;
};

/// The room as scanned: five pipes more than the mesh has, and noise.
CloudPtr scan_of_room(size_t points, Task& task) {
  const Cloud exact = sample_model(PlantMesh(5000, true).take(), {.points = points}, task);
  Buffer<double> xyz(3 * points);
  RandomStream random(5, 0);
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = exact.xyz()[i] + kNoise_m * random.normal();
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

struct Row {
  size_t points, triangles;
  double printed_s;  ///< at the best level
};
constexpr Row kTable21[] = {{293587, 38044, 7.6},     {2180182, 24155, 46.94},
                            {2725142, 141494, 49.19}, {2725142, 53254, 38.03},
                            {2975731, 10089, 24.56},  {3412681, 16553, 74.77}};

}  // namespace

/// Indexes included, signed distances, one thread.
int main() {
  Task task(one_thread());
  Table table("table 2.1");
  size_t uncompared = 0;
  for (const Row& row : kTable21) {
    const CloudPtr cloud = scan_of_room(row.points, task);
    const auto mesh = std::make_shared<const Model>(PlantMesh(row.triangles, false).take());
    double compared = 0;
    const double seconds = processor_seconds([&] {
      compared = compare_with_model(mesh, cloud, {}, task).summary.require("compared").number(0);
    });
    uncompared += static_cast<size_t>(static_cast<double>(row.points) - compared);
    table.add(
        std::to_string(row.points) + " points, " + std::to_string(row.triangles) + " triangles",
        seconds, row.printed_s);
  }
  table.close();
  if (uncompared > 0) std::printf("%zu points were not compared\n", uncompared);
  return uncompared == 0 ? 0 : 1;
}
