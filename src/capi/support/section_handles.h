// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "capi/support/handles.h"
#include "cloud/sections/sections.h"

struct jalon_sections : jalon::capi::Counted {
  jalon::Sections sections;
  std::vector<std::string> names;
  std::string parameters;
};
