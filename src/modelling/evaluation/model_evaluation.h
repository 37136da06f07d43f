// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "modelling/evaluation/area_indices.h"
#include "modelling/evaluation/border_distances.h"
#include "modelling/evaluation/vertex_deviations.h"

namespace jalon {

/// A face of one side and how it fared.
struct FaceVerdict {
  uint32_t face = 0, ring = ~uint32_t{0}, part = 0, merged = 1;  ///< as ComparedFace
  double area_m2 = 0;
  bool kept = true;               ///< false: too small
  uint32_t partner = kNoPartner;  ///< row of its counterpart on the other side

  static constexpr uint32_t kNoPartner = ~uint32_t{0};
};

/// An automatic face and its reference, in the reference's plane.
struct FacePair {
  uint32_t automatic = 0, reference = 0;  ///< rows of the sides' verdicts
  ComparedAreas areas;
  double angle_rad = 0;  ///< between the planes
  double distance_m =
      0;  ///< of the automatic face's middle from the reference's plane, along its normal
  bool same_class = false;  ///< their parts have one class
  BorderComparison borders;
};

/// A model against a reference (Boulaassal 2010, 5.6.2, 5.6.3.2 and table 5.8).
struct ModelEvaluation {
  std::vector<FaceVerdict> automatic, reference;
  std::vector<FacePair> pairs;       ///< ascending by reference
  std::vector<VertexPair> vertices;  ///< of paired faces; indices of the models' vertices
  ComparedAreas unpaired;            ///< kept faces without a counterpart, nothing shared
  Vec3 shift;  ///< what the automatic model was moved by first; 0 when absolute
  IndexFormulas formulas = IndexFormulas::kCanonical;
};

/// Operation "model_evaluation".
struct ModelEvaluationSettings {
  enum class Mode { kAbsolute, kRelative };
  enum class Compare { kFaces, kOpenings };
  enum class Group { kFace, kPlane };

  Mode mode = Mode::kAbsolute;
  IndexSettings indices;
  Compare compare = Compare::kFaces;
  Group group = Group::kFace;
  std::string classes, ignored_classes = "no_data";  ///< of the faces' parts, separated by commas
  double min_area_m2 = 0;
  double angle_tolerance_rad = 0.0873,
         distance_tolerance_m = 0.1;  ///< between the planes of a pair
  double min_iou = 0.1;
  double contour_tolerance_m = 0.02, contour_step_m = 0.01;
  double vertex_tolerance_m = 0.15;
  double corner_angle_rad = 0.35;
};
std::span<const ParamRow> model_evaluation_rows();
/// 1. The faces (or openings) of both to compare, in one frame of coordinates; 2. paired one to one
/// by the area they share; 3. areas, borders and vertices of the pairs. Same bits for any number of
/// threads.
ModelEvaluation evaluate_model(const Model& automatic, const Model& reference,
                               const ModelEvaluationSettings& settings, Task& task);

// Tables of jalon/evaluate.h.
FieldTable face_pair_table(const ModelEvaluation& evaluation);
FieldTable automatic_face_table(const ModelEvaluation& evaluation);
FieldTable reference_face_table(const ModelEvaluation& evaluation);
FieldTable model_totals_table(const ModelEvaluation& evaluation);

}  // namespace jalon
