// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "base/params.h"
#include "capi/support/handles.h"
#include "model/model.h"
#include "model/part_attributes.h"
#include "modelling/methods.h"

struct jalon_model : jalon::capi::Counted {
  jalon::ModelPtr model;
  std::shared_ptr<const jalon::PartAttributes> attributes;  ///< for files; nullptr: none
};

struct jalon_modeller : jalon::capi::Counted {
  const jalon::ModellingMethod* method = nullptr;
  std::shared_ptr<jalon::ParamSet>
      values;  ///< shared with the jalon_params handles of this modeller
};

namespace jalon::capi {

jalon_model* new_model(Model model);

}  // namespace jalon::capi
