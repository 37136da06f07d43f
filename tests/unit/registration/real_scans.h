// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "base/text_number.h"
#include "formats/formats.h"
#include "geometry/rigid_motion.h"
#include "registration/icp/settings.h"

namespace jalon::test {

/// Two real lidar scans from 0.5 m apart, with the pose that a public ICP found.
struct RealScans {
  std::string folder = std::string(JALON_SHARED_DATA) + "/registration/";

  /// False, visibly, where they are not at hand.
  bool exist() const {
    if (std::filesystem::exists(folder + "source.ply")) return true;
    if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no registration");
    MESSAGE("skipped: no " << folder);
    return false;
  }
  Cloud source() const { return read("source.ply"); }
  Cloud target() const { return read("target.ply"); }
  /// target <- source
  Transform pose() const {
    std::ifstream file(folder + "T_target_source.txt");
    Transform out;
    std::string word;
    for (double& value : out.m) {
      file >> word;
      REQUIRE(parse_number(word, value));
    }
    return out;
  }

  /// Settings of method "icp" by which a peer comes to that pose: generalised ICP on centroids of 10 cm cubes, 10
  /// neighbours, all pairs within a metre, no robust weights. The scans were taken in motion and do not fit to better
  /// than centimetres; other choices give poses that differ by 0.1 to 0.2 degrees, whatever the library.
  static IcpSettings as_published() {
    return {.kernel = KernelKind::kNone,
            .max_distance_m = 1,
            .min_distance_m = 1,
            .max_angle_rad = std::numbers::pi / 2,
            .cell_m = 0.1,
            .k = 10};
  }

 private:
  Cloud read(const char* name) const {
    Task task;
    return read_cloud(folder + name, {}, task);
  }
};

}  // namespace jalon::test
