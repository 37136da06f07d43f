// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// street_scene PREFIX COUNT [SEED [points]]: the street of street_points.h as files, with "points" the first only.
//   PREFIX.f64      x y z as doubles
//   PREFIX_pf0.las  LAS 1.2, point format 0
//   PREFIX_pf3.las  the same points with time and colour (point format 3)
//   PREFIX.planes   the true planes, seven doubles each (street_truth.h)

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "street_las.h"
#include "street_points.h"
#include "street_truth.h"

namespace {

bool write_doubles(const std::string& path, const std::vector<double>& values) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool complete = std::fwrite(values.data(), 8, values.size(), file) == values.size();
  return std::fclose(file) == 0 && complete;
}

}  // namespace

int main(int argc, char** argv) {
  const size_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  if (count == 0 || count > 0xffffffffu) {
    std::fprintf(stderr, "usage: street_scene PREFIX COUNT [SEED [points]]\n");
    return 2;
  }
  const std::string prefix = argv[1];
  const uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const bench::Street street;
  const std::vector<bench::Sample> samples = bench::scan_street(street, count, seed);
  const std::vector<double> xyz = bench::coordinates(samples);
  bool good = write_doubles(prefix + ".f64", xyz);
  if (argc <= 4) {
    good = good && bench::write_las(prefix + "_pf0.las", 0, xyz) && bench::write_las(prefix + "_pf3.las", 3, xyz) &&
           write_doubles(prefix + ".planes", bench::true_planes(street, samples));
  }
  if (!good) {
    std::fprintf(stderr, "street_scene: cannot write %s.*\n", prefix.c_str());
    return 1;
  }
  std::printf("%s: %zu points\n", prefix.c_str(), count);
  return 0;
}
