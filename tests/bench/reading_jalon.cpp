// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// reading_jalon [POINTS [LARGE [THREADS]]]: how long files of other formats than LAS are read: LAZ
// and E57 of a street (street_points.h) of 5 M points, and a hundredth of the ground of a COPC file of
// 20 M. Every reading is the first of a process of its own, which tells its memory; the least of three
// counts.

#include <jalon/jalon.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "driver.h"
#include "street_las.h"
#include "street_points.h"

namespace {

constexpr int kTurns = 3;

void check(jalon_status status) {
  if (status == JALON_OK) return;
  std::fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  _exit(1);
}

/// What a child tells.
struct Told {
  double seconds = 0, megabytes = 0;
  uint64_t points = 0;
  std::array<double, 6> box{};
};

/// run(Told&) in a process of its own.
template <class Run>
Told in_child(Run&& run) {
  void* const shared =
      mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) std::exit(1);
  Told& told = *new (shared) Told;
  const pid_t child = fork();
  if (child == 0) {
    run(told);
    _exit(0);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) < 0 || status != 0) std::exit(1);
  told.megabytes = static_cast<double>(used.ru_maxrss) / 1000;
  const Told out = told;
  munmap(shared, sizeof(Told));
  return out;
}

/// The street as LAS with colours, and the box about its middle point that has a tenth of its length and breadth.
Told make_street(const std::string& prefix, size_t count) {
  return in_child([&](Told& told) {
    const std::vector<double> xyz =
        bench::coordinates(bench::scan_street(bench::Street(), count, 1));
    if (!bench::write_las(prefix + "_pf3.las", 3, xyz)) _exit(1);
    constexpr double kPart = 0.1, kAll = 1e9;
    for (size_t axis = 0; axis < 3; ++axis) {
      double low = xyz[axis], high = xyz[axis];
      for (size_t i = axis; i < xyz.size(); i += 3) {
        low = std::min(low, xyz[i]);
        high = std::max(high, xyz[i]);
      }
      const double half = axis == 2 ? kAll : kPart / 2 * (high - low);
      const double middle = xyz[3 * (count / 2) + axis];
      told.box[axis] = middle - half;
      told.box[3 + axis] = middle + half;
    }
  });
}

void convert(const std::string& from, const std::string& to) {
  in_child([&](Told& told) {
    check(jalon_cloud_convert(from.c_str(), to.c_str(), nullptr, nullptr, &told.points));
  });
}

Told read(const std::string& path, unsigned threads, const std::array<double, 6>* box) {
  Told best;
  for (int turn = 0; turn < kTurns; ++turn) {
    const Told told = in_child([&](Told& out) {
      jalon_task* task = nullptr;
      jalon_params* options = nullptr;
      jalon_cloud* cloud = nullptr;
      check(jalon_task_create(&task));
      check(jalon_task_set_threads(task, threads));
      check(jalon_params_create("read", &options));
      if (box != nullptr) check(jalon_params_set_doubles(options, "box", box->data(), box->size()));
      const bench::Stopwatch watch;
      check(jalon_cloud_read(path.c_str(), options, task, &cloud));
      out.seconds = watch.seconds();
      check(jalon_cloud_count(cloud, &out.points));
    });
    if (turn == 0 || told.seconds < best.seconds) best = told;
  }
  return best;
}

double millions(double count) { return count / 1e6; }

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, size_t usual) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : usual;
  };
  const size_t points = number(1, 5000000), large = number(2, 20000000);
  const auto threads = static_cast<unsigned>(number(3, 2));
  std::string folder = (std::filesystem::temp_directory_path() / "jalon_reading_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return 1;
  const std::string street = folder + "/street", town = folder + "/town";
  make_street(street, points);
  for (const char* format : {"laz", "e57"}) {
    const std::string file = street + "." + format;
    convert(street + "_pf3.las", file);
    const Told told = read(file, threads, nullptr);
    std::printf(
        "FIGURE reading %s of %.1f M points with time and colours: %.3f s on %u threads, %.0f MB\n",
        format, millions(static_cast<double>(told.points)), told.seconds, threads, told.megabytes);
    std::fflush(stdout);
  }
  const Told made = make_street(town, large);
  convert(town + "_pf3.las", town + ".copc.laz");
  const Told told = read(town + ".copc.laz", threads, &made.box);
  std::printf(
      "FIGURE reading a hundredth of the ground of a COPC file of %.1f M points: %.3f s, %.0f MB, "
      "%.2f M points\n",
      millions(static_cast<double>(large)), told.seconds, told.megabytes,
      millions(static_cast<double>(told.points)));
  std::filesystem::remove_all(folder);
  return 0;
}
