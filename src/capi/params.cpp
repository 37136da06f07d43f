// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/params.h"

#include <cstring>

#include "capi/support/guard.h"
#include "capi/support/operations.h"
#include "cloud/operations.h"
#include "compare/clearance/clearance.h"
#include "compare/changes/diagnosis.h"
#include "cloud/precision.h"
#include "cloud/sections/sections.h"
#include "compare/distance/model_sample.h"
#include "compare/visibility/visibility.h"
#include "fieldtools/chamfer.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/fast_marching.h"
#include "fieldtools/field_arithmetic.h"
#include "fieldtools/gradient.h"
#include "fieldtools/histogram.h"
#include "fieldtools/propagation.h"
#include "fieldtools/smoothing.h"
#include "fieldtools/two_means.h"
#include "compare/volumes/volume.h"
#include "formats/formats.h"
#include "model/relations/relations.h"
#include "modelling/edge_curve.h"
#include "formats/trajectory/trajectory_files.h"
#include "modelling/evaluation/model_evaluation.h"
#include "fieldtools/field_normality.h"
#include "model/buildings/building_offsets.h"
#include "model/buildings/building_tree.h"
#include "model/trajectory/ellipsoids.h"
#include "model/trajectory/trajectory_settings.h"
#include "registration/joint/joint_settings.h"
#include "registration/network/network_settings.h"
#include "registration/targets/measure.h"
#include "report/pages/change_outlines.h"
#include "report/pages/clearance_report.h"
#include "report/pages/comparison_report.h"
#include "report/pages/adjustment_report.h"
#include "report/pages/registration_report.h"
#include "report/pictures/deviation_picture.h"
#include "report/pictures/orthoimage.h"
#include "report/pictures/picture.h"
#include "report/report.h"
#include "scan/mobile/drive_scenario.h"
#include "scan/mobile/georeference.h"
#include "scan/mobile/street_drive.h"
#include "scan/scene.h"
#include "segment/evaluation/confusion.h"
#include "segment/evaluation/evaluation.h"
#include "segment/labels/from_labels.h"
#include "segment/picks/picks.h"
#include "segment/surface/primitive_fits.h"

namespace jalon::capi {

std::span<const Operation> operations() {
  static constexpr Operation kOperations[] = {
      {"normals", normals_rows},
      {"features", features_rows},
      {"components", components_rows},
      {"regions", regions_rows},
      {"diagnosis", diagnosis_rows},
      {"volume", volume_rows},
      {"model_sample", model_sample_rows},
      {"change_outlines", change_outlines_rows},
      {"deviation_picture", deviation_picture_rows},
      {"comparison_report", comparison_report_rows},
      {"registration_report", registration_report_rows},
      {"clearance_report", clearance_report_rows},
      {"adjustment_report", adjustment_report_rows},
      {"outliers", outliers_rows},
      {"subsample", subsample_rows},
      {"interest", interest_rows},
      {"read", read_rows},
      {"write", write_rows},
      {"convert", convert_rows},
      {"scene", scene_rows},
      {"elevation", elevation_rows},
      {"report", report_rows},
      {"picture", picture_rows},
      {"orthoimage", orthoimage_rows},
      {"labels", labels_rows},
      {"evaluation", evaluation_rows},
      {"confusion", confusion_rows},
      {"primitive", primitive_rows},
      {"pick", pick_rows},
      {"model_evaluation", model_evaluation_rows},
      {"indices", indices_rows},
      {"precision", precision_rows},
      {"visibility", visibility_rows},
      {"noise_law", noise_law_rows},
      {"histogram", histogram_rows},
      {"chi_square", chi_square_rows},
      {"classes", classes_rows},
      {"gradient", gradient_rows},
      {"field_filter", field_filter_rows},
      {"field_arithmetic", field_arithmetic_rows},
      {"geodesic", geodesic_rows},
      {"propagation", propagation_rows},
      {"distance_map", distance_map_rows},
      {"clearance", clearance_rows},
      {"target", target_rows},
      {"sections", section_rows},
      {"relations", relation_rows},
      {"long_edges", edge_curve_rows},
      {"trajectory", trajectory_rows},
      {"trajectory_file", trajectory_file_rows},
      {"georeference", georeference_rows},
      {"drive_scenario", drive_scenario_rows},
      {"adjust", joint_rows},
      {"network", network_rows},
      {"ellipsoids", ellipsoid_rows},
      {"normality", normality_rows},
      {"building_strips", building_strip_rows},
      {"building_sigmas", building_sigma_rows},
      {"street_drive", street_drive_rows},
  };
  return kOperations;
}

namespace {

constexpr size_t kLongestValue = size_t{1} << 20;  // a list of codes: some 25 000 points

const Operation& find_operation(const std::string& name) {
  std::string names;
  for (const auto& operation : operations()) {
    if (name == operation.name) return operation;
    names += (names.empty() ? "" : ", ") + std::string(operation.name);
  }
  fail(Status::kNotFound, "no operation \"%.100s\"; there are: %s", name.c_str(), names.c_str());
}

}  // namespace

ParamSet options_or_default(const jalon_params* options, const char* operation) {
  if (options == nullptr) return {find_operation(operation).name, find_operation(operation).rows()};
  if (options->operation != operation)
    fail(Status::kInvalidArgument, "the options are of \"%s\", not of \"%s\"",
         options->operation.c_str(), operation);
  return *options->values;
}

}  // namespace jalon::capi

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_params_create(const char* operation, jalon_params** out) {
  return guard([&] {
    require(out, "out");
    const Operation& found = find_operation(require_text(operation, "operation"));
    auto handle = std::make_unique<jalon_params>();
    handle->operation = found.name;
    handle->values = std::make_shared<ParamSet>(found.name, found.rows());
    *out = handle.release();
  });
}

jalon_status jalon_params_operation_count(uint64_t* out) {
  return guard([&] {
    require(out, "out");
    *out = operations().size();
  });
}

jalon_status jalon_params_operation_name(uint64_t i, const char** out) {
  return guard([&] {
    require(out, "out");
    if (i >= operations().size())
      fail(Status::kInvalidArgument, "there are %zu operations", operations().size());
    *out = operations()[i].name;
  });
}

jalon_status jalon_params_copy(const jalon_params* params, jalon_params** out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    auto handle = std::make_unique<jalon_params>();
    handle->operation = params->operation;
    handle->values = std::make_shared<ParamSet>(*params->values);
    *out = handle.release();
  });
}

jalon_params* jalon_params_retain(jalon_params* params) { return retain(params); }
void jalon_params_release(jalon_params* params) { release(params); }

jalon_status jalon_params_count(const jalon_params* params, uint64_t* out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = params->values->rows().size();
  });
}

jalon_status jalon_params_info(const jalon_params* params, uint64_t i, jalon_param_info* out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    const auto rows = params->values->rows();
    if (i >= rows.size()) fail(Status::kInvalidArgument, "there are %zu parameters", rows.size());
    if (out->struct_size < sizeof(uint32_t) || out->struct_size > 4096)
      fail(Status::kInvalidArgument, "struct_size of jalon_param_info is not set");
    // Texts are made once, at the first look: handles are for one thread at a time.
    auto& texts = const_cast<jalon_params*>(params)->default_texts;
    if (texts.empty()) {
      std::vector<std::string> made;
      for (size_t k = 0; k < rows.size(); ++k) made.push_back(params->values->default_text(k));
      texts.swap(made);
    }
    const ParamRow& row = rows[i];
    const jalon_param_info info{out->struct_size, static_cast<int32_t>(row.type),
                                row.name,         row.unit,
                                row.methods,      row.help,
                                row.choices,      texts[i].c_str(),
                                row.minimum,      row.maximum};
    std::memcpy(out, &info, std::min<size_t>(out->struct_size, sizeof info));
  });
}

jalon_status jalon_params_set_double(jalon_params* params, const char* name, double value) {
  return guard([&] {
    require(params, "params");
    params->values->set_number(require_text(name, "name"), value);
  });
}

jalon_status jalon_params_set_int64(jalon_params* params, const char* name, int64_t value) {
  return guard([&] {
    require(params, "params");
    params->values->set_integer(require_text(name, "name"), value);
  });
}

jalon_status jalon_params_set_bool(jalon_params* params, const char* name, int32_t value) {
  return guard([&] {
    require(params, "params");
    params->values->set_bool(require_text(name, "name"), value != 0);
  });
}

jalon_status jalon_params_set_string(jalon_params* params, const char* name, const char* value) {
  return guard([&] {
    require(params, "params");
    params->values->set_text(require_text(name, "name"),
                             require_text(value, "value", kLongestValue));
  });
}

jalon_status jalon_params_set_doubles(jalon_params* params, const char* name, const double* values,
                                      uint64_t count) {
  return guard([&] {
    require(params, "params");
    require_array(values, JALON_FLOAT64, count, 1, 0, "values");
    params->values->set_numbers(require_text(name, "name"), {values, count});
  });
}

jalon_status jalon_params_get_double(const jalon_params* params, const char* name, double* out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = params->values->number(require_text(name, "name"));
  });
}

jalon_status jalon_params_get_int64(const jalon_params* params, const char* name, int64_t* out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = params->values->integer(require_text(name, "name"));
  });
}

jalon_status jalon_params_get_bool(const jalon_params* params, const char* name, int32_t* out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = params->values->flag(require_text(name, "name")) ? 1 : 0;
  });
}

jalon_status jalon_params_get_string(const jalon_params* params, const char* name,
                                     const char** out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = params->values->text(require_text(name, "name")).c_str();
  });
}

jalon_status jalon_params_get_doubles(const jalon_params* params, const char* name,
                                      const double** values, uint64_t* count) {
  return guard([&] {
    require(params, "params");
    require(values, "values");
    require(count, "count");
    const auto& numbers = params->values->numbers(require_text(name, "name"));
    *values = numbers.data();
    *count = numbers.size();
  });
}

jalon_status jalon_params_reset(jalon_params* params) {
  return guard([&] {
    require(params, "params");
    params->values->reset();
  });
}

jalon_status jalon_params_to_json(jalon_params* params, const char** out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    params->json = params->values->to_json();
    *out = params->json.c_str();
  });
}

jalon_status jalon_params_from_json(jalon_params* params, const char* json) {
  return guard([&] {
    require(params, "params");
    params->values->from_json(require_text(json, "json", kLongestValue));
  });
}
