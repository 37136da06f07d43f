// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "base/params.h"
#include "base/shared_text.h"
#include "capi/support/handles.h"
#include "registration/methods.h"
#include "registration/registration.h"

struct jalon_registrar : jalon::capi::Counted {
  const jalon::RegistrationMethod* method = nullptr;
  std::shared_ptr<jalon::ParamSet>
      values;  ///< shared with the jalon_params handles of this registrar
};

struct jalon_registration : jalon::capi::Counted {
  jalon::RegistrationPtr registration;
  jalon::SharedText crs;  ///< of the reference
};
