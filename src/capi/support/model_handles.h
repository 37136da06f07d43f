// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/params.h"
#include "capi/support/handles.h"
#include "model/model.h"

struct jalon_model : jalon::capi::Counted {
  jalon::ModelPtr model;
};

struct jalon_modeller : jalon::capi::Counted {
  std::string method;
  std::shared_ptr<jalon::ParamSet> values;
};

namespace jalon::capi {

jalon_model* new_model(Model model);

}  // namespace jalon::capi
