// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// street_mesh PREFIX CELL_M: the surfaces of the street of street_points.h as triangles with sides of about CELL_M.
//   PREFIX.f64  nine doubles a triangle, which floats hold exactly

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "street_points.h"

namespace {

constexpr double kLeastAround = 24;  // sides of a cylinder or sphere

class Mesh {
 public:
  /// A grid of u x v pairs of triangles.
  void add(const bench::Surface& surface, double cell_m) {
    const bool is_flat = surface.shape == bench::Shape::rectangle,
               is_sphere = surface.shape == bench::Shape::sphere;
    const double around = bench::kTwoPi * surface.radius / cell_m;
    const double u = is_flat ? std::ceil(surface.length_u / cell_m - 1e-9)
                             : std::max(kLeastAround, std::ceil(around));
    const double v = is_sphere ? u / 2 : std::ceil(surface.length_v / cell_m - 1e-9);
    for (double j = 0; j < v; ++j)
      for (double i = 0; i < u; ++i) {
        const bench::Vec a = surface.at(i / u, j / v), b = surface.at((i + 1) / u, j / v),
                         c = surface.at(i / u, (j + 1) / v),
                         d = surface.at((i + 1) / u, (j + 1) / v);
        for (const bench::Vec& corner : {a, b, c, b, d, c}) add(bench::turned(corner));
      }
  }
  const std::vector<double>& values() const { return values_; }

 private:
  void add(const bench::Vec& p) {
    for (const double value : {p.x, p.y, p.z}) values_.push_back(static_cast<float>(value));
  }
  std::vector<double> values_;
};

}  // namespace

int main(int argc, char** argv) {
  const double cell_m = argc > 2 ? std::strtod(argv[2], nullptr) : 0;
  if (!(cell_m > 0)) {
    std::fprintf(stderr, "usage: street_mesh PREFIX CELL_M\n");
    return 2;
  }
  Mesh mesh;
  for (const bench::Surface& surface : bench::Street().surfaces) mesh.add(surface, cell_m);
  const std::string path = std::string(argv[1]) + ".f64";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return 1;
  const size_t written = std::fwrite(mesh.values().data(), 8, mesh.values().size(), file);
  if (std::fclose(file) != 0 || written != mesh.values().size()) return 1;
  std::printf("%s: %zu triangles\n", argv[1], mesh.values().size() / 9);
  return 0;
}
