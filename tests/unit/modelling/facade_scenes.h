// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/topology.h"
#include "modelling/facade/facade.h"
#include "scan/scanner.h"
#include "scan/scene.h"
#include "segment/labels/from_labels.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace facades {

using namespace jalon;

/// A scene seen by the tripods of the scanner's choice, and its true planes as segments.
struct Scan {
  Model scene;
  CloudPtr cloud;
  Segmentation segmentation;

  explicit Scan(const char* scene_json, const char* scanner_json = "{}") {
    Task task;
    ParamSet options("scene", scene_rows());
    options.from_json(scene_json);
    scene = build_scene(settings_from<SceneSettings>(options), task);
    ParamSet scanner("scanner", static_scanner_rows());
    scanner.from_json(scanner_json);
    const auto settings = settings_from<StaticSettings>(scanner);
    cloud = std::make_shared<const Cloud>(scan_static(scene, {}, settings, task));
    segmentation = segment_ransac(cloud, RansacSettings{}, task);
  }
};

inline Model facade_of(const Segmentation& segmentation, const char* json = "{}",
                       unsigned threads = 2) {
  ParamSet params("modeller facade", facade_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  Model model = model_facade(segmentation, settings_from<FacadeSettings>(params), task);
  validate(model);
  return model;
}

inline std::vector<size_t> parts_of(const Model& model, const std::string& part_class) {
  std::vector<size_t> out;
  for (size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].part_class == part_class) out.push_back(i);
  return out;
}

/// The box of all faces of a part.
inline Box3 box_of_part(const Model& model, size_t part) {
  Box3 box;
  for (const Face& face : model.faces)
    if (face.part == part)
      for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
        for (uint64_t c = model.rings[r].first; c < model.rings[r].first + model.rings[r].count;
             ++c)
          box.add(model.vertices[model.corners[c]]);
  return box;
}

/// The child of this class, or the number of parts.
inline size_t child_of(const Model& model, size_t parent, const std::string& part_class) {
  for (size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].parent == parent && model.parts[i].part_class == part_class) return i;
  return model.parts.size();
}

}  // namespace facades
