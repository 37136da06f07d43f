// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// street_scene PREFIX COUNT [SEED [points|moved]]: the street of street_points.h as files, with
// "points" the first only,
// with "moved" the same by the motion of the seed (street_motion.h), and that motion.
//   PREFIX.f64      x y z as doubles
//   PREFIX.motion   twelve doubles, T_moved_street, and the middle of the street
//   PREFIX_pf0.las  LAS 1.2, point format 0
//   PREFIX_pf3.las  the same points with time and colour (point format 3)
//   PREFIX.planes   the true planes, seven doubles each (street_truth.h)

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "street_las.h"
#include "street_motion.h"
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
    std::fprintf(stderr, "usage: street_scene PREFIX COUNT [SEED [points|moved]]\n");
    return 2;
  }
  const std::string prefix = argv[1];
  const uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const bench::Street street;
  const std::vector<bench::Sample> samples = bench::scan_street(street, count, seed);
  std::vector<double> xyz = bench::coordinates(samples);
  bool good = true;
  if (argc > 4 && std::strcmp(argv[4], "moved") == 0) {
    const bench::Rows motion = bench::planted_motion(seed);
    const bench::Vec middle = bench::turned(bench::kStreetMiddle);
    xyz = bench::moved(motion, xyz);
    std::vector<double> values(motion.begin(), motion.end());
    values.insert(values.end(), {middle.x, middle.y, middle.z});
    good = write_doubles(prefix + ".motion", values);
  }
  good = good && write_doubles(prefix + ".f64", xyz);
  if (argc <= 4) {
    good = good && bench::write_las(prefix + "_pf0.las", 0, xyz) &&
           bench::write_las(prefix + "_pf3.las", 3, xyz) &&
           write_doubles(prefix + ".planes", bench::true_planes(street, samples));
  }
  if (!good) {
    std::fprintf(stderr, "street_scene: cannot write %s.*\n", prefix.c_str());
    return 1;
  }
  std::printf("%s: %zu points\n", prefix.c_str(), count);
  return 0;
}
