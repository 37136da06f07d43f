// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/methods.h"

#include "base/names_of.h"
#include "modelling/codes/coded_model.h"
#include "modelling/facade/facade.h"
#include "modelling/outlines.h"

namespace jalon {

namespace {

template <class Settings, Model (*model)(const Segmentation&, const Settings&, Task&)>
Model run(const Segmentation& segmentation, const ParamSet& params, Task& task) {
  return model(segmentation, settings_from<Settings>(params), task);
}

constexpr ModellingMethod kMethods[] = {
    {"outlines", "modeller outlines", outlines_rows, run<VectoriseSetting, model_outlines>},
    {"facade", "modeller facade", facade_rows, run<FacadeSettings, model_facade>},
    {"cell_decomposition", "modeller cell_decomposition", cell_decomposition_rows,
     run<FacadeSettings, model_cell_decomposition>},
    {"extrusion", "modeller extrusion", extrusion_rows, run<ExtrusionSettings, model_extrusion>},
    {"coded_objects", "modeller coded_objects", coded_model_rows,
     run<CodedModelSettings, model_coded_objects>},
};

}  // namespace

std::span<const ModellingMethod> modelling_methods() { return kMethods; }
std::span<const char* const> modelling_method_names() { return kNamesOf<kMethods>; }

}  // namespace jalon
