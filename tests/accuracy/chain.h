// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "modelling/outlines.h"
#include "scan/scanner.h"
#include "scan/scene.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon::test {

/// A scene, its scan and what the chain makes of it, with default parameters throughout but those given.
struct SceneChain {
  Model scene;
  CloudPtr cloud;
  Segmentation segmentation;
  Model outlines;

  SceneChain(SceneName name, double step_rad, uint64_t seed, double outliers = 0) {
    Task task;
    scene = build_scene({.name = name}, task);
    const StaticSettings scanner{.horizontal_step_rad = step_rad,
                                 .vertical_step_rad = step_rad,
                                 .outliers = outliers,
                                 .seed = seed};
    cloud = std::make_shared<const Cloud>(scan_static(scene, {}, scanner, task));
    segmentation = segment_ransac(cloud, RansacSettings{}, task);
    outlines = model_outlines(segmentation, {}, task);
  }
};

/// How one segment relates to the true faces.
struct SegmentTruth {
  uint32_t face = kNoFace;  ///< the one most of its points are from
  uint64_t points = 0, own = 0;
  double purity() const {
    return points == 0 ? 0 : static_cast<double>(own) / static_cast<double>(points);
  }
};

inline std::vector<SegmentTruth> truth_of_segments(const SceneChain& chain) {
  const auto labels = chain.segmentation.labels->values<uint32_t>();
  const auto ids = chain.cloud->fields.require("face").values<uint32_t>();
  std::vector<std::map<uint32_t, uint64_t>> counts(chain.segmentation.segments.size());
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0) ++counts[labels[i] - 1][ids[i]];
  std::vector<SegmentTruth> out;
  for (const auto& count : counts) {
    SegmentTruth truth;
    for (const auto& [face, n] : count) {
      truth.points += n;
      if (n > truth.own) truth.face = face, truth.own = n;
    }
    out.push_back(truth);
  }
  return out;
}

inline std::map<uint32_t, uint64_t> points_of_faces(const Cloud& cloud) {
  std::map<uint32_t, uint64_t> out;
  for (const uint32_t id : cloud.fields.require("face").values<uint32_t>()) ++out[id];
  return out;
}

inline double angle_degrees(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))) * 57.29577951308232;
}

/// Extent of a ring in x and z, for faces that look along Y.
struct Frontal {
  double left, right, bottom, top;
};
inline Frontal frontal(const Model& model, const Ring& ring) {
  Frontal box{1e9, -1e9, 1e9, -1e9};
  for (uint64_t k = ring.first; k < ring.first + ring.count; ++k) {
    const Vec3& p = model.vertices[model.corners[k]];
    box.left = std::min(box.left, p.x);
    box.right = std::max(box.right, p.x);
    box.bottom = std::min(box.bottom, p.z);
    box.top = std::max(box.top, p.z);
  }
  return box;
}

}  // namespace jalon::test
