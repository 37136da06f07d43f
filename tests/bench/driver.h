// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// What the drivers of the peers share. A driver is started as `driver PREFIX`, loads the scene
/// once and then serves lines
///     OPERATION THREADS [SAMPLE_FILE]
/// from its standard input, so that run.py can let all libraries take turns. It answers each with
///     peer|operation|points|threads|seconds|count
/// where count is the number of results (points left by the voxel grid, points read). With a
/// SAMPLE_FILE it also writes, as doubles, the results of about kSamples points spread over the
/// cloud; run.py compares them between the libraries. Of planes: a row of seven numbers each, normal,
/// centroid of its points, how many they are. Of a registration: the three rows of its pose.
namespace bench {

constexpr size_t kSamples = 2000;
constexpr int kNeighbours = 16;
constexpr double kVoxel_m = 0.05;
// Of the peers' ICP: the motion is 0.5 m and, 30 m from the middle, 1.6 m more.
constexpr double kPairs_m = 1.0;
constexpr double kKernel_m = 0.05;
constexpr int kIterations = 30;

struct Result {
  double seconds = 0;
  uint64_t count = 0;
  std::vector<double> sample;
};
using Operation = std::function<Result(int threads, bool with_sample)>;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

inline std::vector<double> load_points(const std::string& prefix) {
  const std::string path = prefix + ".f64";
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    std::fprintf(stderr, "cannot open %s\n", path.c_str());
    std::exit(1);
  }
  std::fseek(file, 0, SEEK_END);
  std::vector<double> xyz(static_cast<size_t>(std::ftell(file)) / 8);
  std::rewind(file);
  const bool complete = std::fread(xyz.data(), 8, xyz.size(), file) == xyz.size();
  std::fclose(file);
  if (!complete) std::exit(1);
  return xyz;
}

/// The scan of the same street that is compared with the scene: as many points, another draw.
inline std::vector<double> load_second_scan(const std::string& prefix) {
  return load_points(prefix + "_second");
}

/// Calls use(i) for the sampled points.
template <class Use>
void for_samples(size_t count, Use use) {
  const size_t step = count > kSamples ? count / kSamples : 1;
  for (size_t i = 0; i < count; i += step) use(i);
}

/// The result of an operation that gives a distance for each point of the second scan.
inline Result distances(const Stopwatch& watch, const std::vector<double>& nearest,
                        bool with_sample) {
  Result result{watch.seconds(), nearest.size(), {}};
  if (with_sample)
    for_samples(nearest.size(), [&](size_t i) { result.sample.push_back(nearest[i]); });
  return result;
}

inline int serve(const std::string& peer, size_t points,
                 const std::map<std::string, Operation>& operations) {
  std::string names;
  for (const auto& [name, operation] : operations) names += (names.empty() ? "" : ",") + name;
  std::printf("ready|%s|%s\n", peer.c_str(), names.c_str());
  std::fflush(stdout);
  char line[4096];
  while (std::fgets(line, sizeof line, stdin) != nullptr) {
    char name[64] = "", sample_path[4000] = "";
    int threads = 1;
    if (std::sscanf(line, "%63s %d %3999s", name, &threads, sample_path) < 2) break;
    const auto operation = operations.find(name);
    if (operation == operations.end()) return 1;
    const Result result = operation->second(threads, sample_path[0] != '\0');
    if (sample_path[0] != '\0') {
      std::FILE* file = std::fopen(sample_path, "wb");
      if (file == nullptr) return 1;
      const bool good =
          std::fwrite(result.sample.data(), 8, result.sample.size(), file) == result.sample.size();
      if (std::fclose(file) != 0 || !good) return 1;
    }
    std::printf("%s|%s|%zu|%d|%.6f|%llu\n", peer.c_str(), name, points, threads, result.seconds,
                static_cast<unsigned long long>(result.count));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace bench
