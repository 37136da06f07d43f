// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "scan/methods.h"
#include "scan/scene.h"
#include "scan/truth.h"
#include "segment/evaluation/evaluation.h"
#include "segment/labels/from_labels.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon::test {

inline bool is_full() { return std::getenv("JALON_FULL") != nullptr; }

/// A scene after Boulaassal 2010, chapter 3, measured by a scanner's method; all parameters but the seed as JSON.
struct Recipe {
  Model scene;
  CloudPtr cloud;

  Recipe(const char* scene_json, const std::string& method, const char* scanner_json,
         uint64_t seed) {
    Task task;
    ParamSet options("scene", scene_rows());
    options.from_json(scene_json);
    scene = build_scene(settings_from<SceneSettings>(options), task);
    for (const ScannerMethod& m : scanner_methods()) {
      if (method != m.name) continue;
      ParamSet params(m.owner, m.rows());
      params.from_json(scanner_json);
      params.set_integer("seed", static_cast<int64_t>(seed));
      cloud = std::make_shared<const Cloud>(m.scan(scene, {}, params, task));
    }
  }
};

inline Segmentation ransac(const CloudPtr& cloud, const std::string& json, uint64_t seed = 1) {
  Task task;
  ParamSet params("segmenter ransac", ransac_rows());
  params.from_json(json);
  auto settings = settings_from<RansacSettings>(params);
  settings.draw.seed = seed;
  return segment_ransac(cloud, settings, task);
}

/// The true planes that the scanner wrote down: field "segment".
inline Segmentation true_segmentation(const CloudPtr& cloud) {
  Task task;
  return segmentation_from_labels(cloud, "segment", LabelSettings{}, task);
}

inline Evaluation evaluated(const Segmentation& found, const Segmentation& truth,
                            uint64_t min_points) {
  Task task;
  return evaluate_segmentation(found, truth, {.min_points = min_points}, task);
}

/// Share of the points of a true plane that carry the label; label 0: of those of any segment.
inline double share_of(const Segmentation& s, uint32_t true_plane, uint32_t label) {
  const auto labels = s.labels->values<uint32_t>(),
             truth = s.cloud->fields.require("segment").values<uint32_t>();
  double all = 0, own = 0;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (truth[i] != true_plane) continue;
    ++all;
    own += label == 0 ? labels[i] != 0 : labels[i] == label;
  }
  return all > 0 ? own / all : 0;
}

}  // namespace jalon::test
