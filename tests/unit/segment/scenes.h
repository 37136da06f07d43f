// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/text_number.h"
#include "segment/growing_settings.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon::test {

/// Points with the number of the face each lies on (0 = outlier).
struct Scene {
  std::vector<Vec3> points;
  std::vector<int> faces;

  /// count points at random on corner + a u + b v, a and b in [0, 1), with normal noise along x, y and z.
  void rectangle(int face, Vec3 corner, Vec3 u, Vec3 v, size_t count, double sigma,
                 RandomStream& random) {
    for (size_t i = 0; i < count; ++i) {
      const double along_v = random.uniform(), along_u = random.uniform();
      const Vec3 p = corner + along_u * u + along_v * v;
      const Vec3 noise{random.normal(), random.normal(), random.normal()};
      points.push_back(p + sigma * noise);
      faces.push_back(face);
    }
  }
  void outliers(Vec3 low, Vec3 high, size_t count, RandomStream& random) {
    for (size_t i = 0; i < count; ++i) {
      const Vec3 d = high - low;
      points.push_back(
          low + Vec3{d.x * random.uniform(), d.y * random.uniform(), d.z * random.uniform()});
      faces.push_back(0);
    }
  }
};

inline CloudPtr cloud_of(const std::vector<Vec3>& points, const Vec3& shift = {}) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k] + shift[k];
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

inline RansacSettings ransac_params(const char* json = "{}", uint64_t seed = 1) {
  ParamSet params("segmenter ransac", ransac_rows());
  params.from_json(json);
  auto settings = settings_from<RansacSettings>(params);
  settings.draw.seed = seed;
  return settings;
}

inline Segmentation run(const CloudPtr& cloud, const RansacSettings& settings,
                        unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return segment_ransac(cloud, settings, task);
}

inline Segmentation grow(const CloudPtr& cloud, const char* json = "{}", unsigned threads = 2) {
  ParamSet params("segmenter region_growing", region_growing_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return segment_region_growing(cloud, settings_from<GrowingSettings>(params), task);
}

/// Points of the face that carry the label.
inline size_t overlap(const Scene& scene, const Segmentation& s, int face, uint32_t label) {
  const auto labels = s.labels->values<uint32_t>();
  size_t count = 0;
  for (size_t i = 0; i < labels.size(); ++i) count += scene.faces[i] == face && labels[i] == label;
  return count;
}

/// A facade with recessed windows, a cornice, ground and a box: 18 planes, 3 mm noise.
inline Scene facade_scene(size_t density_per_m2, uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 7);
  const auto add = [&](int face, Vec3 corner, Vec3 u, Vec3 v) {
    const double area = norm(cross(u, v));
    scene.rectangle(face, corner, u, v,
                    static_cast<size_t>(area * static_cast<double>(density_per_m2)), 0.003, random);
  };
  // Wall y = 0, x 0 ... 10, z 0 ... 6 around two windows 1.5 x 2 at z 2 ... 4.
  add(1, {0, 0, 0}, {10, 0, 0}, {0, 0, 2});
  add(1, {0, 0, 4}, {10, 0, 0}, {0, 0, 2});
  for (const double x : {0.0, 3.5, 7.5})
    add(1, {x, 0, 2}, {x == 3.5 ? 2.5 : (x == 0 ? 2.0 : 2.5), 0, 0}, {0, 0, 2});
  int face = 2;
  for (const double x : {2.0, 6.0}) {
    add(face++, {x, 0.2, 2}, {1.5, 0, 0}, {0, 0, 2});  // pane
    add(face++, {x, 0, 2}, {0, 0.2, 0}, {0, 0, 2});    // reveals
    add(face++, {x + 1.5, 0, 2}, {0, 0.2, 0}, {0, 0, 2});
    add(face++, {x, 0, 2}, {1.5, 0, 0}, {0, 0.2, 0});  // sill
    add(face++, {x, 0, 4}, {1.5, 0, 0}, {0, 0.2, 0});  // lintel
  }
  add(face++, {0, -0.4, 6}, {10, 0, 0}, {0, 0.4, 0});  // soffit of the cornice
  add(face++, {0, -0.4, 6}, {10, 0, 0}, {0, 0, 0.4});  // its front
  add(face++, {-1, -6, 0}, {12, 0, 0}, {0, 6, 0});     // ground
  add(face++, {4, -4, 1}, {1, 0, 0}, {0, 1, 0});       // box
  add(face++, {4, -4, 0}, {1, 0, 0}, {0, 0, 1});
  add(face++, {4, -4, 0}, {0, 1, 0}, {0, 0, 1});
  add(face++, {5, -4, 0}, {0, 1, 0}, {0, 0, 1});
  scene.outliers({-1, -6, -0.5}, {11, 1, 7}, scene.points.size() / 50, random);
  return scene;
}

/// A street of hand-labelled points: faces are the classes 1 wall, 2 door, 3 window. Empty when the folder is not
/// there.
inline Scene street(const char* name) {
  Scene scene;
  std::ifstream file(std::string(JALON_SHARED_DATA) + "/facades/" + name);
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    double values[5];
    size_t from = 0;
    bool good = true;
    for (double& value : values) {
      const size_t to = line.find(' ', from);
      good = good && parse_number(std::string_view(line).substr(from, to - from), value);
      from = to + 1;
    }
    if (!good) continue;
    scene.points.push_back({values[0], values[1], values[2]});
    scene.faces.push_back(static_cast<int>(values[4]));
  }
  return scene;
}

}  // namespace jalon::test
