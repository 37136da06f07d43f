// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/model_evaluation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "modelling/evaluation/compared_faces.h"
#include "modelling/evaluation/face_pairing.h"

namespace jalon {

namespace {

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> out;
  std::string word;
  for (const char c : text + ",") {
    if (c != ',' && c != ' ') {
      word += c;
    } else if (!word.empty()) {
      out.push_back(word);
      word.clear();
    }
  }
  return out;
}

FaceChoice choice_of(const ModelEvaluationSettings& settings) {
  FaceChoice choice;
  choice.openings = settings.compare == ModelEvaluationSettings::Compare::kOpenings;
  choice.by_plane = settings.group == ModelEvaluationSettings::Group::kPlane;
  choice.min_area_m2 = settings.min_area_m2;
  choice.angle_rad = settings.angle_tolerance_rad;
  choice.distance_m = settings.distance_tolerance_m;
  choice.corner_angle_rad = settings.corner_angle_rad;
  choice.classes = words(settings.classes);
  choice.ignored_classes = words(settings.ignored_classes);
  return choice;
}

bool is_mesh(const Model& model) { return model.faces.empty() && !model.triangles.empty(); }

// Whole metres near the models: national grids lose nothing.
Vec3 local_origin(const Model& automatic, const Model& reference) {
  const Model& model = reference.vertices.empty() ? automatic : reference;
  if (model.vertices.empty()) return {};
  const Vec3& p = model.vertices.front();
  return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
}

// One side: its faces, and the vertices of the paired ones, each place once.
struct Side {
  const Model& model;
  Vec3 origin;
  std::vector<ComparedFace> faces;
  std::vector<uint32_t> vertices;  ///< of the model
  std::vector<uint32_t> largest;   ///< of each, its largest paired face
  std::vector<Vec3> places;        ///< of each, relative to the origin

  Side(const Model& m, const Vec3& o, const FaceChoice& choice, Task& task)
      : model(m), origin(o), faces(compared_faces(m, o, choice, task)) {}

  void collect_vertices(const std::vector<uint32_t>& paired, const Vec3& shift) {
    struct Use {
      Vec3 place;
      uint32_t vertex, face;
    };
    std::vector<Use> uses;
    for (const uint32_t f : paired)
      for (const uint32_t v : faces[f].vertices) uses.push_back({model.vertices[v] - origin, v, f});
    std::sort(uses.begin(), uses.end(), [&](const Use& a, const Use& b) {
      for (int i = 0; i < 3; ++i)
        if (a.place[i] != b.place[i]) return a.place[i] < b.place[i];
      if (faces[a.face].area_m2 != faces[b.face].area_m2)
        return faces[a.face].area_m2 > faces[b.face].area_m2;
      return a.face != b.face ? a.face < b.face : a.vertex < b.vertex;
    });
    vertices.clear(), largest.clear(), places.clear();
    for (size_t i = 0; i < uses.size(); ++i) {
      if (i > 0 && uses[i].place == uses[i - 1].place) continue;
      vertices.push_back(uses[i].vertex);
      largest.push_back(uses[i].face);
      places.push_back(uses[i].place + shift);
    }
  }
};

// Against the covariances that are known: a reference without one is taken as right.
double normalised_deviation(const Vec3& e, const Model& a, uint32_t vertex_a, const Model& r,
                            uint32_t vertex_r) {
  const auto known = [](const Model& model, uint32_t v) {
    return !model.vertex_covariances.empty() && std::isfinite(model.vertex_covariances[v][0]);
  };
  if (!known(a, vertex_a) && !known(r, vertex_r)) return kNaN;
  std::array<double, 9> sum{};
  for (size_t i = 0; i < 9; ++i)
    sum[i] = (known(a, vertex_a) ? a.vertex_covariances[vertex_a][i] : 0) +
             (known(r, vertex_r) ? r.vertex_covariances[vertex_r][i] : 0);
  return jalon::normalised_deviation(e, sum);
}

std::vector<VertexPair> compare_vertices(Side& automatic, Side& reference,
                                         const std::vector<FacePair>& pairs, const Vec3& shift,
                                         double tolerance_m, Task& task) {
  std::vector<uint32_t> a, r;
  for (const FacePair& pair : pairs) a.push_back(pair.automatic), r.push_back(pair.reference);
  automatic.collect_vertices(a, shift);
  reference.collect_vertices(r, {});
  std::vector<VertexPair> out =
      homologous_vertices(automatic.places, reference.places, tolerance_m, task);
  for (VertexPair& pair : out) {
    const PlaneFrame& frame = reference.faces[reference.largest[pair.reference]].frame;
    pair.in_facade = {dot(pair.deviation, frame.axis_u), dot(pair.deviation, frame.axis_v),
                      dot(pair.deviation, frame.normal)};
    pair.automatic = automatic.vertices[pair.automatic];
    pair.normalised = normalised_deviation(pair.deviation, automatic.model, pair.automatic,
                                           reference.model, reference.vertices[pair.reference]);
    pair.reference = reference.vertices[pair.reference];
  }
  return out;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// What moves the automatic model onto the reference: medians of the deviations, which a few wrong pairs do not turn.
Vec3 common_shift(const std::vector<VertexPair>& vertices) {
  if (vertices.empty()) return {};
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    std::vector<double> values;
    for (const VertexPair& pair : vertices) values.push_back(-pair.deviation[i]);
    out[i] = median(std::move(values));
  }
  return out;
}

std::vector<FaceVerdict> verdicts_of(const Side& side) {
  std::vector<FaceVerdict> out;
  for (const ComparedFace& f : side.faces)
    out.push_back({f.face, f.ring, f.part, f.merged, f.area_m2, f.kept});
  return out;
}

std::string class_of(const Model& model, uint32_t part) {
  return part < model.parts.size() ? model.parts[part].part_class : "";
}

// What the pairs leave: partners, and the area of kept faces without one.
void judge_faces(const Side& automatic, const Side& reference, ModelEvaluation& out) {
  out.automatic = verdicts_of(automatic);
  out.reference = verdicts_of(reference);
  for (FacePair& pair : out.pairs) {
    FaceVerdict &a = out.automatic[pair.automatic], &r = out.reference[pair.reference];
    a.partner = pair.reference;
    r.partner = pair.automatic;
    pair.same_class = class_of(automatic.model, a.part) == class_of(reference.model, r.part);
  }
  for (const FaceVerdict& a : out.automatic)
    if (a.kept && a.partner == FaceVerdict::kNoPartner) out.unpaired.automatic_m2 += a.area_m2;
  for (const FaceVerdict& r : out.reference)
    if (r.kept && r.partner == FaceVerdict::kNoPartner) out.unpaired.reference_m2 += r.area_m2;
}

}  // namespace

// 1. polygons; 2. pairs; 3. relative: the common shift off, pairs anew; 4. vertices; 5. contours; 6. what is left over.
ModelEvaluation evaluate_model(const Model& automatic_model, const Model& reference_model,
                               const ModelEvaluationSettings& settings, Task& task) {
  FaceChoice choice = choice_of(settings);
  if (is_mesh(automatic_model) || is_mesh(reference_model)) choice.by_plane = true;
  const double min_iou = settings.min_iou, vertex_tolerance_m = settings.vertex_tolerance_m;
  const Vec3 origin = local_origin(automatic_model, reference_model);
  const auto side_of = [&](const Model& model, double from, double to) {
    ProgressSpan span(task, from, to, "reading faces");
    return Side(model, origin, choice, task);
  };
  Side automatic = side_of(automatic_model, 0, 0.1), reference = side_of(reference_model, 0.1, 0.2);
  ModelEvaluation out;
  out.formulas = settings.indices.formulas;
  {
    ProgressSpan span(task, 0.2, 0.6, "pairing faces");
    out.pairs = pair_faces(automatic.faces, reference.faces, {}, choice, min_iou, task);
    out.vertices = compare_vertices(automatic, reference, out.pairs, {}, vertex_tolerance_m, task);
    if (settings.mode == ModelEvaluationSettings::Mode::kRelative) {
      out.shift = common_shift(out.vertices);
      out.pairs = pair_faces(automatic.faces, reference.faces, out.shift, choice, min_iou, task);
      out.vertices =
          compare_vertices(automatic, reference, out.pairs, out.shift, vertex_tolerance_m, task);
    }
  }
  ProgressSpan span(task, 0.6, 1, "comparing contours");
  parallel_for(task, out.pairs.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const ComparedFace& r = reference.faces[out.pairs[i].reference];
      out.pairs[i].borders =
          compare_borders(region_in(r.frame, automatic.faces[out.pairs[i].automatic], out.shift),
                          r.region, settings.contour_tolerance_m, settings.contour_step_m);
    }
  });
  judge_faces(automatic, reference, out);
  return out;
}

}  // namespace jalon
