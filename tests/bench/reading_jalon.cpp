// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// reading_jalon [POINTS [LARGE [THREADS]]]: how long files of other formats than LAS are read: LAZ
// and E57 of a street (street_points.h) of 5 M points, and a hundredth of the points and of the ground of
// COPC files of 20 M, one with attributes made up from the points' numbers, which are noise in the order
// of an octree, one with those that a scanner sees (street_attributes.h). Every reading is the first of a
// process of its own, which tells its time and memory; the least of three counts.

#include <jalon/jalon.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>

#include "driver.h"
#include "street_attributes.h"
#include "street_las.h"
#include "street_points.h"

namespace {

constexpr int kTurns = 3;

void check(jalon_status status) {
  if (status == JALON_OK) return;
  std::fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  _exit(1);
}

using Box = std::array<double, 6>;
constexpr double kAll = 1e9;

/// What a child tells.
struct Told {
  double seconds = 0, processor_seconds = 0, megabytes = 0;
  uint64_t points = 0;
  Box of_points{}, of_ground{};
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

/// About a point of xyz, with this part of the length and breadth of all, and all heights.
Box box_about(const std::vector<double>& xyz, size_t point, double part, const Box& bounds) {
  Box box{};
  for (size_t axis = 0; axis < 3; ++axis) {
    const double half = axis == 2 ? kAll : part / 2 * (bounds[3 + axis] - bounds[axis]);
    box[axis] = xyz[3 * point + axis] - half;
    box[3 + axis] = xyz[3 * point + axis] + half;
  }
  return box;
}

/// The part of length and breadth about a point in which a hundredth of the points are.
double part_of_a_hundredth(const std::vector<double>& xyz, size_t point, const Box& bounds) {
  std::vector<float> parts;  // of the box that just holds a point
  parts.reserve(xyz.size() / 3);
  for (size_t i = 0; i < xyz.size(); i += 3) {
    double part = 0;
    for (size_t axis = 0; axis < 2; ++axis)
      part = std::max(part, 2 * std::fabs(xyz[i + axis] - xyz[3 * point + axis]) /
                                (bounds[3 + axis] - bounds[axis]));
    parts.push_back(static_cast<float>(part));
  }
  const auto last = parts.begin() + static_cast<ptrdiff_t>(parts.size() / 100);
  std::nth_element(parts.begin(), last, parts.end());
  return *last;
}

enum class Attributes { made_up, seen };

/// The street as LAS with colours, and the boxes about its middle point that have a hundredth of its points, and a
/// tenth of its length and breadth.
Told make_street(const std::string& prefix, size_t count, Attributes attributes) {
  return in_child([&](Told& told) {
    const bench::Street street;
    constexpr uint64_t kSeed = 1;
    std::vector<bench::Sample> samples = bench::scan_street(street, count, kSeed);
    const std::vector<double> xyz = bench::coordinates(samples);
    const bench::SeenAttributes seen(street, kSeed);
    const std::string path = prefix + "_pf3.las";
    const bool is_written =
        attributes == Attributes::seen
            ? bench::write_las(path, 3, xyz, [&](size_t i) { return seen.of(samples[i], i); })
            : bench::write_las(path, 3, xyz);
    if (!is_written) _exit(1);
    Box bounds = {kAll, kAll, kAll, -kAll, -kAll, -kAll};
    for (size_t i = 0; i < xyz.size(); ++i) {
      bounds[i % 3] = std::min(bounds[i % 3], xyz[i]);
      bounds[3 + i % 3] = std::max(bounds[3 + i % 3], xyz[i]);
    }
    constexpr double kTenth = 0.1;
    told.of_points = box_about(xyz, count / 2, part_of_a_hundredth(xyz, count / 2, bounds), bounds);
    told.of_ground = box_about(xyz, count / 2, kTenth, bounds);
  });
}

void convert(const std::string& from, const std::string& to) {
  in_child([&](Told& told) {
    check(jalon_cloud_convert(from.c_str(), to.c_str(), nullptr, nullptr, &told.points));
  });
}

Told read(const std::string& path, unsigned threads, const Box* box) {
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
      const std::clock_t before = std::clock();
      check(jalon_cloud_read(path.c_str(), options, task, &cloud));
      out.seconds = watch.seconds();
      out.processor_seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      check(jalon_cloud_count(cloud, &out.points));
    });
    if (turn == 0 || told.seconds < best.seconds) best = told;
  }
  return best;
}

double millions(uint64_t count) { return static_cast<double>(count) / 1e6; }

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
  make_street(street, points, Attributes::made_up);
  for (const char* format : {"laz", "e57"}) {
    const std::string file = street + "." + format;
    convert(street + "_pf3.las", file);
    const Told told = read(file, threads, nullptr);
    std::printf(
        "FIGURE reading %s of %.1f M points with time and colours: %.3f s on %u threads, %.0f MB\n",
        format, millions(told.points), told.seconds, threads, told.megabytes);
    std::fflush(stdout);
  }
  for (const Attributes attributes : {Attributes::made_up, Attributes::seen}) {
    const Told made = make_street(town, large, attributes);
    const std::string file = town + ".copc.laz";
    convert(town + "_pf3.las", file);
    std::filesystem::remove(town + "_pf3.las");
    for (const Box* box : {&made.of_points, &made.of_ground}) {
      const Told told = read(file, threads, box);
      std::printf(
          "FIGURE reading a hundredth of the %s of a COPC file of %.1f M points, attributes %s, "
          "%.1f B a point: "
          "%.3f s, %.0f MB, %.2f processor seconds, %.2f M points\n",
          box == &made.of_points ? "points" : "ground", millions(large),
          attributes == Attributes::seen ? "of the surfaces" : "made up",
          static_cast<double>(std::filesystem::file_size(file)) / static_cast<double>(large),
          told.seconds, told.megabytes, told.processor_seconds, millions(told.points));
      std::fflush(stdout);
    }
  }
  std::filesystem::remove_all(folder);
  return 0;
}
