// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "base/json_reader.h"
#include "base/json_writer.h"
#include "report/names/notes.h"
#include "report/names/orientation_name.h"
#include "report/pages/json_model.h"
#include "report/pages/plane_precision.h"
#include "report/report.h"
#include "segment/result/residuals.h"

namespace jalon {

namespace {

constexpr size_t kBins = 60;  // as the page shows by default

template <class Range>
void write_array(JsonWriter& json, const char* name, const Range& values) {
  json.name(name).begin_array();
  for (const auto& value : values) json.value(value);
  json.end_array();
}

void write_vector(JsonWriter& json, const char* name, const Vec3& v) {
  write_array(json, name, std::array{v.x, v.y, v.z});
}

template <class Pairs>
void write_pairs(JsonWriter& json, const char* name, const Pairs& pairs) {
  json.name(name).begin_object();
  for (const auto& [key, value] : pairs) json.name(key).value(value);
  json.end_object();
}

void write_plane(JsonWriter& json, const Segment& s, const PropagatedPlane* scanner) {
  json.begin_object();
  json.name("label").value(s.label);
  json.name("orientation").value(orientation_name(s.orientation));
  json.name("inliers").value(s.fit.n);
  json.name("length_u_m").value(s.length_u_m);
  json.name("length_v_m").value(s.length_v_m);
  json.name("area_m2").value(s.area_m2);
  write_vector(json, "normal", s.fit.plane.normal);
  json.name("offset_m").value(s.fit.plane.offset);
  write_vector(json, "centroid", s.fit.centroid);
  json.name("sigma_m").value(s.fit.sigma);
  const PlanePrecision precision = plane_precision(s.fit);
  json.name("sigma_normal_rad").value(precision.sigma_normal_rad);
  json.name("sigma_offset_m").value(precision.sigma_offset_m);
  if (scanner != nullptr) {
    json.name("sigma_scanner_m").value(scanner->sigma_prior_m);
    json.name("variance_factor").value(scanner->variance_factor);
  }
  json.end_object();
}

void write_curved(JsonWriter& json, const Segment& s) {
  const bool sphere = s.type == PrimitiveType::kSphere;
  json.begin_object();
  json.name("label").value(s.label);
  json.name("inliers").value(s.point_count());
  json.name("radius_m").value(sphere ? s.sphere.sphere.radius : s.cylinder.cylinder.radius);
  json.name("sigma_radius_m")
      .value(std::sqrt(sphere ? s.sphere.covariance[15] : s.cylinder.covariance[48]));
  if (sphere) {
    write_vector(json, "centre", s.sphere.sphere.centre);
  } else {
    write_vector(json, "axis_point", s.cylinder.cylinder.point);
    write_vector(json, "axis", s.cylinder.cylinder.direction);
    json.name("length_m").value(s.length_u_m);
  }
  json.name("area_m2").value(s.area_m2);
  json.name("sigma_m").value(s.sigma_m());
  json.end_object();
}

void write_all_curved(JsonWriter& json, const char* name, const Segmentation& segmentation,
                      PrimitiveType type) {
  json.name(name).begin_array();
  for (const Segment& segment : segmentation.segments)
    if (segment.type == type) write_curved(json, segment);
  json.end_array();
}

void write_face(JsonWriter& json, const Face& face) {
  json.begin_object();
  json.name("plane").value(face.id);
  json.name("area_m2").value(face.area_m2);
  json.name("openings").value(face.ring_count > 0 ? face.ring_count - 1 : 0);
  json.end_object();
}

void write_residuals(JsonWriter& json, const Residuals& r) {
  json.begin_object();
  json.name("count").value(r.count);
  json.name("mean_m").value(r.mean_m);
  json.name("sigma_m").value(r.sigma_m);
  json.name("from_m").value(-r.half_range_m);
  json.name("to_m").value(r.half_range_m);
  json.name("below").value(r.below);
  json.name("above").value(r.above);
  write_array(json, "bins", r.bins);
  json.end_object();
}

}  // namespace

std::string report_json(const Segmentation& segmentation, const Model& model,
                        std::string_view notes_json, Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  const std::string& parameters = segmentation.parameters_json;
  JsonWriter json(1);
  json.begin_object();
  json.name("title").value(notes.title);
  json.name("points").value(segmentation.cloud->size());
  json.name("crs").value(segmentation.cloud->crs.str());
  write_pairs(json, "input", notes.input);
  if (!notes.scanner_json.empty()) json.name("scanner").value(read_json(notes.scanner_json)[0]);
  write_pairs(json, "times_s", notes.times_s);
  json.name("parameters")
      .value(read_json(parameters.empty() ? "{}" : std::string_view(parameters))[0]);
  write_array(json, "T_facade_world", segmentation.T_facade_world.m);
  json.name("planes").begin_array();
  const std::vector<PropagatedPlane> scanner = scanner_planes(segmentation, notes, task);
  for (size_t i = 0; i < segmentation.segments.size(); ++i)
    if (segmentation.segments[i].is_plane())
      write_plane(json, segmentation.segments[i], scanner.empty() ? nullptr : &scanner[i]);
  json.end_array();
  write_all_curved(json, "spheres", segmentation, PrimitiveType::kSphere);
  write_all_curved(json, "cylinders", segmentation, PrimitiveType::kCylinder);
  json.name("faces").begin_array();
  for (const Face& face : model.faces) write_face(json, face);
  json.end_array();
  write_model_parts(json, model);
  json.name("residuals");
  write_residuals(json, bin_residuals(segmentation, 0, kBins, task));
  return json.end_object().take() + "\n";
}

}  // namespace jalon
