// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// icp_exactness [POINTS [SEEDS [THREADS [FIRST]]]]: how far Jalon's registrar "icp" with its defaults is off, over
// several draws of two scans of the street and of the motion between them (street_motion.h), near the origin and again
// on a national grid. Ends with 1 when an error at the middle of the street or a turn is above its limit.

#include <jalon/jalon.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "street_motion.h"
#include "street_points.h"

namespace {

constexpr double kLimit_mm = 0.05, kLimit_deg = 0.0003;
constexpr bench::Vec kNationalGrid = {652000, 6861000, 35};
constexpr uint64_t kSecondDraw = 1000;  // seeds of the moving scan lie so far above

void check(jalon_status status) {
  if (status == JALON_OK) return;
  std::fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  std::exit(1);
}

struct Worst {
  double mm = 0, deg = 0;
};

jalon_cloud* cloud_of(const std::vector<double>& xyz) {
  jalon_cloud* cloud = nullptr;
  check(jalon_cloud_create(xyz.data(), JALON_FLOAT64, xyz.size() / 3, 24, 0, &cloud));
  return cloud;
}

bench::Rows registered(const std::vector<double>& reference_xyz,
                       const std::vector<double>& moving_xyz, unsigned threads, bool& converged) {
  jalon_cloud *reference = cloud_of(reference_xyz), *moving = cloud_of(moving_xyz);
  jalon_registrar* registrar = nullptr;
  jalon_registration* registration = nullptr;
  jalon_task* task = nullptr;
  jalon_fields* summary = nullptr;
  jalon_array_view flag;
  jalon_transform pose;
  check(jalon_task_create(&task));
  check(jalon_task_set_threads(task, threads));
  check(jalon_registrar_create("icp", &registrar));
  check(jalon_registrar_run(registrar, reference, moving, nullptr, task, &registration));
  check(jalon_registration_pose(registration, &pose));
  check(jalon_registration_summary(registration, &summary));
  check(jalon_fields_view(summary, "converged", &flag));
  converged = *static_cast<const uint8_t*>(flag.data) != 0;
  jalon_fields_release(summary);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_task_release(task);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  bench::Rows rows;
  std::copy(pose.m, pose.m + 12, rows.begin());
  return rows;
}

// One registration; its line, and what it adds to the worst.
void measure(uint64_t seed, const char* where, bench::Vec origin, const std::vector<double>& street,
             size_t points, unsigned threads, Worst& worst) {
  const bench::Street scene;
  const bench::Rows motion = bench::planted_motion(seed);
  std::vector<double> reference = street,
                      moving = bench::moved(motion, bench::coordinates(bench::scan_street(
                                                        scene, points, seed + kSecondDraw)));
  bench::snap(reference, origin);
  bench::snap(moving, origin);
  bool converged = false;
  const auto start = std::chrono::steady_clock::now();
  const bench::Rows pose = registered(reference, moving, threads, converged);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const bench::PoseError error = bench::pose_error(pose, motion, origin);
  std::printf("seed %2llu %-13s %.4f mm (along %7.4f, across %7.4f, up %7.4f) %.6f deg %s %.2f s\n",
              static_cast<unsigned long long>(seed), where, 1000 * error.shift_m,
              1000 * error.parts_m.x, 1000 * error.parts_m.y, 1000 * error.parts_m.z,
              error.turn_deg, converged ? "converged" : "NOT CONVERGED", seconds);
  std::fflush(stdout);
  worst.mm = std::max(worst.mm, 1000 * error.shift_m);
  worst.deg = std::max(worst.deg, error.turn_deg);
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
  };
  const auto points = static_cast<size_t>(argument(1, 1e6));
  const auto seeds = static_cast<uint64_t>(argument(2, 10));
  const auto first = static_cast<uint64_t>(argument(4, 1));
  const auto threads = static_cast<unsigned>(argument(3, 2));
  Worst worst;
  for (uint64_t seed = first; seed < first + seeds; ++seed) {
    const std::vector<double> street =
        bench::coordinates(bench::scan_street(bench::Street(), points, seed));
    measure(seed, "local", {}, street, points, threads, worst);
    measure(seed, "national grid", kNationalGrid, street, points, threads, worst);
  }
  const bool good = worst.mm <= kLimit_mm && worst.deg <= kLimit_deg;
  std::printf("worst of %llu seeds, %zu points: %.4f mm (limit %.2f), %.6f deg (limit %.4f): %s\n",
              static_cast<unsigned long long>(seeds), points, worst.mm, kLimit_mm, worst.deg,
              kLimit_deg, good ? "PASS" : "FAIL");
  return good ? 0 : 1;
}
