// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "base/params.h"
#include "capi/support/handles.h"
#include "scan/methods.h"

struct jalon_scanner : jalon::capi::Counted {
  const jalon::ScannerMethod* method = nullptr;
  std::shared_ptr<jalon::ParamSet> values;
  std::vector<jalon::ScanStation> stations;
};
