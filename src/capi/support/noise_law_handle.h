// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "capi/support/handles.h"
#include "fieldtools/noise_law.h"

struct jalon_noise_law : jalon::capi::Counted {
  jalon::NoiseLaw law;
  std::string json;
};
