// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "report/notes.h"
#include "report/orientation_name.h"
#include "report/report.h"
#include "report/residuals.h"

namespace jalon {

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kBins = 60;  // as the page shows by default

Json array_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json plane_json(const PlaneSegment& s) {
  Json plane = Json::object();
  plane["label"] = s.label;
  plane["orientation"] = orientation_name(s.orientation);
  plane["inliers"] = s.fit.n;
  plane["length_u_m"] = s.length_u_m;
  plane["length_v_m"] = s.length_v_m;
  plane["area_m2"] = s.area_m2;
  plane["normal"] = array_of(s.fit.plane.normal);
  plane["offset_m"] = s.fit.plane.offset;
  plane["centroid"] = array_of(s.fit.centroid);
  plane["sigma_m"] = s.fit.sigma;
  return plane;
}

Json face_json(const Face& face) {
  Json out = Json::object();
  out["plane"] = face.id;
  out["area_m2"] = face.area_m2;
  out["openings"] = face.ring_count > 0 ? face.ring_count - 1 : 0;
  return out;
}

Json residual_json(const Residuals& r) {
  Json out = Json::object();
  out["count"] = r.count;
  out["mean_m"] = r.mean_m;
  out["sigma_m"] = r.sigma_m;
  out["from_m"] = -r.half_range_m;
  out["to_m"] = r.half_range_m;
  out["below"] = r.below;
  out["above"] = r.above;
  out["bins"] = r.bins;
  return out;
}

}  // namespace

std::string report_json(const Segmentation& segmentation, const Model& model, std::string_view notes_json, Task& task) {
  const Span span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  Json out = Json::object();
  out["title"] = notes.title;
  out["points"] = segmentation.cloud->size();
  out["crs"] = segmentation.cloud->crs;
  out["input"] = Json::object();
  for (const auto& [name, value] : notes.input) out["input"][name] = value;
  out["times_s"] = Json::object();
  for (const auto& [name, seconds] : notes.times_s) out["times_s"][name] = seconds;
  out["parameters"] = Json::parse(segmentation.parameters_json, nullptr, false);
  if (out["parameters"].is_discarded()) out["parameters"] = Json::object();
  out["T_facade_world"] = segmentation.T_facade_world.m;
  out["planes"] = Json::array();
  for (const PlaneSegment& segment : segmentation.segments) out["planes"].push_back(plane_json(segment));
  out["faces"] = Json::array();
  for (const Face& face : model.faces) out["faces"].push_back(face_json(face));
  out["residuals"] = residual_json(bin_residuals(segmentation, kBins, task));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace jalon
