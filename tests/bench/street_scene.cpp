// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// street_scene PREFIX COUNT [SEED]: the street of street_points.h as files.
//   PREFIX.f64      x y z as doubles
//   PREFIX_pf0.las  LAS 1.2, point format 0
//   PREFIX_pf3.las  the same points with time and colour (point format 3)

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "street_las.h"
#include "street_points.h"

int main(int argc, char** argv) {
  const size_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  if (count == 0 || count > 0xffffffffu) {
    std::fprintf(stderr, "usage: street_scene PREFIX COUNT [SEED]\n");
    return 2;
  }
  const std::string prefix = argv[1];
  const uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::vector<double> xyz = bench::coordinates(bench::scan_street(bench::Street(), count, seed));
  std::FILE* file = std::fopen((prefix + ".f64").c_str(), "wb");
  bool good = file != nullptr && std::fwrite(xyz.data(), 8, xyz.size(), file) == xyz.size();
  if (file != nullptr) good = std::fclose(file) == 0 && good;
  good = good && bench::write_las(prefix + "_pf0.las", 0, xyz) &&
         bench::write_las(prefix + "_pf3.las", 3, xyz);
  if (!good) {
    std::fprintf(stderr, "street_scene: cannot write %s.*\n", prefix.c_str());
    return 1;
  }
  std::printf("%s: %zu points\n", prefix.c_str(), count);
  return 0;
}
